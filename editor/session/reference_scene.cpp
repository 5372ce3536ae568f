// See reference_scene.h.
#include "editor/session/reference_scene.h"

#include <utility>
#include <vector>

#include "editor/session/scene_input.h"
#include "renderer/opacity.h"

namespace relievo {

struct ReferenceScene::State {
    explicit State(Scene given) : scene(std::move(given)) {
        for (const SceneObject& object : scene.objects) {
            maps.push_back(open_map(object.displacement, object.displacement.map).map);
            opacities.push_back(object.opacity_map.empty() ? OpacityMap{}
                                                           : load_opacity_map(object.opacity_map));
        }
        std::vector<ReferenceObject> objects;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            ReferenceTexels<std::uint8_t> holes;
            if (!scene.objects[i].opacity_map.empty())
                holes = {opacities[i].width, opacities[i].height, opacities[i].texels.data()};
            objects.push_back(reference_object(
                scene.objects[i], {maps[i].width(), maps[i].height(), maps[i].texels().data()}, holes));
        }
        surface = std::make_unique<ReferenceSurface>(objects);
    }

    Scene scene;
    std::vector<HeightMap> maps;
    std::vector<OpacityMap> opacities;  // as long as the objects; unused where an object is opaque
    std::unique_ptr<ReferenceSurface> surface;
};

ReferenceScene::ReferenceScene(Scene scene) : state_(std::make_unique<State>(std::move(scene))) {}
ReferenceScene::~ReferenceScene() = default;
ReferenceScene::ReferenceScene(ReferenceScene&&) noexcept = default;
ReferenceScene& ReferenceScene::operator=(ReferenceScene&&) noexcept = default;

const Scene& ReferenceScene::scene() const {
    return state_->scene;
}
const ReferenceSurface& ReferenceScene::surface() const {
    return *state_->surface;
}
const HeightMap& ReferenceScene::map(std::size_t object) const {
    return state_->maps.at(object);
}

}  // namespace relievo
