// The ray-traced picture as the window shows it.
#include "editor/gui/picture.h"

#include <cstring>

namespace relievo::gui {
namespace {

constexpr VkImageSubresourceLayers kColor{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
constexpr VkClearColorValue kEmpty{{0.09f, 0.095f, 0.105f, 1}};

VkImageBlit whole_to_whole(PixelSize from, PixelSize to) {
    VkImageBlit blit{};
    blit.srcSubresource = blit.dstSubresource = kColor;
    blit.srcOffsets[1] = {from.width, from.height, 1};
    blit.dstOffsets[1] = {to.width, to.height, 1};
    return blit;
}

// The renderer's image is a bare handle; its layout between calls is GENERAL.
void record_layout(VkCommandBuffer cmd, VkImage image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(cmd, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                         nullptr, 0, nullptr, 1, &barrier);
}

constexpr VkImageLayout kSource = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
constexpr VkImageLayout kTarget = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;

}  // namespace

Picture::Picture(vulkan::Context& context, VkFormat format)
    : context_(&context), format_(format), commands_(context) {
    resize({1, 1});
}

Picture::~Picture() {
    context_->wait_idle();
}

void Picture::resize(PixelSize size) {
    if (size == this->size()) return;
    vulkan::Image old = std::move(image_);
    image_ = vulkan::Image(*context_, size.width, size.height, format_,
                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                               VK_IMAGE_USAGE_SAMPLED_BIT);  // for the view, which Image always makes
    commands_.run([&](VkCommandBuffer cmd) {
        image_.transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, kTarget);
        if (old.width() > 1) {
            const VkImageBlit blit = whole_to_whole({old.width(), old.height()}, size);
            vkCmdBlitImage(cmd, old.get(), kSource, image_.get(), kTarget, 1, &blit, VK_FILTER_LINEAR);
        } else {
            const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
            vkCmdClearColorImage(cmd, image_.get(), kTarget, &kEmpty, 1, &all);
        }
        image_.transition(cmd, kTarget, kSource);
    });
}

// A blit and not a copy: the canvas may hold its channels in another order.
void Picture::blit(VkCommandBuffer cmd, VkImage from, PixelSize from_size, const PixelRect& window) {
    image_.transition(cmd, kSource, kTarget);
    VkImageBlit region = whole_to_whole(from_size, size());
    if (size() == from_size) {
        region.srcOffsets[0] = region.dstOffsets[0] = {window.x0, window.y0, 0};
        region.srcOffsets[1] = region.dstOffsets[1] = {window.x1, window.y1, 1};
    }
    vkCmdBlitImage(cmd, from, kSource, image_.get(), kTarget, 1, &region, VK_FILTER_LINEAR);
    image_.transition(cmd, kTarget, kSource);
}

void Picture::copy(const Renderer& renderer, const PixelRect& window) {
    const Renderer::DisplayImage from = renderer.display_image();
    const auto source = static_cast<VkImage>(from.image);
    commands_.run([&](VkCommandBuffer cmd) {
        record_layout(cmd, source, VK_IMAGE_LAYOUT_GENERAL, kSource);
        blit(cmd, source, {from.width, from.height}, window);
        record_layout(cmd, source, kSource, VK_IMAGE_LAYOUT_GENERAL);
    });
}

std::vector<std::uint8_t> Picture::read(const Renderer& renderer, const PixelRect& window) {
    const auto width = static_cast<std::uint32_t>(window.x1 - window.x0);
    const auto height = static_cast<std::uint32_t>(window.y1 - window.y0);
    const std::size_t bytes = static_cast<std::size_t>(width) * height * 4;
    if (reading_.bytes() < bytes)
        reading_ = vulkan::Buffer(*context_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::Access::read_back);
    VkBufferImageCopy download{};
    download.imageSubresource = kColor;
    download.imageOffset = {window.x0, window.y0, 0};
    download.imageExtent = {width, height, 1};
    const auto source = static_cast<VkImage>(renderer.display_image().image);
    commands_.run([&](VkCommandBuffer cmd) {
        record_layout(cmd, source, VK_IMAGE_LAYOUT_GENERAL, kSource);
        vkCmdCopyImageToBuffer(cmd, source, kSource, reading_.get(), 1, &download);
        record_layout(cmd, source, kSource, VK_IMAGE_LAYOUT_GENERAL);
        vulkan::memory_barrier(cmd);
    });
    std::vector<std::uint8_t> rgba(bytes);
    std::memcpy(rgba.data(), reading_.mapped(), bytes);
    return rgba;
}

void Picture::write(const std::vector<std::uint8_t>& rgba, PixelSize from, const PixelRect& window) {
    if (window.x0 >= window.x1 || window.y0 >= window.y1) return;
    const bool fresh = from != PixelSize{written_.width(), written_.height()};
    if (fresh)
        written_ = vulkan::Image(*context_, from.width, from.height, VK_FORMAT_R8G8B8A8_UNORM,
                                 VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                                     VK_IMAGE_USAGE_SAMPLED_BIT);  // for the view, which Image always makes
    const std::size_t row_bytes = static_cast<std::size_t>(from.width) * 4;
    const std::size_t bytes = row_bytes * static_cast<std::size_t>(window.y1 - window.y0);
    if (staging_.bytes() < bytes)
        staging_ = vulkan::Buffer(*context_, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, vulkan::Access::host);
    std::memcpy(staging_.mapped(), rgba.data() + row_bytes * static_cast<std::size_t>(window.y0), bytes);
    VkBufferImageCopy upload{};
    upload.bufferOffset = static_cast<VkDeviceSize>(window.x0) * 4;
    upload.bufferRowLength = static_cast<std::uint32_t>(from.width);
    upload.imageSubresource = kColor;
    upload.imageOffset = {window.x0, window.y0, 0};
    upload.imageExtent = {static_cast<std::uint32_t>(window.x1 - window.x0),
                          static_cast<std::uint32_t>(window.y1 - window.y0), 1};
    commands_.run([&](VkCommandBuffer cmd) {
        written_.transition(cmd, fresh ? VK_IMAGE_LAYOUT_UNDEFINED : kSource, kTarget);
        vkCmdCopyBufferToImage(cmd, staging_.get(), written_.get(), kTarget, 1, &upload);
        written_.transition(cmd, kTarget, kSource);
        blit(cmd, written_.get(), from, window);
    });
}

void Picture::record_copy(VkCommandBuffer cmd, VkImage to, int x, int y, int x0, int x1) const {
    if (x0 >= x1) return;
    VkImageCopy copy{};
    copy.srcSubresource = copy.dstSubresource = kColor;
    copy.srcOffset = {x0, 0, 0};
    copy.dstOffset = {x + x0, y, 0};
    copy.extent = {static_cast<std::uint32_t>(x1 - x0), static_cast<std::uint32_t>(image_.height()), 1};
    vkCmdCopyImage(cmd, image_.get(), kSource, to, kTarget, 1, &copy);
}

}  // namespace relievo::gui
