// accuracy_report.cpp -- one line for each distance, and the pictures of the view.
#include "app/accuracy_report.h"

#include <span>

#include "app/cli/measure_report.h"
#include "core/files.h"
#include "core/heat_map.h"
#include "core/pixels.h"

namespace pelage {
namespace {

OrderedJson rowOf(const AccuracyPoint& point, const AccuracySubject& subject,
                  const std::string& device) {
    const FrameStats& stats = point.live.stats;
    OrderedJson row = {{"distance", point.distance},
                       {"width", subject.view.size.x},
                       {"height", subject.view.size.y},
                       {"detail", textOf(subject.view.detail)},
                       {"shadows", subject.options.traced ? "traced" : "live"},
                       {"samples", point.samples},
                       {"ms", point.ms()},
                       {"hairsTotal", stats.hairsTotal},
                       {"hairsDrawn", stats.hairsDrawn},
                       {"segmentsDrawn", stats.segmentsDrawn},
                       {"layers", stats.layers},
                       {"textureBytes", stats.textureBytes},
                       {"msShellPass", 1e3 * stats.shellSeconds}};
    row.update(errorsJson(point.errors, point.reference));
    row["device"] = device;
    return row;
}

}  // namespace

void writeAccuracyReport(const std::string& path, const Accuracy& accuracy,
                         const std::string& device) {
    OrderedJson rows = OrderedJson::array();
    for (const AccuracyPoint& point : accuracy.points())
        rows.push_back(rowOf(point, accuracy.subject(), device));
    const std::string lines = reportCsv({{"rows", rows}});
    writeFileAtomically(path, std::as_bytes(std::span(lines)));
    const AccuracyPoint& view = accuracy.points().front();
    const std::string before = path.substr(0, path.rfind(".csv"));
    writeImage(before + "-live.png", view.live.image);
    writeImage(before + "-reference.png", view.reference.image);
    writeImage(before + "-heat.png", heatMap(view.errors.flipMap));
}

}  // namespace pelage
