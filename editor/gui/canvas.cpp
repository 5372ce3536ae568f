// The picture of the whole window.
#include "editor/gui/canvas.h"

#include <cstring>
#include <utility>

#include "renderer/vulkan/functions.h"

namespace relievo::gui {
namespace {

constexpr VkClearColorValue kBackground{{0.09f, 0.095f, 0.105f, 1}};

RenderPassHandle make_pass(VkDevice device, VkFormat format) {
    VkAttachmentDescription color{};
    color.format = format;
    color.samples = VK_SAMPLE_COUNT_1_BIT;
    color.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    color.initialLayout = color.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &color;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass pass = VK_NULL_HANDLE;
    vulkan::check(vkCreateRenderPass(device, &info, nullptr, &pass), "creating the interface's render pass");
    return {device, pass};
}

}  // namespace

Canvas::Canvas(vulkan::Context& context, VkFormat format)
    : context_(&context), format_(format), commands_(context), pass_(make_pass(context.device(), format)) {}

void Canvas::resize(PixelSize size) {
    if (size == this->size()) return;
    frame_ = {};
    image_ = vulkan::Image(*context_, size.width, size.height, format_,
                           VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                               VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    const VkImageView view = image_.view();
    VkFramebufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = pass_.get();
    info.attachmentCount = 1;
    info.pAttachments = &view;
    info.width = static_cast<std::uint32_t>(size.width);
    info.height = static_cast<std::uint32_t>(size.height);
    info.layers = 1;
    VkFramebuffer frame = VK_NULL_HANDLE;
    vulkan::check(vkCreateFramebuffer(context_->device(), &info, nullptr, &frame), "creating a framebuffer");
    frame_ = FramebufferHandle(context_->device(), frame);
}

void Canvas::record(VkCommandBuffer cmd, const Record& underlay, const Record& overlay) const {
    image_.transition(cmd, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    underlay(cmd);
    image_.transition(cmd, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    VkRenderPassBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    begin.renderPass = pass_.get();
    begin.framebuffer = frame_.get();
    begin.renderArea.extent = {static_cast<std::uint32_t>(image_.width()),
                               static_cast<std::uint32_t>(image_.height())};
    vkCmdBeginRenderPass(cmd, &begin, VK_SUBPASS_CONTENTS_INLINE);
    overlay(cmd);
    vkCmdEndRenderPass(cmd);
    image_.transition(cmd, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

void Canvas::record_clear(VkCommandBuffer cmd) const {
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(cmd, image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &kBackground, 1, &all);
}

DisplayPicture Canvas::read_back() {
    const auto pixels = static_cast<std::size_t>(image_.width()) * static_cast<std::size_t>(image_.height());
    const vulkan::Buffer bytes(*context_, pixels * 4, VK_BUFFER_USAGE_TRANSFER_DST_BIT, vulkan::Access::read_back);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {static_cast<std::uint32_t>(image_.width()),
                        static_cast<std::uint32_t>(image_.height()), 1};
    commands_.run([&](VkCommandBuffer cmd) {
        vulkan::memory_barrier(cmd);
        vkCmdCopyImageToBuffer(cmd, image_.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, bytes.get(), 1,
                               &copy);
        vulkan::memory_barrier(cmd);
    });
    DisplayPicture picture{image_.width(), image_.height(), std::vector<std::uint8_t>(pixels * 4)};
    std::memcpy(picture.rgba.data(), bytes.mapped(), picture.rgba.size());
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        if (format_ == VK_FORMAT_B8G8R8A8_UNORM) std::swap(picture.rgba[i], picture.rgba[i + 2]);
        picture.rgba[i + 3] = 255;
    }
    return picture;
}

}  // namespace relievo::gui
