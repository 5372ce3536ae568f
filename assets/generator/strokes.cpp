// Strokes on a base mesh: nearest points (Ericson, "Real-Time Collision Detection", 5.1.5), arc-length
// spacing, and the journal's lines.
#include "assets/generator/strokes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <stdexcept>

#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr double kBarycentricOne = 1 << 20, kPressureOne = 65535;  // units of a journal's dabs

std::string number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
    return {text, end};
}

// Barycentrics (b1, b2) of the triangle's point nearest to p.
glm::dvec2 nearest_barycentrics(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {0, 0};
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {1 - w, w};
    }
    const double all = va + vb + vc;
    return {vb / all, vc / all};
}

std::string brush_text(const StrokeBrush& brush) {
    std::string text = R"({"tool":")";
    text += brush.tool;
    text += R"(","falloff":")";
    text += brush.falloff;
    text += R"(","invert":)";
    text += brush.lower ? "true" : "false";
    text += R"(,"radius":)" + number(brush.radius);
    text += R"(,"strength":)" + number(brush.strength);
    text += R"(,"hardness":)" + number(brush.hardness);
    text += R"(,"spacing":)" + number(brush.spacing);
    text += R"(,"level":)" + number(brush.level);
    return text + "}";
}

std::string dab_text(const StrokeJournal::Foot& foot, double seconds, double pressure) {
    const auto one = static_cast<long>(kBarycentricOne);
    const long b1 = std::clamp(std::lround(foot.b1 * kBarycentricOne), 0L, one);
    const long b2 = std::clamp(std::lround(foot.b2 * kBarycentricOne), 0L, one - b1);
    std::string text = "[";
    for (const long value : {std::lround(seconds * 1e6), static_cast<long>(foot.face), b1, b2})
        text += std::to_string(value) + ",";
    return text + std::to_string(std::lround(clamp01(pressure) * kPressureOne)) + "]";
}

}  // namespace

StrokeJournal::StrokeJournal(const Shape& shape, const std::string& scene) {
    text_ = R"({"relievo_journal":1,"scene":")";
    text_ += scene;
    text_ += "\"}\n";
    for (const Triangle& t : shape.triangles()) {
        Face face{shape.positions[t.position[0]],
                  shape.positions[t.position[1]],
                  shape.positions[t.position[2]],
                  {},
                  0};
        face.centre = (face.a + face.b + face.c) / 3.0;
        for (const glm::dvec3& corner : {face.a, face.b, face.c})
            face.reach = std::max(face.reach, glm::distance(face.centre, corner));
        faces_.push_back(face);
    }
}

StrokeJournal::Foot StrokeJournal::nearest(glm::dvec3 p) const {
    Foot best{};
    double least = 1e300;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        const Face& f = faces_[i];
        if (glm::distance(p, f.centre) - f.reach >= least) continue;
        const glm::dvec2 b = nearest_barycentrics(p, f.a, f.b, f.c);
        const glm::dvec3 point = f.a * (1.0 - b.x - b.y) + f.b * b.x + f.c * b.y;
        const double distance = glm::distance(p, point);
        if (distance >= least) continue;
        least = distance;
        best = {point, glm::normalize(glm::cross(f.b - f.a, f.c - f.a)), i, b.x, b.y};
    }
    return best;
}

void StrokeJournal::stroke(const StrokeBrush& brush, const std::vector<glm::dvec3>& line, double speed) {
    const double step = brush.radius * brush.spacing;
    constexpr int kParts = 4;  // of a step: how finely the line is walked
    std::vector<Foot> feet{nearest(line.front())};
    glm::dvec3 last = feet.front().point;
    double gone = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const int parts = 1 + static_cast<int>(glm::distance(line[i - 1], line[i]) / step * kParts);
        for (int k = 1; k <= parts; ++k) {
            const Foot foot =
                nearest(line[i - 1] + (line[i] - line[i - 1]) * (static_cast<double>(k) / parts));
            gone += glm::distance(last, foot.point);
            last = foot.point;
            if (gone < step) continue;
            feet.push_back(foot);
            gone = 0.0;
        }
    }
    text_ += R"({"op":"stroke","brush":)";
    text_ += brush_text(brush);
    text_ += R"(,"dabs":[)";
    const auto count = static_cast<double>(feet.size());
    for (std::size_t i = 0; i < feet.size(); ++i) {
        const double part = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
        const double pressure = 0.35 + 0.65 * smooth_step(0.0, 0.08, part) * smooth_step(1.0, 0.92, part);
        if (i > 0) text_ += ",";
        text_ += dab_text(feet[i], static_cast<double>(i) * step / speed, pressure);
    }
    text_ += "]}\n";
}

void StrokeJournal::undo() {
    text_ += "{\"op\":\"undo\"}\n";
}

void StrokeJournal::write(const std::filesystem::path& path) const {
    std::ofstream file(path, std::ios::binary);
    file << text_;
    file.close();
    if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace relievo::assets
