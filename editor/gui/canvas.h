// The picture of the whole window: the ray-traced picture with the interface drawn over it. It is copied to
// the window's images byte by byte, and to files for screenshots.
#pragma once

#include <functional>

#include "editor/gui/window.h"
#include "editor/session/image_file.h"
#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/resources.h"

namespace relievo::gui {

using RenderPassHandle = vulkan::Handle<VkRenderPass, vkDestroyRenderPass>;
using FramebufferHandle = vulkan::Handle<VkFramebuffer, vkDestroyFramebuffer>;

class Canvas {
  public:
    Canvas(vulkan::Context& context, VkFormat format);

    VkFormat format() const { return format_; }
    VkRenderPass render_pass() const { return pass_.get(); }
    VkImage image() const { return image_.get(); }
    PixelSize size() const { return {image_.width(), image_.height()}; }
    void resize(PixelSize size);

    // Records `underlay` (copies into image(), in layout TRANSFER_DST_OPTIMAL; what it leaves out is
    // undefined), then `overlay` in the render pass. The image ends in layout TRANSFER_SRC_OPTIMAL.
    using Record = std::function<void(VkCommandBuffer)>;
    void record(VkCommandBuffer commands, const Record& underlay, const Record& overlay) const;

    // For an underlay without a picture.
    void record_clear(VkCommandBuffer commands) const;

    // As last drawn.
    DisplayPicture read_back();

  private:
    vulkan::Context* context_;
    VkFormat format_;
    vulkan::Commands commands_;
    RenderPassHandle pass_;
    vulkan::Image image_;
    FramebufferHandle frame_;
};

}  // namespace relievo::gui
