// info.cpp -- pelage info: what was found in a mesh file.
#include <cstdio>
#include <memory>

#include "app/cli/cli.h"
#include "app/cli/print.h"
#include "core/carried_counts.h"
#include "core/document.h"
#include "core/rig.h"
#include "core/spacing.h"

namespace pelage {
namespace {

OrderedJson jsonOf(FieldRange range) { return {{"min", range.least}, {"max", range.greatest}}; }
OrderedJson jsonOf(vec3 v) { return OrderedJson::array({v.x, v.y, v.z}); }

// Ranges of the fields that the file holds, in the file's own units; empty when it holds none.
OrderedJson fieldsOf(const Document& document) {
    OrderedJson fields = OrderedJson::object();
    if (!document.skin->source->fur) return fields;
    fields["length"] = jsonOf(fieldRange(document.groom, Channel::length));
    fields["density"] = jsonOf(fieldRange(document.groom, Channel::density));
    fields["direction"] = jsonOf(fieldRange(document.groom, Channel::direction));
    return fields;
}

OrderedJson infoOf(const std::string& file, const Document& document) {
    const Skin& skin = *document.skin;
    const LoadReport& report = skin.report;
    const CarriedCounts carried = carriedCounts(*skin.source);
    OrderedJson clips = OrderedJson::array();
    if (const auto& rig = skin.source->rig)
        for (const Clip& clip : rig->clips)
            clips.push_back({{"name", clip.name}, {"seconds", clip.seconds}});
    std::vector<std::string> warnings = report.warnings;
    for (std::string& note : spacingNotes(document)) warnings.push_back(std::move(note));
    OrderedJson segments = OrderedJson::array();
    for (const Segment& segment : document.groom.body()) segments.push_back(segment.name);
    return {{"file", file},
            {"vertices", report.vertices},
            {"triangles", report.triangles},
            {"weldedVertices", report.weldedVertices},
            {"unusedVertices", report.unusedVertices},
            {"nonManifoldEdges", report.nonManifoldEdges},
            {"flippedEdges", report.flippedEdges},
            {"boundaryEdges", report.boundaryEdges},
            {"degenerateFaces", report.degenerateFaces},
            {"segments", segments},
            {"joints", carried.joints},
            {"animations", carried.animations},
            {"clips", clips},
            {"morphTargets", carried.morphTargets},
            {"materials", carried.materials},
            {"images", carried.images},
            {"hasFur", skin.source->fur != nullptr},
            {"fields", fieldsOf(document)},
            {"bounds", {{"min", jsonOf(skin.lower)}, {"max", jsonOf(skin.upper)}}},
            {"area", skin.area},
            {"spacing", skin.spacing},
            {"warnings", warnings}};
}

std::string number(const OrderedJson& value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value.get<double>());
    return text;
}

std::string vectorText(const OrderedJson& v) {
    return number(v[0]) + " " + number(v[1]) + " " + number(v[2]);
}

std::string textOf(const OrderedJson& info) {
    std::string text = info["file"].get<std::string>() + "\n";
    const auto line = [&](const std::string& name, const std::string& value) {
        text.append("  ").append(name).append(18 - name.size(), ' ').append(value).append("\n");
    };
    for (const char* count :
         {"vertices", "triangles", "weldedVertices", "unusedVertices", "nonManifoldEdges",
          "flippedEdges", "boundaryEdges", "degenerateFaces", "joints", "animations",
          "morphTargets", "materials", "images"}) {
        line(count, info[count].dump());
    }
    std::string names;
    for (const auto& segment : info["segments"]) {
        names += (names.empty() ? "" : ", ") + segment.get<std::string>();
    }
    line("segments", names.empty() ? "none" : names);
    for (const auto& clip : info["clips"])
        line("clip", clip["name"].get<std::string>() + ", " + number(clip["seconds"]) + " s");
    line("bounds", vectorText(info["bounds"]["min"]) + " to " + vectorText(info["bounds"]["max"]));
    line("spacing", number(info["spacing"]));
    line("fur", info["hasFur"].get<bool>() ? "yes" : "no");
    for (const auto& [field, range] : info["fields"].items()) {
        line("fur " + field, number(range["min"]) + " to " + number(range["max"]));
    }
    for (const auto& warning : info["warnings"]) line("warning", warning.get<std::string>());
    return text;
}

}  // namespace

void addInfo(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("info", "Say what a mesh file holds");
    const auto file = std::make_shared<std::string>();
    verb->add_option("FILE", *file, "A .glb, .gltf, .obj, .ply, .off or .stl file")->required();
    addJsonFlag(*verb, json);
    verb->callback([file, &json] {
        const OrderedJson info = infoOf(*file, openDocument(readSource(*file)));
        if (json) {
            printJson(info);
        } else {
            print(textOf(info));
        }
    });
}

}  // namespace pelage
