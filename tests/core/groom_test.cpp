// groom_test.cpp -- the promises of groom.h and of openDocument.
#include "core/groom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "core/animal.h"
#include "core/document.h"
#include "reading.h"

namespace pelage {
namespace {

// A flat strip along z, 2 m long and 1 m wide, facing up, with one split corner.
Source strip() {
    Source source;
    source.positions = {{0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 0, 0}, {1, 0, 2}};
    source.triangles = {{0, 1, 2}, {0, 4, 3}};
    SourcePart part;
    part.vertexCount = 5;
    part.triangleCount = 2;
    source.parts.push_back(part);
    source.fileVertices = 5;
    return source;
}

std::unique_ptr<SourceFur> someFields() {
    auto fur = std::make_unique<SourceFur>();
    fur->length = {0.125f, 1e-30f, 3.0f, -0.0f, 7.0f};
    fur->density = {1.0f, 0.0f, 0.3f, 0.7f, 0.9f};
    fur->direction = {{0.1f, 0.2f, 0.3f}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    return fur;
}

TEST(InitialGroom, IsFourPercentOfTheDiagonalLongAndFullyDense) {
    const auto skin = makeSkin(strip());
    const Groom groom = initialGroom(*skin);
    ASSERT_EQ(groom.fur.size(), 4u);
    ASSERT_EQ(groom.mask.size(), 4u);
    for (uint v = 0; v < 4; ++v) {
        EXPECT_FLOAT_EQ(groom.fur[v].furLength, 0.04f * std::sqrt(5.0f));
        EXPECT_EQ(groom.fur[v].density, 1.0f);
        EXPECT_EQ(groom.mask[v], 0.0f);
    }
}

TEST(InitialGroom, KeepsItsLengthInTheWorldWhenTheMeshIsScaled) {
    Source source = strip();
    source.parts[0].toWorld = mat4(mat3(0.01f));
    source.parts[0].toWorld[3][3] = 1.0f;
    const auto skin = makeSkin(std::move(source));
    const Groom groom = initialGroom(*skin);
    // In mesh space as long as on the unscaled strip, in the world a hundredth of it.
    EXPECT_NEAR(groom.fur[0].furLength, 0.04f * std::sqrt(5.0f), 1e-5f);
    EXPECT_NEAR(furToWorld(*skin, 0, groom.fur[0]).furLength, 0.0004f * std::sqrt(5.0f), 1e-7f);
}

TEST(InitialGroom, LiesDownAndBackWithoutSegments) {
    const auto skin = makeSkin(strip());
    const Groom groom = initialGroom(*skin);
    for (uint v = 0; v < 4; ++v) {
        const vec3 d = groom.fur[v].direction;
        EXPECT_NEAR(d.y, 0.0f, 1e-6f);  // on the skin, which faces up
        EXPECT_NEAR(d.z, -0.5f, 1e-5f);
    }
}

TEST(InitialGroom, FollowsTheSegments) {
    Source source = strip();
    source.segments = {{"a", {0, 0, 1}, {1, 0, 1}}};
    source.segmentOf.assign(5, 0);
    const auto skin = makeSkin(std::move(source));
    const Groom groom = initialGroom(*skin);
    for (uint v = 0; v < 4; ++v) EXPECT_NEAR(groom.fur[v].direction.x, 0.5f, 1e-5f);
}

// A segment without length has no axis; the fur must not become NaN.
TEST(InitialGroom, IgnoresSegmentsWithoutLength) {
    Source source = strip();
    source.segments = {{"point", {0, 0, 0}, {0, 0, 0}}};
    source.segmentOf.assign(5, 0);
    const auto skin = makeSkin(std::move(source));
    const Groom groom = initialGroom(*skin);
    for (uint v = 0; v < 4; ++v) EXPECT_NEAR(groom.fur[v].direction.z, -0.5f, 1e-5f);
}

TEST(InitialGroom, IsCombedFromHeadToTailOnTheAnimal) {
    const auto skin = makeSkin(makeAnimal(5000));
    const Groom groom = initialGroom(*skin);
    double along = 0.0, count = 0.0;
    for (uint v = 0; v < skin->vertices.size(); ++v) {
        ASSERT_LE(glm::length(groom.fur[v].direction), 0.5001f);
        ASSERT_LE(std::abs(glm::dot(groom.fur[v].direction, skin->vertices[v].normal)), 1e-4f);
        if (groom.body()[groom.segmentOf[v]].name != "trunk") continue;
        along -= double(groom.fur[v].direction.z);
        count += 1.0;
    }
    EXPECT_GT(along / count, 0.25);
}

TEST(InitialGroom, TakesTheFieldsOfTheFileBitForBit) {
    Source source = strip();
    source.fur = someFields();
    const SourceFur fields = *source.fur;
    const auto skin = makeSkin(std::move(source));
    const Groom groom = initialGroom(*skin);
    for (uint v = 0; v < 4; ++v) {  // the fifth is welded to the third
        const FurVertex& fur = groom.fur[skin->weld[v]];
        EXPECT_EQ(fur.furLength, fields.length[v]);
        EXPECT_EQ(std::signbit(fur.furLength), std::signbit(fields.length[v]));
        EXPECT_EQ(fur.density, fields.density[v]);
        EXPECT_EQ(fur.direction, fields.direction[v]);
    }
}

TEST(InitialGroom, TakesTheFirstOfWeldedVerticesThatDiffer) {
    Source source = strip();
    source.fur = someFields();
    const auto skin = makeSkin(std::move(source));
    ASSERT_EQ(skin->weld[2], skin->weld[4]);
    EXPECT_EQ(initialGroom(*skin).fur[skin->weld[4]].furLength, 3.0f);
}

TEST(InitialGroom, OfASkinWithoutVerticesIsEmpty) {
    const auto skin = makeSkin(Source{});
    EXPECT_EQ(initialGroom(*skin).fur.size(), 0u);
    EXPECT_EQ(fieldRange(initialGroom(*skin), Channel::length).greatest, 0.0f);
}

TEST(FieldRange, SpansTheValuesOfEachChannel) {
    Source source = strip();
    source.fur = someFields();
    const auto skin = makeSkin(std::move(source));
    Groom groom = initialGroom(*skin);
    groom.mask.edit(2) = 0.25f;
    EXPECT_EQ(fieldRange(groom, Channel::length).least, 0.0f);
    EXPECT_EQ(fieldRange(groom, Channel::length).greatest, 3.0f);
    EXPECT_EQ(fieldRange(groom, Channel::density).least, 0.0f);
    EXPECT_EQ(fieldRange(groom, Channel::density).greatest, 1.0f);
    EXPECT_EQ(fieldRange(groom, Channel::direction).least, 0.0f);
    EXPECT_EQ(fieldRange(groom, Channel::direction).greatest, 1.0f);
    EXPECT_EQ(fieldRange(groom, Channel::mask).least, 0.0f);
    EXPECT_EQ(fieldRange(groom, Channel::mask).greatest, 0.25f);
}

TEST(OpenDocument, HasDefaultFurWhereTheFileHasNone) {
    Source source = strip();
    source.colors.assign(5, vec4(0.2f, 0.3f, 0.4f, 1.0f));
    EXPECT_EQ(openDocument(std::move(source)).fur, defaultFur());
}

TEST(OpenDocument, IsBrownWhereTheMeshHasNoColor) {
    Fur fur = openDocument(strip()).fur;
    for (Coat* coat : {&fur.over, &fur.under}) {
        for (const vec3 color : {coat->rootColor, coat->tipColor}) {
            EXPECT_GT(color.r, color.g);
            EXPECT_GT(color.g, color.b);
        }
    }
    const Fur plain = defaultFur();
    fur.over.rootColor = plain.over.rootColor, fur.over.tipColor = plain.over.tipColor;
    fur.under.rootColor = plain.under.rootColor, fur.under.tipColor = plain.under.tipColor;
    EXPECT_EQ(fur, plain);  // and nothing else differs
}

TEST(OpenDocument, TakesTheFurBlockOfTheFile) {
    Source source = strip();
    Fur fur = defaultFur();
    fur.hairs = 1234;
    fur.over.stiffness = 0.625f;
    source.furBlock = furToJson(fur);
    EXPECT_EQ(openDocument(std::move(source)).fur, fur);
}

TEST(OpenDocument, RefusesABrokenFurBlock) {
    Source source = strip();
    source.furBlock = "{\"version\":1,\"hairs\":\"many\"}";
    EXPECT_THROW(openDocument(std::move(source)), std::runtime_error);
}

TEST(OpenDocument, NamesTheFileOfABrokenFurBlock) {
    Source source = strip();
    source.path = "horse.glb";
    source.furBlock = "{\"version\":2}";
    EXPECT_EQ(test::refusal([&] { openDocument(std::move(source)); }),
              "horse.glb: extras.fur: version is 2, this program reads 1..1");
}

TEST(OpenDocument, StopsWhenCancelled) {
    Progress progress;
    progress.cancel = true;
    EXPECT_THROW(openDocument(strip(), &progress), Cancelled);
}

}  // namespace
}  // namespace pelage
