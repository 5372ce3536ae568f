// See method_images.h.
#include "tests/accuracy/method_images.h"

#include "renderer/vulkan/context.h"

namespace relievo::test {

MethodImages method_images(const Scene& scene, const HeightView& map, int size,
                           const MethodUnderTest& method) {
    static vulkan::Context device{vulkan::ContextOptions{}};
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.method = method.name;
    settings.parameters = method.parameters;
    Renderer renderer(device, scene, std::span(&map, 1), settings);
    return {renderer.read_back(Layer::depth), renderer.read_back(Layer::normal)};
}

}  // namespace relievo::test
