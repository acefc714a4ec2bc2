// measure_page.cpp -- the report as one page of HTML: what to read first comes first.
#include <cmath>
#include <cstdio>
#include <tuple>

#include "app/cli/measure_report.h"
#include "core/coat.h"
#include "core/heat_map.h"
#include "core/pixels.h"
#include "core/srgb.h"
#include "core/text.h"

namespace pelage {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 sans-serif;color:#222;max-width:1400px;margin:2em auto;padding:0 1em}"
    "h1{margin-bottom:0}h2{margin-top:2.2em;border-bottom:1px solid #ccc}"
    ".small{color:#666;font-size:13px}"
    "table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums}"
    "th,td{padding:2px 9px;text-align:right;border-bottom:1px solid #eee;white-space:nowrap}"
    "th{border-bottom:1px solid #888;vertical-align:bottom}"
    "td:first-child,th:first-child,td:nth-child(2),th:nth-child(2){text-align:left}"
    "tr.front td{background:#fff4d0}tr.first td{border-top:1px solid #aaa}"
    "td.wrap{white-space:normal;text-align:left}"
    "figure{display:inline-block;margin:0 10px 14px 0;vertical-align:top}"
    "figure img{display:block;background:#949fb0}figcaption{font-size:12px;color:#444}"
    ".pair{display:flex;gap:2px}svg{max-width:100%;height:auto}.doubt{color:#a04000}";

std::string textOf(const char* format, double value) {
    if (!std::isfinite(value)) return "&#8211;";
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string cell(const std::string& content, const char* attributes = "") {
    return std::string("<td") + attributes + ">" + content + "</td>";
}

// A picture over black as it looks over the background of a view.
std::string pictureTag(const Image& image, const std::string& what) {
    const vec3 background = View{}.background;
    std::vector<unsigned char> bytes;
    bytes.reserve(4 * image.pixels.size());
    for (const vec4& pixel : image.pixels) {
        const vec3 color = vec3(pixel) + (1.0f - pixel.a) * background;
        for (int i = 0; i < 3; ++i)
            bytes.push_back(static_cast<unsigned char>(
                std::lround(255.0f * srgbFromLinear(glm::clamp(color[i], 0.0f, 1.0f)))));
        bytes.push_back(255);
    }
    return "<img width=\"" + std::to_string(image.size.x) + "\" height=\"" +
           std::to_string(image.size.y) + "\" alt=\"" + markupText(what) +
           "\" src=\"data:image/jpeg;base64," + base64(encodeJpeg(image.size, bytes)) + "\"/>";
}

std::string figure(const std::string& pictures, const std::string& caption) {
    return "<figure><div class=\"pair\">" + pictures + "</div><figcaption>" + markupText(caption) +
           "</figcaption></figure>\n";
}

std::string approachTable(const MeasuredEye& eye) {
    std::string html =
        "<table><tr><th>technique</th><th>what is turned</th><th>RMSE, coarsest</th><th>finest"
        "</th><th>falls</th><th>finest, times noise</th><th class=\"wrap\">what it leaves out"
        "</th></tr>\n";
    for (const Approach& approach : approaches(eye)) {
        const Technique& technique = *approach.technique;
        html += "<tr>" + cell(technique.name) + cell(markupText(technique.knob)) +
                cell(textOf("%.4f", approach.coarsest)) + cell(textOf("%.4f", approach.finest)) +
                cell(!technique.ordered ? "&#8211;"
                     : approach.falls   ? "yes"
                                        : "no") +
                cell(textOf("%.1f", approach.finest / approach.noise)) +
                cell(markupText(technique.leavesOut), " class=\"wrap\"") + "</tr>\n";
    }
    return html + "</table>\n";
}

std::string rowLine(const MeasuredEye& eye, const Measured& row, bool front, bool first) {
    const Technique& technique = *row.technique;
    const auto& coverage = row.drawing.coverage;
    const References& references = eye.referenceOf(row);
    const auto error = [&](const ImageErrors& errors, const TracedPicture& reference) {
        const bool doubt = !(noiseShare(errors.rmse, reference) <= kMostNoise);
        return cell(textOf("%.4f", errors.rmse) + (doubt ? "&#160;?" : ""),
                    doubt ? " class=\"doubt\"" : "") +
               cell(textOf("%.4f", errors.flipMean)) +
               cell(textOf("%+.2f", 100.0 * errors.luminanceBias));
    };
    return std::string("<tr class=\"") + (front ? "front " : "") + (first ? "first" : "") + "\">" +
           cell(technique.name) + cell(markupText(technique.values[row.value])) +
           cell(textOf("%.1f", row.ms())) + cell(textOf("%.2f", row.msFrame)) +
           cell(textOf("%.2f", row.msLeast) + "&#8211;" + textOf("%.2f", row.msGreatest)) +
           cell(std::to_string(row.hairsDrawn)) + cell(std::to_string(row.segmentsDrawn)) +
           cell(row.layers > 0 ? std::to_string(row.layers) : "&#8211;") +
           cell(textOf("%.1f", 1e-6 * static_cast<double>(row.bytes))) +
           error(row.drawing, references.drawing) + cell(textOf("%.3f", row.drawing.flip99)) +
           cell(textOf("%.3f", row.drawing.ssim)) +
           cell(coverage ? textOf("%.4f", coverage->areaRatio) : "&#8211;") +
           cell(coverage ? textOf("%.4f", coverage->silhouette) : "&#8211;") +
           error(row.light, references.light) + "</tr>\n";
}

std::string rowTable(const MeasuredEye& eye) {
    std::string html =
        "<table><tr><th colspan=\"9\"></th><th colspan=\"7\">drawing</th><th colspan=\"3\">light"
        "</th></tr>\n<tr><th>technique</th><th>value</th><th>ms</th><th>ms a frame</th>"
        "<th>least&#8211;most</th><th>hairs</th><th>segments</th><th>layers</th><th>MB</th>"
        "<th>RMSE</th><th>FLIP</th><th>bias, %</th><th>FLIP 99 "
        "%</th><th>SSIM</th><th>area</th><th>silhouette</th>"
        "<th>RMSE</th><th>FLIP</th><th>bias, %</th></tr>\n";
    const std::vector<bool> front = onFront(eye);
    for (std::size_t i = 0; i < eye.rows.size(); ++i)
        html += rowLine(eye, eye.rows[i], front[i],
                        i == 0 || eye.rows[i].technique != eye.rows[i - 1].technique);
    return html + "</table>\n";
}

// Which errors the noise of the reference leaves in doubt.
std::string doubts(const MeasuredEye& eye) {
    std::string names;
    for (const Measured& row : eye.rows) {
        const References& references = eye.referenceOf(row);
        for (const auto& [errors, reference, what] :
             {std::tuple(&row.drawing, &references.drawing, "drawing"),
              std::tuple(&row.light, &references.light, "light")})
            if (!(noiseShare(errors->rmse, *reference) <= kMostNoise))
                names += (names.empty() ? "" : ", ") + std::string(row.technique->name) + " " +
                         row.technique->values[row.value] + " (" + what + ")";
    }
    return "<p>Errors less than five times the noise of their reference: " +
           (names.empty() ? "none" : markupText(names)) + ".</p>\n";
}

std::string gallery(const MeasuredEye& eye) {
    const auto noiseText = [](const TracedPicture& traced) {
        return "noise " + textOf("%.4f", static_cast<double>(traced.noise.color));
    };
    std::string html;
    for (const References& references : eye.references) {
        const std::string hair =
            references.style ? std::string(", hair lit as ") + styleRow().choices[*references.style]
                             : "";
        html += figure(pictureTag(references.drawing.image, "reference"),
                       "reference" + hair + ", light of the live view; " +
                           noiseText(references.drawing)) +
                figure(pictureTag(references.light.image, "reference"),
                       "reference" + hair + ", traced light; " + noiseText(references.light));
    }
    html += "<br/>\n";
    for (const Measured& row : eye.rows) {
        const std::string name =
            std::string(row.technique->name) + " " + row.technique->values[row.value];
        html += figure(pictureTag(row.image, name) +
                           pictureTag(heatMap(row.drawing.flipMap), "FLIP of " + name),
                       name + ": " + textOf("%.1f", row.ms()) + " ms, FLIP " +
                           textOf("%.4f", row.drawing.flipMean));
    }
    return html;
}

std::string intro(const ReportHead& head, const Measurement& m) {
    return "<p class=\"small\">" + markupText(machineText(head, m)) + "<br/>" +
           std::to_string(m.triangles) + " triangles, " + std::to_string(m.hairs) + " hairs, " +
           (head.preset.empty() ? "" : "coat " + markupText(head.preset) + ", ") +
           std::to_string(m.size.x) + "&#215;" + std::to_string(m.size.y) +
           " pixels; references of " + std::to_string(m.spp) + " samples a pixel, seed " +
           std::to_string(m.seed) + "; at least " + std::to_string(m.repeat) +
           " frames timed for each row</p>\n<p>Every way to draw hair is held against a ray-traced "
           "picture of the same "
           "hairs at their true width. <b>Drawing</b> is the error against a reference that is lit "
           "as the live view lights it, <b>light</b> that against one whose shadows are traced. "
           "Each style is held against a reference whose hair is lit as that style lights it: thin "
           "lines by the normal of the skin or their own, ribbons and tubes as round. "
           "<b>ms</b> is the time of the picture whose error stands beside it: a frame at the "
           "median, times the frames that it averages. On yellow is the Pareto front of time and "
           "FLIP: nothing faster is as exact. An error with a question mark is less than five "
           "times the noise of its reference. Errors are taken over black.</p>\n";
}

}  // namespace

std::string reportPage(const ReportHead& head, const Measurement& measurement) {
    const std::string title = "Speed against error: " + markupText(head.model);
    std::string html =
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\"><head>"
        "<meta charset=\"utf-8\"/><title>" +
        title + "</title><style>" + kStyle + "</style></head><body>\n<h1>" + title + "</h1>\n" +
        intro(head, measurement);
    for (const MeasuredEye& eye : measurement.eyes) {
        html +=
            "<h2>" + markupText(eye.name) + "</h2>\n" + eyePlots(head, measurement, eye) +
            "<h3>How near each comes</h3>\n" + approachTable(eye) + "<h3>All figures</h3>\n" +
            rowTable(eye) + doubts(eye) +
            "<h3>Pictures, and where they differ (FLIP of drawing, black 0 to yellow 1)</h3>\n" +
            gallery(eye);
    }
    return html + "</body></html>\n";
}

}  // namespace pelage
