// photo_histogram.cpp -- the histogram of a photograph and its layers, as SVG.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "photo_layers.h"
#include "srgb.h"
#include "text.h"

namespace pelage {
namespace {

constexpr double kLeft = 12.0, kTop = 30.0, kWide = 512.0, kHigh = 160.0;

std::string at(const char* name, double value) {
    char text[48];
    std::snprintf(text, sizeof text, " %s=\"%.2f\"", name, value);
    return text;
}

double placeOf(double encoded) { return kLeft + kWide * encoded; }

std::string textAt(double x, double y, const std::string& text, const char* rest) {
    return "<text" + at("x", x) + at("y", y) + " " + rest + ">" + markupText(text) + "</text>\n";
}

std::string barsOf(const PhotoLayers& layers) {
    const double highest = static_cast<double>(std::ranges::max(layers.histogram));
    std::string svg;
    for (std::size_t i = 0; i < layers.histogram.size(); ++i) {
        if (layers.histogram[i] == 0) continue;
        const double high = kHigh * static_cast<double>(layers.histogram[i]) / highest;
        svg += "<rect" + at("x", placeOf(static_cast<double>(i) / 256.0)) +
               at("y", kTop + kHigh - high) + at("width", kWide / 256.0) + at("height", high) +
               " fill=\"#9a9a9a\"/>\n";
    }
    return svg;
}

// In the middle of the bar of its tone.
std::string lineOf(float threshold, double from, double to, const char* color) {
    const double x =
        placeOf((255.0 * static_cast<double>(srgbFromLinear(threshold)) + 0.5) / 256.0);
    return "<line" + at("x1", x) + at("y1", from) + at("x2", x) + at("y2", to) + " stroke=\"" +
           color + "\"/>\n";
}

}  // namespace

std::string histogramSvg(const PhotoLayers& layers, const std::string& title) {
    constexpr const char* kColors[] = {"#0072b2", "#d55e00"};  // Okabe and Ito, 2008
    const double right = 2.0 * kLeft + kWide, bottom = kTop + kHigh + 40.0;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + at("width", right) +
                      at("height", bottom) + " font-family=\"sans-serif\" font-size=\"11\">\n";
    svg += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    svg += textAt(kLeft, 18.0, title, "font-size=\"13\" font-weight=\"bold\"");
    svg += barsOf(layers);
    // One below the other, so that the lines of both regions can be told apart.
    const double part = kHigh / static_cast<double>(layers.regions.size());
    for (std::size_t i = 0; i < layers.regions.size(); ++i)
        for (const float threshold : layers.regions[i].thresholds)
            svg += lineOf(threshold, kTop + static_cast<double>(i) * part,
                          kTop + static_cast<double>(i + 1) * part, kColors[i]);
    const double below = kTop + kHigh + 15.0;
    svg += textAt(kLeft, below, "0", "");
    svg += textAt(kLeft + kWide, below, "255", "text-anchor=\"end\"");
    svg += textAt(kLeft + 0.5 * kWide, below, "luminance, as displayed", "text-anchor=\"middle\"");
    svg += textAt(
        kLeft, below + 17.0,
        std::string("Lines: from where on a layer holds what is as bright") +
            (layers.regions.size() > 1 ? "; above of the larger color, below of the other." : "."),
        "fill=\"#666\"");
    return svg + "</svg>\n";
}

}  // namespace pelage
