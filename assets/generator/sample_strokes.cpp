// The sample journals: rocks raised on the stump, a groove carved around the orb, a first minute on the
// asteroid.
#include <cmath>
#include <glm/geometric.hpp>

#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"
#include "assets/generator/strokes.h"

namespace relievo::assets {
namespace {

using Line = std::vector<glm::dvec3>;

struct Axes {
    glm::dvec3 u, v;  // unit, square to the axis and to each other
};
Axes across(glm::dvec3 axis) {
    const glm::dvec3 aside = std::fabs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(aside, axis));
    return {u, glm::cross(axis, u)};
}

// From `inner` to `outer` in the given number of turns around a point.
Line spiral(glm::dvec3 centre, glm::dvec3 axis, double inner, double outer, double turns) {
    const Axes axes = across(axis);
    Line line;
    const int steps = 1 + static_cast<int>(turns * 36);
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps, angle = 2.0 * kPi * turns * part;
        line.push_back(centre + mix(inner, outer, part) * (axes.u * cosine(angle) + axes.v * sine(angle)));
    }
    return line;
}

// A circle of the unit sphere around `axis`, `angle` radians from it, drawn by a hand that wavers; starts
// behind.
Line parallel(glm::dvec3 axis, double angle, double waver) {
    const Axes axes = across(axis);
    Line line;
    for (int i = 0; i <= 240; ++i) {
        const double turn = 2.0 * kPi * i / 240;
        const glm::dvec3 out = axes.u * cosine(turn) + axes.v * sine(turn);
        const double a = angle + waver * noise(out * 1.7, 601);
        line.push_back(axis * cosine(a) + out * sine(a));
    }
    return line;
}

// One rock: the ground evened, a steep mound, facets knocked flat, a gap all around, a crack.
void raise_rock(StrokeJournal& journal, glm::dvec3 where, double radius, std::uint32_t seed) {
    const StrokeJournal::Foot foot = journal.nearest(where);
    const glm::dvec3 c = foot.point, n = foot.normal;
    const Axes axes = across(n);
    journal.stroke({"smooth", 0.7 * radius, 1.0, 0.5, 0.2}, spiral(c, n, 0.1 * radius, 0.5 * radius, 1.5),
                   0.8);
    journal.stroke({"draw", 0.5 * radius, 0.95, 0.6}, spiral(c, n, 0.22 * radius, 0.5 * radius, 2.3), 0.6);
    constexpr std::uint32_t kFacets = 4;
    for (std::uint32_t k = 0; k < kFacets; ++k) {
        const double angle = 2.0 * kPi * (k + 0.6 * hash01(k, 0, 0, seed)) / kFacets;
        const glm::dvec3 aside = axes.u * cosine(angle) + axes.v * sine(angle);
        const glm::dvec3 along = glm::cross(n, aside);
        const glm::dvec3 facet = c + aside * (radius * (0.35 + 0.3 * hash01(k, 1, 0, seed)));
        journal.stroke({"flatten", 0.45 * radius, 0.85, 0.6, 0.2},
                       {facet - along * (0.25 * radius), facet + along * (0.25 * radius)}, 0.35);
    }
    journal.stroke({"draw", 0.16 * radius, 1.0, 0.2, 0.25, true},
                   spiral(c, n, 1.02 * radius, 1.06 * radius, 1.02), 0.6);
    const double angle = 2.0 * kPi * hash01(7, 2, 0, seed);
    const glm::dvec3 way = axes.u * cosine(angle) + axes.v * sine(angle);
    const glm::dvec3 bend = glm::cross(n, way) * (0.3 * radius * (hash01(8, 3, 0, seed) - 0.5));
    journal.stroke({"draw", 0.1 * radius, 1.0, 0.0, 0.25, true},
                   {c - way * (0.7 * radius), c + bend, c + way * (0.8 * radius)}, 0.4);
}

void rocks_on_the_stump(StrokeJournal& journal) {
    struct Rock {
        glm::dvec3 where;
        double radius;
    };
    constexpr Rock kRocks[] = {{{0.2, 1.2, 0.12}, 0.24},   {{-0.26, 1.2, 0.2}, 0.16},
                               {{-0.08, 1.2, -0.28}, 0.2}, {{0.62, 0.7, 0.45}, 0.2},
                               {{0.15, 0.62, 0.8}, 0.24},  {{0.55, 0.28, 0.85}, 0.17},
                               {{-0.35, 0.4, 0.95}, 0.19}};
    std::uint32_t seed = 611;
    for (const Rock& rock : kRocks) raise_rock(journal, rock.where, rock.radius, seed++);
    // A slip of the hand over the rings, taken back.
    journal.stroke({"draw", 0.12, 1.0}, {{-0.3, 1.2, -0.3}, {0.4, 1.2, 0.0}, {0.5, 1.2, 0.4}}, 1.2);
    journal.undo();
    // Moss on the edge: wood and bark beside the rocks are softened, over the slanted seam.
    journal.stroke({"smooth", 0.1, 0.7, 0.0, 0.2}, {{0.58, 1.12, 0.15}, {0.5, 1.12, 0.38}, {0.3, 1.14, 0.56}},
                   0.5);
}

void groove_around_the_orb(StrokeJournal& journal) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(-0.52, 0.83, -0.12));
    constexpr double kMiddle = kPi / 2.0, kWaver = 0.05;
    // The ornament is taken off along a band, the band is hollowed out twice, its edges are raised and
    // evened.
    StrokeBrush clear{"level", 0.2, 1.0, 0.75, 0.2};
    clear.level = 0.54;
    journal.stroke(clear, parallel(axis, kMiddle, kWaver), 1.4);
    journal.stroke({"draw", 0.13, 1.0, 0.3, 0.2, true}, parallel(axis, kMiddle, kWaver), 0.9);
    journal.stroke({"draw", 0.07, 1.0, 0.2, 0.3, true}, parallel(axis, kMiddle, kWaver), 0.9);
    for (const double side : {-0.165, 0.165})
        journal.stroke({"draw", 0.045, 1.0, 0.2, 0.3}, parallel(axis, kMiddle + side, kWaver), 0.9);
    journal.stroke({"smooth", 0.07, 0.5, 0.0, 0.4}, parallel(axis, kMiddle, kWaver), 1.4);
}

void first_minute_on_the_asteroid(StrokeJournal& journal) {
    const glm::dvec3 front = glm::normalize(glm::dvec3(0.72, 0.22, 0.66));
    const Axes axes = across(front);
    const auto at = [&](double right, double up) { return front * 0.95 + axes.u * right + axes.v * up; };
    // What everyone does first: one long wave across the front.
    Line wave;
    for (int i = 0; i <= 80; ++i) {
        const double x = -0.75 + 1.2 * i / 80.0;
        wave.push_back(at(x, -0.2 + 0.15 * sine(9.0 * x)));
    }
    journal.stroke({"draw", 0.085, 1.0, 0.4}, wave, 0.7);
    journal.stroke({"draw", 0.06, 1.0, 0.4}, wave, 0.9);
    // Then the other way: a crater, its rim, and a hill in its middle.
    const StrokeJournal::Foot foot = journal.nearest(at(-0.15, 0.42));
    const glm::dvec3 c = foot.point, n = foot.normal;
    journal.stroke({"smooth", 0.2, 1.0, 0.5, 0.2}, spiral(c, n, 0.05, 0.22, 2.0), 0.9);
    journal.stroke({"draw", 0.13, 1.0, 0.3, 0.15, true}, spiral(c, n, 0.02, 0.13, 2.2), 0.6);
    journal.stroke({"draw", 0.07, 1.0, 0.2}, spiral(c, n, 0.27, 0.27, 1.05), 0.6);
    journal.stroke({"draw", 0.07, 1.0}, spiral(c, n, 0.0, 0.03, 2.0), 0.3);
    journal.stroke({"smooth", 0.1, 0.5, 0.0, 0.25}, spiral(c, n, 0.1, 0.25, 2.0), 0.8);
}

}  // namespace

void write_sample_strokes(const std::string& asset, const Shape& shape, const std::filesystem::path& folder) {
    struct Entry {
        const char *asset, *file;
        void (*make)(StrokeJournal&);
    };
    constexpr Entry kEntries[] = {{"stump", "stump_rocks", rocks_on_the_stump},
                                  {"orb", "orb_groove", groove_around_the_orb},
                                  {"asteroid", "asteroid_first_minute", first_minute_on_the_asteroid}};
    for (const Entry& entry : kEntries) {
        if (asset != entry.asset) continue;
        StrokeJournal journal(shape, "../scenes/" + asset + ".json");
        entry.make(journal);
        journal.write(folder / (std::string(entry.file) + ".jsonl"));
    }
}

}  // namespace relievo::assets
