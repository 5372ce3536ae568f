// The numbers that a view shows, and their colours.
#include "editor/gui/layer_image.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "editor/gui/map_value.h"

namespace relievo::gui {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// Displacement of the surface at each pixel of a window, world units.
std::vector<float> heights(const Renderer& renderer, const PixelRect& window, const Session& session) {
    const std::vector<float> uv = renderer.traced_layer(Layer::uv, window);
    const std::vector<float> id = renderer.traced_layer(Layer::id, window);
    std::vector<float> values(id.size(), kNone);
    for (std::size_t i = 0; i < id.size(); ++i) {
        if (id[i] < 1) continue;
        const auto object = static_cast<std::size_t>(id[i]) - 1;
        const Displacement& d = session.scene().objects[object].displacement;
        const double counts = map_value(session.map_of(object), d.wrap, {uv[2 * i], uv[2 * i + 1]});
        values[i] = static_cast<float>(displacement_of(d, counts));
    }
    return values;
}

std::vector<float> normals(const Renderer& renderer, const PixelRect& window) {
    std::vector<float> values = renderer.traced_layer(Layer::normal, window);
    for (std::size_t i = 0; i < values.size(); i += 3)
        if (values[i] == 0 && values[i + 1] == 0 && values[i + 2] == 0) values[i] = kNone;
    return values;
}

std::vector<float> costs(const Renderer& renderer, const PixelRect& window, RayCount count) {
    const std::vector<float> counts = renderer.traced_layer(Layer::counts, window);
    std::vector<float> values(counts.size() / 4, kNone);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (counts[4 * i] > 0) values[i] = counts[4 * i + static_cast<std::size_t>(count)];
    return values;
}

// The absolute cosine between the surface's normal and the way the camera looks; 0 where nothing is hit.
std::vector<float> facing(const Renderer& renderer, const PixelRect& window) {
    const Camera& camera = renderer.camera();
    const glm::vec3 forward(glm::normalize(camera.look_at - camera.eye));
    const std::vector<float> n = renderer.traced_layer(Layer::normal, window);
    std::vector<float> values(n.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::min(1.0f, std::abs(glm::dot(forward, {n[3 * i], n[3 * i + 1], n[3 * i + 2]})));
    return values;
}

Rgb shaded(const Rgb& colour, float brightness) {
    const auto part = [&](std::uint8_t c) {
        return static_cast<std::uint8_t>(std::lround(static_cast<float>(c) * brightness));
    };
    return {part(colour.r), part(colour.g), part(colour.b)};
}

}  // namespace

std::vector<double> error_units(const Scene& scene) {
    std::vector<double> units;
    for (const SceneObject& object : scene.objects) {
        const double amplitude = std::abs(object.displacement.amplitude);
        units.push_back(amplitude > 0 ? amplitude : static_cast<double>(object.mesh.sphere_radius));
    }
    return units;
}

void LayerImage::reset(PixelSize size, View view) {
    size_ = size;
    view_ = view;
    channels_ = view == View::normals ? 3 : 1;
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    values_.assign(pixels * channels_, kNone);
    facing_.assign(view == View::error ? pixels : 0, 0);
    rgba_.assign(pixels * 4, 255);
}

void LayerImage::collect(const Renderer& renderer, const PixelRect& window, RayCount count,
                         const Session& session) {
    const std::vector<float> fresh = view_ == View::normals  ? normals(renderer, window)
                                     : view_ == View::height ? heights(renderer, window, session)
                                     : view_ == View::steps  ? costs(renderer, window, count)
                                                             : renderer.traced_layer(Layer::depth, window);
    put(fresh, window, channels_, values_);
    if (view_ == View::error) put(facing(renderer, window), window, 1, facing_);
}

void LayerImage::put(const std::vector<float>& from, const PixelRect& window, std::size_t channels,
                     std::vector<float>& to) const {
    const std::size_t row = static_cast<std::size_t>(window.x1 - window.x0) * channels;
    for (int y = window.y0; y < window.y1; ++y)
        std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(row) * (y - window.y0), row,
                    to.begin() + static_cast<std::ptrdiff_t>(index(window.x0, y) * channels));
}

void LayerImage::paint(const PixelRect& window, const Palette& palette) {
    for (int y = window.y0; y < window.y1; ++y) {
        for (int x = window.x0; x < window.x1; ++x) {
            const Rgb c = colour(x, y, palette);
            std::uint8_t* to = rgba_.data() + index(x, y) * 4;
            to[0] = c.r;
            to[1] = c.g;
            to[2] = c.b;
        }
    }
}

Rgb LayerImage::colour(int x, int y, const Palette& palette) const {
    if (view_ == View::error) return error_colour(x, y, palette);
    const float* value = values_.data() + index(x, y) * channels_;
    if (std::isnan(*value)) return kNothing;
    if (view_ == View::normals) return normal_colour({value[0], value[1], value[2]});
    return palette.scale.colour(static_cast<double>(*value));
}

Rgb LayerImage::error_colour(int x, int y, const Palette& palette) const {
    const ReferencePicture* reference = palette.reference;
    const bool known = reference && reference->width() == size_.width && reference->height() == size_.height;
    const auto sample = known ? reference->at(x, y) : std::nullopt;
    const auto depth = static_cast<double>(sample ? values_[index(sample->x, sample->y)] : kNone);
    if (std::isnan(depth)) return shaded(kNotKnown, 0.3f + 0.7f * facing_[index(x, y)]);
    const bool hit = std::isfinite(depth), hit_there = sample->object > 0;
    if (!hit || !hit_there) return hit ? kInvented : hit_there ? kMissed : kNothing;
    return palette.scale.colour(std::abs(depth - sample->depth) / palette.units[sample->object - 1]);
}

double LayerImage::quantile(double rank) const {
    std::vector<float> known;
    for (const float value : values_)
        if (std::isfinite(value)) known.push_back(std::abs(value));
    if (known.empty()) return 0;
    const auto place = static_cast<std::ptrdiff_t>(rank * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), known.begin() + place, known.end());
    return static_cast<double>(known[static_cast<std::size_t>(place)]);
}

ErrorSummary LayerImage::errors(const Palette& palette, int stride) const {
    ErrorSummary summary;
    const ReferencePicture* reference = palette.reference;
    if (view_ != View::error || !reference || reference->width() != size_.width ||
        reference->height() != size_.height)
        return summary;
    std::vector<double> errors;
    for (int y = 0; y < size_.height; y += stride) {
        for (int x = 0; x < size_.width; x += stride) {
            const auto sample = reference->at(x, y);
            const auto depth = static_cast<double>(values_[index(x, y)]);
            if (!sample || sample->x != x || sample->y != y || std::isnan(depth)) continue;
            const bool hit = std::isfinite(depth), hit_there = sample->object > 0;
            summary.missed += hit_there && !hit ? 1 : 0;
            summary.invented += hit && !hit_there ? 1 : 0;
            if (hit && hit_there)
                errors.push_back(std::abs(depth - sample->depth) / palette.units[sample->object - 1]);
        }
    }
    summary.pixels = errors.size();
    if (errors.empty()) return summary;
    const auto at = [&](double rank) {
        const auto place = static_cast<std::ptrdiff_t>(rank * static_cast<double>(errors.size() - 1));
        std::nth_element(errors.begin(), errors.begin() + place, errors.end());
        return errors[static_cast<std::size_t>(place)];
    };
    summary.median = at(0.5);
    summary.p99 = at(0.99);
    summary.largest = at(1);
    return summary;
}

}  // namespace relievo::gui
