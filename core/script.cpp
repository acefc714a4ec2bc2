// script.cpp -- the lines of a script: what each means.
#include "script.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "animal.h"
#include "coat.h"
#include "files.h"
#include "gltf_out.h"
#include "gradient.h"
#include "mask_edit.h"
#include "preset_file.h"
#include "region_text.h"
#include "rig.h"
#include "script_text.h"
#include "segment_text.h"
#include "subdivide.h"
#include "text.h"
#include "transfer.h"

namespace pelage {
namespace {

// Of a script or a journal.
std::string textOfFile(const std::string& path) {
    constexpr std::size_t kLargest = std::size_t{1} << 30;  // bytes
    const std::vector<std::byte> bytes = readFile(path, kLargest);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Editor& editorOf(Workspace& workspace) {
    if (!workspace.editor) throw std::runtime_error("nothing is open yet");
    return *workspace.editor;
}

std::string pathOf(Words& words) {
    const std::string path(words.path());
    if (path.empty()) throw std::runtime_error("names no file");
    return path;
}

// Whether the skin has the clip and the targets of a pose that another skin took.
bool canStand(const Skin& skin, const Pose& pose) {
    const Rig* rig = skin.source->rig.get();
    return rig && pose.clip < static_cast<int>(rig->clips.size()) &&
           (pose.weights.empty() || pose.weights.size() == rig->targets.size());
}

// "Comb stroke"
std::string strokeLabel(const Brush& brush) {
    return std::string(toolInfo(brush.tool).label) + " stroke";
}

vec3 pointFromWords(Words& words) {
    vec3 point(0.0f);
    for (int i = 0; i < 3; ++i) {
        const std::string_view word = words.next();
        const std::optional<float> number = floatFromText(word);
        if (!number) throw std::runtime_error(inQuotes(word) + " is no number");
        point[i] = *number;
    }
    return point;
}

float pressureFromWords(Words& words) {
    const std::string_view word = words.next();
    const std::optional<float> number = floatFromText(word);
    if (!number || !(*number >= 0.0f && *number <= 1.0f))
        throw std::runtime_error(inQuotes(word) + " is no pressure from 0 to 1");
    return *number;
}

void runOpen(Workspace& workspace, Words& words) {
    workspace.open(openDocument(readSource(pathOf(words))));
}

void runAnimal(Workspace& workspace, Words& words) {
    std::size_t triangles = kAnimalTriangles;
    if (const std::string_view word = words.next(); !word.empty()) {
        const std::optional<float> number = floatFromText(word);
        if (!number || *number < 2000.0f || *number > 2e6f)
            throw std::runtime_error(inQuotes(word) +
                                     " is no number of triangles from 2000 to 2000000");
        triangles = static_cast<std::size_t>(*number);
    }
    expectEnd(words);
    workspace.open(groomedAnimal(triangles));
}

void runPreset(Workspace& workspace, Words& words) {
    const Preset preset = findPreset(words.rest());
    Editor& editor = editorOf(workspace);
    editor.edit([&](Document& document) { applyPreset(document.fur, preset); });
    editor.commit("Preset " + preset.name);
}

void runSet(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    Fur fur = editor.document().fur;
    std::string label = "Set";
    int count = 0;
    do {
        const std::string_view name = words.next();
        const std::string_view value = words.next();
        setParameter(fur, name, value);
        if (++count <= 3) label += (count > 1 ? ", " : " ") + std::string(name);
    } while (!words.done());
    if (count > 3) label += ", ...";
    editor.edit([&](Document& document) { document.fur = fur; });
    editor.commit(std::move(label));
}

void runStroke(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    auto [brush, stopped] = brushFromWords(words, true);
    const bool pressed = stopped == "pressure";
    if (pressed) stopped = words.next();
    if (stopped != ":")
        throw std::runtime_error(stopped.empty() ? "the stroke has no : and no points"
                                                 : "no brush knows " + inQuotes(stopped));
    struct Point {
        vec3 position, normal;
        float pressure = 1.0f;
    };
    std::vector<Point> points;
    while (!words.done()) {
        Point point{pointFromWords(words), vec3(0.0f)};
        if (words.done()) throw std::runtime_error("the last point of the stroke has no normal");
        point.normal = pointFromWords(words);
        if (pressed) point.pressure = pressureFromWords(words);
        points.push_back(point);
    }
    editor.edit([&, &of = brush](Document& document) {
        Stroke stroke(*workspace.query, document.groom, of);
        for (const Point& point : points)
            stroke.dab(document.groom, point.position, point.normal, point.pressure);
    });
    editor.commit(strokeLabel(brush));
}

void runFlood(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    const auto [brush, stopped] = brushFromWords(words, false);
    vec3 direction(0.0f);
    if (stopped == "direction") {
        direction = pointFromWords(words);
    } else if (!stopped.empty()) {
        throw std::runtime_error("no flood knows " + inQuotes(stopped));
    }
    expectEnd(words);
    if (toolInfo(brush.tool).needsPath)
        throw std::runtime_error(std::string(toolInfo(brush.tool).name) +
                                 " goes by the path of a stroke; a flood has none");
    if (brush.tool == Tool::comb && direction == vec3(0.0f))
        throw std::runtime_error("a flood of comb needs a direction");
    editor.edit([&, &of = brush](Document& document) {
        flood(*workspace.query, document.groom, of, direction);
    });
    editor.commit(std::string("Flood ") + toolInfo(brush.tool).name);
}

void runReset(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    const ToolInfo& tool = toolNamed(words.next());
    expectEnd(words);
    editor.edit([&](Document& document) { reset(*document.skin, document.groom, tool.tool); });
    editor.commit(std::string("Reset ") + tool.name);
}

void runSegmentLine(Workspace& workspace, Words& words) { runSegment(editorOf(workspace), words); }

void runBodyLine(Workspace& workspace, Words& words) { runBody(editorOf(workspace), words); }

void runComb(Workspace& workspace, Words& words) { runHeadToTail(editorOf(workspace), words); }

void runRegion(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    const auto [region, change] = regionFromWords(words);
    expectEnd(words);
    Groom groom = editor.document().groom;
    applyRegion(*workspace.query, groom, region, change);
    editor.edit([&](Document& document) { document.groom = std::move(groom); });
    editor.commit(regionLabel(region, change));
}

void runGradientLine(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    runGradient(workspace.query->skin(), editor, words);
}

void runMaskLine(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    runMask(*workspace.query, editor, words);
}

void runPose(Workspace& workspace, Words& words) {
    workspace.stand(poseFromWords(*editorOf(workspace).document().skin, words));
}

void runSubdivide(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    int levels = 1;
    if (const std::string_view word = words.next(); !word.empty()) {
        levels = 0;
        for (int n = 1; n <= kMostLevels; ++n)
            if (word == std::to_string(n)) levels = n;
        if (levels == 0)
            throw std::runtime_error(inQuotes(word) + " is no whole number from 1 to " +
                                     std::to_string(kMostLevels));
    }
    expectEnd(words);
    Document after = subdivided(editor.document(), levels);
    editor.edit([&](Document& document) { document = std::move(after); });
    editor.commit(kSubdivideLabel);
}

void runTransfer(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    Document after =
        transferred(openDocument(readSource(pathOf(words))), editor.document()).document;
    editor.edit([&](Document& document) { document = std::move(after); });
    editor.commit(kTransferLabel);
}

void runUndo(Workspace& workspace, Words& words) {
    expectEnd(words);
    editorOf(workspace).undo();
}

void runRedo(Workspace& workspace, Words& words) {
    expectEnd(words);
    editorOf(workspace).redo();
}

void runSave(Workspace& workspace, Words& words) {
    Editor& editor = editorOf(workspace);
    writeGroomedGlb(editor.document(), pathOf(words));
    editor.markSaved();
}

struct Command {
    const char* name;
    void (*run)(Workspace&, Words&);
};
constexpr std::array<Command, 19> kCommands{{{"open", runOpen},
                                             {"animal", runAnimal},
                                             {"preset", runPreset},
                                             {"set", runSet},
                                             {"stroke", runStroke},
                                             {"flood", runFlood},
                                             {"reset", runReset},
                                             {"segment", runSegmentLine},
                                             {"body", runBodyLine},
                                             {"comb", runComb},
                                             {"region", runRegion},
                                             {"gradient", runGradientLine},
                                             {"mask", runMaskLine},
                                             {"pose", runPose},
                                             {"subdivide", runSubdivide},
                                             {"transfer", runTransfer},
                                             {"undo", runUndo},
                                             {"redo", runRedo},
                                             {"save", runSave}}};

void runText(Workspace& workspace, const std::string& path, std::string_view text) {
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        try {
            runLine(workspace, text.substr(0, end));
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(path + ": line " + std::to_string(number) + ": " +
                                     error.what());
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

// The value of a row as text that sets it again bit for bit.
template <class Object>
std::string valueText(const Object& object, const Parameter& row) {
    if (row.kind == ParameterKind::count) return std::to_string(parameterCount(object, row));
    if (row.kind == ParameterKind::choice) return row.choices[parameterCount(object, row)];
    const vec3 value = parameterValue(object, row);
    std::string text = floatText(value[0]);
    for (int i = 1; i < row.components(); ++i) text += ',' + floatText(value[i]);
    return text;
}

template <class Object>
void addChanges(std::string& line, const std::string& owner, std::span<const Parameter> rows,
                const Object& before, const Object& after) {
    for (const Parameter& row : rows) {
        const std::string value = valueText(after, row);
        if (value != valueText(before, row)) line += ' ' + owner + '.' + row.name + ' ' + value;
    }
}

}  // namespace

void Workspace::open(Document document) {
    auto newQuery = std::make_unique<SkinQuery>(document.skin);
    auto newEditor = std::make_unique<Editor>(std::move(document));
    stroke.reset();
    pose = {};
    posed.reset();
    query = std::move(newQuery);
    editor = std::move(newEditor);
}

void Workspace::stand(Pose to) {
    cancelStroke();
    posed = to.atRest() ? nullptr : posedSkin(editor->document().skin, to);
    pose = std::move(to);
}

void Workspace::follow() {
    const std::shared_ptr<const Skin>& rest = editor->document().skin;
    if (posed && posed->source != rest->source) {
        if (!canStand(*rest, pose)) pose = {};
        posed = pose.atRest() ? nullptr : posedSkin(rest, pose);
    }
    if (&query->skin() == shown().get()) return;
    stroke.reset();  // it asks the old one
    query = std::make_unique<SkinQuery>(shown());
}

bool Workspace::undo() {
    const bool undone = editor->undo();
    follow();
    return undone;
}

bool Workspace::redo() {
    const bool redone = editor->redo();
    follow();
    return redone;
}

void Workspace::press(const Brush& brush, vec3 position, vec3 normal, float pressure) {
    cancelStroke();
    follow();
    stroke.emplace(*query, editor->document().groom, brush);
    drag(position, normal, pressure);
}

void Workspace::drag(vec3 position, vec3 normal, float pressure) {
    if (!stroke) return;
    editor->edit(
        [&](Document& document) { stroke->dab(document.groom, position, normal, pressure); });
}

std::string Workspace::release() {
    if (!stroke) return {};
    std::string line = stroke->line();
    const bool changed = editor->commit(strokeLabel(stroke->brush()));
    stroke.reset();
    return changed ? line : std::string{};
}

void Workspace::cancelStroke() {
    if (!stroke) return;
    stroke.reset();
    editor->cancel();
}

void runLine(Workspace& workspace, std::string_view line) {
    Words words(line);
    const std::string_view name = words.next();
    if (name.empty() || name.front() == '#') return;
    const auto command = std::find_if(kCommands.begin(), kCommands.end(),
                                      [&](const Command& row) { return name == row.name; });
    if (command == kCommands.end()) throw std::runtime_error("no command " + inQuotes(name));
    workspace.cancelStroke();
    if (workspace.editor) {
        workspace.editor->cancel();
        workspace.follow();
    }
    try {
        command->run(workspace, words);
        if (workspace.editor) workspace.follow();
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string(name) + ": " + error.what());
    }
}

void runScript(Workspace& workspace, const std::string& path) {
    runText(workspace, path, textOfFile(path));
}

std::string replayJournal(Workspace& workspace, const std::string& path) {
    std::string text = textOfFile(path);
    text.resize(text.rfind('\n') + 1);
    runText(workspace, path, text);
    return text;
}

std::string setLine(const Fur& before, const Fur& after) {
    std::string changes;
    addChanges(changes, "over", coatParameters(), before.over, after.over);
    addChanges(changes, "under", coatParameters(), before.under, after.under);
    addChanges(changes, "fur", furParameters(), before, after);
    return changes.empty() ? changes : "set" + changes;
}

std::string subdivideLine(int levels) {
    return levels == 1 ? "subdivide" : "subdivide " + std::to_string(levels);
}

std::string transferLine(const std::string& path) { return "transfer " + path; }

std::string floodLine(const Brush& brush, vec3 direction) {
    std::string line = "flood " + toolText(brush);
    if (brush.tool == Tool::comb)
        line += " direction " + pointText(direction);
    return line;
}

}  // namespace pelage
