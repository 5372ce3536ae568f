// A scene's maps as images on the device: heights, their bounds, opacity. See gpu_scene.h.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

#include "renderer/gpu_scene.h"
#include "renderer/opacity.h"

namespace relievo {
namespace {

constexpr int kBand = 512;  // rows that are uploaded at once, so that the staging buffer stays small on large maps
constexpr int kNodesAtOnce = 128;  // that one core bounds: what it takes to hand them out is little beside it
constexpr VkImageUsageFlags kTexture = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

// Copies rows of one region into staging memory, tightly packed.
template <typename T>
T* pack_rows(T* to, const T* texels, int width, const TexelRegion& r) {
    const auto count = static_cast<std::size_t>(r.x1 - r.x0);
    for (int y = r.y0; y < r.y1; ++y) {
        std::memcpy(to, texels + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + r.x0,
                    count * sizeof(T));
        to += count;
    }
    return to;
}

VkBufferImageCopy image_copy(const TexelRegion& r, VkDeviceSize offset) {
    VkBufferImageCopy copy{};
    copy.bufferOffset = offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageOffset = {r.x0, r.y0, 0};
    copy.imageExtent = {static_cast<std::uint32_t>(r.x1 - r.x0), static_cast<std::uint32_t>(r.y1 - r.y0), 1};
    return copy;
}

}  // namespace

void GpuScene::load_heights(Object& object, const Features& features, const Object* before, const WorkPart& part) {
    const HeightView& map = object.heights;
    const HeightView shown{map.width, map.height, object.source ? object.source->gaussianised().data() : map.texels};
    object.has_slabs = features.slabs && !object.source;
    object.has_pyramid = features.pyramid && !object.has_slabs;
    object.map_sampler = vulkan::make_sampler(context_, object.wrap == Wrap::clamp, false);
    if (object.source) load_source(object);
    if (before) {
        object.map = before->map;
        object.bounds = before->bounds;
    } else {
        load_map(object, shown, part.within(0, 0.25));
        part.at(0.25, 0.3);
        if (!object.source) object.bounds = std::make_shared<HeightBounds>(map.width, map.height, map.texels, object.wrap);
    }
    if (!object.source) object.lookup = std::make_unique<TriangleLookup>(object.mesh, map.width, map.height, object.wrap);
    load_bounds(object, shown, before, part.within(0.3, 1));
    if (has_close_bounds(object)) object.close.resize(object.mesh.faces.size());
}

void GpuScene::load_pictures(const SceneObject& description, Object& object, const ColourView& colours,
                             const Features& features, const Object* before, const WorkPart& part) {
    const bool clamp = object.wrap == Wrap::clamp;
    if (before) {
        object.opacity = before->opacity;
        object.opacity_sampler = vulkan::make_sampler(context_, clamp, true);
    } else {
        load_opacity(description, object, features.opacity);
    }
    object.albedo = before && before->wrap == object.wrap
                        ? before->albedo
                        : std::make_shared<AlbedoImage>(context_, commands_, colours, clamp, part);
}

void GpuScene::load_source(Object& object) {
    const auto table = object.source->inverse();
    object.inverse = vulkan::Buffer(context_, table.size_bytes(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Access::host);
    std::memcpy(object.inverse.mapped(), table.data(), table.size_bytes());
}

void GpuScene::load_map(Object& object, const HeightView& map, const WorkPart& part) {
    object.map = std::make_shared<vulkan::Image>(context_, map.width, map.height, VK_FORMAT_R16_UNORM, kTexture);
    commands_.run([&](VkCommandBuffer cmd) {
        object.map->transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
    for (int y = 0; y < map.height; y += kBand) {
        part.at(static_cast<double>(y) / map.height);
        const TexelRegion band{0, y, map.width, std::min(map.height, y + kBand)};
        upload_texels(object, map, std::span(&band, 1));
    }
}

void GpuScene::load_bounds(Object& object, const HeightView& map, const Object* before, const WorkPart& part) {
    const bool wanted = object.has_pyramid || object.has_slabs;
    object.slabs_left_out = object.has_slabs ? slab_levels_left_out(map.width, map.height) : 0;
    if (wanted)
        object.pyramid = before && before->pyramid ? before->pyramid
                                                   : std::make_shared<HeightPyramid>(map, object.wrap, part.within(0, 0.3));
    if (before && object.has_slabs == before->has_slabs && object.has_pyramid == before->has_pyramid) {
        object.pyramid_image = before->pyramid_image;
        object.slab_image = before->slab_image;
        return;
    }
    // One node stands in where no method asks: descriptors need an image.
    const HeightPyramid one({1, 1, map.texels}, object.wrap);
    const auto make_image = [&](bool asked_for, int first_level, VkFormat format) {
        const HeightPyramid& of = asked_for ? *object.pyramid : one;
        auto image = std::make_shared<vulkan::Image>(context_, of.width(first_level), of.height(first_level), format, kTexture,
                                                     of.levels() - first_level + 1);
        commands_.run([&](VkCommandBuffer cmd) {
            image->transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        });
        return image;
    };
    object.pyramid_image = make_image(object.has_pyramid, 1, VK_FORMAT_R16G16_UNORM);
    object.slab_image = make_image(object.has_slabs, 1 + object.slabs_left_out, VK_FORMAT_R16G16B16A16_SINT);
    if (!wanted) return;
    const HeightPyramid& pyramid = *object.pyramid;
    const WorkPart upload = part.within(0.3, 1);
    double begin = 0;  // of the level; the finest of n is as much work as three quarters of them all
    for (int level = 1; level <= pyramid.levels(); ++level) {
        const double share = 0.75 * (1 - begin);
        for (int y = 0; y < pyramid.height(level); y += kBand / 4) {
            upload.at(begin + share * y / pyramid.height(level));
            const int end = std::min(pyramid.height(level), y + kBand / 4);
            upload_bounds(object, map, {{level, 0, y, pyramid.width(level), end}});
        }
        begin += share;
    }
}

void GpuScene::load_opacity(const SceneObject& description, Object& object, bool wanted) {
    // A white texel stands in where there is no map: descriptors need an image.
    OpacityMap opacity;
    if (wanted && !description.opacity_map.empty()) opacity = load_opacity_map(description.opacity_map);
    object.opacity = std::make_shared<vulkan::Image>(context_, opacity.width, opacity.height, VK_FORMAT_R8_UNORM, kTexture);
    object.opacity_sampler = vulkan::make_sampler(context_, object.wrap == Wrap::clamp, true);
    const vulkan::Buffer staging(context_, opacity.texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                 vulkan::Access::host);
    std::memcpy(staging.mapped(), opacity.texels.data(), opacity.texels.size());
    const VkBufferImageCopy copy = image_copy({0, 0, opacity.width, opacity.height}, 0);
    commands_.run([&](VkCommandBuffer cmd) {
        object.opacity->transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        vkCmdCopyBufferToImage(cmd, staging.get(), object.opacity->get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                               &copy);
        object.opacity->transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                  VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
}

void GpuScene::upload_bounds(Object& object, const HeightView& map, const std::vector<HeightPyramid::Nodes>& changed) {
    const HeightPyramid& pyramid = *object.pyramid;
    if (object.has_slabs) {
        upload_nodes<PackedSlab>(*object.slab_image, 1 + object.slabs_left_out, changed, [&](int level, int x, int y) {
            return height_slab(map, pyramid, level, x, y);
        });
    } else {
        upload_nodes<HeightPyramid::Node>(*object.pyramid_image, 1, changed, [&](int level, int x, int y) {
            return pyramid.overlapping(level, x, y);
        });
    }
}

// The changed nodes, level by level from the image's first one, into its mips.
template <typename Texel, typename NodeOf>
void GpuScene::upload_nodes(const vulkan::Image& image, int first_level, std::vector<HeightPyramid::Nodes> changed,
                            const NodeOf& node_of) {
    std::erase_if(changed, [&](const HeightPyramid::Nodes& n) { return n.level < first_level; });
    if (changed.empty()) return;
    std::vector<VkBufferImageCopy> copies;
    std::size_t count = 0;
    for (const HeightPyramid::Nodes& n : changed) {
        copies.push_back(image_copy({n.x0, n.y0, n.x1, n.y1}, count * sizeof(Texel)));
        copies.back().imageSubresource.mipLevel = static_cast<std::uint32_t>(n.level - first_level);
        count += static_cast<std::size_t>(n.x1 - n.x0) * static_cast<std::size_t>(n.y1 - n.y0);
    }
    if (staging_.bytes() < count * sizeof(Texel))
        staging_ = vulkan::Buffer(context_, count * sizeof(Texel), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vulkan::Access::host);
    auto* to = staging_.as<Texel>();
    for (const HeightPyramid::Nodes& n : changed) {
        const auto width = static_cast<std::ptrdiff_t>(n.x1 - n.x0);
        tbb::parallel_for(tbb::blocked_range<int>(n.y0, n.y1, std::max(1, kNodesAtOnce / std::max(1, n.x1 - n.x0))),
                          [&](const tbb::blocked_range<int>& rows) {
                              Texel* row = to + (rows.begin() - n.y0) * width;
                              for (int y = rows.begin(); y < rows.end(); ++y)
                                  for (int x = n.x0; x < n.x1; ++x) *row++ = node_of(n.level, x, y);
                          });
        to += (n.y1 - n.y0) * width;
    }
    commands_.run([&](VkCommandBuffer cmd) {
        image.transition(cmd, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        vkCmdCopyBufferToImage(cmd, staging_.get(), image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               static_cast<std::uint32_t>(copies.size()), copies.data());
        image.transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
}

void GpuScene::upload_texels(Object& object, const HeightView& map, std::span<const TexelRegion> regions) {
    VkDeviceSize bytes = 0;
    std::vector<VkBufferImageCopy> copies;
    for (const TexelRegion& r : regions) {
        copies.push_back(image_copy(r, bytes));
        // Offsets of image copies are multiples of 4.
        bytes += (static_cast<VkDeviceSize>(r.x1 - r.x0) * static_cast<VkDeviceSize>(r.y1 - r.y0) * 2 + 3) / 4 * 4;
    }
    if (staging_.bytes() < bytes)
        staging_ = vulkan::Buffer(context_, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vulkan::Access::host);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        auto* to = reinterpret_cast<std::uint16_t*>(staging_.as<std::uint8_t>() + copies[i].bufferOffset);
        pack_rows(to, map.texels, map.width, regions[i]);
    }
    commands_.run([&](VkCommandBuffer cmd) {
        object.map->transition(cmd, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        vkCmdCopyBufferToImage(cmd, staging_.get(), object.map->get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               static_cast<std::uint32_t>(copies.size()), copies.data());
        object.map->transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
}

std::uint64_t GpuScene::map_bytes() const {
    std::uint64_t sum = 0;
    for (const Object& o : objects_) sum += o.map->bytes();
    return sum;
}

std::uint64_t GpuScene::procedural_bytes() const {
    std::uint64_t sum = procedural_.bytes();
    for (const Object& o : objects_) sum += o.inverse.bytes();
    return sum;
}

std::uint64_t GpuScene::pyramid_bytes() const {
    std::uint64_t sum = 0;
    for (const Object& o : objects_) sum += o.has_pyramid ? o.pyramid_image->bytes() : 0;
    return sum;
}

std::uint64_t GpuScene::slab_bytes() const {
    std::uint64_t sum = 0;
    for (const Object& o : objects_) sum += o.has_slabs ? o.slab_image->bytes() : 0;
    return sum;
}

std::uint64_t GpuScene::albedo_bytes() const {
    std::uint64_t sum = 0;
    for (const Object& o : objects_) sum += o.albedo->bytes();
    return sum;
}

std::uint64_t GpuScene::opacity_bytes() const {
    std::uint64_t sum = 0;
    for (const Object& o : objects_) sum += o.opacity->bytes();
    return sum;
}

}  // namespace relievo
