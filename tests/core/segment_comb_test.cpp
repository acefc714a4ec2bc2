// segment_comb_test.cpp -- axes lie on the skin, and no border between segments shows.
#include "core/segment_comb.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

#include "core/animal.h"
#include "reading.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::refusal;

constexpr float kLying = 0.8f;  // length of a direction that does not fade
constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;

// A tube along z, 1 m long, of 48 x 48 cells; the axis of its front half runs along it, that of its
// back half round to +x.
Source tube() {
    constexpr uint kCells = 48;
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    for (uint z = 0; z <= kCells; ++z) {
        for (uint a = 0; a < kCells; ++a) {
            const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(a) / kCells;
            positions.emplace_back(0.15f * std::cos(angle), 0.15f * std::sin(angle),
                                   static_cast<float>(z) / kCells);
            if (z == kCells) continue;
            const uint right = z * kCells + (a + 1) % kCells, here = z * kCells + a;
            triangles.push_back({here, right, here + kCells});
            triangles.push_back({right, right + kCells, here + kCells});
        }
    }
    Source source = test::oneMesh(positions, triangles);
    source.segments = {{"front", {0, 0, 0}, {0, 0, 1}}, {"back", {0, 0, 0}, {1, 0, 0}}};
    for (const vec3 p : positions) source.segmentOf.push_back(p.z > 0.5f ? 0 : 1);
    return source;
}

struct Seam {
    float across = 0.0f, inside = 0.0f;  // largest angles, degrees
    std::size_t bordering = 0;           // pairs of neighbours across a border
};

// The direction at one vertex as it would lie at another, turned as the skin turns between them: a
// crease of the skin is no seam of the field.
vec3 carried(vec3 direction, vec3 from, vec3 to) {
    const vec3 middle = from + to;
    const float square = glm::dot(middle, middle);
    if (!(square > 0.0f)) return direction;
    const vec3 turned = 2.0f * glm::dot(direction, middle) / square * middle - direction;
    return 2.0f * glm::dot(turned, to) * to - turned;
}

// Angles between the directions of neighbours, where both lie: where hair parts or meets, every
// field turns round and fades.
Seam seamOf(const Skin& skin, const Groom& groom, const std::vector<vec3>& field) {
    Seam seam;
    for (uint v = 0; v < field.size(); ++v) {
        for (const uint n : skin.ring(v)) {
            const SkinVertex &here = skin.vertices[v], &there = skin.vertices[n];
            const bool border = groom.segmentOf[v] != groom.segmentOf[n];
            const vec3 other = carried(field[n], there.normal, here.normal);
            const float a = glm::length(field[v]), b = glm::length(other);
            if (a < kLying || b < kLying) continue;
            const float cosine = std::clamp(glm::dot(field[v], other) / (a * b), -1.0f, 1.0f);
            float& largest = border ? seam.across : seam.inside;
            largest = std::max(largest, std::acos(cosine) / kDegree);
            seam.bordering += border;
        }
    }
    return seam;
}

std::vector<vec3> axesOnSkin(const Skin& skin, const Groom& groom) {
    std::vector<vec3> field;
    for (uint v = 0; v < skin.vertices.size(); ++v)
        field.push_back(
            laidOnSkin(axisOf(groom.body()[groom.segmentOf[v]]), skin.vertices[v].normal));
    return field;
}

// On the mesh as it is, and against the seams of each segment combed along its own axis.
void expectNoSeam(const Skin& skin, float most, float share) {
    const Groom groom = test::evenGroom(skin);
    const Seam plain = seamOf(skin, groom, axesOnSkin(skin, groom));
    const Seam smooth = seamOf(skin, groom, headToTail(skin, groom));
    std::printf(
        "largest angle between neighbours: %.1f across borders, %.1f inside; with each "
        "segment's own axis %.1f and %.1f degrees\n",
        static_cast<double>(smooth.across), static_cast<double>(smooth.inside),
        static_cast<double>(plain.across), static_cast<double>(plain.inside));
    EXPECT_GT(plain.across, 60.0f) << "no seam to remove";
    EXPECT_GT(smooth.bordering, 100u);
    EXPECT_LT(smooth.across, most);
    EXPECT_LE(smooth.across, share * smooth.inside);
}

Groom combed(const Skin& skin, Groom groom, float weight) {
    combHeadToTail(skin, groom, weight);
    return groom;
}

TEST(LaidOnSkin, IsUnitAndTangentialAndFadesWhereTheAxisIsTheNormal) {
    const vec3 up(0, 1, 0);
    const vec3 d = laidOnSkin(glm::normalize(vec3(1, 1, 0)), up);
    EXPECT_NEAR(glm::distance(d, vec3(1, 0, 0)), 0.0f, 1e-6f);
    EXPECT_EQ(laidOnSkin(up, up), vec3(0.0f));
    EXPECT_NEAR(glm::length(laidOnSkin({0.2f, std::sqrt(0.96f), 0}, up)), 0.5f, 1e-5f);
    EXPECT_EQ(laidOnSkin({0, 0, 1}, vec3(0.0f)), vec3(0, 0, 1));  // a vertex without a normal
}

TEST(CombSegment, LaysTheAxisOnItsOwnVerticesOnly) {
    const auto skin = makeSkin(tube());
    const Groom before = test::evenGroom(*skin);
    Groom groom = before;
    combSegment(*skin, groom, 1, {0, 5, 0}, 1.0f);
    for (uint v = 0; v < groom.fur.size(); ++v) {
        const vec3 wanted = before.segmentOf[v] == 1
                                ? laidOnSkin({0, 1, 0}, skin->vertices[v].normal)
                                : before.fur[v].direction;
        ASSERT_LT(glm::distance(groom.fur[v].direction, wanted), 1e-6f);
        FurVertex rest = groom.fur[v];
        rest.direction = before.fur[v].direction;
        ASSERT_EQ(rest, before.fur[v]);  // length, density and tint stay
    }
}

TEST(CombSegment, MixesByWeightAndMask) {
    const auto skin = makeSkin(tube());
    Groom groom = test::evenGroom(*skin, {vec3(0.0f), 0.04f, vec3(1.0f), 1.0f});
    for (uint v = 0; v < groom.fur.size(); ++v) groom.mask.edit(v) = v % 2 == 0 ? 1.0f : 0.5f;
    combSegment(*skin, groom, 0, {0, 0, 1}, 0.4f);
    for (uint v = 0; v < groom.fur.size(); ++v) {
        const bool touched = groom.segmentOf[v] == 0 && v % 2 == 1;
        ASSERT_NEAR(glm::length(groom.fur[v].direction), touched ? 0.2f : 0.0f, 1e-3f);
    }
}

TEST(CombSegment, ByNothingCopiesNoChunk) {
    const auto skin = makeSkin(tube());
    const Groom before = test::evenGroom(*skin);
    Groom groom = before;
    combSegment(*skin, groom, 0, {0, 0, 1}, 0.0f);
    EXPECT_EQ(groom, before);
}

TEST(HeadToTail, TurnsFromOneAxisToTheNextWithoutASeamAndKeepsBothBeyondIt) {
    const auto skin = makeSkin(tube());
    expectNoSeam(*skin, 35.0f, 1.2f);
    const Groom groom = test::evenGroom(*skin);
    const std::vector<vec3> field = headToTail(*skin, groom), axes = axesOnSkin(*skin, groom);
    for (uint v = 0; v < field.size(); ++v) {
        if (std::abs(skin->vertices[v].position.z - 0.5f) < 0.3f) continue;
        ASSERT_LT(glm::distance(field[v], axes[v]), 0.35f);
    }
}

TEST(HeadToTail, HasNoSeamOnTheAnimal) { expectNoSeam(*makeSkin(makeAnimal(60000)), 45.0f, 0.5f); }

TEST(HeadToTail, HasNoSeamOnTheFox) {
    const std::string path = test::sharedMesh("Fox.glb");
    if (path.empty()) GTEST_SKIP() << "Fox.glb is not there";
    expectNoSeam(*makeSkin(readSource(path)), 60.0f, 0.5f);
}

TEST(HeadToTail, LiesOnTheSkinAndIsAtMostAsLongAsOne) {
    const auto skin = makeSkin(makeAnimal(5000));
    const std::vector<vec3> field = headToTail(*skin, test::evenGroom(*skin));
    for (uint v = 0; v < field.size(); ++v) {
        ASSERT_LE(glm::length(field[v]), 1.00001f);
        ASSERT_LT(std::abs(glm::dot(field[v], skin->vertices[v].normal)), 1e-5f);
    }
}

TEST(HeadToTail, IsTheSameWithAnyNumberOfThreads) {
    const auto skin = makeSkin(makeAnimal(20000));
    const std::vector<vec3> many = headToTail(*skin, test::evenGroom(*skin));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const std::vector<vec3> alone = headToTail(*skin, test::evenGroom(*skin));
    ASSERT_EQ(many.size(), alone.size());
    EXPECT_EQ(std::memcmp(many.data(), alone.data(), many.size() * sizeof(vec3)), 0);
}

TEST(HeadToTail, IsTheSameAtEverySize) {
    const auto skin = makeSkin(tube());
    const std::vector<vec3> field = headToTail(*skin, test::evenGroom(*skin));
    for (const float scale : {1e-5f, 1e5f}) {
        Source source = tube();
        for (vec3& p : source.positions) p *= scale;
        const auto scaled = makeSkin(std::move(source));
        const std::vector<vec3> other = headToTail(*scaled, test::evenGroom(*scaled));
        ASSERT_EQ(other.size(), field.size());
        for (uint v = 0; v < field.size(); ++v)
            ASSERT_LT(glm::distance(field[v], other[v]), 0.02f) << scale;
    }
}

TEST(HeadToTail, StaysFiniteOnDegenerateSkins) {
    Source flat = test::sheet(4);
    flat.segments = {{"up", {0, 0, 0}, {0, 1, 0}}, {"point", {0, 0, 0}, {0, 0, 0}}};
    flat.segmentOf.assign(flat.positions.size(), 0);
    flat.segmentOf[3] = 1;
    flat.segmentOf[4] = 77;               // a segment that is not there
    flat.triangles.push_back({0, 1, 1});  // of no area
    flat.positions.push_back({9, 9, 9});  // used by no triangle: no normal, no ring
    flat.segmentOf.push_back(0);
    ++flat.parts[0].vertexCount, ++flat.parts[0].triangleCount;
    const auto skin = makeSkin(std::move(flat));
    const Groom groom = combed(*skin, test::evenGroom(*skin), 1.0f);
    for (uint v = 0; v < groom.fur.size(); ++v)
        ASSERT_TRUE(std::isfinite(glm::length(groom.fur[v].direction)));
}

TEST(HeadToTail, LeavesPiecesThatNoAxisReaches) {
    std::vector<vec3> positions;
    std::vector<uvec3> triangles;
    test::addSheet(positions, triangles, 6, 0.0f, true);
    const std::size_t first = positions.size();
    test::addSheet(positions, triangles, 6, 1.0f, true);
    Source source = test::oneMesh(positions, triangles);
    source.segments = {{"along", {0, 0, 0}, {1, 0, 0}}, {"point", {0, 0, 0}, {0, 0, 0}}};
    source.segmentOf.assign(positions.size(), 1);
    std::fill_n(source.segmentOf.begin(), first, 0);
    const auto skin = makeSkin(std::move(source));
    const Groom before = test::evenGroom(*skin);
    const Groom after = combed(*skin, before, 1.0f);
    for (uint v = 0; v < after.fur.size(); ++v) {
        const bool reached = after.segmentOf[v] == 0;
        ASSERT_LT(glm::distance(after.fur[v].direction,
                                reached ? vec3(1, 0, 0) : before.fur[v].direction),
                  1e-5f);
    }
}

TEST(HeadToTail, SaysThatThereAreNoSegments) {
    const auto problem = [](Source source) {
        const auto skin = makeSkin(std::move(source));
        return refusal([&] { headToTail(*skin, test::evenGroom(*skin)); });
    };
    EXPECT_EQ(problem(test::sheet(2)), "the mesh has no body segments to comb along");
    Source source = test::sheet(2);
    source.segments = {{"point", {0, 0, 0}, {0, 0, 0}}};
    EXPECT_EQ(problem(std::move(source)), "no body segment of the mesh has an axis to comb along");
}

}  // namespace
}  // namespace pelage
