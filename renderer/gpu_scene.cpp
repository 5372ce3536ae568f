// See gpu_scene.h.
#include "renderer/gpu_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <map>
#include <stdexcept>
#include <utility>

#include "renderer/stopwatch.h"
#include "renderer/vulkan/functions.h"

namespace relievo {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

// Parts of the time that a scene takes, about; and after how many triangles it is told again.
constexpr double kMapsLoaded = 0.6, kBounded = 0.8, kSorted = 0.83, kHulled = 0.88;
constexpr std::size_t kTellAfter = 256;

// work(i) of each i in [begin, end) on any core, all done at the end. Of triangles: what bounds one takes microseconds.
template <typename Work>
void by_all_cores(std::size_t begin, std::size_t end, const Work& work) {
    constexpr std::size_t kAtOnce = 8;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, kAtOnce), [&](const auto& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) work(i);
    });
}

int wrapped(double texel, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return static_cast<int>(std::clamp(texel, 0.0, static_cast<double>(size - 1)));
    return static_cast<int>(texel - size * std::floor(texel / size));
}

// In [0, 1], at texel coordinates.
double bilinear_height(const HeightView& map, Wrap wrap, const glm::dvec2& texel) {
    const glm::dvec2 cell = glm::floor(texel), f = texel - cell;
    const auto height = [&](double x, double y) {
        return map.texels[static_cast<std::size_t>(wrapped(cell.y + y, map.height, wrap)) *
                              static_cast<std::size_t>(map.width) +
                          static_cast<std::size_t>(wrapped(cell.x + x, map.width, wrap))] /
               65535.0;
    };
    return glm::mix(glm::mix(height(0, 0), height(1, 0), f.x), glm::mix(height(0, 1), height(1, 1), f.x), f.y);
}

// Edges that one triangle has for itself: rays may look underneath there.
void flag_open_edges(const Mesh& mesh, std::uint32_t face, const std::map<std::pair<std::uint32_t, std::uint32_t>, int>& uses,
                     gpu::Primitive& primitive) {
    const auto& p = mesh.faces[face].position;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const auto edge = std::minmax(p[(i + 1) % 3], p[(i + 2) % 3]);
        if (uses.at({edge.first, edge.second}) == 1) primitive.flags |= gpu::kPrimitiveOpenEdge0 << i;
    }
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> count_edge_uses(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Mesh::Face& f : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto edge = std::minmax(f.position[i], f.position[(i + 1) % 3]);
            ++uses[{edge.first, edge.second}];
        }
    }
    return uses;
}

}  // namespace

GpuScene::GpuScene(vulkan::Context& context, vulkan::Commands& commands, const Scene& scene,
                   std::span<const HeightView> maps, std::span<const ColourView> colours, const Features& features,
                   const std::vector<Mesh>& meshes, const SceneBefore& before, const WorkPart& part)
    : context_(context), commands_(commands), meets_surface_(features.true_shell), hits_(features.hits) {
    const std::size_t count = scene.objects.size();
    objects_.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        describe_object(scene.objects[i], maps[i], meshes[i], maps_before(before, i).heights);
    if (features.micro_triangles) micro_.emplace(micro_objects(), features.density);  // refused before anything is built
    std::vector<gpu::Primitive> found;
    for (std::size_t i = 0; i < count; ++i) {
        const WorkPart of_object = part.within(kMapsLoaded * double(i) / double(count), kMapsLoaded * double(i + 1) / double(count));
        const MapsBefore taken_over = maps_before(before, i);
        load_heights(objects_[i], features, taken_over.heights, of_object.within(0, 0.7));
        add_primitives(objects_[i], static_cast<std::uint32_t>(i), found);
        load_pictures(scene.objects[i], objects_[i], colours[i], features, taken_over.pictures, of_object.within(0.7, 1));
    }
    if (found.empty()) throw std::invalid_argument(scene.path.string() + ": no triangle of the scene has an area");
    const auto tell = [&, all = static_cast<double>(found.size())](std::size_t done, double begin, double end) {
        if (done % kTellAfter == 0) part.at(begin + (end - begin) * static_cast<double>(done) / all);
    };
    std::vector<Box> boxes(found.size());
    for (std::size_t begin = 0; begin < found.size(); begin += kTellAfter) {
        tell(begin, kMapsLoaded, kBounded);
        by_all_cores(begin, std::min(begin + kTellAfter, found.size()), [&](std::size_t i) {
            bound_closely(found[i]);
            boxes[i] = box_of(found[i]);
        });
    }
    part.at(kBounded, kSorted);
    const auto order = spatial_order(boxes);

    primitives_.reserve(order.size());
    normals_ = vulkan::Buffer(context, found.size() * sizeof(gpu::PrimitiveNormals), kStorage, vulkan::Access::host);
    std::vector<Box> sorted;
    std::vector<SurfaceHull> hulls;
    sorted.reserve(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        tell(i, kSorted, kHulled);
        const gpu::Primitive& p = primitives_.emplace_back(found[order[i]]);
        normals_.as<gpu::PrimitiveNormals>()[i] = primitive_normals(objects_[p.object].mesh, p.face);
        objects_[p.object].primitive_of[p.face] = i;
        sorted.push_back(boxes[order[i]]);
        if (hits_ != HitPlace::in_box) hulls.push_back(hull_of(p));
    }
    primitive_buffer_ =
        vulkan::Buffer(context, primitives_.size() * sizeof(gpu::Primitive), kStorage, vulkan::Access::host);
    write_primitives(hulls);
    part.at(kHulled, 1);
    if (micro_) {
        micro_->build(context, micro_objects(), primitives_, features.path);
        if (!features.driver_triangles) sorted = micro_->take_boxes();
    }
    tree_ = features.driver_triangles ? SceneTree(context, commands, micro_->triangles())
                                      : SceneTree(context, commands, sorted, hulls, features.path);

    object_data_ = vulkan::Buffer(context, objects_.size() * sizeof(gpu::ObjectData), kStorage, vulkan::Access::host);
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        gpu::ObjectData& data = object_data_.as<gpu::ObjectData>()[i];
        data = {};
        data.amplitude = static_cast<float>(objects_[i].amplitude);
        data.midlevel = static_cast<float>(objects_[i].midlevel);
        data.map_size = {maps[i].width, maps[i].height};
        data.radius = objects_[i].mesh.sphere_radius;
        data.albedo_map = objects_[i].albedo->is_map() ? 1 : 0;
        data.slabs_left_out = objects_[i].slabs_left_out;
        data.clamp_wrap = objects_[i].wrap == Wrap::clamp ? 1 : 0;
        set_material(i, scene.objects[i].material);
    }
    procedural_ = vulkan::Buffer(context, features.procedural ? objects_.size() * sizeof(gpu::ProceduralData) : 0, kStorage,
                                 vulkan::Access::host);
    for (std::size_t i = 0; features.procedural && i < objects_.size(); ++i) {
        gpu::ProceduralData& data = procedural_.as<gpu::ProceduralData>()[i];
        data = objects_[i].source ? objects_[i].source->data() : gpu::ProceduralData{};
        data.inverse = vulkan::address_words(objects_[i].inverse.address());
        // All of an object's triangles or none: where the two walks met, they would leave a gap.
        if (objects_[i].thin_over_lattice) data.used = gpu::kHeightsOfTexels;
    }
    staging_ = {};  // as large as the largest map; edits are smaller
}

GpuScene::MapsBefore GpuScene::maps_before(const SceneBefore& before, std::size_t index) const {
    if (!before.scene) return {};
    const Object& object = before.scene->objects_[index];
    return {before.other_heights == index ? nullptr : &object, &object};
}

void GpuScene::describe_object(const SceneObject& description, const HeightView& map, const Mesh& mesh, const Object* before) {
    Object& object = objects_.emplace_back();
    const Displacement& displacement = description.displacement;
    object.mesh = mesh;
    object.wrap = displacement.wrap;
    object.amplitude = displacement.amplitude;
    object.midlevel = displacement.midlevel;
    object.heights = map;
    if (before) object.source = before->source;
    else if (displacement.procedural)
        object.source = std::make_shared<ProceduralSource>(*displacement.procedural, map.width, map.height, map.texels);
}

void GpuScene::add_primitives(Object& object, std::uint32_t index, std::vector<gpu::Primitive>& primitives) {
    const TexelSpace texels{{object.heights.width, object.heights.height}, object.wrap == Wrap::clamp, object.source.get()};
    object.primitive_of.assign(object.mesh.faces.size(), kNone);
    object.ranges.resize(object.mesh.faces.size());
    const auto uses = count_edge_uses(object.mesh);
    for (std::uint32_t face = 0; face < object.mesh.faces.size(); ++face) {
        auto p = make_primitive(object.mesh, face, index, texels);
        if (!p) continue;
        flag_open_edges(object.mesh, face, uses, *p);
        object.ranges[face] = range_of(object, face);
        set_bounds(object, face, *p);
        object.thin_over_lattice = object.thin_over_lattice || (object.source && object.source->thin_over_lattice(
                                                                                       corner_uvs(object.mesh, face)));
        any_searched_ = any_searched_ || (p->flags & gpu::kPrimitiveSearched) != 0;
        primitives.push_back(*p);
    }
}

std::vector<MicroScene::Object> GpuScene::micro_objects() const {
    std::vector<MicroScene::Object> all;
    for (const Object& o : objects_) all.push_back(micro_object(o));
    return all;
}

// S as the device has it: bilinear between texels, in double.
MicroScene::Object GpuScene::micro_object(const Object& object) const {
    const Object* o = &object;
    if (o->source)
        return {&o->mesh, [o](const glm::dvec2& uv) { return o->source->texel_at(uv); },
                [o](const glm::dvec2& uv) {
                    return o->amplitude * (o->source->value(o->source->texel_at(uv)) - o->midlevel);
                }};
    const glm::dvec2 size(o->heights.width, o->heights.height);
    return {&o->mesh, [size](const glm::dvec2& uv) { return uv * size - 0.5; },
            [o, size](const glm::dvec2& uv) {
                return o->amplitude * (bilinear_height(o->heights, o->wrap, uv * size - 0.5) - o->midlevel);
            }};
}

void GpuScene::upload_colours(std::size_t index, const ColourView& colours, std::span<const TexelRegion> regions) {
    objects_.at(index).albedo->upload(context_, commands_, staging_, colours, regions);
}

std::shared_ptr<AlbedoImage> GpuScene::colour_image(std::size_t index, const ColourView& colours, const WorkPart& part) const {
    return std::make_shared<AlbedoImage>(context_, commands_, colours, objects_.at(index).wrap == Wrap::clamp, part);
}

void GpuScene::set_colours(std::size_t index, std::shared_ptr<AlbedoImage> image) {
    object_data_.as<gpu::ObjectData>()[index].albedo_map = image->is_map() ? 1 : 0;
    objects_.at(index).albedo = std::move(image);
}

UploadStats GpuScene::upload(std::size_t index, const HeightView& map, std::span<const TexelRegion> regions) {
    UploadStats stats;
    if (regions.empty()) return stats;
    Object& object = objects_[index];
    if (object.source) throw std::logic_error("procedural heights are not edited");
    Stopwatch watch;
    upload_texels(object, map, regions);
    if (object.pyramid) {
        std::vector<HeightPyramid::Nodes> nodes;
        for (const TexelRegion& r : regions) {
            const auto changed = object.pyramid->update(map, r);
            nodes.insert(nodes.end(), changed.begin(), changed.end());
        }
        upload_bounds(object, map, nodes);
    }
    stats.copy_ms = watch.lap_ms();

    object.bounds->move(map.texels);
    object.heights = map;
    std::vector<std::uint32_t> faces, found;
    for (const TexelRegion& r : regions) {
        object.bounds->update({r.x0, r.y0, r.x1, r.y1});
        object.lookup->find({r.x0, r.y0, r.x1, r.y1}, found);
        faces.insert(faces.end(), found.begin(), found.end());
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::erase_if(faces, [&](std::uint32_t face) { return object.primitive_of[face] == kNone; });
    std::vector<char> moved(faces.size());
    by_all_cores(0, faces.size(), [&](std::size_t i) { moved[i] = bound_anew(object, faces[i]); });
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!moved[i]) continue;
        update_primitive(object, faces[i]);
        ++stats.triangles_moved;
    }
    stats.triangles_touched = static_cast<int>(faces.size());
    stats.bounds_ms = watch.lap_ms();
    if (stats.triangles_moved > 0) {
        tree_.refit(commands_);
        stats.refit_ms = watch.lap_ms();
    }
    return stats;
}

void GpuScene::set_displacement(std::size_t index, double amplitude, double midlevel, const WorkPart& part) {
    constexpr double kBounded = 0.6, kMoved = 0.9;  // parts of the time, about
    Object& object = objects_[index];
    const std::size_t count = object.primitive_of.size();
    const auto is_there = [&](std::size_t face) { return object.primitive_of[face] != kNone; };
    const auto move = [&](std::size_t face) {
        if (is_there(face)) update_primitive(object, static_cast<std::uint32_t>(face));
    };
    const auto ranges = object.ranges;
    const auto close = object.close;
    const double amplitude_before = object.amplitude, midlevel_before = object.midlevel;
    const bool searched_before = any_searched_;
    std::size_t moved = 0;
    const auto tell = [&](std::size_t done, double begin, double end) {
        part.within(begin, end).at(static_cast<double>(done) / static_cast<double>(count));
    };
    object.amplitude = amplitude;
    object.midlevel = midlevel;
    try {
        for (std::size_t begin = 0; begin < count; begin += kTellAfter) {
            tell(begin, 0, kBounded);
            by_all_cores(begin, std::min(begin + kTellAfter, count), [&](std::size_t face) {
                if (is_there(face)) bound_anew(object, static_cast<std::uint32_t>(face));
            });
        }
        for (; moved < count; ++moved) {
            if (moved % kTellAfter == 0) tell(moved, kBounded, kMoved);
            move(moved);
        }
        part.at(kMoved, 1);
    } catch (...) {
        object.amplitude = amplitude_before;
        object.midlevel = midlevel_before;
        object.ranges = ranges;
        object.close = close;
        while (moved > 0) move(--moved);
        any_searched_ = searched_before;
        throw;
    }
    gpu::ObjectData& data = object_data_.as<gpu::ObjectData>()[index];
    data.amplitude = static_cast<float>(amplitude);
    data.midlevel = static_cast<float>(midlevel);
    tree_.refit(commands_);
}

void GpuScene::set_material(std::size_t index, const Material& material) {
    gpu::ObjectData& data = object_data_.as<gpu::ObjectData>()[index];
    data.albedo = material.albedo;
    data.roughness = material.roughness;
    data.specular = material.specular;
}

void GpuScene::set_ray_offset(double fraction_of_radius) {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        gpu::ObjectData& data = object_data_.as<gpu::ObjectData>()[i];
        data.ray_offset = static_cast<float>(fraction_of_radius) * objects_[i].mesh.sphere_radius;
    }
}

PrimitiveId GpuScene::primitive_id(std::uint32_t primitive) const {
    const gpu::Primitive& p = primitives_[primitive];
    return {p.object, p.face};
}

void GpuScene::write_bindings(VkDescriptorSet set) const {
    const VkAccelerationStructureKHR top = tree_.acceleration_structure();
    VkWriteDescriptorSetAccelerationStructureKHR structure{
        VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR, nullptr, 1, &top};
    const std::array<VkDescriptorBufferInfo, 4> buffers{
        VkDescriptorBufferInfo{primitive_buffer_.get(), 0, VK_WHOLE_SIZE},
        VkDescriptorBufferInfo{normals_.get(), 0, VK_WHOLE_SIZE},
        VkDescriptorBufferInfo{object_data_.get(), 0, VK_WHOLE_SIZE},
        VkDescriptorBufferInfo{procedural_.get(), 0, VK_WHOLE_SIZE}};
    std::vector<VkDescriptorImageInfo> maps, opacities, pyramids, slabs, albedos;
    for (const Object& o : objects_) {
        maps.push_back({o.map_sampler.get(), o.map->view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
        pyramids.push_back({o.map_sampler.get(), o.pyramid_image->view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
        slabs.push_back({o.map_sampler.get(), o.slab_image->view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
        albedos.push_back(o.albedo->descriptor());
        opacities.push_back({o.opacity_sampler.get(), o.opacity->view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }
    std::vector<VkWriteDescriptorSet> writes;
    const auto add = [&](std::uint32_t binding, VkDescriptorType type, std::size_t count) -> VkWriteDescriptorSet& {
        VkWriteDescriptorSet w{};
        w.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        w.dstSet = set;
        w.dstBinding = binding;
        w.descriptorCount = static_cast<std::uint32_t>(count);
        w.descriptorType = type;
        return writes.emplace_back(w);
    };
    if (top != VK_NULL_HANDLE) add(gpu::kBindTlas, VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR, 1).pNext = &structure;
    add(gpu::kBindPrimitives, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1).pBufferInfo = &buffers[0];
    add(gpu::kBindNormals, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1).pBufferInfo = &buffers[1];
    add(gpu::kBindObjects, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1).pBufferInfo = &buffers[2];
    add(gpu::kBindProcedural, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1).pBufferInfo = &buffers[3];
    add(gpu::kBindMaps, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, maps.size()).pImageInfo = maps.data();
    add(gpu::kBindOpacity, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, opacities.size()).pImageInfo = opacities.data();
    add(gpu::kBindPyramids, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, pyramids.size()).pImageInfo = pyramids.data();
    add(gpu::kBindSlabs, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, slabs.size()).pImageInfo = slabs.data();
    add(gpu::kBindAlbedo, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, albedos.size()).pImageInfo = albedos.data();
    vkUpdateDescriptorSets(context_.device(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

std::uint64_t GpuScene::primitive_bytes() const {
    return primitive_buffer_.bytes() + normals_.bytes() + object_data_.bytes();
}

}  // namespace relievo
