// reference_scene.cpp -- a document made ready for rays.
#include "reference_scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "clumps.h"
#include "strand.h"

namespace pelage {
namespace {

constexpr uint kMostSegments = 64;  // of growCurves
// What a segment needs at the peak, in curves and in the hierarchy that is made from them: 91 were
// measured.
constexpr std::size_t kBytesPerSegment = 100;

// Segments whose chords stay within a hundredth of the size of what they follow.
uint segmentsOf(const Fur& fur) {
    float most = 16.0f;
    for (const Coat& coat : {fur.over, fur.under}) {
        if (coat.curlRadius > 0.0f) most = std::max(most, 20.0f * coat.curlTurns);
        if (coat.frizz > 0.0f) most = std::max(most, 8.0f * coat.frizzWaves);
    }
    return static_cast<uint>(std::min(std::ceil(most), static_cast<float>(kMostSegments)));
}

Document standing(Document document, const std::shared_ptr<const Skin>& posed) {
    if (posed) document.skin = posed;
    document.fur.over.style = document.fur.under.style = kStylePolyline;
    return document;
}

Roots rootsOf(const Document& document) {
    Roots roots = scatterRoots(*document.skin, document.fur.hairs, document.fur.seed);
    assignGuides(roots, *document.skin, document.fur);
    return roots;
}

std::string gigabytes(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GB", static_cast<double>(bytes) * 1e-9);
    return text;
}

void requireMemory(std::size_t hairs, uint segments, std::size_t allowed) {
    const std::size_t needed = hairs * segments * kBytesPerSegment;
    if (needed <= allowed) return;
    throw std::runtime_error(std::to_string(hairs) + " hairs of " + std::to_string(segments) +
                             " segments need about " + gigabytes(needed) + " of memory, " +
                             gigabytes(allowed) + " are allowed: take fewer hairs or segments");
}

// Keeps the hairs of the coats that are wanted.
void leaveCoats(Curves& curves, const Growth& growth, bool over, bool under) {
    if (over && under) return;
    std::size_t kept = 0;
    for (std::size_t h = 0; h < curves.root.size(); ++h) {
        const Root& root = growth.roots.roots[curves.root[h]];
        if (!(isOvercoat(root.id, growth.fur.share) ? over : under)) continue;
        curves.root[kept] = curves.root[h];
        curves.rootWidth[kept] = curves.rootWidth[h];
        const auto points = static_cast<std::ptrdiff_t>(curves.pointsPerHair);
        std::copy_n(curves.points.begin() + points * static_cast<std::ptrdiff_t>(h), points,
                    curves.points.begin() + points * static_cast<std::ptrdiff_t>(kept));
        ++kept;
    }
    curves.root.resize(kept);
    curves.rootWidth.resize(kept);
    curves.points.resize(kept * curves.pointsPerHair);
}

}  // namespace

TracedDocument::TracedDocument(const Document& original, const ReferenceOptions& options,
                               Progress* progress)
    : document(standing(original, options.posed)),
      overStyle(original.fur.over.style),
      underStyle(original.fur.under.style),
      // Where hairs are rooted and what they gather to is decided on the skin at rest.
      roots(rootsOf(original)),
      growth(growthOf(document, roots, options.seconds)),
      colors(*document.skin),
      segments(options.segments > 0 ? std::min(options.segments, kMostSegments)
                                    : segmentsOf(document.fur)) {
    if (progress) progress->report(0.2f);
    requireMemory(roots.roots.size(), segments, options.memory);
    Curves curves = growCurves(growth, segments);
    leaveCoats(curves, growth, options.over, options.under);
    if (progress) progress->report(0.4f);

    const Fur& fur = document.fur;
    std::vector<float> tapers;
    tapers.reserve(curves.root.size());
    for (const uint root : curves.root)
        tapers.push_back(isOvercoat(roots.roots[root].id, fur.share) ? fur.over.taper
                                                                     : fur.under.taper);
    rays = std::make_unique<RayScene>(options.skin ? document.skin : nullptr, curves, tapers,
                                      progress);
    rootOf = std::move(curves.root);
    if (progress) progress->report(1.0f);
}

float TracedDocument::hairsPerArea() const {
    const double area = document.skin->area;
    return area > 0.0 ? static_cast<float>(document.fur.hairs / area) : 0.0f;
}

ReferenceScene::ReferenceScene(const Document& document, const ReferenceOptions& options,
                               Progress* progress)
    : traced_(std::make_unique<const TracedDocument>(document, options, progress)) {}

ReferenceScene::~ReferenceScene() = default;

std::size_t ReferenceScene::hairs() const { return traced_->rootOf.size(); }

uint ReferenceScene::segments() const { return traced_->segments; }

std::size_t ReferenceScene::bytes() const { return traced_->rays->bytes(); }

}  // namespace pelage
