// spacing_test.cpp -- how far vertices are apart, and when that is worth a line.
#include "core/spacing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_skins.h"

namespace pelage {
namespace {

TEST(Spacing, IsTheMedianOfTheEdges) {
    const auto skin = makeSkin(test::sheet(10));
    EXPECT_NEAR(skin->spacing, 0.1f, 1e-6f);
    EXPECT_EQ(skin->spacing, medianSpacing(*skin));
}

TEST(Spacing, IsInMetresOfTheWorld) {
    EXPECT_NEAR(makeSkin(test::sheet(10, mat4(mat3(5.0f))))->spacing, 0.5f, 1e-5f);
}

TEST(Spacing, OfALargeMeshIsThatOfASample) {
    EXPECT_NEAR(makeSkin(test::sheet(400))->spacing, 0.0025f, 1e-6f);
}

TEST(Spacing, AtAVertexIsTheMeanOfItsEdges) {
    const auto skin = makeSkin(test::oneMesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}));
    const uint corner = skin->weld[0], alone = skin->weld[1];
    EXPECT_EQ(spacingAt(*skin, corner), 3.5f);
    EXPECT_EQ(spacingAt(*skin, alone), 4.0f);
}

TEST(Spacing, OfVerticesWithoutEdgesIsZero) {
    const auto skin =
        makeSkin(test::oneMesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {9, 9, 9}}, {{0, 1, 2}}));
    EXPECT_EQ(spacingAt(*skin, skin->weld[3]), 0.0f);
}

TEST(Spacing, HairShorterThanItIsToldWithNumbers) {
    Document document = test::evenDocument(test::sheet(10));  // hair of 0.04 m
    document.fur.hairs = 100000;
    ASSERT_EQ(spacingNotes(document).size(), 1u);
    EXPECT_EQ(spacingNotes(document)[0],
              "the mesh is coarse for its fur: vertices are 0.1 m apart, hairs 0.04 m long "
              "(medians); subdividing it makes that 0.05 m");
    document = test::evenDocument(test::sheet(40));
    EXPECT_TRUE(spacingNotes(document).empty());
}

TEST(Spacing, OfABareMeshIsNotToldAgainstItsHair) {
    Document document = test::evenDocument(test::sheet(10));
    document.groom.fur = Chunked<FurVertex>(document.groom.fur.size(), kBareFur);
    EXPECT_TRUE(spacingNotes(document).empty());
}

TEST(Spacing, FarMoreVerticesThanHairsAreTold) {
    Document document = test::evenDocument(test::sheet(100));
    document.fur.hairs = 1020;
    EXPECT_EQ(spacingNotes(document),
              std::vector<std::string>{
                  "the mesh is denser than its fur needs: 10201 vertices for 1020 hairs"});
    document.fur.hairs = 1021;
    EXPECT_TRUE(spacingNotes(document).empty());
}

}  // namespace
}  // namespace pelage
