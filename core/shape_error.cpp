// shape_error.cpp -- hairs against exact ones, sampled at equal shares of their lengths.
#include "shape_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "coat.h"
#include "elastica.h"
#include "strand.h"

namespace pelage {
namespace {

using glm::dvec2;

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr int kSolverSteps = 512;
constexpr uint kFine = 512;   // chords that stand for a curve
constexpr int kBetween = 16;  // places looked at on each chord, at least

// A line through points, by the share of its length.
class Line {
public:
    explicit Line(std::vector<dvec2> points) : points_(std::move(points)), length_{0.0} {
        for (std::size_t i = 1; i < points_.size(); ++i)
            length_.push_back(length_.back() + glm::distance(points_[i - 1], points_[i]));
    }
    // Made as long as 1.
    dvec2 at(double share) const {
        const double wanted = share * length_.back();
        const auto next = std::upper_bound(length_.begin() + 1, length_.end() - 1, wanted);
        const auto i = static_cast<std::size_t>(next - length_.begin());
        const double f = (wanted - length_[i - 1]) / (length_[i] - length_[i - 1]);
        return glm::mix(points_[i - 1], points_[i], f) / length_.back();
    }

private:
    std::vector<dvec2> points_;
    std::vector<double> length_;  // up to each point
};

template <class Exact>
double farthest(const Line& line, uint chords, const Exact& exact) {
    const uint places = std::max(kFine, chords * kBetween);
    double worst = 0.0;
    for (uint i = 1; i <= places; ++i) {
        const double share = static_cast<double>(i) / places;
        worst = std::max(worst, glm::distance(line.at(share), exact(share)));
    }
    return worst;
}

// Points of a hair in the plane of up and its root's direction: level, and up.
Line lineOf(const Strand& hair, uint chords) {
    std::vector<dvec2> points;
    for (uint i = 0; i <= chords; ++i) {
        const vec3 p = strandPoint(hair, static_cast<float>(i) / static_cast<float>(chords));
        points.emplace_back(p.x, p.y);
    }
    return Line(std::move(points));
}

Line rodLine(double root, double load, uint chords) {
    const auto curve =
        rodCurve(rodColumn(static_cast<float>(root)), rodRow(static_cast<float>(load)));
    const Turn turn = turnOf(root);
    std::vector<dvec2> points;
    for (uint i = 0; i <= chords; ++i) {
        const dvec2 p(rodWeights(curve, static_cast<float>(i) / static_cast<float>(chords)));
        points.emplace_back(p.x * turn.sine + p.y * turn.cosine,
                            p.x * turn.cosine - p.y * turn.sine);
    }
    return Line(std::move(points));
}

// A hair of length 1 that leaves the skin along its normal, so far from up, and droops by the rule
// of the paper, like the rod of that load.
Strand paperHair(double root, double load) {
    float least = 0.0f, most = 1.0f;
    for (int i = 0; i < 30; ++i) {
        const float g = 0.5f * (least + most);
        (static_cast<double>(rodLoadLike(g)) < load ? least : most) = g;
    }
    Coat coat = defaultFur().over;
    coat.stiffness = 1.0f - most;
    coat.directionWeight = coat.endRandomness = 0.0f;
    const Turn turn = turnOf(root);
    // Combed across the plane, where the tie-break of the rule is not seen.
    const vec3 along(turn.sine, turn.cosine, 0.0), across(0.0f, 0.0f, 1.0f);
    return bendStrand(vec3(0.0f), along, across, 1.0f, coat, 1u, vec3(0.0f, -1.0f, 0.0f));
}

double fadedLoad(double root, double load) {
    return load * static_cast<double>(rodFade(static_cast<float>(root)));
}

// The exact rod, as a function of the share of its length.
auto exactRod(double root, double load) {
    return
        [rod = hangingRod(root, load, kSolverSteps)](double share) { return placeOn(rod, share); };
}

double segmentError(uint droop, double root, double load, uint segments) {
    if (droop == kDroopElastica) {
        const double faded = fadedLoad(root, load);
        return farthest(rodLine(root, faded, segments), segments, exactRod(root, faded));
    }
    const Strand hair = paperHair(root, load);
    const Line curve = lineOf(hair, 8 * kFine);
    return farthest(lineOf(hair, segments), segments,
                    [&](double share) { return curve.at(share); });
}

// The middle of a cell of the table, or what a hair looks up there at most.
ShapeError cellError(uint i, uint j) {
    constexpr double kCells = kRodNodes - 1;
    const double v = (i + 0.5) / kCells, most = kMostLoad;
    const auto loadAt = [&](double u) {
        const double y = u * most / (most + 10.0);
        return 10.0 * y / (1.0 - y);
    };
    ShapeError cell{ShapeError::Part::table,
                    kDroopElastica,
                    0,
                    v * std::sqrt(v) * 180.0 * kDegree,
                    loadAt((j + 0.5) / kCells),
                    0.0};
    const double greatest = fadedLoad(cell.root, most);
    cell.used = loadAt(j / kCells) <= greatest;
    if (cell.used) cell.load = std::min(cell.load, greatest);
    cell.error = tableShapeError(cell.root, cell.load);
    return cell;
}

}  // namespace

double paperShapeError(double root, double load) {
    return farthest(lineOf(paperHair(root, load), kFine), kFine, exactRod(root, load));
}

double tableShapeError(double root, double load) {
    return farthest(rodLine(root, load, kFine), kFine, exactRod(root, load));
}

std::vector<ShapeError> shapeErrors() {
    using Part = ShapeError::Part;
    std::vector<ShapeError> all;
    const double roots[] = {5, 15, 35, 55, 75, 95, 115, 135, 155, 175};
    const double loads[] = {0.5, 1, 2, 5, 7.84, 10, 15, 20, 50, 200, 1000};
    for (const double root : roots)
        for (const double load : loads) {
            all.push_back({Part::droop, kDroopPaper, 0, root * kDegree, load, 0.0});
            for (const uint segments : {1u, 2u, 4u, 7u, 8u, 16u, 32u})
                for (const uint droop : {kDroopPaper, kDroopElastica})
                    if (droop == kDroopElastica || load <= 10.0)  // the paper's rule ends at 11.4
                        all.push_back({Part::segments, droop, segments, root * kDegree, load, 0.0});
        }
    tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t i) {
        ShapeError& e = all[i];
        e.error = e.part == Part::droop ? paperShapeError(e.root, e.load)
                                        : segmentError(e.droop, e.root, e.load, e.segments);
    });
    constexpr uint kCells = kRodNodes - 1;
    std::vector<ShapeError> cells(kCells * kCells);
    tbb::parallel_for(0u, kCells, [&](uint i) {
        for (uint j = 0; j < kCells; ++j) cells[i * kCells + j] = cellError(i, j);
    });
    all.insert(all.end(), cells.begin(), cells.end());
    return all;
}

}  // namespace pelage
