// Dear ImGui over Vulkan in one window: draws the interface above the ray-traced picture and shows both.
#pragma once

#include <span>

#include "editor/gui/canvas.h"
#include "editor/gui/picture.h"
#include "editor/gui/swapchain.h"

namespace relievo::gui {

class Screen {
  public:
    // One at a time: Dear ImGui's context is the program's.
    Screen(vulkan::Context& context, Window& window);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    // Interface code goes between begin and end. begin() is false while the window has no area: draw nothing
    // then and do not call end().
    bool begin();
    // Shows the strips of pictures of one size, their corner at (x, y), and the interface, which covers the
    // rest; without strips the interface alone.
    void end(std::span<const PictureStrip> strips, int x, int y);

    PixelSize size() const { return canvas_.size(); }
    VkFormat format() const { return canvas_.format(); }
    DisplayPicture screenshot() { return canvas_.read_back(); }  // of the last end()

  private:
    void start_ui(Window& window);
    void show();

    vulkan::Context* context_;
    Window* window_;
    Swapchain swapchain_;
    Canvas canvas_;
    vulkan::DescriptorPoolHandle descriptors_;
    vulkan::CommandPoolHandle pool_;
    vulkan::FenceHandle done_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace relievo::gui
