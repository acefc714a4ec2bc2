// animal_test.cpp -- the promises of animal.h.
#include "core/animal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "reading.h"

namespace pelage {
namespace {

// The surface without the splits at the borders of the picture's charts. Made once a size.
const std::shared_ptr<const Skin>& animalSkin(std::size_t triangles) {
    static std::map<std::size_t, std::shared_ptr<const Skin>> skins;
    std::shared_ptr<const Skin>& skin = skins[triangles];
    if (!skin) skin = makeSkin(makeAnimal(triangles));
    return skin;
}

const Source& animal(std::size_t triangles) { return *animalSkin(triangles)->source; }

const Document& groomed() {
    static const Document document = groomedAnimal(20000);
    return document;
}

// Mean of a value over the vertices of the segments whose name begins with `name`.
template <typename Value>
double meanOver(const Skin& skin, const std::string& name, Value value) {
    const Groom groom = evenGroom(skin, kBareFur);
    double sum = 0.0, count = 0.0;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const std::string& segment = groom.body()[groom.segmentOf[v]].name;
        if (segment.compare(0, name.size(), name) != 0) continue;
        sum += static_cast<double>(value(v));
        count += 1.0;
    }
    EXPECT_GT(count, 0.0) << name << " owns no vertex";
    return sum / count;
}

double meanLength(const std::string& name) {
    return meanOver(*groomed().skin, name, [](uint v) { return groomed().groom.fur[v].furLength; });
}

class AnimalOfSize : public testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(Sizes, AnimalOfSize, testing::Values(2000, 20000, 200000));

TEST_P(AnimalOfSize, IsClosedAndManifold) {
    const auto& skin = animalSkin(GetParam());
    std::map<std::pair<uint, uint>, int> sides;
    for (const uvec3& t : skin->triangles) {
        for (int i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [side, uses] : sides) {
        ASSERT_EQ(uses, 1) << side.first << " to " << side.second;
        ASSERT_EQ(sides.count({side.second, side.first}), 1u);
    }
    // The faces at each vertex form one ring: as many as it has neighbours, in one walk.
    std::vector<std::map<uint, uint>> next(skin->vertices.size());
    for (const uvec3& t : skin->triangles) {
        for (int i = 0; i < 3; ++i) next[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    }
    for (const auto& ring : next) {
        ASSERT_GE(ring.size(), 3u);
        std::size_t steps = 1;
        for (uint n = ring.begin()->second; n != ring.begin()->first; n = ring.at(n)) ++steps;
        ASSERT_EQ(steps, ring.size());
    }
    EXPECT_EQ(skin->report.nonManifoldEdges, 0u);
    EXPECT_EQ(skin->report.degenerateFaces, 0u);
    EXPECT_EQ(skin->report.unusedVertices, 0u);
}

TEST_P(AnimalOfSize, IsOnePiece) {
    const auto& skin = animalSkin(GetParam());
    std::vector<char> seen(skin->vertices.size(), 0);
    std::vector<uint> queue{0};
    seen[0] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        for (const uint n : skin->ring(queue[i])) {
            if (!std::exchange(seen[n], char(1))) queue.push_back(n);
        }
    }
    EXPECT_EQ(queue.size(), skin->vertices.size());
}

TEST_P(AnimalOfSize, FacesOutwards) {
    const auto& skin = animalSkin(GetParam());
    double volume = 0.0;
    std::size_t inverted = 0;
    for (const uvec3& t : skin->triangles) {
        const glm::dvec3 a = skin->vertices[t.x].position, b = skin->vertices[t.y].position,
                         c = skin->vertices[t.z].position;
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        const glm::dvec3 mean =
            skin->vertices[t.x].normal + skin->vertices[t.y].normal + skin->vertices[t.z].normal;
        inverted += glm::dot(glm::cross(b - a, c - a), mean) <= 0.0;
    }
    EXPECT_NEAR(volume, 0.036, 0.004);  // m^3
    // On the coarsest lattices a thin ear folds a few triangles.
    EXPECT_LE(double(inverted), 0.005 * double(skin->triangles.size()));
}

TEST_P(AnimalOfSize, IsSymmetric) {
    const Source& source = animal(GetParam());
    std::set<std::tuple<float, float, float>> places;
    for (const vec3& p : source.positions) places.insert({p.x, p.y, p.z});
    for (const vec3& p : source.positions) {
        ASSERT_TRUE(places.count({-p.x, p.y, p.z})) << p.x << " " << p.y << " " << p.z;
    }
}

TEST_P(AnimalOfSize, HasUnitNormalsThatFaceOutwards) {
    const Source& source = animal(GetParam());
    ASSERT_EQ(source.normals.size(), source.positions.size());
    for (const vec3& n : source.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
    std::size_t away = 0;
    for (const uvec3& t : source.triangles) {
        const vec3 face = glm::cross(source.positions[t.y] - source.positions[t.x],
                                     source.positions[t.z] - source.positions[t.x]);
        away += glm::dot(face, source.normals[t.x]) <= 0.0f;
    }
    EXPECT_LE(double(away), 0.02 * double(source.triangles.size()));
}

// Counts how many triangles cover each middle of a fine grid over the picture. Samples that lie
// within a thousandth of a triangle from its rim belong to nobody.
TEST_P(AnimalOfSize, HasUvsInTheUnitSquareWithoutOverlap) {
    const Source& source = animal(GetParam());
    ASSERT_EQ(source.uvs.size(), source.positions.size());
    for (const vec2& uv : source.uvs) {
        ASSERT_TRUE(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f);
    }
    constexpr int kGrid = 2048;
    std::vector<unsigned char> covered(kGrid * kGrid, 0);
    for (const uvec3& t : source.triangles) {
        const glm::dvec2 a = glm::dvec2(source.uvs[t.x]) * double(kGrid);
        const glm::dvec2 b = glm::dvec2(source.uvs[t.y]) * double(kGrid);
        const glm::dvec2 c = glm::dvec2(source.uvs[t.z]) * double(kGrid);
        const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        ASSERT_NE(area, 0.0);
        for (int y = int(std::min({a.y, b.y, c.y})); y <= int(std::max({a.y, b.y, c.y})); ++y) {
            for (int x = int(std::min({a.x, b.x, c.x})); x <= int(std::max({a.x, b.x, c.x})); ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                const double u = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area;
                const double v = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area;
                if (std::min({u, v, 1.0 - u - v}) < 2e-3) continue;
                ASSERT_EQ(int(covered[std::size_t(y * kGrid + x)]++), 0) << x << ", " << y;
            }
        }
    }
    const auto used = std::count(covered.begin(), covered.end(), 1);
    EXPECT_GT(double(used), 0.25 * kGrid * kGrid);
}

TEST_P(AnimalOfSize, IsSplitOnlyAtTheBordersOfCharts) {
    const Source& source = animal(GetParam());
    const auto& skin = animalSkin(GetParam());
    EXPECT_GT(source.positions.size(), skin->vertices.size());
    EXPECT_LT(double(source.positions.size()),
              double(skin->vertices.size()) * (1.0 + 40.0 / std::sqrt(double(GetParam()))));
    EXPECT_EQ(skin->report.boundaryEdges, 0u);
}

TEST(Animal, HasWithinTenPercentOfTheTrianglesWanted) {
    for (const std::size_t wanted : {2000u, 2900u, 5000u, 11000u, 47000u, 130000u, 400000u}) {
        const double made = double(animal(wanted).triangles.size());
        EXPECT_LE(std::abs(made - double(wanted)), 0.1 * double(wanted)) << wanted;
    }
}

TEST(Animal, RefusesACountOutOfRangeWithTheNumbers) {
    for (const std::size_t wanted : {0u, 1999u, 2000001u}) {
        EXPECT_EQ(test::refusal([&] { makeAnimal(wanted); }),
                  "animal: " + std::to_string(wanted) +
                      " triangles wanted, from 2000 to 2000000 can be made");
    }
}

TEST(Animal, IsTheSameEveryTime) {
    const Source &a = animal(20000), b = makeAnimal(20000);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.uvs, b.uvs);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.segmentOf, b.segmentOf);
    EXPECT_EQ(a.images[0].bytes, b.images[0].bytes);
}

TEST(Animal, IsAboutAMetreLongAndStandsOnTheGround) {
    const auto& skin = animalSkin(20000);
    EXPECT_NEAR(skin->upper.z - skin->lower.z, 1.05f, 0.1f);
    EXPECT_NEAR(skin->lower.y, 0.0f, 0.001f);
    EXPECT_GT(skin->upper.y, 0.6f);
    // The head is in front: the nose is the foremost place.
    const auto nose = std::max_element(
        skin->vertices.begin(), skin->vertices.end(),
        [](const SkinVertex& a, const SkinVertex& b) { return a.position.z < b.position.z; });
    const Groom groom = evenGroom(*skin, kBareFur);
    const auto segmentAt = [&](std::size_t v) { return groom.body()[groom.segmentOf[v]].name; };
    EXPECT_EQ(segmentAt(static_cast<std::size_t>(nose - skin->vertices.begin())), "muzzle");
    // All four feet touch the ground.
    std::set<std::string> onGround;
    for (std::size_t v = 0; v < skin->vertices.size(); ++v)
        if (skin->vertices[v].position.y < 0.002f) onGround.insert(segmentAt(v));
    EXPECT_EQ(onGround, (std::set<std::string>{"leg.front.left.foot", "leg.front.right.foot",
                                               "leg.back.left.foot", "leg.back.right.foot"}));
}

TEST(Animal, HasNamedSegmentsThatOwnVertices) {
    const Source& source = animal(20000);
    std::set<std::string> names;
    std::vector<std::size_t> owned(source.segments.size(), 0);
    for (const uint s : source.segmentOf) {
        ASSERT_LT(s, source.segments.size());
        ++owned[s];
    }
    for (std::size_t s = 0; s < owned.size(); ++s) {
        EXPECT_GT(owned[s], 10u) << source.segments[s].name;
        EXPECT_GT(glm::length(source.segments[s].tip - source.segments[s].root), 0.03f);
        names.insert(source.segments[s].name);
    }
    EXPECT_EQ(names.size(), source.segments.size());
    for (const char* name : {"head", "muzzle", "ear.left", "ear.right", "neck", "trunk", "tail"}) {
        EXPECT_TRUE(names.count(name)) << name;
    }
    for (const char* leg :
         {"leg.front.left", "leg.front.right", "leg.back.left", "leg.back.right"}) {
        for (const char* part : {".upper", ".lower", ".foot"}) {
            EXPECT_TRUE(names.count(std::string(leg) + part)) << leg << part;
        }
    }
}

TEST(Animal, HasLeftSegmentsOnItsLeft) {
    const Source& source = animal(5000);  // it looks along +z, so its left is +x
    for (std::size_t v = 0; v < source.positions.size(); ++v) {
        const std::string& name = source.segments[source.segmentOf[v]].name;
        if (name.find("left") != std::string::npos) {
            EXPECT_GE(source.positions[v].x, 0.0f);
        }
        if (name.find("right") != std::string::npos) {
            EXPECT_LE(source.positions[v].x, 0.0f);
        }
    }
}

TEST(Animal, HasSegmentAxesFromHeadToTail) {
    std::map<std::string, Segment> segments;
    for (const Segment& s : animal(2000).segments) segments[s.name] = s;
    EXPECT_EQ(segments["muzzle"].tip, segments["head"].root);
    EXPECT_EQ(segments["head"].tip, segments["neck"].root);
    EXPECT_EQ(segments["neck"].tip, segments["trunk"].root);
    for (const char* name : {"muzzle", "head", "neck", "trunk", "tail"}) {
        EXPECT_LT(segments[name].tip.z, segments[name].root.z) << name;
    }
    EXPECT_LT(segments["leg.back.left.upper"].tip.y, segments["leg.back.left.upper"].root.y);
    EXPECT_GT(segments["ear.left"].tip.y, segments["ear.left"].root.y);
}

TEST(Animal, HasABaseColorPicture) {
    const Source& source = animal(2000);
    ASSERT_EQ(source.materials.size(), 1u);
    ASSERT_EQ(source.materials[0].image, 0);
    const auto& png = source.images.at(0).bytes;
    ASSERT_GT(png.size(), 10000u);
    EXPECT_EQ(std::memcmp(png.data(), "\x89PNG\r\n\x1a\n", 8), 0);
}

TEST(GroomedAnimal, IsShortOnFaceAndFeetAndLongOnTheTail) {
    const double trunk = meanLength("trunk"), tail = meanLength("tail");
    EXPECT_LT(meanLength("muzzle"), 0.4 * trunk);
    EXPECT_LT(meanLength("leg.front.left.foot"), 0.4 * trunk);
    EXPECT_LT(meanLength("leg.back.right.foot"), 0.5 * trunk);
    EXPECT_LT(meanLength("ear"), 0.5 * trunk);
    EXPECT_GT(tail, 1.6 * trunk);
    EXPECT_GT(meanLength("neck"), trunk);
    EXPECT_NEAR(trunk, 0.042, 0.008);
}

TEST(GroomedAnimal, LiesOnTheSkin) {
    const Skin& skin = *groomed().skin;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const vec3 d = groomed().groom.fur[v].direction;
        ASSERT_LE(glm::length(d), 1.0f);
        ASSERT_LE(std::abs(glm::dot(d, skin.vertices[v].normal)), 1e-4f);
    }
    const double lean =
        meanOver(skin, "", [](uint v) { return glm::length(groomed().groom.fur[v].direction); });
    EXPECT_GT(lean, 0.6);
}

TEST(GroomedAnimal, IsCombedFromHeadToTail) {
    const Skin& skin = *groomed().skin;
    for (const char* name : {"muzzle", "trunk", "tail", "leg.front.left.lower", "ear.left"}) {
        const auto& segments = skin.source->segments;
        const auto segment = std::find_if(segments.begin(), segments.end(),
                                          [&](const Segment& s) { return s.name == name; });
        const vec3 axis = glm::normalize(segment->tip - segment->root);
        EXPECT_GT(
            meanOver(skin, name,
                     [&](uint v) { return glm::dot(groomed().groom.fur[v].direction, axis); }),
            0.4)
            << name;
    }
}

// A border between segments must not show: neighbours are combed nearly alike where the skin is
// smooth.
TEST(GroomedAnimal, TurnsSmoothlyFromSegmentToSegment) {
    const Skin& skin = *groomed().skin;
    std::size_t edges = 0, jumps = 0;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        for (const uint n : skin.ring(v)) {
            if (groomed().groom.segmentOf[v] == groomed().groom.segmentOf[n]) continue;
            if (glm::dot(skin.vertices[v].normal, skin.vertices[n].normal) < 0.9f) continue;
            ++edges;
            jumps += glm::length(groomed().groom.fur[v].direction -
                                 groomed().groom.fur[n].direction) > 0.5f;
        }
    }
    EXPECT_GT(edges, 500u);
    EXPECT_LT(double(jumps), 0.01 * double(edges));
}

TEST(GroomedAnimal, HasABareNoseAndBareEyes) {
    const Skin& skin = *groomed().skin;
    std::size_t bare = 0;
    float foremost = -1.0f;
    uint nose = 0;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const FurVertex& fur = groomed().groom.fur[v];
        ASSERT_TRUE(fur.density == 0.0f || fur.density == 1.0f);
        bare += fur.density == 0.0f;
        if (skin.vertices[v].position.z > foremost) {
            foremost = skin.vertices[v].position.z;
            nose = v;
        }
    }
    EXPECT_EQ(groomed().groom.fur[nose].density, 0.0f);
    EXPECT_GT(double(bare), 0.005 * double(skin.vertices.size()));
    EXPECT_LT(double(bare), 0.08 * double(skin.vertices.size()));
}

TEST(GroomedAnimal, IsSymmetric) {
    const Skin& skin = *groomed().skin;
    std::map<std::tuple<float, float, float>, uint> at;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const vec3 p = skin.vertices[v].position;
        at[{p.x, p.y, p.z}] = v;
    }
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const vec3 p = skin.vertices[v].position;
        const FurVertex& here = groomed().groom.fur[v];
        const FurVertex& there = groomed().groom.fur[at.at({-p.x, p.y, p.z})];
        EXPECT_EQ(here.furLength, there.furLength);
        EXPECT_EQ(here.density, there.density);
        EXPECT_NEAR(here.direction.x, -there.direction.x, 1e-3f);
        EXPECT_NEAR(here.direction.z, there.direction.z, 1e-3f);
    }
}

}  // namespace
}  // namespace pelage
