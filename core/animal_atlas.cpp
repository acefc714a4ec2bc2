// animal_atlas.cpp -- the animal's skin laid flat: charts seen from six sides, packed into a
// square.
//
// Each chart is a connected piece of skin that faces one of the six directions, seen from there.
// A piece that would cover another piece of its own chart becomes a chart of its own, so no two
// triangles overlap, whatever the shape and the resolution.
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "animal_shape.h"

namespace pelage::animal {
namespace {

using Label = unsigned char;  // 2 * axis, + 1 for the negative direction
constexpr uint kNone = ~0u;
constexpr float kLeastFacing = 0.2f;  // cosine; no triangle is seen at a flatter angle
constexpr float kMargin = 3.0f / float(kPictureSize);  // around each chart, share of the side

float facing(vec3 normal, Label label) {
    const float along = normal[label / 2];
    return label % 2 == 0 ? along : -along;
}

Label mainLabel(vec3 n) {
    Label best = 0;
    for (Label label = 1; label < 6; ++label) {
        if (facing(n, label) > facing(n, best)) best = label;
    }
    return best;
}

// A point seen from the side of the label, m.
vec2 seen(vec3 p, Label label) {
    switch (label) {
        case 0:
            return {-p.z, -p.y};
        case 1:
            return {p.z, -p.y};
        case 2:
            return {p.x, p.z};
        case 3:
            return {p.x, -p.z};
        case 4:
            return {p.x, -p.y};
        default:
            return {-p.x, -p.y};
    }
}

std::vector<vec3> faceNormals(const Surface& surface) {
    std::vector<vec3> normals(surface.triangles.size());
    for (std::size_t t = 0; t < normals.size(); ++t) {
        const uvec3 c = surface.triangles[t];
        const vec3 n = glm::cross(surface.positions[c.y] - surface.positions[c.x],
                                  surface.positions[c.z] - surface.positions[c.x]);
        normals[t] = n / std::max(std::sqrt(glm::dot(n, n)), 1e-20f);
    }
    return normals;
}

// The triangles across the three edges of each triangle. Every edge has two.
std::vector<uvec3> neighbours(const std::vector<uvec3>& triangles) {
    struct Side {
        std::uint64_t edge;
        uint triangle, corner;
        bool operator<(const Side& o) const {
            return edge != o.edge ? edge < o.edge : triangle < o.triangle;
        }
    };
    std::vector<Side> sides;
    sides.reserve(triangles.size() * 3);
    for (uint t = 0; t < triangles.size(); ++t) {
        for (uint i = 0; i < 3; ++i) {
            const uint a = triangles[t][int(i)], b = triangles[t][int((i + 1) % 3)];
            sides.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), t, i});
        }
    }
    tbb::parallel_sort(sides.begin(), sides.end());
    std::vector<uvec3> across(triangles.size(), uvec3(kNone));
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        across[sides[i].triangle][int(sides[i].corner)] = sides[i + 1].triangle;
        across[sides[i + 1].triangle][int(sides[i + 1].corner)] = sides[i].triangle;
    }
    return across;
}

// A side for each triangle: the one it faces most, without frayed borders.
std::vector<Label> chooseSides(const std::vector<vec3>& normals, const std::vector<uvec3>& across) {
    constexpr int kRounds = 4;
    std::vector<Label> labels(normals.size());
    for (std::size_t t = 0; t < labels.size(); ++t) labels[t] = mainLabel(normals[t]);
    std::vector<Label> next = labels;
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t t = 0; t < labels.size(); ++t) {
            const Label a = labels[across[t].x], b = labels[across[t].y], c = labels[across[t].z];
            const Label most = a == b || a == c ? a : b == c ? b : labels[t];
            if (facing(normals[t], most) > kLeastFacing) next[t] = most;
        }
        labels = next;
    }
    return labels;
}

struct Chart {
    Label label = 0;
    std::vector<uint> triangles;   // of the surface
    vec2 lower{0.0f}, size{0.0f};  // m, seen from its side
    vec2 place{0.0f};              // m, in the atlas
};

// Connected pieces of one label, in the order of their first triangle.
std::vector<Chart> connectedPieces(const std::vector<Label>& labels,
                                   const std::vector<uvec3>& across) {
    std::vector<Chart> charts;
    std::vector<char> taken(labels.size(), 0);
    for (uint first = 0; first < labels.size(); ++first) {
        if (taken[first]) continue;
        Chart chart;
        chart.label = labels[first];
        chart.triangles.push_back(first);
        taken[first] = 1;
        for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
            for (int side = 0; side < 3; ++side) {
                const uint n = across[chart.triangles[i]][side];
                if (taken[n] || labels[n] != chart.label) continue;
                taken[n] = 1;
                chart.triangles.push_back(n);
            }
        }
        charts.push_back(std::move(chart));
    }
    return charts;
}

// Gives crumbs the side of a neighbour where they face it at all, so that charts are few.
void mergeCrumbs(std::vector<Label>& labels, const std::vector<vec3>& normals,
                 const std::vector<uvec3>& across) {
    const std::size_t crumb = 4 + labels.size() / 2000;
    for (const Chart& chart : connectedPieces(labels, across)) {
        if (chart.triangles.size() > crumb) continue;
        std::array<int, 6> votes{};
        for (const uint t : chart.triangles) {
            for (int side = 0; side < 3; ++side) ++votes[labels[across[t][side]]];
        }
        votes[chart.label] = 0;
        for (Label label = 0; label < 6; ++label) {
            for (const uint t : chart.triangles) {
                if (facing(normals[t], label) < kLeastFacing) votes[label] = 0;
            }
        }
        const auto best = std::max_element(votes.begin(), votes.end());
        if (*best == 0) continue;
        for (const uint t : chart.triangles) labels[t] = Label(best - votes.begin());
    }
}

using Corners = std::array<glm::dvec2, 3>;

// Whether two triangles share more than a rim of width `rim`.
bool overlap(const Corners& a, const Corners& b, double rim) {
    const auto apart = [rim](const Corners& p, const Corners& q) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 edge = p[(i + 1) % 3] - p[i];
            glm::dvec2 out(edge.y, -edge.x);
            const double length = std::sqrt(glm::dot(out, out));
            if (length < 1e-12) continue;
            out /= length;
            if (glm::dot(out, p[(i + 2) % 3] - p[i]) > 0.0) out = -out;
            double least = 1e9;
            for (const glm::dvec2& corner : q)
                least = std::min(least, glm::dot(out, corner - p[i]));
            if (least > -rim) return true;
        }
        return false;
    };
    return !apart(a, b) && !apart(b, a);
}

// Moves the triangles that would cover others out of the chart; returns them.
std::vector<uint> splitOverlaps(const Surface& surface, Chart& chart) {
    const auto cornersOf = [&](uint t) {
        Corners c;
        for (int i = 0; i < 3; ++i) {
            c[std::size_t(i)] =
                glm::dvec2(seen(surface.positions[surface.triangles[t][i]], chart.label));
        }
        return c;
    };
    glm::dvec2 lower(1e9), upper(-1e9);
    for (const uint t : chart.triangles) {
        for (const glm::dvec2& p : cornersOf(t)) {
            lower = glm::min(lower, p);
            upper = glm::max(upper, p);
        }
    }
    // A grid of buckets about as large as a triangle.
    const double cell = 0.8 * double(surface.cell);
    const int width = int((upper.x - lower.x) / cell) + 1;
    const int height = int((upper.y - lower.y) / cell) + 1;
    struct Entry {
        uint triangle, next;
    };
    std::vector<uint> head(std::size_t(width) * std::size_t(height), kNone);
    std::vector<Entry> entries;
    std::vector<uint> kept, moved;
    for (const uint t : chart.triangles) {
        const Corners c = cornersOf(t);
        const auto column = [&](double x) { return int((x - lower.x) / cell); };
        const auto row = [&](double y) { return int((y - lower.y) / cell); };
        const int x0 = column(std::min({c[0].x, c[1].x, c[2].x}));
        const int x1 = column(std::max({c[0].x, c[1].x, c[2].x}));
        const int y0 = row(std::min({c[0].y, c[1].y, c[2].y}));
        const int y1 = row(std::max({c[0].y, c[1].y, c[2].y}));
        bool free = true;
        for (int y = y0; y <= y1 && free; ++y) {
            for (int x = x0; x <= x1 && free; ++x) {
                const std::size_t bucket = std::size_t(y) * std::size_t(width) + std::size_t(x);
                for (uint e = head[bucket]; e != kNone && free; e = entries[e].next) {
                    free = !overlap(c, cornersOf(entries[e].triangle), 1e-3 * double(surface.cell));
                }
            }
        }
        (free ? kept : moved).push_back(t);
        if (!free) continue;
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                const std::size_t bucket = std::size_t(y) * std::size_t(width) + std::size_t(x);
                entries.push_back({t, head[bucket]});
                head[bucket] = uint(entries.size() - 1);
            }
        }
    }
    chart.triangles = std::move(kept);
    return moved;
}

// Charts that cover nothing twice.
std::vector<Chart> makeCharts(const Surface& surface) {
    const std::vector<vec3> normals = faceNormals(surface);
    const std::vector<uvec3> across = neighbours(surface.triangles);
    std::vector<Label> labels = chooseSides(normals, across);
    for (int round = 0; round < 3; ++round) mergeCrumbs(labels, normals, across);
    std::vector<Chart> pieces = connectedPieces(labels, across);
    std::vector<std::vector<Chart>> parts(pieces.size());
    tbb::parallel_for(std::size_t(0), pieces.size(), [&](std::size_t i) {
        Chart rest = std::move(pieces[i]);
        while (!rest.triangles.empty()) {
            Chart left{rest.label, splitOverlaps(surface, rest), {}, {}, {}};
            parts[i].push_back(std::move(rest));
            rest = std::move(left);
        }
    });
    std::vector<Chart> charts;
    for (auto& part : parts) std::move(part.begin(), part.end(), std::back_inserter(charts));
    for (Chart& chart : charts) {
        vec2 lower(1e9f), upper(-1e9f);
        for (const uint t : chart.triangles) {
            for (int i = 0; i < 3; ++i) {
                const vec2 p = seen(surface.positions[surface.triangles[t][i]], chart.label);
                lower = glm::min(lower, p);
                upper = glm::max(upper, p);
            }
        }
        chart.lower = lower;
        chart.size = upper - lower;
    }
    return charts;
}

// Puts the charts on shelves of the given width, the tallest first; returns the height, m.
float placeOnShelves(std::vector<Chart>& charts, const std::vector<uint>& order, float width,
                     float margin) {
    float x = 0.0f, y = 0.0f, shelf = 0.0f;
    for (const uint c : order) {
        const vec2 size = charts[c].size + vec2(2.0f * margin);
        if (x + size.x > width && x > 0.0f) {
            y += shelf;
            x = shelf = 0.0f;
        }
        charts[c].place = vec2(x, y) + vec2(margin);
        x += size.x;
        shelf = std::max(shelf, size.y);
    }
    return y + shelf;
}

// Packs the charts into a square; returns its side, m.
float pack(std::vector<Chart>& charts) {
    std::vector<uint> order(charts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint a, uint b) { return charts[a].size.y > charts[b].size.y; });
    float least = 0.0f, area = 0.0f;
    for (const Chart& chart : charts) {
        least = std::max(least, chart.size.x);
        area += chart.size.x * chart.size.y;
    }
    // The smallest square, by trying; a width in which the charts come out no taller than wide.
    float side = std::max(least * (1.0f + 3.0f * kMargin), std::sqrt(area));
    while (placeOnShelves(charts, order, side, kMargin * side) > side) side *= 1.01f;
    return side;
}

}  // namespace

Atlas unwrap(const Surface& surface) {
    std::vector<Chart> charts = makeCharts(surface);
    const float side = pack(charts);
    Atlas atlas;
    atlas.triangles.resize(surface.triangles.size());
    // Each chart has its own copy of a vertex.
    std::vector<uint> copy(surface.positions.size(), kNone), owner(surface.positions.size(), kNone);
    for (uint c = 0; c < charts.size(); ++c) {
        for (const uint t : charts[c].triangles) {
            for (int i = 0; i < 3; ++i) {
                const uint v = surface.triangles[t][i];
                if (owner[v] != c) {
                    owner[v] = c;
                    copy[v] = uint(atlas.uvs.size());
                    const vec2 p = seen(surface.positions[v], charts[c].label);
                    const vec2 uv = (p - charts[c].lower + charts[c].place) / side;
                    atlas.uvs.push_back(glm::clamp(uv, vec2(0.0f), vec2(1.0f)));
                    atlas.vertexOf.push_back(v);
                }
                atlas.triangles[t][i] = copy[v];
            }
        }
    }
    return atlas;
}

}  // namespace pelage::animal
