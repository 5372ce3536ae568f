// The renderer's public face: upload, render, read back, pick. Everything Vulkan is behind it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/beside.h"
#include "renderer/scene/scene.h"
#include "renderer/trace_path.h"
#include "renderer/vulkan/pass.h"

namespace relievo {

namespace vulkan {
class Context;
}

// A displacement map as the renderer reads it, or the exemplar of procedural heights; row 0 is v = 0. The caller keeps the texels of the last upload alive
// as long as the renderer: height bounds, and structures that another method needs, are made from them.
struct HeightView {
    int width = 0, height = 0;
    const std::uint16_t* texels = nullptr;
};

// An albedo map as the renderer reads it: planes of red, green and blue, each texel 0 to 65535 for the sRGB-encoded values
// 0 to 1; row 0 is v = 0. The caller keeps the texels of the last upload alive as long as the renderer.
struct ColourView {
    int width = 0, height = 0;
    int bits = 8;  // of a channel on the device: with 8, texels are rounded to the nearest of 256 values; else 16
    std::array<const std::uint16_t*, 3> planes{};
    bool empty() const { return width == 0; }
};

struct TexelRegion {  // half-open
    int x0, y0, x1, y1;
};

struct PixelRect {  // half-open, row 0 at the top of the image
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct RenderSettings {
    int width = 512, height = 512;
    std::string method;                      // empty: the registry's default
    std::map<std::string, double> parameters;  // of the method; std::invalid_argument on a wrong name or range
    TracePath path = TracePath::automatic;
    std::vector<vulkan::Pass> ready;  // their programs are compiled with the rest, else at first use
    bool everything = false;  // build all features whether the scene needs them or not (tests compare the images)
};

// Milliseconds of wall clock by stage of the last call; 0 where a stage did not run.
struct UploadStats {
    double copy_ms = 0;    // texels into the image
    double bounds_ms = 0;  // height bounds of the touched triangles
    double refit_ms = 0;   // acceleration structure, only where bounds of triangles changed
    int triangles_touched = 0, triangles_moved = 0;
};

enum class Quality {
    preview,  // one hard shadow ray a light, the sky unshadowed: free of noise, for the window under the brush;
              // replaces what the pixels showed, never mixes with samples, and is replaced by the first of them
    full,
};

enum class Layer {
    beauty,
    depth,
    normal,
    shading_normal,
    uv,
    id,
    counts,  // what the pixel's primary ray cost: boxes met, steps, map and pyramid fetches, cells solved
};

// One entry of a ray's log: what the method did, in order.
struct TraceNote {
    enum class Kind { box, step, cell, root, hit } kind = Kind::box;
    std::uint32_t object = 0, face = 0;  // of the object's mesh as traced (creases mended where the method wants it)
    // All but box:
    float t = 0;          // along the unit direction, world units
    float height = 0;     // of the ray over the base triangle along the interpolated unit normal, world units
    glm::vec2 texel{0};   // uv * size - 1/2, not wrapped
    float extent = 0;     // step: texels that it may cross, 0 for a sample; cell: t where the ray leaves it
};
struct TraceLog {
    std::vector<TraceNote> notes;
    std::uint32_t left_out = 0;  // notes beyond the log's length
    bool hit = false;
    float distance = 0;
};

struct PickHit {
    bool hit = false;
    std::uint32_t object = 0, face = 0;
    float b1 = 0, b2 = 0;      // barycentrics of vertices 1 and 2
    float distance = 0;        // along the unit direction, world units
    glm::vec3 position{0}, normal{0};  // on S, rebased space; geometric normal
};

struct Ray {
    glm::vec3 origin;     // rebased space (world minus Scene::origin)
    glm::vec3 direction;  // need not be unit
};

class Renderer {
  public:
    // One HeightView per scene object. Throws std::runtime_error on Vulkan failures, std::invalid_argument on a
    // method or parameter that the registry does not know, or a map or an image larger than the device takes.
    // `colours`: none, or one an object; where it is empty, the file that the material names is read, if it names one
    // (std::invalid_argument as load_albedo_file).
    Renderer(vulkan::Context& context, const Scene& scene, std::span<const HeightView> maps,
             const RenderSettings& settings, std::span<const ColourView> colours = {}, const WorkProgress& progress = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Copies texels of the regions into the object's image and keeps its triangles' bounds true. Nothing is rebuilt. Elsewhere
    // `map` is as it was: bounds are made of its texels.
    UploadStats upload(std::size_t object, const HeightView& map, std::span<const TexelRegion> regions);

    // The same of the object's albedo map, which must have been given; of its size.
    void upload_colours(std::size_t object, const ColourView& colours, std::span<const TexelRegion> regions);

    // Compiles a pass's program where that was not done yet: else its first use waits for it. Keeps the samples of all
    // others than the beauty.
    void make_ready(vulkan::Pass pass, const WorkProgress& progress = {});
    std::vector<vulkan::Pass> ready() const;

    // Each of these restarts the accumulation of the whole image. Where another scene, method or setting needs other
    // programs, those of the passes that were in use are compiled at once if there is a `progress`, else at first use. What
    // is thrown by one of these, by `progress` too, leaves all as it was.
    void set_camera(const Camera& camera);
    void set_lights(const std::vector<Light>& lights, const Environment& environment, const WorkProgress& progress = {});
    void set_material(std::size_t object, const Material& material, const WorkProgress& progress = {});
    // New bounds for all triangles.
    void set_displacement(std::size_t object, double amplitude, double midlevel, const WorkProgress& progress = {});
    // An albedo map for an object, in the place of its albedo or of another map; empty: its albedo again.
    void set_colours(std::size_t object, const ColourView& colours, const WorkProgress& progress = {});
    // Other heights for an object: another map, an exemplar, or the same one otherwise read. Makes the device's scene anew.
    void set_heights(std::size_t object, const Displacement& displacement, const HeightView& heights,
                     const WorkProgress& progress = {});
    // std::invalid_argument where the method refuses what it would have to build (too many micro-triangles).
    void set_method(const std::string& name, const std::map<std::string, double>& parameters, const WorkProgress& progress = {});
    void resize(int width, int height);
    void restart();                        // forget all samples
    void restart(const PixelRect& window);  // forget the samples of a window only

    // Adds one sample a pixel inside the window to the accumulation. Returns milliseconds of wall clock.
    double render(const PixelRect& window, Quality quality = Quality::full);
    double render();  // the whole image, full quality
    // Counts windows that together covered the image, traced one by one in full quality, as one whole-image pass.
    void end_pass();
    int samples() const;  // whole-image passes since the last restart

    int width() const;
    int height() const;
    const Camera& camera() const;

    // Row 0 at the top. beauty: 4 linear floats (average of the samples, alpha = coverage); depth: 1 (infinity where
    // nothing is hit); normals: 3; uv: 2; id: 1 (object index + 1, 0 where nothing is hit); counts: 4. AOVs come from the pixel
    // centres and are not jittered.
    std::vector<float> read_back(Layer layer);
    // Traces the layers of a window alone, in slices as short as a live view needs them; counts only where they are
    // asked for (they forget those of the rest of their rows). Returns milliseconds of wall clock.
    double trace_layers(const PixelRect& window, bool with_counts = false);
    // A window of a layer as it was last traced; it must have been. beauty: of the samples so far, where there are any.
    std::vector<float> traced_layer(Layer layer, const PixelRect& window) const;
    // Tone-mapped 8-bit sRGB, 4 channels, row 0 at the top.
    std::vector<std::uint8_t> read_back_display();

    // Traces the layers but counts afresh, without reading them. Returns milliseconds of wall clock.
    double trace_layers();
    // What the device's own clock says of the last trace, in milliseconds; 0 where it has none.
    double last_device_ms() const;

    // First hits of any rays with the displaced surface as uploaded, by the method in use, unjittered.
    std::vector<PickHit> pick(std::span<const Ray> rays);
    // The same for one ray, with all that the method did on its way.
    TraceLog trace_notes(const Ray& ray);
    // The ray through a pixel position (0..width, 0..height; centres at .5).
    Ray camera_ray(double x_px, double y_px) const;

    // What was built and what was left out, with reasons and bytes (features.h).
    const struct FeatureReport& features() const;

    // The tone-mapped image for the window: VkImage and VkImageView as opaque handles, layout GENERAL, R8G8B8A8_UNORM
    // holding sRGB-encoded values, width x height; valid until resize().
    struct DisplayImage {
        void* image;
        int width, height;
    };
    DisplayImage display_image() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
