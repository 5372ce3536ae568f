// The window's surface and the images that it shows in turn. They are only copied to.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "editor/gui/window.h"
#include "renderer/vulkan/context.h"
#include "renderer/vulkan/handle.h"

namespace relievo::gui {

using SemaphoreHandle = vulkan::Handle<VkSemaphore, vkDestroySemaphore>;
using SwapchainHandle = vulkan::Handle<VkSwapchainKHR, vkDestroySwapchainKHR>;

class Swapchain {
  public:
    // Throws std::runtime_error when the device cannot show pictures in this window.
    Swapchain(vulkan::Context& context, const Window& window);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    // Fits the images to the window; false while it has no area.
    bool fit();
    PixelSize size() const { return size_; }

    // The next image, ready when `acquired()` is signalled; empty when the window has changed: fit() again.
    std::optional<std::uint32_t> acquire();
    VkImage image(std::uint32_t index) const { return images_[index]; }
    VkSemaphore acquired() const { return acquired_.get(); }
    VkSemaphore drawn(std::uint32_t index) const { return drawn_[index].get(); }
    void present(std::uint32_t index);  // once drawn(index) is signalled

    // The format of a picture whose bytes can be copied to the images as they are and whose values count as
    // already encoded: an sRGB format's plain sibling, so that nothing is encoded twice.
    VkFormat canvas_format() const;

  private:
    void choose_format();
    void choose_mode();
    SemaphoreHandle make_semaphore() const;

    vulkan::Context* context_;
    const Window* window_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_{};
    VkPresentModeKHR mode_ = VK_PRESENT_MODE_FIFO_KHR;
    SwapchainHandle chain_;
    std::vector<VkImage> images_;
    SemaphoreHandle acquired_;
    std::vector<SemaphoreHandle> drawn_;
    PixelSize size_;
    bool stale_ = true;
};

}  // namespace relievo::gui
