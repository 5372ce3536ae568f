// See stability_case.h.
#include "renderer/stability/stability_case.h"

#include <stdexcept>

namespace relievo::stability {

Scene Case::scene(const NamedView& view) const {
    Scene scene;
    scene.path = "stability";
    for (const SampleSurface& surface : objects) scene.objects.push_back(surface.scene_object());
    scene.origin = origin;
    scene.camera.eye = view.eye + origin;
    scene.camera.look_at = view.look_at + origin;
    scene.camera.up = {0, 0, 1};
    scene.camera.fov_deg = 50;
    scene.lights.emplace_back();
    return scene;
}

std::vector<HeightView> Case::maps() const {
    std::vector<HeightView> maps;
    for (const SampleSurface& surface : objects)
        maps.push_back({surface.width, surface.height, surface.texels.data()});
    return maps;
}

ReferenceSurface Case::reference() const {
    std::vector<ReferenceObject> references;
    for (const SampleSurface& surface : objects) references.push_back(surface.object());
    return ReferenceSurface(references);
}

const std::vector<CaseEntry>& cases() {
    static const std::vector<CaseEntry> all = [] {
        std::vector<CaseEntry> joined;
        for (const auto& list :
             {map_cases(), amplitude_cases(), mesh_cases(), uv_cases(), place_cases(), ray_cases(),
              procedural_cases()})
            joined.insert(joined.end(), list.begin(), list.end());
        return joined;
    }();
    return all;
}

const CaseEntry& find_case(const std::string& name) {
    for (const CaseEntry& entry : cases())
        if (entry.name == name) return entry;
    throw std::invalid_argument("no stability case is called \"" + name + "\"");
}

}  // namespace relievo::stability
