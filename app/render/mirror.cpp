// mirror.cpp -- what differs from the last upload goes to the GPU, nothing else.
#include "app/render/mirror.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <iterator>
#include <utility>

#include "app/render/base_colors.h"
#include "app/render/frame_data.h"
#include "core/clumps.h"

namespace pelage {
namespace {

std::vector<Mirror::Part> partsOf(const Source& source, const BaseColors& colors) {
    const std::size_t white = source.materials.size();  // see makeBaseColors
    std::vector<Mirror::Part> parts;
    for (const SourcePart& part : source.parts) {
        const std::size_t material =
            part.material < 0 ? white : static_cast<std::size_t>(part.material);
        parts.push_back({part.firstTriangle, part.triangleCount, static_cast<uint>(material),
                         colors.materials[material].layer});
    }
    return parts;
}

std::vector<uvec3> inOrder(const std::vector<uvec3>& triangles, const std::vector<uint>& order) {
    std::vector<uvec3> sorted;
    sorted.reserve(order.size());
    for (const uint t : order) sorted.push_back(triangles[t]);
    return sorted;
}

std::vector<glm::uvec4> trianglesWithMaterial(const Skin& skin,
                                              const std::vector<Mirror::Part>& parts) {
    std::vector<glm::uvec4> triangles(skin.triangles.size());
    for (const Mirror::Part& part : parts)
        for (std::size_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
            triangles[t] = glm::uvec4(skin.triangles[t], part.material);
    return triangles;
}

std::vector<CornerData> cornersOf(const Skin& skin) {
    const Source& source = *skin.source;
    std::vector<CornerData> corners(source.positions.size());
    for (std::size_t v = 0; v < corners.size(); ++v) {
        if (!source.uvs.empty()) corners[v].uv = source.uvs[v];
        if (!source.colors.empty()) corners[v].color = glm::packUnorm4x8(source.colors[v]);
        corners[v].skinVertex = skin.weld[v];
    }
    return corners;
}

template <typename T>
std::span<const T> view(const std::vector<T>& values) {
    return values;
}

// Calls upload(c, first, chunk) for the chunks that are not those of `before`, all of them where
// `all` says so; their number.
template <typename T, typename Upload>
std::size_t eachNewChunk(const Chunked<T>& now, const Chunked<T>& before, bool all,
                         const Upload& upload) {
    std::size_t first = 0, count = 0;
    for (std::size_t c = 0; c < now.chunkCount(); ++c) {
        const auto chunk = now.chunk(c);
        if (all || !now.sharesChunk(before, c)) {
            upload(c, first, chunk);
            ++count;
        }
        first += chunk.size();
    }
    return count;
}

template <typename T>
std::size_t uploadChunks(gl::Buffer& buffer, const Chunked<T>& now, const Chunked<T>& before,
                         bool all) {
    return eachNewChunk(now, before, all, [&](std::size_t, std::size_t first, auto chunk) {
        buffer.write(first * sizeof(T), chunk);
    });
}

}  // namespace

void Mirror::uploadSkin(const Skin& skin) {
    const Source& source = *skin.source;
    BaseColors colors = makeBaseColors(source);
    baseColors_ = std::move(colors.texture);
    materials_.upload(view(colors.materials));
    parts_ = partsOf(source, colors);
    fine_.patches = makePatches(skin);
    fine_.upload(inOrder(source.triangles, fine_.patches.order));
    coarse_.clear();
    making_.reset();
    triangles_.upload(view(trianglesWithMaterial(skin, parts_)));
    sourceTriangles_.upload(view(source.triangles));
    corners_.upload(view(cornersOf(skin)));
    furVertices_.resize(skin.vertices.size() * sizeof(FurVertex));
    mask_.resize(skin.vertices.size() * sizeof(float));
    segmentOf_.resize(skin.vertices.size() * sizeof(uint));
    textured_ = !source.uvs.empty() || !source.colors.empty();
}

void Mirror::uploadGroom(const Groom& groom, bool newSkin, bool newPose) {
    longestOfChunk_.resize(groom.fur.chunkCount());
    std::vector<FurVertex> inWorld;
    chunksUploaded_ += eachNewChunk(
        groom.fur, groom_.fur, newPose, [&](std::size_t c, std::size_t first, auto chunk) {
            inWorld.clear();
            longestOfChunk_[c] = 0.0f;
            for (std::size_t i = 0; i < chunk.size(); ++i) {
                inWorld.push_back(furToWorld(*shown_, static_cast<uint>(first + i), chunk[i]));
                longestOfChunk_[c] = std::max(longestOfChunk_[c], inWorld.back().furLength);
            }
            furVertices_.write(first * sizeof(FurVertex), view(inWorld));
        });
    chunksUploaded_ += uploadChunks(mask_, groom.mask, groom_.mask, newSkin);
    chunksUploaded_ += uploadChunks(segmentOf_, groom.segmentOf, groom_.segmentOf, newSkin);
    groom_ = groom;
}

void Mirror::findChunks() {
    chunksOf_.clear();
    for (const Cluster& cluster : roots_.clusters) {
        uint first = ~0u, last = 0;
        for (uint t = 0; t < cluster.triangleCount; ++t) {
            const uvec3 corners = skin_->triangles[skin_->spatialOrder[cluster.firstTriangle + t]];
            first = std::min({first, corners.x, corners.y, corners.z});
            last = std::max({last, corners.x, corners.y, corners.z});
        }
        chunksOf_.push_back(uvec2(first, last) / static_cast<uint>(groom_.fur.kChunkSize));
    }
}

void Mirror::updateTufts(const std::vector<bool>& newChunks) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tufts_.size(), 64), [&](const auto& range) {
            for (std::size_t c = range.begin(); c < range.end(); ++c) {
                const auto begin = newChunks.begin();
                const uvec2 chunks = chunksOf_[c];
                if (std::find(begin + chunks.x, begin + chunks.y + 1, true) != begin + chunks.y + 1)
                    tufts_[c] = tuftOf(roots_.clusters[c], *shown_, groom_.fur, fur_);
            }
        });
}

bool Mirror::update(const Document& document, const std::shared_ptr<const Skin>& posed) {
    const std::shared_ptr<const Skin>& shown = posed ? posed : document.skin;
    const bool newSkin = document.skin != skin_;
    const bool newPose = shown != shown_;
    const bool newGroom = newPose || !(document.groom == groom_);
    const bool newFur = newSkin || !(document.fur == fur_);
    chunksUploaded_ = 0;
    if (newSkin) {
        uploadSkin(*document.skin);
        skin_ = document.skin;
    }
    if (newPose) {
        skinVertices_.upload(view(shown->vertices));
        shown_ = shown;
    }
    if (newSkin || newPose) boundPatches(fine_.patches, *shown);
    const bool newRoots =
        newSkin || document.fur.hairs != fur_.hairs || document.fur.seed != fur_.seed;
    std::vector<bool> newChunks(document.groom.fur.chunkCount());
    for (std::size_t c = 0; c < newChunks.size(); ++c)
        newChunks[c] = newPose || newRoots || !document.groom.fur.sharesChunk(groom_.fur, c);
    if (newGroom) uploadGroom(document.groom, newSkin, newPose);
    if (newRoots) roots_ = scatterRoots(*document.skin, document.fur.hairs, document.fur.seed);
    const bool newGuides = newRoots || guidesDiffer(document.fur, fur_);
    if (newGuides) {
        assignGuides(roots_, *document.skin, document.fur);
        rootBuffer_.upload(view(roots_.roots));
    }
    // Roots are scattered with bounds at rest.
    if (newRoots ? shown_ != skin_ : newPose) boundClusters(roots_, *shown_);
    if (newRoots) {
        findChunks();
        tufts_.assign(roots_.clusters.size(), Tuft{});
    }
    if (newFur) {
        if (!combsAlike(document.fur, fur_)) newChunks.assign(newChunks.size(), true);
        fur_ = document.fur;
        furBlock_.upload(std::span<const Fur>(&fur_, 1));
    }
    if (newFur || newGroom) updateTufts(newChunks);
    return newGroom || newFur;
}

void Mirror::bind() const {
    skinVertices_.bindStorage(binding::skinVertices);
    furVertices_.bindStorage(binding::furVertices);
    triangles_.bindStorage(binding::triangles);
    sourceTriangles_.bindStorage(binding::sourceTriangles);
    corners_.bindStorage(binding::corners);
    materials_.bindStorage(binding::materials);
    mask_.bindStorage(binding::mask);
    segmentOf_.bindStorage(binding::segmentOf);
    rootBuffer_.bindStorage(binding::roots);
    furBlock_.bindUniform(binding::fur);
    glBindTextureUnit(binding::baseColors, baseColors_.name());
}

void Mirror::Surface::upload(const std::vector<uvec3>& triangles) {
    indices.upload(view(triangles));
    rows = gl::makeTexture(indices, GL_R32UI);
}

void Mirror::keep(int level, SkinLevel made) {
    Surface& surface = coarse_[level];
    surface.patches = std::move(made.patches);
    surface.upload(made.triangles);
}

const Mirror::Surface& Mirror::surface(const Sight& sight, float deviation, bool waits) {
    return surfaceOf(shown_ == skin_ ? levelWithin(*skin_, sight, deviation) : kNoLevel, waits);
}

const Mirror::Surface& Mirror::surfaceWithin(float error, bool waits) {
    return surfaceOf(levelWithin(*skin_, error), waits);
}

const Mirror::Surface& Mirror::surfaceOf(int wanted, bool waits) {
    if (wanted == kNoLevel) return fine_;
    if (making_ && (making_->ready() || (waits && making_->level() == wanted))) {
        const auto made = std::exchange(making_, nullptr);
        keep(made->level(), made->take());
    }
    if (waits && !coarse_.contains(wanted)) keep(wanted, makeSkinLevel(*skin_, wanted));
    if (!making_ && !coarse_.contains(wanted)) making_ = std::make_unique<LevelTask>(skin_, wanted);
    const auto coarser = coarse_.upper_bound(wanted);
    return coarser == coarse_.begin() ? fine_ : std::prev(coarser)->second;
}

float Mirror::longestHair() const {
    float longest = 0.0f;
    for (const float ofChunk : longestOfChunk_) longest = std::max(longest, ofChunk);
    return longest;
}

float Mirror::usualHair() const {
    std::vector<float> lengths = longestOfChunk_;
    if (lengths.empty()) return 0.0f;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    return *middle;
}

std::size_t Mirror::bytes() const {
    std::size_t coarse = 0;
    for (const auto& [level, surface] : coarse_) coarse += surface.indices.bytes();
    return coarse + skinVertices_.bytes() + furVertices_.bytes() + triangles_.bytes() +
           sourceTriangles_.bytes() + fine_.indices.bytes() + corners_.bytes() + mask_.bytes() +
           segmentOf_.bytes() + rootBuffer_.bytes();
}

}  // namespace pelage
