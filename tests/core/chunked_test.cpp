// chunked_test.cpp -- copies share, writes separate.
#include "core/chunked.h"

#include <gtest/gtest.h>

#include <vector>

#include "test_skins.h"

namespace pelage {
namespace {

using Small = Chunked<int, 4>;

TEST(Chunked, HoldsCountCopiesOfTheValue) {
    const Small array(10, 7);
    EXPECT_EQ(array.size(), 10u);
    EXPECT_EQ(array.chunkCount(), 3u);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(array[i], 7);
    EXPECT_EQ(Small().size(), 0u);
    EXPECT_EQ(Small(0, 1).chunkCount(), 0u);
}

TEST(Chunked, LastChunkMayBeShort) {
    const Small array(10, 7);
    EXPECT_EQ(array.chunk(1).size(), 4u);
    EXPECT_EQ(array.chunk(2).size(), 2u);
}

TEST(Chunked, FreshArrayIsOneChunkInMemory) {
    const Small array(1000, 1);
    for (std::size_t c = 1; c < array.chunkCount() - 1; ++c)
        EXPECT_EQ(array.chunk(c).data(), array.chunk(0).data());
}

TEST(Chunked, WritingCopiesOneChunk) {
    const Small before(20, 0);
    Small after = before;
    EXPECT_TRUE(after == before);
    after.edit(9) = 5;
    EXPECT_EQ(before[9], 0);
    EXPECT_EQ(after[9], 5);
    for (std::size_t c = 0; c < 5; ++c) EXPECT_EQ(after.sharesChunk(before, c), c != 2);
    EXPECT_FALSE(after == before);
}

TEST(Chunked, WritingTwiceCopiesOnce) {
    Small array(8, 0);
    array.edit(1) = 1;
    const int* chunk = array.chunk(0).data();
    array.edit(2) = 2;
    EXPECT_EQ(array.chunk(0).data(), chunk);
}

TEST(Chunked, ArraysOfOtherSizesShareNothing) {
    const Small a(8, 0);
    const Small b(7, 0);
    EXPECT_FALSE(a.sharesChunk(b, 0));
    EXPECT_FALSE(a.sharesChunk(a, 2));
    EXPECT_FALSE(a == b);
}

TEST(Chunked, CopiesNeverSeeEachOthersWrites) {
    test::Draws draws(11);
    std::vector<Small> arrays{Small(50, 0)};
    std::vector<std::vector<int>> plain{std::vector<int>(50, 0)};
    for (int i = 0; i < 3000; ++i) {
        const uint which = draws.below(static_cast<uint>(arrays.size()));
        if (draws.below(20) == 0 && arrays.size() < 30) {
            const Small copy = arrays[which];
            const std::vector<int> plainCopy = plain[which];
            arrays.push_back(copy);
            plain.push_back(plainCopy);
        } else {
            const uint at = draws.below(50);
            arrays[which].edit(at) = plain[which][at] = i;
        }
    }
    for (std::size_t k = 0; k < arrays.size(); ++k)
        for (std::size_t i = 0; i < 50; ++i) ASSERT_EQ(arrays[k][i], plain[k][i]);
}

}  // namespace
}  // namespace pelage
