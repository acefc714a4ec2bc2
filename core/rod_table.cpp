// rod_table.cpp -- the table of heavy elastic rods: the best polynomial for each root and load.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "elastica.h"

namespace pelage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kUpright = 1e-6;  // rad; the rod of exactly 0 may fall to either side
constexpr int kSteps = 256;        // of the solver
constexpr std::size_t kDegree = 6;
constexpr std::size_t kSamples = 48;  // that a polynomial is fitted to

// The polynomial has its points closer where a soft rod bends most, near its root:
// s = t / (t + spread (1 - t)).
double spreadOf(double load) {
    const double root = std::sqrt(load);
    return 1.0 + 0.3 * root / (1.0 + 0.04 * root);
}

// Places of the samples in t, closer towards the ends, as a polynomial needs them. No cosine, for
// the sake of the same bits everywhere.
double sampleAt(std::size_t i) {
    const double x = static_cast<double>(i) / (kSamples - 1);
    return x * x * (3.0 - 2.0 * x);
}

using Weights = std::array<double, kDegree>;  // of t, t^2, ...

Weights powersOf(double t) {
    Weights powers;
    double power = 1.0;
    for (double& value : powers) value = power *= t;
    return powers;
}

// For each sample by how much it adds to each coefficient, in the sense of least squares, of a
// polynomial whose coefficients before `first` are 0: (A^T A)^-1 A^T by elimination.
std::array<Weights, kSamples> fitterOf(std::size_t first) {
    std::array<std::array<double, kDegree + kSamples>, kDegree> rows{};
    for (std::size_t i = 0; i < kSamples; ++i) {
        const Weights powers = powersOf(sampleAt(i));
        for (std::size_t a = first; a < kDegree; ++a) {
            rows[a][kDegree + i] = powers[a];
            for (std::size_t b = first; b < kDegree; ++b) rows[a][b] += powers[a] * powers[b];
        }
    }
    for (std::size_t pivot = first; pivot < kDegree; ++pivot) {
        const double inverse = 1.0 / rows[pivot][pivot];
        for (double& value : rows[pivot]) value *= inverse;
        for (std::size_t other = first; other < kDegree; ++other) {
            if (other == pivot) continue;
            const double factor = rows[other][pivot];
            for (std::size_t k = 0; k < rows[other].size(); ++k)
                rows[other][k] -= factor * rows[pivot][k];
        }
    }
    std::array<Weights, kSamples> fitter{};
    for (std::size_t i = 0; i < kSamples; ++i)
        for (std::size_t a = 0; a < kDegree; ++a) fitter[i][a] = rows[a][kDegree + i];
    return fitter;
}

// The curve of a rod in coordinates along its root and across, as polynomials.
struct Curve {
    Weights along{}, across{};
};

Curve curveOf(const Rod& rod, double spread) {
    static const auto alongFitter = fitterOf(0), acrossFitter = fitterOf(1);
    const glm::dvec2 root = rod.tangent[0];
    Curve curve;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const double t = sampleAt(i);
        const glm::dvec2 p = placeOn(rod, t / (t + spread * (1.0 - t)));
        for (std::size_t k = 0; k < kDegree; ++k) {
            curve.along[k] += alongFitter[i][k] * glm::dot(p, root);
            curve.across[k] += acrossFitter[i][k] * (p.x * root.y - p.y * root.x);
        }
    }
    return curve;
}

// The greatest curvature over t, of the curve as it is drawn with even steps of t: what its chords
// miss. |p' x p''| / |p'|.
double bendOf(const Curve& curve) {
    double greatest = 0.0;
    for (int i = 0; i <= 64; ++i) {
        const double t = i / 64.0;
        glm::dvec2 first(0.0), second(0.0);
        double power = 1.0, before = 0.0;  // t^(k-1), t^(k-2)
        for (std::size_t k = 1; k <= kDegree; ++k) {
            const glm::dvec2 c(curve.along[k - 1], curve.across[k - 1]);
            const double n = static_cast<double>(k);
            first += n * power * c;
            second += n * (n - 1.0) * before * c;
            before = power;
            power *= t;
        }
        greatest = std::max(greatest,
                            std::abs(first.x * second.y - first.y * second.x) / glm::length(first));
    }
    return greatest;
}

double sum(const Weights& weights) {
    double total = 0.0;
    for (const double w : weights) total += w;
    return total;
}

using Column = std::array<Curve, kRodNodes>;  // one root, all loads

// The row, [0,1], at which the tip reaches the direction so far from that of the root.
double contactRow(const Column& column, double angle) {
    const Turn limit = turnOf(angle);
    const auto beyond = [&](std::size_t j) {
        return sum(column[j].across) * limit.cosine - sum(column[j].along) * limit.sine;
    };
    for (std::size_t j = 1; j < kRodNodes; ++j) {
        const double before = beyond(j - 1), here = beyond(j);
        if (here < 0.0) continue;
        const double f = here > before ? -before / (here - before) : 0.0;
        return (static_cast<double>(j - 1) + std::clamp(f, 0.0, 1.0)) / (kRodNodes - 1);
    }
    return 1.0;
}

// Column i of the table: its texels, as rod.glsl reads them.
void fillColumn(std::size_t i, std::span<vec4> texels) {
    const double v = static_cast<double>(i) / (kRodNodes - 1);
    const double root = std::max(kPi * v * std::sqrt(v), kUpright);
    Column column;
    for (std::size_t j = 0; j < kRodNodes; ++j) {
        const double u = static_cast<double>(j) / (kRodNodes - 1);
        const double y = u * kMostLoad / (kMostLoad + 10.0);
        const double load = 10.0 * y / (1.0 - y);
        column[j] = curveOf(hangingRod(std::min(root, kPi), load, kSteps), spreadOf(load));
    }
    for (std::size_t j = 0; j < kRodNodes; ++j) {
        const double share = static_cast<double>(j) / (kRodNodes - 1);
        const bool free = i + 1 == kRodNodes || j + 1 == kRodNodes;
        const double contact = free ? 1.0 : contactRow(column, share * (kPi - root));
        const Curve& curve = column[j];
        for (std::size_t k = 0; k < 3; ++k)
            texels[kRodTexels * j + k] = vec4(curve.along[2 * k], curve.across[2 * k],
                                              curve.along[2 * k + 1], curve.across[2 * k + 1]);
        texels[kRodTexels * j + 3] = vec4(bendOf(curve), contact, 0.0, 0.0);
    }
}

std::vector<vec4> makeRodTable() {
    std::vector<vec4> table(kRodNodes * kRodNodes * kRodTexels);
    // Isolated: a thread that waits here must not take up work that asks for the table.
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t(0), std::size_t(kRodNodes), [&](std::size_t i) {
            fillColumn(
                i, std::span(table).subspan(i * kRodNodes * kRodTexels, kRodNodes * kRodTexels));
        });
    });
    return table;
}

}  // namespace

const vec4* rodTable() {
    static const std::vector<vec4> table = makeRodTable();
    return table.data();
}

}  // namespace pelage
