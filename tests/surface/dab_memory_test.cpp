// What dabs hold while they work, counted by the heap itself: as dab_cost.h says, for every tool, and for
// many copies no more than for a few.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "brushes/copy_changes.h"
#include "brushes/dab_cost.h"
#include "brushes/sculptor.h"
#include "brushes/symmetry.h"
#include "test_meshes.h"

namespace {

std::atomic<std::size_t> held{0}, most_held{0};  // bytes

void took(std::size_t bytes) {
    const std::size_t now = held += bytes;
    for (std::size_t seen = most_held; now > seen && !most_held.compare_exchange_weak(seen, now);) {
    }
}

}  // namespace

void* operator new(std::size_t size) {
    void* const place = std::malloc(size);
    if (!place) throw std::bad_alloc();
    took(malloc_usable_size(place));
    return place;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    void* const place = std::malloc(size);
    if (place) took(malloc_usable_size(place));
    return place;
}
void operator delete(void* place) noexcept {
    if (place) held -= malloc_usable_size(place);
    std::free(place);
}
void operator delete(void* place, std::size_t) noexcept {
    if (place) held -= malloc_usable_size(place);
    std::free(place);
}

namespace relievo::dab_memory_test {
namespace {

// The unit square at a map of 1024 x 1024 texels, dabbed in the middle.
struct Sheet {
    Sheet()
        : mesh(test::plane()),
          map(1024, 1024),
          surface(mesh, test::displacement(0.1), map),
          sculptor(map, surface) {
        constexpr std::uint32_t kHalf = Dab::kBarycentricOne / 2;
        for (const FacePoint& point : {FacePoint{0, kHalf, 0}, {0, 0, kHalf}, {0, kHalf, kHalf}}) {
            const glm::vec3 base = surface.at(0, point.b1 ? 0.5f : 0.0f, point.b2 ? 0.5f : 0.0f).base;
            if (glm::length(glm::vec2(base) - glm::vec2(0.5f)) < 1e-3f) middle = point;
        }
    }

    // Bytes that the first dab of a stroke holds at most, beyond those that it leaves; the stroke goes on.
    std::size_t first_dab(const Brush& brush) {
        const std::size_t copies = symmetry_copies(brush, surface.world_from_object()).size();
        const std::vector<FacePoint> others(copies - 1, middle),
            sources(brush.tool == Tool::clone ? copies : 0, middle);
        sculptor.begin(brush, image);
        Dab dab{};
        dab.face = middle.face, dab.b1 = middle.b1, dab.b2 = middle.b2;
        dab.pressure = Dab::kPressureOne;
        dab.size = Dab::kSizeOne;
        const bool moves = brush.tool == Tool::smear || brush.tool == Tool::grab;
        if (moves) {  // smear needs a way from the last dab, grab a drag
            Dab before = dab;
            (before.b1 > 0 ? before.b1 : before.b2) -= Dab::kBarycentricOne / 64;
            if (brush.tool == Tool::smear) sculptor.dab(before, others, sources);
            dab.drag[0] = Dab::kDragOne / 8;
        }
        const std::size_t at_first = held;
        most_held = at_first;
        sculptor.dab(dab, others, sources);
        return most_held - at_first;
    }

    Mesh mesh;
    HeightMap map;
    MeshSurface surface;
    Sculptor sculptor;
    FacePoint middle{};
    std::shared_ptr<const Alpha> image =
        std::make_shared<const Alpha>("grey.png", 2, 2, std::vector<float>(4, 0.5f));
};

constexpr std::size_t kTiles = 26000 * 16 * 16;  // of a stroke over the whole map

TEST(DabMemory, one_copy_of_every_tool_keeps_to_its_bound) {
    for (const ToolInfo& tool : tools()) {
        Sheet sheet;
        Brush brush;
        brush.tool = tool.tool;
        brush.blur = tool.tool == Tool::mask;  // which holds more than to paint it
        brush.radius = 0.2f;
        const std::size_t texels = sheet.surface.count_in_ball({0.5f, 0.5f, 0}, brush.radius);
        ASSERT_GT(texels, 120000u);
        const std::size_t mask = tool.tool == Tool::mask ? 2 * 1024 * 1024 : 0;
        EXPECT_LE(sheet.first_dab(brush), bytes_of_copy(tool.tool, texels) + kTiles + mask) << tool.name;
    }
}

TEST(DabMemory, many_copies_hold_no_more_than_the_bound) {
    for (const Tool tool : {Tool::draw, Tool::smooth, Tool::crease}) {
        Sheet sheet;
        Brush brush;
        brush.tool = tool;
        brush.radius = tool == Tool::draw ? 2.0f : 0.25f;  // draw: every texel, in each of 16 copies or more
        brush.mirror_x = brush.mirror_y = brush.mirror_z = tool == Tool::draw;
        brush.radial = tool == Tool::draw ? 4 : 6;
        constexpr std::size_t kSums = 16 * 1024 * 1024;  // 16 bytes a texel
        EXPECT_LE(sheet.first_dab(brush), kDabBytes + CopyChanges::kWaiting + kSums + kTiles)
            << static_cast<int>(tool);
    }
}

TEST(DabMemory, many_copies_that_paint_hold_little_more) {
    ColourMap colours(1024, 1024, 8);
    for (const Tool tool : {Tool::draw, Tool::smooth}) {
        Sheet sheet;
        sheet.sculptor.set_colours(colours);
        Brush brush;
        brush.tool = tool;
        brush.paint = Paint::colour;
        brush.radius = tool == Tool::draw ? 2.0f : 0.3f;
        brush.mirror_x = brush.mirror_y = true;
        brush.radial = tool == Tool::draw ? 6 : 1;
        constexpr std::size_t kSums = 16 * 1024 * 1024, kWeights = 72 * 1024 * 1024;
        EXPECT_LE(sheet.first_dab(brush), kDabBytes + CopyChanges::kWaiting + kSums + kWeights + 3 * kTiles)
            << static_cast<int>(tool);
        sheet.sculptor.cancel();
    }
}

TEST(DabMemory, what_grab_holds_goes_with_the_stroke) {
    for (const bool cancelled : {false, true}) {
        Sheet sheet;
        Brush brush;
        brush.tool = Tool::grab;
        brush.radius = 0.2f;
        brush.mirror_x = brush.mirror_y = true;
        const std::size_t before = held;
        sheet.first_dab(brush);
        EXPECT_GT(held - before, std::size_t{60} << 20);
        cancelled ? sheet.sculptor.cancel() : sheet.sculptor.end();
        EXPECT_LT(held - before, kTiles + sheet.sculptor.undo_bytes());
    }
}

TEST(DabMemory, as_many_copies_are_in_work_as_the_bound_allows) {
    for (const ToolInfo& tool : tools())
        for (const std::size_t texels : {0u, 1u, 1000u, 100000u, 100000000u}) {
            const std::size_t copies = copies_at_once(tool.tool, texels);
            EXPECT_GE(copies, 1u);
            EXPECT_LE((copies > 1 ? copies : 0) * bytes_of_copy(tool.tool, texels), kDabBytes);
        }
}

}  // namespace
}  // namespace relievo::dab_memory_test
