// See film.h.
#include "renderer/film.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

namespace relievo {
namespace {

constexpr VkDeviceSize kPixelBytes = 16;  // of the largest buffers that hold a whole image
static_assert(sizeof(glm::vec4) == kPixelBytes && sizeof(glm::uvec4) == kPixelBytes);
constexpr VkBufferUsageFlags kSums =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

vulkan::Buffer download(vulkan::Context& context, vulkan::Commands& commands, const vulkan::Buffer& from,
                        VkDeviceSize offset, VkDeviceSize bytes) {
    vulkan::Buffer to(context, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::Access::read_back);
    commands.run([&](VkCommandBuffer cmd) {
        vulkan::memory_barrier(cmd);
        const VkBufferCopy copy{offset, 0, bytes};
        vkCmdCopyBuffer(cmd, from.get(), to.get(), 1, &copy);
        vulkan::memory_barrier(cmd);
    });
    return to;
}

}  // namespace

void Film::check_size(const vulkan::Context& context, int width, int height) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(context.physical_device(), &properties);
    const VkDeviceSize most = properties.limits.maxStorageBufferRange / kPixelBytes;
    if (static_cast<VkDeviceSize>(width) * static_cast<VkDeviceSize>(height) <= most) return;
    throw std::invalid_argument(std::string("an image of ") + std::to_string(width) + " x " + std::to_string(height) +
                                ": the device's largest buffer takes " + std::to_string(most) +
                                " pixels (4096 x " + std::to_string(most / 4096) + ")");
}

Film::Film(vulkan::Context& context, vulkan::Commands& commands, int width, int height)
    : width_(width), height_(height) {
    const auto pixels = static_cast<VkDeviceSize>(width) * static_cast<VkDeviceSize>(height);
    accumulation_ = vulkan::Buffer(context, pixels * sizeof(glm::vec4), kSums, vulkan::Access::device);
    counts_ = vulkan::Buffer(context, pixels * sizeof(std::uint32_t), kSums, vulkan::Access::device);
    aov_ = vulkan::Buffer(context, 0, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Access::read_back);
    ray_counts_ = vulkan::Buffer(context, 0, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Access::device);
    display_ = vulkan::Image(context, width, height, VK_FORMAT_R8G8B8A8_UNORM,
                             VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                 VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    commands.run([&](VkCommandBuffer cmd) {
        display_.transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const VkClearColorValue black{{0, 0, 0, 1}};
        const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(cmd, display_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &black, 1, &all);
        display_.transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_GENERAL);
    });
    clear(commands, {0, 0, width, height});
}

void Film::clear(vulkan::Commands& commands, const PixelRect& window) const {
    // The counts alone say what the sums hold.
    commands.run([&](VkCommandBuffer cmd) {
        vulkan::memory_barrier(cmd);
        if (window.x0 == 0 && window.x1 == width_ && window.y0 == 0 && window.y1 == height_) {
            vkCmdFillBuffer(cmd, counts_.get(), 0, VK_WHOLE_SIZE, 0);
        } else {
            for (int y = window.y0; y < window.y1; ++y) {
                const auto first = static_cast<VkDeviceSize>(y) * static_cast<VkDeviceSize>(width_) +
                                   static_cast<VkDeviceSize>(window.x0);
                vkCmdFillBuffer(cmd, counts_.get(), first * 4, static_cast<VkDeviceSize>(window.x1 - window.x0) * 4,
                                0);
            }
        }
        vulkan::memory_barrier(cmd);
    });
}

void Film::make_aov(vulkan::Context& context) {
    if (has_aov()) return;
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(context.physical_device(), &properties);
    const VkDeviceSize row = static_cast<VkDeviceSize>(width_) * sizeof(gpu::AovPixel);
    const VkDeviceSize most = (properties.limits.maxStorageBufferRange - 64) / row;
    aov_rows_ = static_cast<int>(std::clamp<VkDeviceSize>(most, 1, static_cast<VkDeviceSize>(height_)));
    aov_ = vulkan::Buffer(context, static_cast<VkDeviceSize>(aov_rows_) * row + 64, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                          vulkan::Access::read_back);
    if (aov_rows_ < height_) kept_aov_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
}

void Film::keep_aov(const PixelRect& window) {
    if (kept_aov_.empty()) return;
    const auto* from = aov_.as<gpu::AovPixel>() + window.x0;
    for (int y = window.y0; y < window.y1; ++y, from += width_)
        std::copy_n(from, window.x1 - window.x0,
                    kept_aov_.begin() + static_cast<std::ptrdiff_t>(y) * width_ + window.x0);
}

void Film::make_ray_counts(vulkan::Context& context) {
    if (has_ray_counts()) return;
    const auto pixels = static_cast<VkDeviceSize>(width_) * static_cast<VkDeviceSize>(height_);
    // Rays add to them, which wants them beside the device: they are copied to be read.
    ray_counts_ = vulkan::Buffer(context, std::max<VkDeviceSize>(pixels * sizeof(glm::uvec4), 80), kSums,
                                 vulkan::Access::device);
}

void Film::clear_ray_counts(VkCommandBuffer cmd, int row_begin, int row_end) const {
    const VkDeviceSize row = static_cast<VkDeviceSize>(width_) * sizeof(glm::uvec4);
    vkCmdFillBuffer(cmd, ray_counts_.get(), static_cast<VkDeviceSize>(row_begin) * row,
                    static_cast<VkDeviceSize>(row_end - row_begin) * row, 0);
    vulkan::memory_barrier(cmd);
}

void Film::write_bindings(VkDevice device, VkDescriptorSet set) const {
    const std::array<VkDescriptorBufferInfo, 4> buffers{VkDescriptorBufferInfo{accumulation_.get(), 0, VK_WHOLE_SIZE},
                                                        VkDescriptorBufferInfo{counts_.get(), 0, VK_WHOLE_SIZE},
                                                        VkDescriptorBufferInfo{aov_.get(), 0, VK_WHOLE_SIZE},
                                                        VkDescriptorBufferInfo{ray_counts_.get(), 0, VK_WHOLE_SIZE}};
    const std::array<std::uint32_t, 4> bindings{gpu::kBindAccumulation, gpu::kBindCounts, gpu::kBindAov,
                                                gpu::kBindRayCounts};
    const VkDescriptorImageInfo image{VK_NULL_HANDLE, display_.view(), VK_IMAGE_LAYOUT_GENERAL};
    std::array<VkWriteDescriptorSet, 5> writes{};
    for (std::size_t i = 0; i < writes.size(); ++i) {
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set;
        writes[i].descriptorCount = 1;
        if (i < buffers.size()) {
            writes[i].dstBinding = bindings[i];
            writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            writes[i].pBufferInfo = &buffers[i];
        } else {
            writes[i].dstBinding = gpu::kBindDisplay;
            writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
            writes[i].pImageInfo = &image;
        }
    }
    vkUpdateDescriptorSets(device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

std::vector<float> Film::beauty(vulkan::Context& context, vulkan::Commands& commands, const PixelRect& window) const {
    if (window.x0 >= window.x1 || window.y0 >= window.y1) return {};
    const auto width = static_cast<std::size_t>(width_), first = static_cast<std::size_t>(window.y0) * width,
               pixels = static_cast<std::size_t>(window.y1 - window.y0) * width;
    const vulkan::Buffer
        sums = download(context, commands, accumulation_, first * sizeof(glm::vec4), pixels * sizeof(glm::vec4)),
        counts = download(context, commands, counts_, first * sizeof(std::uint32_t), pixels * sizeof(std::uint32_t));
    std::vector<float> result;
    result.reserve(pixels * 4);
    for (std::size_t row = 0; row < pixels; row += width) {
        for (auto x = static_cast<std::size_t>(window.x0); x < static_cast<std::size_t>(window.x1); ++x) {
            const std::uint32_t count = counts.as<std::uint32_t>()[row + x];
            const float* const sum = sums.as<float>() + (row + x) * 4;
            for (int c = 0; c < 4; ++c) result.push_back(count == 0 ? 0.0f : sum[c] / static_cast<float>(count));
        }
    }
    return result;
}

std::vector<float> Film::ray_counts(vulkan::Context& context, vulkan::Commands& commands,
                                    const PixelRect& window) const {
    const auto width = static_cast<std::size_t>(width_), rows = static_cast<std::size_t>(window.y1 - window.y0);
    const vulkan::Buffer counts =
        download(context, commands, ray_counts_, static_cast<std::size_t>(window.y0) * width * sizeof(glm::uvec4),
                 rows * width * sizeof(glm::uvec4));
    std::vector<float> result;
    for (std::size_t y = 0; y < rows; ++y) {
        for (auto x = static_cast<std::size_t>(window.x0); x < static_cast<std::size_t>(window.x1); ++x) {
            const glm::uvec4& c = counts.as<glm::uvec4>()[y * width + x];
            for (int k = 0; k < 4; ++k) result.push_back(static_cast<float>(c[k]));
        }
    }
    return result;
}

std::vector<float> Film::layer(Layer layer, const PixelRect& window) const {
    std::vector<float> result;
    const auto add = [&](const glm::vec3& v) { result.insert(result.end(), {v.x, v.y, v.z}); };
    const auto add_pixel = [&](std::size_t i) {
        const auto* from = kept_aov_.empty() ? aov_.as<gpu::AovPixel>() : kept_aov_.data();
        switch (layer) {
            case Layer::depth: return result.push_back(from[i].depth);
            case Layer::normal: return add(from[i].normal);
            case Layer::shading_normal: return add(from[i].shading_normal);
            case Layer::uv: result.insert(result.end(), {from[i].uv.x, from[i].uv.y}); return;
            case Layer::id: return result.push_back(from[i].id);
            case Layer::counts:
            case Layer::beauty: return;  // not of this buffer
        }
    };
    for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x)
            add_pixel(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
    return result;
}

std::vector<std::uint8_t> Film::display_pixels(vulkan::Context& context, vulkan::Commands& commands) const {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
    const vulkan::Buffer to(context, pixels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::Access::read_back);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(height_), 1};
    commands.run([&](VkCommandBuffer cmd) {
        display_.transition(cmd, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        vkCmdCopyImageToBuffer(cmd, display_.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.get(), 1, &copy);
        display_.transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_GENERAL);
    });
    std::memcpy(pixels.data(), to.mapped(), pixels.size());
    return pixels;
}

std::uint64_t Film::image_bytes() const { return accumulation_.bytes() + counts_.bytes() + display_.bytes(); }

}  // namespace relievo
