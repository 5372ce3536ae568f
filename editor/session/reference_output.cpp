// See reference_output.h.
#include "editor/session/reference_output.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace relievo {
namespace {

using glm::dvec3;

template <typename Vector>
std::vector<float> floats_of(const std::vector<Vector>& vectors) {
    std::vector<float> values;
    for (const Vector& vector : vectors)
        for (int k = 0; k < Vector::length(); ++k) values.push_back(static_cast<float>(vector[k]));
    return values;
}

std::uint8_t display_value(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(std::lround(encoded * 255));
}

DisplayPicture display_of(const ReferenceImage& image, const std::vector<float>& light) {
    DisplayPicture picture{image.width, image.height, {}};
    for (std::size_t i = 0; i < light.size(); ++i)
        picture.rgba.push_back(i % 4 == 3 ? 255 : display_value(light[i]));
    return picture;
}

}  // namespace

void check_reference_output(const std::filesystem::path& path, const std::vector<Layer>& aovs) {
    if (std::find(aovs.begin(), aovs.end(), Layer::shading_normal) != aovs.end())
        throw std::invalid_argument("--aov: the reference has no layer Ns; it has Z, N, uv, id");
    check_render_output(path, aovs);
}

std::vector<float> head_light(const ReferenceImage& image, const Camera& camera) {
    std::vector<float> light;
    light.reserve(image.depth.size() * 4);
    for (std::size_t i = 0; i < image.depth.size(); ++i) {
        const auto width = static_cast<std::size_t>(image.width);
        const dvec3 towards =
            reference_camera_ray(camera, dvec3(0), image.width, image.height,
                                 static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5)
                .direction;
        const bool hit = image.object[i] != 0;
        const auto grey = static_cast<float>(std::abs(glm::dot(towards, image.normal[i])));
        light.insert(light.end(), {grey, grey, grey, hit ? 1.0f : 0.0f});
    }
    return light;
}

std::vector<float> reference_layer(const ReferenceImage& image, Layer layer) {
    if (layer == Layer::depth) return {image.depth.begin(), image.depth.end()};
    if (layer == Layer::normal) return floats_of(image.normal);
    if (layer == Layer::uv) return floats_of(image.uv);
    if (layer == Layer::id) return {image.object.begin(), image.object.end()};
    throw std::logic_error("a layer that the reference does not have");
}

void write_reference(const ReferenceImage& image, const Camera& camera, const std::filesystem::path& path,
                     const std::vector<Layer>& aovs) {
    check_reference_output(path, aovs);
    const std::vector<float> light = head_light(image, camera);
    if (is_png(path)) return write_png(path, display_of(image, light));
    write_layers(path, image.width, image.height, light, aovs,
                 [&](Layer layer) { return reference_layer(image, layer); });
}

}  // namespace relievo
