// spacing.cpp -- medians of edges and hairs.
#include "spacing.h"

#include <algorithm>
#include <cstdio>

namespace pelage {
namespace {

constexpr std::size_t kSamples = 1 << 14;  // vertices that are looked at
constexpr float kVerticesPerHair = 10.0f;

std::size_t strideFor(std::size_t count) { return std::max<std::size_t>(1, count / kSamples); }

float median(std::vector<float>& values) {
    if (values.empty()) return 0.0f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

float medianSpacing(const Skin& skin) {
    std::vector<float> lengths;
    for (std::size_t v = 0; v < skin.vertices.size(); v += strideFor(skin.vertices.size()))
        for (const uint u : skin.ring(static_cast<uint>(v)))
            lengths.push_back(glm::distance(skin.vertices[v].position, skin.vertices[u].position));
    return median(lengths);
}

float spacingAt(const Skin& skin, uint v) {
    float sum = 0.0f;
    for (const uint u : skin.ring(v))
        sum += glm::distance(skin.vertices[v].position, skin.vertices[u].position);
    return skin.ring(v).empty() ? 0.0f : sum / static_cast<float>(skin.ring(v).size());
}

float medianHair(const Document& document) {
    const std::size_t count = document.groom.fur.size();
    std::vector<float> lengths;
    for (std::size_t v = 0; v < count; v += strideFor(count)) {
        const FurVertex& fur = document.groom.fur[v];
        if (!(fur.furLength > 0.0f && fur.density > 0.0f)) continue;
        lengths.push_back(furToWorld(*document.skin, static_cast<uint>(v), fur).furLength);
    }
    return median(lengths);
}

std::vector<std::string> spacingNotes(const Document& document) {
    std::vector<std::string> notes;
    char text[200];
    const float spacing = document.skin->spacing, hair = medianHair(document);
    if (hair > 0.0f && spacing > hair) {
        std::snprintf(
            text, sizeof text,
            "the mesh is coarse for its fur: vertices are %.3g m apart, hairs %.3g m long "
            "(medians); subdividing it makes that %.3g m",
            static_cast<double>(spacing), static_cast<double>(hair),
            static_cast<double>(0.5f * spacing));
        notes.emplace_back(text);
    }
    const std::size_t vertices = document.skin->vertices.size();
    const auto hairs = static_cast<float>(document.fur.hairs);
    if (hairs > 0.0f && static_cast<float>(vertices) > kVerticesPerHair * hairs) {
        std::snprintf(text, sizeof text,
                      "the mesh is denser than its fur needs: %zu vertices for %u hairs", vertices,
                      document.fur.hairs);
        notes.emplace_back(text);
    }
    return notes;
}

}  // namespace pelage
