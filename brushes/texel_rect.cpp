// Merging the dirty rectangles of tiles into few larger ones.
#include "brushes/texel_rect.h"

#include <cstddef>

namespace relievo {
namespace {

// Merging is worth it while the union is at most this much larger than its parts: one copy command and one
// refresh of bounds cost about as much as a few thousand texels.
constexpr double kWaste = 1.3;
constexpr std::int64_t kFreeTexels = 2048;

bool before(const TexelRect& a, const TexelRect& b) {
    return a.y0 != b.y0 ? a.y0 < b.y0 : a.x0 < b.x0;
}

TexelRect united(TexelRect a, const TexelRect& b) {
    a.include(b);
    return a;
}

bool worth_merging(const TexelRect& a, const TexelRect& b) {
    const std::int64_t parts = a.area() + b.area();
    return static_cast<double>(united(a, b).area()) <= kWaste * static_cast<double>(parts) + kFreeTexels;
}

// Each rectangle takes in later ones that are near, unless the union would touch a third. False when none
// could.
bool merge_near(std::vector<TexelRect>& rects) {
    bool merged = false;
    for (std::size_t i = 0; i < rects.size(); ++i) {
        for (std::size_t j = i + 1; j < rects.size();) {
            const TexelRect both = united(rects[i], rects[j]);
            bool clear = worth_merging(rects[i], rects[j]);
            for (std::size_t k = 0; clear && k < rects.size(); ++k)
                clear = k == i || k == j || !both.overlaps(rects[k]);
            if (!clear) {
                ++j;
                continue;
            }
            rects[i] = both;
            rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(j));
            merged = true;
        }
    }
    return merged;
}

// Neighbours in one row of tiles, touching and of one height: linear time, and what most footprints are made
// of.
void merge_runs(std::vector<TexelRect>& rects) {
    std::vector<TexelRect> runs;
    for (const TexelRect& rect : rects) {
        if (!runs.empty() && runs.back().x1 == rect.x0 && runs.back().y0 == rect.y0 &&
            runs.back().y1 == rect.y1)
            runs.back().x1 = rect.x1;
        else
            runs.push_back(rect);
    }
    rects = std::move(runs);
}

// Merges whatever comes within `gap` texels of each other into bounding rectangles.
void merge_within(std::vector<TexelRect>& rects, int gap) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < rects.size(); ++i) {
            for (std::size_t j = i + 1; j < rects.size();) {
                const TexelRect& r = rects[i];
                if (!TexelRect{r.x0 - gap, r.y0 - gap, r.x1 + gap, r.y1 + gap}.overlaps(rects[j])) {
                    ++j;
                    continue;
                }
                rects[i].include(rects[j]);
                rects[j] = rects.back();
                rects.pop_back();
                changed = true;
            }
        }
    }
}

}  // namespace

std::vector<TexelRect> merge_rects(std::vector<TexelRect> rects, std::size_t most) {
    constexpr std::size_t kMany = 1024;  // beyond it the quadratic search for neighbours would be felt
    std::erase_if(rects, [](const TexelRect& rect) { return rect.empty(); });
    std::sort(rects.begin(), rects.end(), before);
    merge_runs(rects);
    if (rects.size() <= kMany) {
        while (merge_near(rects)) {
        }
    }
    for (int gap = 64; rects.size() > std::max<std::size_t>(most, 1); gap *= 2) merge_within(rects, gap);
    std::sort(rects.begin(), rects.end(), before);
    return rects;
}

}  // namespace relievo
