// plot.cpp -- axes, ticks, marks and legend.
#include "plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "log_axis.h"
#include "text.h"

namespace pelage {
namespace {

// Okabe and Ito, "Color Universal Design", 2008: told apart by people of all kinds of sight.
constexpr std::array kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#a07000",
                                "#56b4e9", "#000000", "#808080", "#7b3fb0"};
constexpr double kWide = 460.0, kHigh = 360.0;  // of one plot
constexpr double kLeft = 62.0, kRight = 30.0, kTop = 34.0, kBottom = 46.0, kLegend = 66.0;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

// name="value" for coordinates.
std::string at(const char* name, double value) {
    char text[48];
    std::snprintf(text, sizeof text, " %s=\"%.1f\"", name, value);
    return text;
}

std::string textAt(double x, double y, const std::string& text, const std::string& rest) {
    return "<text" + at("x", x) + at("y", y) + " " + rest + ">" + markupText(text) + "</text>\n";
}

// The size, or a smaller one by which the text is no wider than that.
std::string fontFor(const std::string& text, double size, double wide) {
    constexpr double kLetter = 0.62;  // mean width of bold ones, of their size
    const double letters = static_cast<double>(std::max<std::size_t>(text.size(), 1));
    return "font-size=\"" + number(std::min(size, wide / (kLetter * letters))) + "\"";
}

std::string lineTo(double x0, double y0, double x1, double y1, const char* rest) {
    return "<line" + at("x1", x0) + at("y1", y0) + at("x2", x1) + at("y2", y1) + " " + rest +
           "/>\n";
}

bool hasPlace(const PlotPoint& p) { return LogAxis::hasPlace(p.x) && LogAxis::hasPlace(p.y); }

constexpr double kLeastRatio = 2.5;               // of the ends of an axis
constexpr double kApartX = 40.0, kApartY = 20.0;  // of ticks

struct Frame {
    LogAxis x, y;
};

Frame frameOf(const Plot& plot, double left) {
    Frame frame;
    for (const PlotSeries& series : plot.series)
        for (const PlotPoint& p : series.points)
            if (hasPlace(p)) {
                frame.x.hold(p.x);
                frame.y.hold(p.y);
            }
    frame.x.widen(kLeastRatio);
    frame.y.widen(kLeastRatio);
    frame.x.from = left + kLeft;
    frame.x.to = left + kWide - kRight;
    frame.y.from = kHigh - kBottom;
    frame.y.to = kTop;
    return frame;
}

std::string axesOf(const Plot& plot, const Frame& f, double left) {
    const double middle = 0.5 * (f.x.from + f.x.to);
    std::string svg;
    for (const double tick : f.x.ticks(kApartX)) {
        const double x = f.x.place(tick);
        svg += lineTo(x, f.y.from, x, f.y.to, "stroke=\"#e4e4e4\"");
        svg += textAt(x, f.y.from + 15.0, number(tick), "text-anchor=\"middle\"");
    }
    for (const double tick : f.y.ticks(kApartY)) {
        const double y = f.y.place(tick);
        svg += lineTo(f.x.from, y, f.x.to, y, "stroke=\"#e4e4e4\"");
        svg += textAt(f.x.from - 6.0, y + 4.0, number(tick), "text-anchor=\"end\"");
    }
    svg += lineTo(f.x.from, f.y.from, f.x.to, f.y.from, "stroke=\"#444\"");
    svg += lineTo(f.x.from, f.y.from, f.x.from, f.y.to, "stroke=\"#444\"");
    const double titleWide = 2.0 * std::min(middle - left, left + kWide - middle);
    svg += textAt(
        middle, f.y.to - 14.0, plot.title,
        "text-anchor=\"middle\" font-weight=\"bold\" " + fontFor(plot.title, 14.0, titleWide));
    svg += textAt(middle, f.y.from + 34.0, plot.xLabel, "text-anchor=\"middle\"");
    svg += textAt(f.x.from, f.y.to - 3.0, plot.yLabel, "text-anchor=\"start\"");
    if (plot.floor > f.y.least && plot.floor < f.y.greatest) {
        const double y = f.y.place(plot.floor);
        svg += lineTo(f.x.from, y, f.x.to, y, "stroke=\"#888\" stroke-dasharray=\"4 3\"");
        svg += textAt(f.x.to, y - 4.0, plot.floorLabel, "text-anchor=\"end\" fill=\"#666\"");
    }
    return svg;
}

std::string polyline(const Frame& f, const std::vector<PlotPoint>& points,
                     const std::string& rest) {
    std::string svg = "<polyline fill=\"none\" " + rest + " points=\"";
    for (const PlotPoint& p : points) {
        char place[48];
        std::snprintf(place, sizeof place, "%.1f,%.1f ", f.x.place(p.x), f.y.place(p.y));
        svg += place;
    }
    return svg + "\"/>\n";
}

// The points of the series of that number. Labels of four neighbors go to four sides, since points
// of different series often lie together.
std::string marksOf(const Frame& f, const PlotSeries& series, std::size_t which) {
    const char* const color = kColors[which % kColors.size()];
    const double aside = which & 2u ? -6.0 : 6.0, above = which & 1u ? 12.0 : -5.0;
    std::vector<PlotPoint> points;
    std::ranges::copy_if(series.points, std::back_inserter(points), hasPlace);
    std::string svg;
    if (series.joined)
        svg = polyline(f, points, std::string("stroke-width=\"1.5\" stroke=\"") + color + "\"");
    for (const PlotPoint& p : points) {
        const double x = f.x.place(p.x), y = f.y.place(p.y);
        svg += "<circle" + at("cx", x) + at("cy", y) + " r=\"3.5\" fill=\"" + color + "\"";
        if (p.front) svg += " stroke=\"#111\" stroke-width=\"2\"";
        svg += "><title>" +
               markupText(series.name + " " + p.label + ": " + number(p.x) + ", " + number(p.y)) +
               "</title></circle>\n";
        svg += textAt(x + aside, y + above, p.label,
                      std::string("font-size=\"10\" text-anchor=\"") +
                          (aside > 0.0 ? "start" : "end") + "\" fill=\"" + color + "\"");
    }
    return svg;
}

// From the left to the right.
std::vector<PlotPoint> frontOf(const Plot& plot) {
    std::vector<PlotPoint> front;
    for (const PlotSeries& series : plot.series)
        std::ranges::copy_if(series.points, std::back_inserter(front),
                             [](const PlotPoint& p) { return p.front && hasPlace(p); });
    std::ranges::sort(front, {}, &PlotPoint::x);
    return front;
}

std::string plotAt(const Plot& plot, double left) {
    const Frame frame = frameOf(plot, left);
    const std::vector<PlotPoint> front = frontOf(plot);
    std::string svg = axesOf(plot, frame, left);
    if (!front.empty())
        svg += polyline(frame, front,
                        "stroke-width=\"7\" stroke=\"#ffe08a\" stroke-linejoin=\"round\"");
    for (std::size_t i = 0; i < plot.series.size(); ++i) svg += marksOf(frame, plot.series[i], i);
    return svg;
}

// In as many lines as the width asks for.
std::string legendOf(const std::vector<PlotSeries>& series, bool front, double wide) {
    std::string svg;
    double x = kLeft, y = kHigh + 12.0;
    const auto entry = [&](const std::string& mark, const std::string& name) {
        const double needed = 34.0 + 7.0 * static_cast<double>(name.size());
        if (x + needed > wide) {
            x = kLeft;
            y += 16.0;
        }
        svg += "<g transform=\"translate(" + number(x) + " " + number(y) + ")\">" + mark +
               textAt(18.0, 4.0, name, "") + "</g>\n";
        x += needed;
    };
    for (std::size_t i = 0; i < series.size(); ++i)
        entry(
            std::string("<circle cx=\"7\" r=\"4\" fill=\"") + kColors[i % kColors.size()] + "\"/>",
            series[i].name);
    if (front)
        entry(lineTo(0.0, 0.0, 14.0, 0.0, "stroke=\"#ffe08a\" stroke-width=\"7\""), "Pareto front");
    return svg;
}

}  // namespace

std::string svgOf(std::span<const Plot> plots, const std::string& footer) {
    const double wide = kWide * static_cast<double>(std::max<std::size_t>(plots.size(), 1));
    const double high = kHigh + kLegend;
    char box[64];
    std::snprintf(box, sizeof box, " viewBox=\"0 0 %.0f %.0f\"", wide, high);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + at("width", wide) +
                      at("height", high) + box +
                      " font-family=\"sans-serif\" font-size=\"11\" fill=\"#222\">\n";
    svg += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (std::size_t i = 0; i < plots.size(); ++i)
        svg += plotAt(plots[i], kWide * static_cast<double>(i));
    const bool front =
        std::ranges::any_of(plots, [](const Plot& plot) { return !frontOf(plot).empty(); });
    if (!plots.empty()) svg += legendOf(plots.front().series, front, wide);
    svg += textAt(8.0, high - 8.0, footer, "fill=\"#666\" " + fontFor(footer, 9.0, wide - 16.0));
    return svg + "</svg>\n";
}

}  // namespace pelage
