// The live path on the orb: dab, upload, bounds, and the trace of the 256 x 256 window under the brush.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "brushes/map_file.h"
#include "renderer/renderer.h"
#include "renderer/vulkan/context.h"

namespace {

using namespace relievo;

// The map at `size` a side: texels repeated, so that the surface is the sample scene's at every size.
HeightMap enlarged(const HeightMap& map, int size) {
    HeightMap result(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            result.set(x, y, map.at(x * map.width() / size, y * map.height() / size));
    return result;
}

struct Bench {
    vulkan::Context context{vulkan::ContextOptions{}};
    Scene scene = load_scene(RELIEVO_ASSETS "/scenes/orb.json");
    HeightMap map;
    std::unique_ptr<Renderer> renderer;

    Bench(int map_size, int image_size)
        : map(enlarged(load_map(scene.objects[0].displacement.map).map, map_size)) {
        RenderSettings settings;
        settings.width = settings.height = image_size;
        settings.method = scene.method.name;
        settings.parameters = scene.method.parameters;
        const HeightView view = this->view();
        renderer = std::make_unique<Renderer>(context, scene, std::span(&view, 1), settings);
    }
    HeightView view() const { return {map.width(), map.height(), map.texels().data()}; }
};

// Primary and shadow rays in the window around the cursor, as the editor traces it while a stroke runs.
void window_of_256(benchmark::State& state) {
    const auto image = static_cast<int>(state.range(0));
    Bench bench(1024, image);
    const int low = image / 2 - 128;
    bench.renderer->render({low, low, low + 256, low + 256}, Quality::preview);
    for (auto _ : state) bench.renderer->render({low, low, low + 256, low + 256}, Quality::preview);
    state.SetLabel(bench.context.info().name);
}
BENCHMARK(window_of_256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2);

// One sample a pixel of the whole image, sky rays included.
void frame_of_512(benchmark::State& state) {
    Bench bench(1024, 512);
    bench.renderer->render();
    for (auto _ : state) bench.renderer->render();
}
BENCHMARK(frame_of_512)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3);

// A 256 x 256 edit on its way to the image: copy, bounds of the touched triangles, refit where they grew (not here).
void upload_of_256(benchmark::State& state) {
    const auto size = static_cast<int>(state.range(0));
    Bench bench(size, 64);
    const TexelRegion region{size / 3, size / 3, size / 3 + 256, size / 3 + 256};
    std::uint16_t flip = 0;
    for (auto _ : state) {
        bench.map.set(region.x0 + 5, region.y0 + 5, static_cast<std::uint16_t>(32768 + (flip ^= 1)));
        bench.renderer->upload(0, bench.view(), std::span(&region, 1));
    }
}
BENCHMARK(upload_of_256)->Arg(1024)->Arg(2048)->Arg(4096)->Arg(8192)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
