// Cases of the amplitude: none, far below what is seen, and ten times the edges' length; both signs.
#include <cmath>

#include "renderer/stability/case_parts.h"

namespace relievo::stability {
namespace {

struct Ground {
    const char *name, *what;
    double edge;  // typical length
    Case (*make)(double amplitude);
};

const Ground kGrounds[] = {
    {"plane", "a plane", 1, [](double a) { return on_plane(a, 0.5, dunes_map(64, 64)); }},
    {"ball", "a ball of 960 triangles", 0.2,
     [](double a) { return on_ball(a, 0.5, ball_dunes_map(128, 64)); }},
    {"lump", "30 irregular triangles", 1,
     [](double a) {
         Case c = on_lump(a, 0.5, ball_dunes_map(64, 64));
         // Rays cross dozens of sheets, which takes the reference its time as well.
         if (std::abs(a) > 1) c.size = 24, c.views = {c.views[0], c.views[2]};
         return c;
     }},
};

}  // namespace

std::vector<CaseEntry> amplitude_cases() {
    std::vector<CaseEntry> list;
    const auto add = [&](const std::string& name, const std::string& what, std::function<Case()> make) {
        list.push_back({"amplitudes", name, what, std::move(make)});
    };
    for (const Ground& ground : kGrounds) {
        const std::string on = std::string("_on_") + ground.name, where = std::string(", on ") + ground.what;
        const auto make = ground.make;
        const double ten = 10 * ground.edge;
        add("amplitude_0" + on, "amplitude 0" + where, [=] { return make(0); });
        add("amplitude_1em6" + on, "amplitude 1e-6" + where, [=] { return make(1e-6); });
        add("amplitude_minus_1em6" + on, "amplitude -1e-6" + where, [=] { return make(-1e-6); });
        add("ten_edges" + on, "amplitude ten times the edges" + where, [=] { return make(ten); });
        add("minus_ten_edges" + on, "amplitude minus ten times the edges" + where,
            [=] { return make(-ten); });
    }
    add("lump_high", "amplitude 0.4 of the radius on 30 irregular triangles",
        [] { return irregular(on_lump(0.4, 0.5, ball_dunes_map(128, 128))); });
    add("lump_carved", "amplitude -0.4 of the radius on 30 irregular triangles",
        [] { return on_lump(-0.4, 0.5, ball_dunes_map(128, 128)); });
    return list;
}

}  // namespace relievo::stability
