// measure_report.cpp -- rows of figures, and plots.
#include "app/cli/measure_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/cli/compare.h"
#include "core/pareto.h"
#include "core/plot.h"
#include "core/text.h"

namespace pelage {
namespace {

using Figure = double (*)(const Measured& row);

double flipOfDrawing(const Measured& row) { return row.drawing.flipMean; }
double rmseOfDrawing(const Measured& row) { return row.drawing.rmse; }

std::vector<bool> frontBy(const MeasuredEye& eye, Figure figure) {
    std::vector<Cost> costs;
    for (const Measured& row : eye.rows) costs.push_back({row.ms(), figure(row)});
    std::vector<bool> front(costs.size(), false);
    for (const std::size_t i : paretoFront(costs)) front[i] = true;
    return front;
}

OrderedJson rowJson(const MeasuredEye& eye, const Measured& row, bool front) {
    const Technique& technique = *row.technique;
    return {{"view", eye.name},
            {"technique", technique.name},
            {"knob", technique.knob},
            {"value", technique.values[row.value]},
            {"ms", row.ms()},
            {"msFrame", row.msFrame},
            {"msLeast", row.msLeast},
            {"msGreatest", row.msGreatest},
            {"framesTimed", row.framesTimed},
            {"samples", row.samples},
            {"hairsDrawn", row.hairsDrawn},
            {"segmentsDrawn", row.segmentsDrawn},
            {"layers", row.layers},
            {"textureBytes", row.textureBytes},
            {"msShellPass", row.msShells},
            {"bytes", row.bytes},
            {"front", front},
            {"drawing", errorsJson(row.drawing, eye.referenceOf(row).drawing)},
            {"light", errorsJson(row.light, eye.referenceOf(row).light)}};
}

OrderedJson approachJson(const MeasuredEye& eye, const Approach& approach) {
    return {{"view", eye.name},
            {"technique", approach.technique->name},
            {"coarsest", approach.coarsest},
            {"finest", approach.finest},
            {"ordered", approach.technique->ordered},
            {"falls", approach.falls},
            {"leavesOut", approach.technique->leavesOut}};
}

// "rmse" and the like, objects within objects by "drawing.rmse".
void flatten(const OrderedJson& object, const std::string& before,
             std::vector<std::pair<std::string, std::string>>& fields) {
    for (const auto& [name, value] : object.items()) {
        std::string text;
        if (value.is_object()) {
            flatten(value, before + name + ".", fields);
            continue;
        }
        if (value.is_string()) {
            text = value.get<std::string>();
        } else if (value.is_number_float()) {
            std::array<char, 32> digits{};
            if (std::isfinite(value.get<double>()))
                std::snprintf(digits.data(), digits.size(), "%.6g", value.get<double>());
            text = digits.data();
        } else if (!value.is_null()) {
            text = value.dump();
        }
        fields.emplace_back(before + name, text);
    }
}

Plot plotOf(const MeasuredEye& eye, Figure figure, const std::string& error) {
    Plot plot{.title = eye.name, .xLabel = "ms of a picture", .yLabel = error};
    const std::vector<bool> front = frontBy(eye, figure);
    for (std::size_t i = 0; i < eye.rows.size(); ++i) {
        const Measured& row = eye.rows[i];
        if (i == 0 || row.technique != eye.rows[i - 1].technique)
            plot.series.push_back({row.technique->name, {}, row.technique->ordered});
        plot.series.back().points.push_back(
            {row.ms(), figure(row), row.technique->values[row.value], front[i]});
    }
    return plot;
}

}  // namespace

OrderedJson errorsJson(const ImageErrors& errors, const TracedPicture& reference) {
    OrderedJson result = jsonOf(errors);
    const double share = noiseShare(errors.rmse, reference);
    result["noise"] = reference.noise.color;
    result["noiseShare"] = share;
    result["trusted"] = share <= kMostNoise;
    return result;
}

std::vector<bool> onFront(const MeasuredEye& eye) { return frontBy(eye, flipOfDrawing); }

std::string machineText(const ReportHead& head, const Measurement& measurement) {
    return std::to_string(head.cores) + " cores of " + head.processor + "; " + measurement.device +
           "; " + head.date;
}

OrderedJson reportJson(const ReportHead& head, const Measurement& measurement) {
    OrderedJson views = OrderedJson::array(), rows = OrderedJson::array(),
                near = OrderedJson::array();
    for (const MeasuredEye& eye : measurement.eyes) {
        views.push_back({{"name", eye.name},
                         {"distance", eye.camera.distance},
                         {"drawingNoise", eye.references.front().drawing.noise.color},
                         {"lightNoise", eye.references.front().light.noise.color}});
        const std::vector<bool> front = onFront(eye);
        for (std::size_t i = 0; i < eye.rows.size(); ++i)
            rows.push_back(rowJson(eye, eye.rows[i], front[i]));
        for (const Approach& approach : approaches(eye))
            near.push_back(approachJson(eye, approach));
    }
    return {{"model", head.model},
            {"preset", head.preset},
            {"date", head.date},
            {"processor", head.processor},
            {"cores", head.cores},
            {"device", measurement.device},
            {"width", measurement.size.x},
            {"height", measurement.size.y},
            {"triangles", measurement.triangles},
            {"hairs", measurement.hairs},
            {"spp", measurement.spp},
            {"seed", measurement.seed},
            {"repeat", measurement.repeat},
            {"views", views},
            {"approaches", near},
            {"rows", rows}};
}

std::string reportCsv(const OrderedJson& report) {
    // Where nothing of a picture is transparent its coverage is null: columns come from any row
    // that has it.
    std::vector<std::string> columns;
    std::vector<std::vector<std::pair<std::string, std::string>>> lines;
    for (const OrderedJson& row : report["rows"]) {
        flatten(row, "", lines.emplace_back());
        if (lines.back().size() <= columns.size()) continue;
        columns.clear();
        for (const auto& [name, text] : lines.back()) columns.push_back(name);
    }
    std::string csv;
    const auto field = [&](std::size_t i, const std::string& text) {
        csv += (i > 0 ? "," : "") + csvField(text);
    };
    for (std::size_t i = 0; i < columns.size(); ++i) field(i, columns[i]);
    csv += "\n";
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto found =
                std::ranges::find(line, columns[i], [](const auto& f) { return f.first; });
            field(i, found == line.end() ? "" : found->second);
        }
        csv += "\n";
    }
    return csv;
}

std::string reportPlot(const ReportHead& head, const Measurement& measurement) {
    std::vector<Plot> plots;
    for (const MeasuredEye& eye : measurement.eyes) {
        plots.push_back(plotOf(eye, flipOfDrawing, "FLIP, mean"));
        plots.back().title = head.model + ", " + eye.name;
    }
    return svgOf(plots, machineText(head, measurement));
}

std::string eyePlots(const ReportHead& head, const Measurement& measurement,
                     const MeasuredEye& eye) {
    std::vector<Plot> plots = {plotOf(eye, flipOfDrawing, "FLIP, mean"),
                               plotOf(eye, rmseOfDrawing, "RMSE, linear RGB")};
    plots[0].title = eye.name + ": FLIP of drawing";
    plots[1].title = eye.name + ": RMSE of drawing";
    plots[1].floor = static_cast<double>(eye.references.front().drawing.noise.color) / kMostNoise;
    plots[1].floorLabel = "5 times the noise of the reference";
    return svgOf(plots, machineText(head, measurement));
}

}  // namespace pelage
