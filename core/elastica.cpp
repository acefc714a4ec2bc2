// elastica.cpp -- the heavy elastic rod, by Numerov's method.
#include "elastica.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMostIterations = 60;
constexpr double kLongestStep = 0.7;  // rad; longer ones overshoot where the rod buckles

// The second derivative of theta, and how it changes with theta, at each node.
struct Bend {
    std::vector<double> value, slope;

    Bend(const std::vector<double>& angle, double load) {
        const double n = static_cast<double>(angle.size() - 1);
        for (std::size_t i = 0; i < angle.size(); ++i) {
            const Turn turn = turnOf(angle[i]);
            const double weight = -load * (1.0 - static_cast<double>(i) / n);
            value.push_back(weight * turn.sine);
            slope.push_back(weight * turn.cosine);
        }
    }
};

// One step of Newton's method; returns the largest correction. Forward elimination and
// substitution of the tridiagonal system, row by row.
double improve(std::vector<double>& angle, double load) {
    const std::size_t n = angle.size() - 1;
    const double h = 1.0 / static_cast<double>(n), twelfth = h * h / 12.0;
    const Bend bend(angle, load);
    std::vector<double> above(n + 1, 0.0), right(n + 1, 0.0);
    for (std::size_t i = 1; i < n; ++i) {
        const double lower = 1.0 - twelfth * bend.slope[i - 1];
        const double residual =
            angle[i + 1] - 2.0 * angle[i] + angle[i - 1] -
            twelfth * (bend.value[i + 1] + 10.0 * bend.value[i] + bend.value[i - 1]);
        const double pivot = -2.0 - 10.0 * twelfth * bend.slope[i] - lower * above[i - 1];
        above[i] = (1.0 - twelfth * bend.slope[i + 1]) / pivot;
        right[i] = (-residual - lower * right[i - 1]) / pivot;
    }
    // At the free end two derivatives of theta are 0 and the third is load * sin(theta).
    const Turn tip = turnOf(angle[n]);
    const double sixth = h * h * h * load / 6.0;
    const double residual = angle[n - 1] - angle[n] + sixth * tip.sine;
    double step = (-residual - right[n - 1]) / (-1.0 + sixth * tip.cosine - above[n - 1]);
    double largest = 0.0;
    for (std::size_t i = n; i >= 1; --i) {
        if (i < n) step = right[i] - above[i] * step;
        angle[i] += std::clamp(step, -kLongestStep, kLongestStep);
        largest = std::max(largest, std::abs(step));
    }
    return largest;
}

// d theta / ds, of the order of Numerov's method.
std::vector<double> curvatures(const std::vector<double>& angle, double load) {
    const std::size_t n = angle.size() - 1;
    const double h = 1.0 / static_cast<double>(n);
    const Bend bend(angle, load);
    std::vector<double> slope(n + 1, 0.0);
    slope[0] = (angle[1] - angle[0]) / h - h / 6.0 * (2.0 * bend.value[0] + bend.value[1]);
    for (std::size_t i = 1; i < n; ++i)
        slope[i] = (angle[i + 1] - angle[i - 1]) / (2.0 * h) -
                   h / 12.0 * (bend.value[i + 1] - bend.value[i - 1]);
    return slope;
}

// Trapezoids, with the first term of Euler and Maclaurin for their error.
void integrate(Rod& rod) {
    const std::size_t n = rod.angle.size() - 1;
    const double h = 1.0 / static_cast<double>(n);
    for (const double angle : rod.angle) {
        const Turn turn = turnOf(angle);
        rod.tangent.emplace_back(turn.sine, turn.cosine);
    }
    const auto turning = [&](std::size_t i) {
        return rod.curvature[i] * glm::dvec2(rod.tangent[i].y, -rod.tangent[i].x);
    };
    glm::dvec2 sum(0.0);
    rod.place.push_back(sum);
    for (std::size_t i = 1; i <= n; ++i) {
        sum += 0.5 * h * (rod.tangent[i - 1] + rod.tangent[i]);
        rod.place.push_back(sum + h * h / 12.0 * (turning(0) - turning(i)));
    }
}

}  // namespace

// Series, because libraries differ in the last bit.
Turn turnOf(double angle) {
    const double quarter = std::round(angle * (2.0 / kPi));
    const double x = angle - quarter * (0.5 * kPi), z = x * x;
    double sine = 0.0, cosine = 0.0;
    for (int k = 8; k >= 0; --k) {
        sine = 1.0 - sine * z / ((2 * k + 2) * (2 * k + 3));
        cosine = 1.0 - cosine * z / ((2 * k + 1) * (2 * k + 2));
    }
    sine *= x;
    switch (static_cast<int>(quarter) & 3) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

Rod hangingRod(double root, double load, int steps) {
    assert(root > 0.0 && root <= kPi && load >= 0.0 && load <= 1e4 && steps >= 8);
    Rod rod;
    rod.angle.assign(static_cast<std::size_t>(steps) + 1, kPi);
    rod.angle[0] = root;
    for (int i = 0; i < kMostIterations && improve(rod.angle, load) > 1e-13; ++i) {
    }
    rod.curvature = curvatures(rod.angle, load);
    integrate(rod);
    return rod;
}

glm::dvec2 placeOn(const Rod& rod, double s) {
    const double n = static_cast<double>(rod.place.size() - 1);
    const double node = std::clamp(std::floor(s * n), 0.0, n - 1.0), f = s * n - node;
    const auto i = static_cast<std::size_t>(node);
    const double back = 1.0 - f;
    return back * back * (1.0 + 2.0 * f) * rod.place[i] +
           f * f * (1.0 + 2.0 * back) * rod.place[i + 1] +
           f * back / n * (back * rod.tangent[i] - f * rod.tangent[i + 1]);
}

}  // namespace pelage
