// See method_renderers.h.
#include "editor/session/compare/method_renderers.h"

#include "renderer/stopwatch.h"

namespace relievo {

MethodRenderers::MethodRenderers(vulkan::Context& context, const ReferenceScene& scene, int width, int height,
                                 TracePath path)
    : context_(context), scene_(scene.scene()) {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
        const HeightMap& map = scene.map(i);
        maps_.push_back({map.width(), map.height(), map.texels().data()});
    }
    settings_.width = width;
    settings_.height = height;
    settings_.path = path;
}

MethodRenderers::~MethodRenderers() = default;

MethodRenderers::Key MethodRenderers::key_of(const PointChoice& point) {
    Key key{point.method, {}};
    for (const MethodParameter& p : point.method->parameters)
        if (const auto value = point.swept.find(std::string(p.name)); p.shapes_build && value != point.swept.end())
            key.second.insert(*value);
    return key;
}

Renderer& MethodRenderers::select(const PointChoice& point) {
    OfMethod& of = renderers_[key_of(point)];
    if (!of.renderer) {
        settings_.method = std::string(point.method->name);
        settings_.parameters = point.swept;
        Stopwatch watch;
        of.renderer = std::make_unique<Renderer>(context_, scene_, maps_, settings_);
        of.build = {watch.lap_ms(), of.renderer->features()};
    }
    of.renderer->set_method(std::string(point.method->name), point.swept);
    return *of.renderer;
}

void MethodRenderers::resize(int width, int height) {
    settings_.width = width;
    settings_.height = height;
    for (auto& [method, of] : renderers_)
        if (of.renderer) of.renderer->resize(width, height);
}

const MethodRenderers::Build& MethodRenderers::build_of(const PointChoice& point) const {
    return renderers_.at(key_of(point)).build;
}

}  // namespace relievo
