// The scene on the device: primitives, their tree, maps; and the live path of an edit through them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/albedo_image.h"
#include "renderer/beside.h"
#include "renderer/close_bounds.h"
#include "renderer/features.h"
#include "renderer/height_pyramid.h"
#include "renderer/height_slabs.h"
#include "renderer/micro_scene.h"
#include "renderer/primitives.h"
#include "renderer/renderer.h"
#include "renderer/scene/triangle_bounds.h"
#include "renderer/scene_tree.h"
#include "renderer/surface_hull.h"

namespace relievo {

// The triangle behind a primitive of the device's arrays.
struct PrimitiveId {
    std::uint32_t object, face;
};

class GpuScene;

// What a scene takes over of the one before it: all objects' maps that are the same. The two hold them together.
struct SceneBefore {
    const GpuScene* scene = nullptr;                   // none: nothing
    std::optional<std::size_t> other_heights{};        // of this object they are others
};

class GpuScene {
  public:
    // Builds everything from one mesh an object, as traced (creases mended where the method wants it).
    GpuScene(vulkan::Context& context, vulkan::Commands& commands, const Scene& scene,
             std::span<const HeightView> maps, std::span<const ColourView> colours, const Features& features,
             const std::vector<Mesh>& meshes, const SceneBefore& before, const WorkPart& part);

    UploadStats upload(std::size_t object, const HeightView& map, std::span<const TexelRegion> regions);
    void upload_colours(std::size_t object, const ColourView& colours, std::span<const TexelRegion> regions);
    std::shared_ptr<AlbedoImage> colour_image(std::size_t object, const ColourView& colours, const WorkPart& part) const;
    void set_colours(std::size_t object, std::shared_ptr<AlbedoImage> image);
    // What it throws, on its way, leaves all as it was.
    void set_displacement(std::size_t object, double amplitude, double midlevel, const WorkPart& part);
    void set_material(std::size_t object, const Material& material);
    void set_ray_offset(double fraction_of_radius);

    PrimitiveId primitive_id(std::uint32_t primitive) const;
    VkDeviceAddress primitive_address() const { return primitive_buffer_.address(); }
    VkDeviceAddress bvh_address() const { return tree_.nodes(); }  // 0 where an acceleration structure is used

    // Micro-triangles, where the method meets them.
    VkDeviceAddress micro_vertices() const { return micro_ ? micro_->vertices() : 0; }
    VkDeviceAddress micro_corners() const { return micro_ ? micro_->corners() : 0; }
    VkDeviceAddress micro_primitives() const { return micro_ ? micro_->primitives() : 0; }
    std::uint64_t micro_bytes() const { return micro_ ? micro_->bytes() : 0; }

    // Writes bindings TLAS (where there is one), primitives, normals, objects, maps, opacity, albedo.
    void write_bindings(VkDescriptorSet set) const;

    // Whether a triangle's shell folds, or ever did, so that methods search it (kPrimitiveSearched).
    bool any_searched() const { return any_searched_; }
    // Whether prisms have slanted ends (kPrimitiveSlanted): where they helped most triangles when the scene was built.
    bool any_slanted() const { return any_slanted_; }

    std::uint64_t primitive_bytes() const;
    std::uint64_t tree_bytes() const { return tree_.bytes(); }
    std::uint64_t map_bytes() const;
    std::uint64_t procedural_bytes() const;
    std::uint64_t opacity_bytes() const;
    std::uint64_t albedo_bytes() const;
    std::uint64_t pyramid_bytes() const;
    std::uint64_t slab_bytes() const;
    std::uint64_t staging_bytes() const { return staging_.bytes(); }  // since the first edit; 0 before

  private:
    struct Object {
        Mesh mesh;                               // as traced: creases mended where the method wants it
        std::vector<std::uint32_t> primitive_of; // traced face -> primitive; kNone for faces without area
        std::vector<DisplacementRange> ranges;   // of traced faces; only ever wider while the map is edited
        // Of traced faces, where the method's hits lie on S itself and heights are a map. Else none.
        std::vector<CloseBounds> close;
        std::shared_ptr<HeightBounds> bounds;
        std::unique_ptr<TriangleLookup> lookup;
        std::shared_ptr<HeightPyramid> pyramid;  // where the method bounds heights
        std::shared_ptr<ProceduralSource> source;  // of procedural heights; then bounds and lookup are not there, and
        vulkan::Buffer inverse;                    // the map is the Gaussianised exemplar
        bool thin_over_lattice = false;            // one of its triangles is (ProceduralSource)
        std::shared_ptr<vulkan::Image> map, opacity, pyramid_image, slab_image;
        bool has_pyramid = false, has_slabs = false;  // else their images are one node that stands in
        int slabs_left_out = 0;                       // finest levels
        std::shared_ptr<AlbedoImage> albedo;
        vulkan::SamplerHandle map_sampler, opacity_sampler;
        Wrap wrap = Wrap::repeat;
        double amplitude = 0, midlevel = 0;
        HeightView heights;  // as last uploaded
    };
    // The object in the scene before this one, where it has its heights, or its other maps, from there. Else null.
    struct MapsBefore {
        const Object *heights = nullptr, *pictures = nullptr;
    };
    MapsBefore maps_before(const SceneBefore& before, std::size_t index) const;
    void describe_object(const SceneObject& description, const HeightView& map, const Mesh& mesh, const Object* before);
    void load_heights(Object& object, const Features& features, const Object* before, const WorkPart& part);
    void load_pictures(const SceneObject& description, Object& object, const ColourView& colours, const Features& features,
                       const Object* before, const WorkPart& part);
    void add_primitives(Object& object, std::uint32_t index, std::vector<gpu::Primitive>& primitives);
    void load_map(Object& object, const HeightView& map, const WorkPart& part);
    void load_source(Object& object);
    void load_bounds(Object& object, const HeightView& map, const Object* before, const WorkPart& part);
    void load_opacity(const SceneObject& description, Object& object, bool wanted);
    std::vector<MicroScene::Object> micro_objects() const;
    void upload_texels(Object& object, const HeightView& map, std::span<const TexelRegion> regions);
    void upload_bounds(Object& object, const HeightView& map, const std::vector<HeightPyramid::Nodes>& changed);
    template <typename Texel, typename NodeOf>
    void upload_nodes(const vulkan::Image& image, int first_level, std::vector<HeightPyramid::Nodes> changed,
                      const NodeOf& node_of);
    // Heights and flags, from the face's range.
    void set_bounds(const Object& object, std::uint32_t face, gpu::Primitive& primitive) const;
    DisplacementRange range_of(const Object& object, std::uint32_t face) const;
    Box box_of(const gpu::Primitive& primitive) const;
    SurfaceHull hull_of(const gpu::Primitive& primitive) const;
    MappedTriangle triangle_of(const gpu::Primitive& primitive) const;
    MapSurface surface_of(const Object& object) const;
    bool has_close_bounds(const Object& object) const;
    // False: bounds are as before.
    bool bound_closely(const gpu::Primitive& primitive);
    bool bound_anew(Object& object, std::uint32_t face);  // after an edit
    MicroScene::Object micro_object(const Object& object) const;
    void write_primitives(std::span<const SurfaceHull> hulls);  // all of them
    void update_primitive(const Object& object, std::uint32_t face);  // bounds and box, after the range has changed

    vulkan::Context& context_;
    vulkan::Commands& commands_;
    bool any_searched_ = false, any_slanted_ = false;
    bool meets_surface_ = false;  // the method meets S itself, not the parallel prism's surface
    HitPlace hits_;               // of the method
    std::vector<Object> objects_;
    // As on the device, of whose memory reading can be slow; but there ends may be slanted.
    std::vector<gpu::Primitive> primitives_;
    vulkan::Buffer primitive_buffer_, normals_, object_data_, procedural_, staging_;
    std::optional<MicroScene> micro_;
    SceneTree tree_;
};

}  // namespace relievo
