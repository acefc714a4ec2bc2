// elastica_test.cpp -- the rod's equation against another integrator and against known figures.
#include "core/elastica.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/figures.h"

namespace pelage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

// All rods are parts of one family: with tau = load^(1/3) (1 - s), measured from the tip, the angle
// psi = pi - theta from "down" obeys psi'' = tau sin psi, psi' = 0 at the tip. Runge and Kutta's
// method from the tip to the root; psi at `nodes` + 1 places from root to tip.
std::vector<double> shot(double tip, double load, int nodes) {
    const int inner = 16384 / nodes;
    const double h = std::cbrt(load) / (nodes * inner);
    std::vector<double> psi{tip};
    double value = tip, slope = 0.0, tau = 0.0;
    for (int i = 0; i < nodes; ++i) {
        for (int k = 0; k < inner; ++k, tau += h) {
            const double k1 = slope, l1 = tau * std::sin(value);
            const double k2 = slope + 0.5 * h * l1,
                         l2 = (tau + 0.5 * h) * std::sin(value + 0.5 * h * k1);
            const double k3 = slope + 0.5 * h * l2,
                         l3 = (tau + 0.5 * h) * std::sin(value + 0.5 * h * k2);
            const double k4 = slope + h * l3, l4 = (tau + h) * std::sin(value + h * k3);
            value += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            slope += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
        }
        psi.insert(psi.begin(), value);
    }
    return psi;
}

// The greatest difference, rad, between the solver and the family's member with that root.
double differenceFromFamily(double root, double load) {
    constexpr int kNodes = 64, kSteps = 4096;
    const Rod rod = hangingRod(root, load, kSteps);
    double a = kPi - rod.angle.back(), b = a * (1.0 + 1e-6);
    double fa = shot(a, load, kNodes)[0] - (kPi - root);
    for (int i = 0; i < 6; ++i) {
        const double fb = shot(b, load, kNodes)[0] - (kPi - root);
        if (fb == fa) break;
        const double next = b - fb * (b - a) / (fb - fa);
        a = b, fa = fb, b = next;
    }
    const std::vector<double> psi = shot(b, load, kNodes);
    double worst = 0.0;
    for (int i = 0; i <= kNodes; ++i)
        worst = std::max(worst, std::abs(kPi - psi[static_cast<std::size_t>(i)] -
                                         rod.angle[static_cast<std::size_t>(i * kSteps / kNodes)]));
    return worst;
}

TEST(Elastica, AgreesWithAnotherIntegratorOfTheUniversalFamily) {
    double upTo200 = 0.0, at1000 = 0.0;
    for (const double root : {0.01, 0.1, 1.6, 2.6}) {
        for (const double load : {1.0, 8.0, 20.0, 200.0})
            upTo200 = std::max(upTo200, differenceFromFamily(root, load));
        at1000 = std::max(at1000, differenceFromFamily(root, 1000.0));
    }
    using test::reached;
    reached("H1", "angles (rad) of the solver of rods against another integrator, loads to 200",
            upTo200, 1e-9);
    reached("H1", "the same at load 1000", at1000, 1e-6);
}

// 7.837347: (3/2 z)^2 where z = 1.866351 is the first zero of the Bessel function of order -1/3.
TEST(Elastica, BucklesUnderTheLoadOfGreenhill) {
    double straight = 7.0, bent = 9.0;
    for (int i = 0; i < 30; ++i) {
        const double load = 0.5 * (straight + bent);
        (hangingRod(1e-6, load, 256).angle.back() > 0.02 ? bent : straight) = load;
    }
    test::reached("H2", "load at which an upright rod buckles, against 7.837347",
                  std::abs(bent - 7.837347), 0.005);
}

TEST(Elastica, TipsHangAtTheKnownAngles) {
    const struct {
        double root, load, degrees;
    } known[] = {{1e-6, 8, 24.30},    {1e-6, 10, 81.44}, {1e-6, 20, 144.86}, {1e-6, 50, 173.71},
                 {1e-6, 100, 179.06}, {0.1, 1, 6.828},   {0.1, 5, 18.83},    {0.1, 7.837, 60.26},
                 {0.1, 10, 92.81},    {0.1, 20, 147.00}};
    double worst = 0.0;
    for (const auto& [root, load, degrees] : known)
        worst =
            std::max(worst, std::abs(hangingRod(root, load, 512).angle.back() / kDegree - degrees));
    test::reached("H3", "angles (degrees) of tips, rods up to .1 rad from upright, loads to 100",
                  worst, 0.02);
}

TEST(Elastica, RisesFromTheRootToAtMostHangingDown) {
    for (const double root : {1e-6, 1e-3, 0.01, 0.1, 1.6, 2.6, kPi})
        for (const double load :
             {0.0, 1e-9, 1.0, 7.837347 - 1e-6, 7.837347 + 1e-6, 20.0, 1e3, 1e4}) {
            const Rod rod = hangingRod(root, load, 512);
            for (std::size_t i = 1; i < rod.angle.size(); ++i)
                ASSERT_GE(rod.angle[i], rod.angle[i - 1] - 1e-12) << root << ", " << load;
            EXPECT_LE(rod.angle.back(), kPi + 1e-12);
            EXPECT_NEAR(rod.curvature.back(), 0.0, 1e-9);
        }
}

TEST(Elastica, PlacesAreAsFarApartAsTheRodIsLong) {
    for (const double root : {0.1, 1.6}) {
        const Rod rod = hangingRod(root, 20.0, 512);
        double length = 0.0;
        for (int i = 1; i <= 5120; ++i)
            length += glm::distance(placeOn(rod, i / 5120.0), placeOn(rod, (i - 1) / 5120.0));
        EXPECT_NEAR(length, 1.0, 1e-6);
    }
}

TEST(Elastica, SineAndCosineAreThoseOfTheLibraryWithinRounding) {
    for (int i = -2000; i <= 2000; ++i) {
        const double angle = 0.0137 * i;
        EXPECT_NEAR(turnOf(angle).sine, std::sin(angle), 1e-14);
        EXPECT_NEAR(turnOf(angle).cosine, std::cos(angle), 1e-14);
    }
}

}  // namespace
}  // namespace pelage
