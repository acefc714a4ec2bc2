// shape_error.cpp -- pelage shape-error: how far drawn hair strays from its exact shape.
#include "core/shape_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <span>
#include <tuple>

#include "app/cli/cli.h"
#include "app/cli/print.h"
#include "core/files.h"

namespace pelage {
namespace {

constexpr const char* kParts[] = {"segments", "droop", "table"};
constexpr const char* kDroops[] = {"paper", "elastica"};

const char* partName(const ShapeError& e) { return kParts[static_cast<int>(e.part)]; }

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string csvOf(const std::vector<ShapeError>& errors) {
    std::string text = "part,droop,segments,rootDegrees,load,error,used\n";
    for (const ShapeError& e : errors)
        text += line("%s,%s,%u,%.4f,%.6g,%.3g,%d\n", partName(e), kDroops[e.droop], e.segments,
                     glm::degrees(e.root), e.load, e.error, e.used);
    return text;
}

// Errors of one kind of hair.
struct Summary {
    std::vector<double> errors;
    std::size_t unused = 0;

    double mean() const {
        double sum = 0.0;
        for (const double e : errors) sum += e;
        return sum / static_cast<double>(errors.size());
    }
    double share(double part) const {  // of the sorted errors
        return errors[static_cast<std::size_t>(part * static_cast<double>(errors.size() - 1))];
    }
};

// By part, droop and segments; for the droop by its load.
using Key = std::tuple<ShapeError::Part, uint, uint, double>;
std::map<Key, Summary> summaries(const std::vector<ShapeError>& errors) {
    std::map<Key, Summary> all;
    for (const ShapeError& e : errors) {
        const double load = e.part == ShapeError::Part::droop ? e.load : 0.0;
        Summary& summary = all[{e.part, e.droop, e.segments, load}];
        if (e.used)
            summary.errors.push_back(e.error);
        else
            ++summary.unused;
    }
    for (auto& [key, summary] : all) std::sort(summary.errors.begin(), summary.errors.end());
    return all;
}

OrderedJson jsonOf(const std::vector<ShapeError>& errors) {
    OrderedJson list = OrderedJson::array();
    for (const auto& [key, s] : summaries(errors)) {
        const auto& [part, droop, segments, load] = key;
        OrderedJson row{{"part", kParts[static_cast<int>(part)]}, {"droop", kDroops[droop]}};
        if (part == ShapeError::Part::segments) row["segments"] = segments;
        if (part == ShapeError::Part::droop) row["load"] = load;
        row["mean"] = s.mean();
        row["p99"] = s.share(0.99);
        row["max"] = s.errors.back();
        if (part == ShapeError::Part::table) row["cellsUnused"] = s.unused;
        list.push_back(row);
    }
    return {{"errors", list}};
}

std::string textOf(const std::vector<ShapeError>& errors) {
    using Part = ShapeError::Part;
    const auto all = summaries(errors);
    std::string text =
        "Greatest distance at equal shares of the length, in lengths of the hair.\n\n"
        "Segments, against the exact curve (1 = style line; ribbons, curves and surfaces take as\n"
        "many as the view needs, up to 32)\n  segments   paper mean    max   elastica mean    "
        "max\n";
    for (const auto& [key, paper] : all) {
        const auto& [part, droop, segments, load] = key;
        if (part != Part::segments || droop != kDroopPaper) continue;
        const Summary& rod = all.at({part, kDroopElastica, segments, load});
        text += line("  %8u       %.4f  %.4f          %.4f  %.4f\n", segments, paper.mean(),
                     paper.errors.back(), rod.mean(), rod.errors.back());
    }
    text +=
        "\nThe paper's rule against the elastic rod: rows angle from up, columns load\n        ";
    std::map<double, std::map<double, double>> table;
    for (const ShapeError& e : errors)
        if (e.part == Part::droop) table[e.root][e.load] = e.error;
    for (const auto& [load, error] : table.begin()->second) text += line("%7g", load);
    text += "\n";
    for (const auto& [root, row] : table) {
        text += line("  %4.0f  ", glm::degrees(root));
        for (const auto& [load, error] : row) text += line("%7.3f", error);
        text += "\n";
    }
    const Summary& cells = all.at({Part::table, kDroopElastica, 0, 0.0});
    text +=
        line("\nThe table of rods against the solver: %zu cells, mean %.2g, p99 %.2g, max %.2g\n",
             cells.errors.size(), cells.mean(), cells.share(0.99), cells.errors.back());
    text += line(
        "%zu cells are never looked up: hair within 30 degrees of upright is stiffer, as\n"
        "else it would fall to one side or the other at a touch.\n",
        cells.unused);
    return text;
}

}  // namespace

void addShapeError(CLI::App& app, bool& json) {
    CLI::App* verb =
        app.add_subcommand("shape-error", "Say how far drawn hair strays from its exact shape");
    const auto csv = std::make_shared<std::string>();
    verb->add_option("--csv", *csv, "The .csv file to write, with every case");
    addJsonFlag(*verb, json);
    verb->callback([csv, &json] {
        if (!csv->empty()) expectExtension(*csv, ".csv");
        const std::vector<ShapeError> errors = shapeErrors();
        if (!csv->empty()) {
            const std::string text = csvOf(errors);
            writeFileAtomically(*csv, std::as_bytes(std::span(text)));
        }
        if (json) {
            printJson(jsonOf(errors));
        } else {
            print(textOf(errors));
        }
    });
}

}  // namespace pelage
