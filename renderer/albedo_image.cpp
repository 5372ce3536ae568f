// See albedo_image.h.
#include "renderer/albedo_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <stdexcept>
#include <vector>

namespace relievo {
namespace {

constexpr std::array<std::uint16_t, 3> kUnread{};  // of the texel that stands in

// The halves of all sRGB-encoded counts, decoded.
const std::vector<std::uint16_t>& decoded_halves() {
    static const std::vector<std::uint16_t> halves = [] {
        std::vector<std::uint16_t> table(65536);
        for (std::size_t count = 0; count < table.size(); ++count) {
            const double c = static_cast<double>(count) / 65535;
            const double linear = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            table[count] = glm::packHalf1x16(static_cast<float>(linear));
        }
        return table;
    }();
    return halves;
}

std::uint8_t eight_bits(std::uint16_t count) {
    return static_cast<std::uint8_t>((count + 128) / 257);
}

// Four channels a texel; the fourth is not read.
template <typename Texel, typename Encode>
void pack(Texel* to, const ColourView& colours, const TexelRegion& r, Encode encode) {
    for (int y = r.y0; y < r.y1; ++y) {
        std::size_t from = static_cast<std::size_t>(y) * static_cast<std::size_t>(colours.width) +
                           static_cast<std::size_t>(r.x0);
        for (int x = r.x0; x < r.x1; ++x, ++from, to += 4) {
            for (std::size_t k = 0; k < 3; ++k) to[k] = encode(colours.planes[k][from]);
            to[3] = 0;
        }
    }
}

}  // namespace

AlbedoImage::AlbedoImage(vulkan::Context& context, vulkan::Commands& commands, const ColourView& colours,
                         bool clamp, const WorkPart& part)
    : is_map_(!colours.empty()), bits_(colours.bits > 8 ? 16 : 8) {
    const ColourView texels =
        is_map_ ? colours : ColourView{1, 1, 8, {kUnread.data(), kUnread.data(), kUnread.data()}};
    image_ = vulkan::Image(context, texels.width, texels.height,
                           bits_ == 8 ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R16G16B16A16_SFLOAT,
                           VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    sampler_ = vulkan::make_sampler(context, clamp, true);
    commands.run([&](VkCommandBuffer cmd) {
        image_.transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
    // In bands, so that the staging buffer stays small on large maps.
    constexpr int kBand = 512;
    vulkan::Buffer staging;
    for (int y = 0; y < texels.height; y += kBand) {
        part.at(static_cast<double>(y) / texels.height);
        const TexelRegion band{0, y, texels.width, std::min(texels.height, y + kBand)};
        copy(context, commands, staging, texels, std::span(&band, 1));
    }
}

void AlbedoImage::upload(vulkan::Context& context, vulkan::Commands& commands, vulkan::Buffer& staging,
                         const ColourView& colours, std::span<const TexelRegion> regions) {
    if (!is_map_ || colours.width != image_.width() || colours.height != image_.height() ||
        (colours.bits > 8) != (bits_ > 8))
        throw std::logic_error("an albedo map of this size and these bits comes first");
    if (!regions.empty()) copy(context, commands, staging, colours, regions);
}

void AlbedoImage::copy(vulkan::Context& context, vulkan::Commands& commands, vulkan::Buffer& staging,
                       const ColourView& colours, std::span<const TexelRegion> regions) {
    const VkDeviceSize texel_bytes = bits_ == 8 ? 4 : 8;
    std::vector<VkBufferImageCopy> copies;
    VkDeviceSize bytes = 0;
    for (const TexelRegion& r : regions) {
        VkBufferImageCopy& copy = copies.emplace_back();
        copy.bufferOffset = bytes;
        copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        copy.imageOffset = {r.x0, r.y0, 0};
        copy.imageExtent = {static_cast<std::uint32_t>(r.x1 - r.x0), static_cast<std::uint32_t>(r.y1 - r.y0),
                            1};
        bytes += texel_bytes * copy.imageExtent.width * copy.imageExtent.height;
    }
    if (staging.bytes() < bytes)
        staging = vulkan::Buffer(context, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vulkan::Access::host);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        std::uint8_t* to = staging.as<std::uint8_t>() + copies[i].bufferOffset;
        if (bits_ == 8)
            pack(to, colours, regions[i], eight_bits);
        else
            pack(reinterpret_cast<std::uint16_t*>(to), colours, regions[i],
                 [&halves = decoded_halves()](std::uint16_t count) { return halves[count]; });
    }
    commands.run([&](VkCommandBuffer cmd) {
        image_.transition(cmd, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                          VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        vkCmdCopyBufferToImage(cmd, staging.get(), image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               static_cast<std::uint32_t>(copies.size()), copies.data());
        image_.transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
}

}  // namespace relievo
