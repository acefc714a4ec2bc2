// plot.h -- points and lines in a plane of two logarithmic axes, as SVG.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace pelage {

struct PlotPoint {
    double x = 0.0, y = 0.0;
    std::string label;   // beside the point
    bool front = false;  // ringed, and joined to the others of all series that are
};

struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
    bool joined = true;  // by a line, in this order
};

struct Plot {
    std::string title, xLabel, yLabel;
    std::vector<PlotSeries> series{};
    double floor = 0.0;        // a dashed line at this y, where it lies in the picture; 0 = none
    std::string floorLabel{};  // of the line
};

// One SVG document: the plots, all of the same series, side by side above one legend and a line of
// text. Titles and that line are smaller where they are long. The legend names the front where a
// plot has one. What is not positive and finite has no place on such an axis and is left out.
std::string svgOf(std::span<const Plot> plots, const std::string& footer);

}  // namespace pelage
