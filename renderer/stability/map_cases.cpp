// Cases of the map: its values, its size, how it wraps.
#include <cmath>

#include "renderer/stability/case_parts.h"
#include "renderer/stability/extreme_meshes.h"

namespace relievo::stability {
namespace {

MapShape clamped(MapShape map) {
    map.wrap = Wrap::clamp;
    return map;
}

MapShape fur_map(int width, int height) {
    return {width, height, [](int x, int y) { return std::pow(hash01(unsigned(x), unsigned(y), 9), 4); }};
}

MapShape steps_map(int width, int height, int period) {
    return {width, height, [=](int x, int y) { return (x + y) % period / double(period - 1); }};
}

// One wall across the map: 0 beside 65535, and again at the map's border.
MapShape wall_map(int width, int height, Wrap wrap) {
    return {width, height, [=](int x, int) { return x < width / 2 ? 0.0 : 1.0; }, wrap};
}

void add_values(std::vector<CaseEntry>& list) {
    const auto add = [&](const char* name, const char* what, std::function<Case()> make) {
        list.push_back({"map values", name, what, std::move(make)});
    };
    add("dunes", "smooth hills on a plane", [] { return smooth(on_plane(0.15, 0.5, dunes_map(256, 256))); });
    add("ball", "smooth hills on a ball of 960 triangles",
        [] { return smooth(on_ball(0.2, 0.5, ball_dunes_map(256, 128))); });
    add("ball_carved", "the same, carved by a negative amplitude at midlevel 0",
        [] { return smooth(on_ball(-0.1, 0.0, ball_dunes_map(256, 128))); });
    add("lump", "30 irregular triangles",
        [] { return irregular(on_lump(0.1, 0.5, ball_dunes_map(128, 128))); });
    add("ramp", "one slope across the map, clamped", [] {
        return smooth(on_plane(0.3, 0.5, {64, 64, [](int x, int) { return x / 63.0; }, Wrap::clamp}));
    });
    add("ramps", "slopes that end in cliffs", [] {
        return smooth(on_plane(0.1, 0, {128, 128, [](int x, int) { return x % 32 / 31.0; }}));
    });
    add("terraces", "a chessboard of plateaus", [] {
        return smooth(on_plane(0.1, 0, {64, 64, [](int x, int y) { return (x / 8 + y / 8) % 2; }}));
    });
    add("wall_repeat", "one texel cliff, 0 beside 65535, and one at the border",
        [] { return on_plane(0.2, 0.5, wall_map(33, 16, Wrap::repeat)); });
    add("wall_clamp", "one texel cliff, clamped",
        [] { return on_plane(-0.2, 0.5, wall_map(33, 16, Wrap::clamp)); });
    add("cliffs", "0 and 65535 side by side at random, on a plane",
        [] { return on_plane(0.05, 1.0, clamped(cliff_map(64, 64))); });
    add("cliffs_on_ball", "the same on a ball", [] { return on_ball(0.1, 0.3, cliff_map(128, 64)); });
    add("cliffs_on_lump", "the same on 30 irregular triangles",
        [] { return on_lump(0.2, 0.5, cliff_map(64, 64)); });
    add("spikes", "single texels stand up", [] { return on_plane(0.1, 0.2, spike_map(96, 96)); });
    add("spikes_on_ball", "the same on a ball", [] { return on_ball(0.2, 0.2, spike_map(256, 128)); });
    add("spikes_on_lump", "the same on 30 irregular triangles",
        [] { return on_lump(0.2, 0.2, spike_map(64, 64)); });
    add("spikes_seen_from_between", "high spikes on a lump with holes, the eye among them", [] {
        MapShape spikes = spike_map(163, 194);
        spikes.wrap = Wrap::clamp;
        return on_mesh(with_holes(lump_mesh()), {{"from inside", {-0.1555, -0.1984, 0.1614}, {0.699, 0.2837, -0.0197}}}, -1,
                       0.5, spikes);
    });
    add("ridges", "single columns and rows are carved",
        [] { return on_plane(-0.1, 0.8, ridge_map(77, 77)); });
    add("ridges_on_ball", "single columns and rows stand up, on a ball",
        [] { return on_ball(0.15, 0.5, ridge_map(255, 127)); });
    add("fur_on_ball", "a needle in every texel", [] { return on_ball(0.1, 0.0, fur_map(512, 256)); });
    add("fur_on_lump", "the same on 30 irregular triangles",
        [] { return on_lump(0.1, 0.0, fur_map(256, 256)); });
    add("noise_on_lump", "white noise", [] { return on_lump(-0.15, 0.5, noise_map(64, 64)); });
}

void add_flats(std::vector<CaseEntry>& list) {
    const auto add = [&](const std::string& name, const std::string& what, std::function<Case()> make) {
        list.push_back({"flat maps", name, what, std::move(make)});
    };
    const struct {
        const char *name, *what;
        double value;
    } heights[] = {{"flat_low", "at 0", 0.0}, {"flat_mid", "at midlevel", 0.5}, {"flat_high", "at 1", 1.0}};
    for (const auto& [name, what, value] : heights) {
        add(name, std::string("a flat map ") + what + ", on a plane",
            [v = value] { return smooth(on_plane(0.2, 0.5, flat_map(v))); });
        add(std::string(name) + "_on_ball", std::string("a flat map ") + what + ", on a ball",
            [v = value] { return on_ball(0.3, 0.5, flat_map(v)); });
        add(std::string(name) + "_on_lump", std::string("a flat map ") + what + ", on 30 irregular triangles",
            [v = value] { return on_lump(0.3, 0.5, flat_map(v)); });
    }
    for (const double midlevel : {0.0, 0.5, 1.0}) {
        const std::string name = midlevel == 0 ? "0" : midlevel == 1 ? "1" : "half";
        add("midlevel_" + name + "_on_lump", "midlevel " + name + ", hills on 30 irregular triangles",
            [=] { return on_lump(0.15, midlevel, ball_dunes_map(64, 64)); });
    }
}

void add_sizes(std::vector<CaseEntry>& list) {
    const auto add = [&](const char* name, const char* what, std::function<Case()> make) {
        list.push_back({"map sizes", name, what, std::move(make)});
    };
    add("one_texel", "1 x 1 on a ball", [] { return on_ball(0.2, 0.5, flat_map(0.8, 1, 1)); });
    add("one_texel_clamp", "1 x 1, clamped, on a plane",
        [] { return on_plane(-0.2, 0.5, clamped(flat_map(0.8, 1, 1))); });
    add("one_by_nine", "1 x 9", [] { return on_plane(0.2, 0.5, steps_map(1, 9, 3)); });
    add("nine_by_one", "9 x 1, clamped", [] { return on_plane(0.2, 0.5, clamped(steps_map(9, 1, 3))); });
    add("one_by_nine_on_ball", "1 x 9 on a ball", [] {
        return on_ball(0.3, 0.5, {1, 9, [](int, int y) { return y / 8.0; }});
    });
    add("one_by_4096", "1 x 4096", [] { return on_plane(0.1, 0.5, steps_map(1, 4096, 128)); });
    add("8192_by_one", "8192 x 1", [] { return on_plane(0.1, 0.5, steps_map(8192, 1, 256)); });
    add("two_by_two", "2 x 2", [] { return on_lump(0.2, 0.5, cliff_map(2, 2)); });
    add("three_by_two", "3 x 2, clamped", [] { return on_plane(0.2, 0.5, clamped(noise_map(3, 2))); });
    add("seven_by_five", "7 x 5 on 30 irregular triangles",
        [] { return on_lump(0.2, 0.5, ball_dunes_map(7, 5)); });
    add("seventeen_by_129", "17 x 129", [] { return on_lump(0.1, 0.5, clamped(ball_dunes_map(17, 129))); });
    add("large_odd_map", "1777 x 601", [] {
        return on_plane(0.1, 0.5, {1777, 601, [](int x, int y) { return dunes(x / 100.0, y / 90.0); }});
    });
    add("8192_map", "8192 x 1024, hills of 100 texels", [] {
        return on_plane(0.1, 0.5, {8192, 1024, [](int x, int y) { return dunes(x / 1024.0, y / 512.0); }});
    });
    // So large that methods leave the finest bounds out.
    add("16384_map", "16384 x 1024, hills and needles of a texel, on a ball", [] {
        return on_ball(0.1, 0.3, {16384, 1024, [](int x, int y) {
                                      const bool needle = hash01(unsigned(x), unsigned(y), 4) > 0.999;
                                      return needle ? 1.0 : 0.8 * ball_dunes((x + 0.5) / 16384, (y + 0.5) / 1024);
                                  }});
    });
}

}  // namespace

std::vector<CaseEntry> map_cases() {
    std::vector<CaseEntry> list;
    add_values(list);
    add_flats(list);
    add_sizes(list);
    return list;
}

}  // namespace relievo::stability
