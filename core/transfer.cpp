// transfer.cpp -- asks the nearest point of every vertex for its fur.
#include "transfer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>

#include "pick.h"
#include "skin_query.h"
#include "tools.h"

namespace pelage {
namespace {

constexpr float kSideShare = 0.01f;  // of the size: how much thicker than this an ear is counts

// Turned by the smallest rotation that takes `from` to `to`, both unit or zero; where they are
// opposite, mirrored.
vec3 turned(vec3 d, vec3 from, vec3 to) {
    const float cosine = glm::dot(from, to);
    if (from == vec3(0.0f) || to == vec3(0.0f)) return d;
    if (cosine < -0.9999f) return d - 2.0f * glm::dot(d, from) * from;
    const vec3 axis = glm::cross(from, to);
    return cosine * d + glm::cross(axis, d) + axis * (glm::dot(axis, d) / (1.0f + cosine));
}

// The nearest point, of several layers that are about as near the one that faces as the vertex
// does.
std::optional<SkinHit> nearestSide(const SkinQuery& query, const SkinVertex& vertex) {
    const std::optional<SkinHit> any = query.nearest(vertex.position);
    const std::optional<SkinHit> facing = query.nearest(vertex.position, vertex.normal);
    const float slack = kSideShare * query.skin().size();
    return facing && facing->distance <= any->distance + slack ? facing : any;
}

// The fur of `from` at a point of its skin, in the world, for skin with the normal `to`.
FurVertex furAt(const Document& from, const SkinHit& hit, vec3 to) {
    const Skin& skin = *from.skin;
    const uvec3 corners = skin.triangles[hit.triangle];
    const float weights[] = {1.0f - hit.u - hit.v, hit.u, hit.v};
    FurVertex sum = pickedAt(skin, from.groom, hit).fur;
    vec3 normal(0.0f);
    for (int k = 0; k < 3; ++k) normal += weights[k] * skin.vertices[corners[k]].normal;
    const float length = glm::length(normal);
    sum.direction = turned(sum.direction, length > 1e-6f ? normal / length : hit.normal, to);
    // What rounding may have added.
    sum.furLength = std::max(sum.furLength, 0.0f);
    sum.tint = glm::clamp(sum.tint, 0.0f, 1.0f);
    sum.density = std::clamp(sum.density, 0.0f, 1.0f);
    return sum;
}

}  // namespace

Transferred transferred(const Document& from, const Document& onto, Progress* progress) {
    const SkinQuery query(from.skin);
    const Skin& skin = *onto.skin;
    std::vector<FurVertex> fur(skin.vertices.size());
    std::vector<float> away(fur.size(), 0.0f);
    constexpr std::size_t kRun = 1 << 14;
    for (std::size_t first = 0; first < fur.size(); first += kRun) {
        if (progress) progress->report(static_cast<float>(first) / static_cast<float>(fur.size()));
        tbb::parallel_for(first, std::min(first + kRun, fur.size()), [&](std::size_t i) {
            const auto v = static_cast<uint>(i);
            const SkinVertex& vertex = skin.vertices[v];
            const std::optional<SkinHit> hit = nearestSide(query, vertex);
            if (!hit) return;
            away[v] = hit->distance;
            fur[v] = furToMesh(skin, v, furAt(from, *hit, vertex.normal));
            fur[v].direction = shortened(fur[v].direction);
        });
    }
    Transferred out{onto, 0, 0.0f};
    out.document.fur = from.fur;
    for (std::size_t v = 0; v < fur.size(); ++v) {
        out.document.groom.fur.edit(v) = fur[v];
        out.far += away[v] > kFarShare * skin.size();
        out.farthest = std::max(out.farthest, away[v]);
    }
    return out;
}

std::string farNote(const Transferred& transfer) {
    if (transfer.far == 0) return {};
    char text[160];
    std::snprintf(text, sizeof text,
                  "%zu of %zu vertices are farther than %.0f %% of the size from the groomed "
                  "surface, the farthest %.3g m",
                  transfer.far, transfer.document.groom.fur.size(),
                  100.0 * static_cast<double>(kFarShare), static_cast<double>(transfer.farthest));
    return text;
}

}  // namespace pelage
