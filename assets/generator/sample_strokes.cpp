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

// One rock: a mound, facets knocked flat, two cracks.
void raise_rock(StrokeJournal& journal, glm::dvec3 where, double radius, std::uint32_t seed) {
    const StrokeJournal::Foot foot = journal.nearest(where);
    const glm::dvec3 c = foot.point, n = foot.normal;
    const Axes axes = across(n);
    journal.stroke({"draw", radius, 0.95, 0.35}, spiral(c, n, 0.05 * radius, 0.45 * radius, 1.6), 0.5);
    for (std::uint32_t k = 0; k < 3; ++k) {
        const double angle = 2.0 * kPi * (k / 3.0 + 0.2 * hash01(k, 0, 0, seed));
        const glm::dvec3 aside = axes.u * cosine(angle) + axes.v * sine(angle);
        const glm::dvec3 along = glm::cross(n, aside);
        const glm::dvec3 facet = c + aside * (0.55 * radius);
        journal.stroke({"flatten", 0.55 * radius, 0.75, 0.4, 0.2},
                       {facet - along * (0.2 * radius), facet + along * (0.2 * radius)}, 0.35);
    }
    for (std::uint32_t k = 0; k < 2; ++k) {
        const double angle = 2.0 * kPi * hash01(k, 1, 0, seed);
        const glm::dvec3 way = axes.u * cosine(angle) + axes.v * sine(angle);
        const glm::dvec3 bend = glm::cross(n, way) * (0.25 * radius * (hash01(k, 2, 0, seed) - 0.5));
        journal.stroke({"draw", 0.16 * radius, 0.85, 0.0, 0.25, true},
                       {c - way * (0.75 * radius), c + bend, c + way * (0.8 * radius)}, 0.4);
    }
}

void rocks_on_the_stump(StrokeJournal& journal) {
    struct Rock {
        glm::dvec3 where;
        double radius;
    };
    constexpr Rock kRocks[] = {{{0.22, 1.2, 0.2}, 0.2},   {{-0.2, 1.2, 0.26}, 0.15},
                               {{0.06, 1.2, -0.2}, 0.17}, {{0.62, 0.62, 0.4}, 0.17},
                               {{0.1, 0.55, 0.9}, 0.2},   {{0.38, 0.3, 0.95}, 0.15},
                               {{-0.5, 1.13, 0.33}, 0.13}};
    std::uint32_t seed = 611;
    for (const Rock& rock : kRocks) raise_rock(journal, rock.where, rock.radius, seed++);
    // A slip of the hand over the rings, taken back.
    journal.stroke({"draw", 0.12, 1.0}, {{-0.3, 1.2, -0.3}, {0.4, 1.2, 0.0}, {0.5, 1.2, 0.4}}, 1.2);
    journal.undo();
    // Moss on the edge: the bark beside the first rocks is softened.
    journal.stroke({"smooth", 0.12, 0.7, 0.0, 0.2}, {{0.55, 1.1, 0.1}, {0.5, 1.12, 0.35}, {0.3, 1.14, 0.55}},
                   0.5);
}

void groove_around_the_orb(StrokeJournal& journal) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(-0.42, 0.8, 0.22));
    constexpr double kMiddle = kPi / 2.0, kWaver = 0.05;
    journal.stroke({"smooth", 0.12, 0.9, 0.3, 0.3}, parallel(axis, kMiddle, kWaver), 1.2);
    journal.stroke({"draw", 0.11, 0.9, 0.25, 0.2, true}, parallel(axis, kMiddle, kWaver), 0.9);
    journal.stroke({"draw", 0.055, 0.8, 0.0, 0.3, true}, parallel(axis, kMiddle, kWaver), 0.9);
    for (const double side : {-0.125, 0.125})
        journal.stroke({"draw", 0.05, 0.9, 0.2, 0.3}, parallel(axis, kMiddle + side, kWaver), 0.9);
    journal.stroke({"smooth", 0.06, 0.5, 0.0, 0.4}, parallel(axis, kMiddle, kWaver), 1.4);
}

void first_minute_on_the_asteroid(StrokeJournal& journal) {
    // What everyone does first: one long stroke across the front.
    Line wave;
    for (int i = 0; i <= 60; ++i) {
        const double x = -0.75 + 1.5 * i / 60.0;
        wave.push_back({x + 0.35, 0.25 * sine(4.2 * x) - 0.1, 0.95 - 0.5 * x});
    }
    journal.stroke({"draw", 0.14, 0.9, 0.1}, wave, 0.7);
    // Then the other way: a crater, its rim, and a hill in its middle.
    const StrokeJournal::Foot foot = journal.nearest({0.35, 0.55, 0.9});
    journal.stroke({"draw", 0.16, 0.8, 0.2, 0.15, true}, spiral(foot.point, foot.normal, 0.02, 0.14, 2.2),
                   0.6);
    journal.stroke({"draw", 0.07, 0.9, 0.1}, spiral(foot.point, foot.normal, 0.28, 0.28, 1.05), 0.6);
    journal.stroke({"smooth", 0.12, 0.6, 0.0, 0.2}, spiral(foot.point, foot.normal, 0.05, 0.2, 2.0), 0.8);
    journal.stroke({"draw", 0.07, 1.0}, spiral(foot.point, foot.normal, 0.0, 0.03, 2.0), 0.3);
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
