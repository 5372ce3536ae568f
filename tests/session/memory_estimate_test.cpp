// A map that does not fit into memory is refused in words, before it is loaded.
#include "editor/session/memory_estimate.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "editor/session/session.h"
#include "tests/session/test_scene.h"

namespace relievo::memory_estimate_test {
namespace {

using test::TemporaryFolder;

constexpr std::uint64_t kGiga = 1'000'000'000;

TEST(MemoryEstimate, TheLargestMapTakesSomeGigabytesAndTheSmallestNothing) {
    const MapMemory largest = estimate_memory({16384, 16384, 2, MapFormat::png16}, true, MapBounds::planes);
    const std::uint64_t total = largest.editing + largest.passing + largest.device;
    EXPECT_GT(total, 2 * kGiga);
    EXPECT_LT(total, 4 * kGiga);
    const MapMemory least = estimate_memory({1, 1, 2, MapFormat::png16}, true, MapBounds::planes);
    EXPECT_LT(least.editing + least.passing + least.device, 100u);
}

TEST(MemoryEstimate, WhatIsKeptOfAFileCounts) {
    const std::uint64_t grey = estimate_memory({1024, 1024, 2, MapFormat::png16}, false, MapBounds::none).editing;
    EXPECT_GT(estimate_memory({1024, 1024, 8, MapFormat::png16}, false, MapBounds::none).editing, grey + 8'000'000);
    EXPECT_GT(estimate_memory({1024, 1024, 2, MapFormat::exr_half}, false, MapBounds::none).editing, grey + 2'000'000);
}

TEST(MemoryEstimate, ColoursTakeThreePlanesAndFourChannelsOnTheDevice) {
    const MapMemory eight = estimate_colour_memory({1000, 1000, 8, 3}, true);
    EXPECT_EQ(eight.editing, 6'000'000u);
    EXPECT_EQ(eight.device, 4'000'000u);
    const MapMemory with_alpha = estimate_colour_memory({1000, 1000, 16, 4}, false);
    EXPECT_EQ(with_alpha.editing, 6'000'000u + 8'000'000u) << "the alpha is kept for saving";
    EXPECT_EQ(with_alpha.device, 0u);
}

TEST(MemoryEstimate, RefusalNamesMapSizeAndBothAmounts) {
    const MapInfo info{8192, 4096, 2, MapFormat::tiff16};
    const MapMemory need = estimate_memory(info, true, MapBounds::planes);
    EXPECT_NO_THROW(require_memory("hills.tif", info, need, need.editing + need.passing + need.device));
    try {
        require_memory("hills.tif", info, need, 1'000'000);
        FAIL() << "must be refused";
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        for (const char* words : {"hills.tif", "8192 x 4096", "MB", "1.0 MB are free"})
            EXPECT_NE(message.find(words), std::string::npos) << words << " in: " << message;
    }
}

TEST(MemoryEstimate, ThisMachineHasSomeMemoryLeft) {
    EXPECT_GT(available_memory(), 1'000'000u);
}

TEST(MemoryEstimate, InfoIsThatOfTheLoadedFile) {
    const TemporaryFolder folder;
    const HeightMap map(7, 3);
    for (const auto& [name, format] :
         {std::pair{"a.png", MapFormat::png16}, std::pair{"a.tif", MapFormat::tiff16},
          std::pair{"a.exr", MapFormat::exr_float}, std::pair{"b.exr", MapFormat::exr_half}}) {
        save_map(map, folder.path() / name, format);
        const MapInfo info = map_info(folder.path() / name);
        EXPECT_EQ(info.width, 7);
        EXPECT_EQ(info.height, 3);
        EXPECT_EQ(info.format, format) << name;
        EXPECT_EQ(info.bytes_per_texel, format == MapFormat::exr_float ? 4 : 2) << name;
    }
    EXPECT_THROW(map_info(folder.path() / "none.png"), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::memory_estimate_test
