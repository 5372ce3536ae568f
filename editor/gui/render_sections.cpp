// Sections of the side panel about how the surface is lit, and how far the picture is refined.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/widgets.h"
#include "renderer/features.h"
#include "renderer/vulkan/context.h"

namespace relievo::gui {
namespace {

std::vector<double> three(const float (&v)[3]) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// The sun's place in the sky, as seen from the camera's up vector: degrees.
struct SunPlace {
    float azimuth, elevation;
};

struct SkyAxes {
    glm::dvec3 up, east, south;
};

SkyAxes sky_axes(const Camera& camera) {
    const glm::dvec3 up = glm::normalize(camera.up);
    const glm::dvec3 x = std::abs(up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 east = glm::normalize(x - up * glm::dot(x, up));
    return {up, east, glm::cross(east, up)};
}

SunPlace place_of(const glm::dvec3& direction, const SkyAxes& axes) {
    const glm::dvec3 to_sun = -glm::normalize(direction);
    return {static_cast<float>(
                glm::degrees(std::atan2(glm::dot(to_sun, axes.east), glm::dot(to_sun, axes.south)))),
            static_cast<float>(glm::degrees(std::asin(std::clamp(glm::dot(to_sun, axes.up), -1.0, 1.0))))};
}

std::vector<double> direction_from(const SunPlace& place, const SkyAxes& axes) {
    const double a = glm::radians(static_cast<double>(place.azimuth));
    const double e = glm::radians(static_cast<double>(place.elevation));
    const glm::dvec3 to_sun =
        (axes.south * std::cos(a) + axes.east * std::sin(a)) * std::cos(e) + axes.up * std::sin(e);
    return {-to_sun.x, -to_sun.y, -to_sun.z};
}

void light_rows(Desk& desk, std::size_t index) {
    const Light light = desk.session.scene().lights[index];
    const std::string key = "lights[" + std::to_string(index) + "].";
    const bool sun = light.kind == Light::Kind::sun;
    ImGui::PushID(static_cast<int>(index));
    ImGui::TextUnformatted(sun ? "Sun" : "Point light");
    if (sun) {
        const SkyAxes axes = sky_axes(desk.session.scene().camera);
        SunPlace place = place_of(light.direction, axes);
        bool moved = slider_row("Direction", place.azimuth, {-180, 180, false, "%.0f deg"},
                                "Where the sun stands around the object; 0 is in front.");
        moved |= slider_row("Elevation", place.elevation, {-89, 89, false, "%.0f deg"},
                            "Low light shows relief best.");
        if (moved) desk.set(key + "direction", direction_from(place, axes));
    }
    float intensity = light.intensity;
    const float most = std::max(sun ? 12.0f : 100.0f, intensity);
    if (slider_row("Intensity", intensity, {0, most, false, "%.2f"},
                   sun ? "Irradiance." : "Radiant intensity, W/sr."))
        desk.set(key + "intensity", static_cast<double>(intensity));
    if (sun) {
        float angle = light.angle_deg;
        if (slider_row("Softness", angle, {0, 20, false, "%.1f deg"},
                       "Angular diameter of the sun: 0.5 in nature. Larger softens shadows."))
            desk.set(key + "angle_deg", static_cast<double>(angle));
    }
    ImGui::PopID();
}

// The first light's place stands for all.
void turn_row(Desk& desk) {
    const Scene& scene = desk.session.scene();
    const Light& first = scene.lights.front();
    const bool sun = first.kind == Light::Kind::sun;
    const glm::dvec3 travels = sun ? first.direction : scene.camera.look_at - first.position;
    if (glm::length(travels) == 0) return;
    const float now = place_of(travels, sky_axes(scene.camera)).azimuth;
    float wanted = now;
    if (slider_row("Turn all", wanted, {-180, 180, false, "%.0f deg"},
                   "All lights and the sky together around the object, as if it stood on a turntable.  L drags them."))
        desk.turn_light(static_cast<double>(wanted - now), scene.camera.up);
}

// The sky has no place around the object, but a zenith.
void upright_row(Desk& desk) {
    const Scene& scene = desk.session.scene();
    const glm::dvec3 up = glm::normalize(scene.camera.up);
    if (glm::length(glm::normalize(scene.environment.up) - up) < 1e-6) return;
    row_label("Zenith");
    if (push_button("Upright", true, "The sky's zenith above the object, as you look at it now."))
        desk.set("environment.up", std::vector<double>{up.x, up.y, up.z});
}

}  // namespace

void draw_lights_section(Desk& desk) {
    if (!section("Lights and material")) return;
    const std::size_t lights = desk.session.scene().lights.size();
    if (lights > 0) turn_row(desk);
    for (std::size_t i = 0; i < lights; ++i) light_rows(desk, i);
    ImGui::TextUnformatted("Sky");
    float sky = desk.session.scene().environment.intensity;
    if (slider_row("Sky light", sky, {0, std::max(4.0f, sky), false, "%.2f"}, "Brightness of the whole sky."))
        desk.set("environment.intensity", static_cast<double>(sky));
    upright_row(desk);
    ImGui::TextUnformatted("Material");
    const Material material = desk.session.scene().objects.front().material;
    float albedo[3] = {material.albedo.r, material.albedo.g, material.albedo.b};
    if (desk.session.colours()) {
        text_row("Albedo", "the colour map");
    } else if (color_row("Albedo", albedo, "Share of light that is scattered back, linear.")) {
        for (float& part : albedo) part = std::clamp(part, 0.0f, 1.0f);
        desk.set("material.albedo", three(albedo));
    }
    float roughness = material.roughness, specular = material.specular;
    if (slider_row("Roughness", roughness, {0.02f, 1}, "Small is polished, 1 is chalk."))
        desk.set("material.roughness", std::clamp(static_cast<double>(roughness), 0.02, 1.0));
    if (slider_row("Specular", specular, {0, 1},
                   "Reflectance at normal incidence; 0.04 for most matter, 0 for none."))
        desk.set("material.specular", std::clamp(static_cast<double>(specular), 0.0, 1.0));
}

void draw_render_section(Desk& desk) {
    if (!section("Render")) return;
    LivePicture& live = desk.live;
    constexpr std::array<const char*, 3> kNames{"every pixel", "half", "a third"};
    row_label("Resolution");
    if (ImGui::BeginCombo("##resolution", kNames[static_cast<std::size_t>(live.reduction() - 1)])) {
        for (int i = 0; i < static_cast<int>(kNames.size()); ++i)
            if (ImGui::Selectable(kNames[static_cast<std::size_t>(i)], live.reduction() == i + 1))
                live.set_reduction(i + 1);
        ImGui::EndCombo();
    }
    tooltip("Pixels that are traced, each way. Fewer are faster on a slow device.", "Resolution");
    row_label("Samples");
    auto limit = static_cast<float>(live.sample_limit());
    if (bar_slider("##limit", limit, {1, 4096, true}, "%.0f a pixel"))
        live.set_sample_limit(static_cast<int>(std::lround(limit)));
    tooltip("The picture refines up to so many samples, then rests.", "Samples");
    const vulkan::DeviceInfo& device = desk.session.context().info();
    text_row("Device", device.name);
    tooltip(device.verdict, device.driver);
    const FeatureReport& report = desk.session.renderer().features();
    std::uint64_t bytes = report.bytes_total;
    if (live.is_split()) bytes += live.renderer_at(live.size().width).features().bytes_total;
    char memory[64];
    std::snprintf(memory, sizeof memory, "%.1f MiB%s", static_cast<double>(bytes) / (1 << 20),
                  live.is_split() ? ", both" : "");
    text_row("Memory", memory);
    std::string parts;
    for (const Feature& feature : report.features)
        parts += (feature.built ? "+ " : "- ") + feature.name + ": " + feature.reason + "\n";
    tooltip(parts, "What this scene needs, and what was left out");
}

}  // namespace relievo::gui
