// The window's surface and the images that it shows in turn.
#include "editor/gui/swapchain.h"

#include <algorithm>
#include <stdexcept>

#include "renderer/vulkan/functions.h"

namespace relievo::gui {
namespace {

constexpr std::uint32_t kAnySize = 0xffffffffu;  // the surface takes the swapchain's size

bool holds_bytes(VkFormat format) {
    return format == VK_FORMAT_B8G8R8A8_UNORM || format == VK_FORMAT_R8G8B8A8_UNORM ||
           format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB;
}

bool is_srgb(VkFormat format) {
    return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB;
}

}  // namespace

Swapchain::Swapchain(vulkan::Context& context, const Window& window)
    : context_(&context), window_(&window), surface_(window.make_surface(context.instance())) {
    try {
        VkBool32 supported = VK_FALSE;
        vulkan::check(vkGetPhysicalDeviceSurfaceSupportKHR(context.physical_device(), context.queue_family(),
                                                           surface_, &supported),
                      "asking whether the device can show pictures");
        if (!supported)
            throw std::runtime_error("the device '" + context.info().name +
                                     "' cannot show pictures in a window; choose another by --device");
        choose_format();
        choose_mode();
        acquired_ = make_semaphore();
    } catch (...) {
        vkDestroySurfaceKHR(context.instance(), surface_, nullptr);
        throw;
    }
}

Swapchain::~Swapchain() {
    context_->wait_idle();
    chain_ = {};
    vkDestroySurfaceKHR(context_->instance(), surface_, nullptr);
}

void Swapchain::choose_format() {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceSurfaceFormatsKHR(context_->physical_device(), surface_, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    vkGetPhysicalDeviceSurfaceFormatsKHR(context_->physical_device(), surface_, &count, formats.data());
    const auto find = [&](auto wanted) {
        return std::find_if(formats.begin(), formats.end(), [&](const VkSurfaceFormatKHR& f) {
            return f.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR && wanted(f.format);
        });
    };
    auto found = find([](VkFormat f) { return holds_bytes(f) && !is_srgb(f); });
    if (found == formats.end()) found = find(holds_bytes);
    if (found == formats.end())
        throw std::runtime_error("the window takes no picture of 8 bits a channel in sRGB");
    format_ = *found;
}

void Swapchain::choose_mode() {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceSurfacePresentModesKHR(context_->physical_device(), surface_, &count, nullptr);
    std::vector<VkPresentModeKHR> modes(count);
    vkGetPhysicalDeviceSurfacePresentModesKHR(context_->physical_device(), surface_, &count, modes.data());
    // A stroke's newest picture, not the oldest in a queue.
    if (std::find(modes.begin(), modes.end(), VK_PRESENT_MODE_MAILBOX_KHR) != modes.end())
        mode_ = VK_PRESENT_MODE_MAILBOX_KHR;
}

VkFormat Swapchain::canvas_format() const {
    if (format_.format == VK_FORMAT_B8G8R8A8_SRGB) return VK_FORMAT_B8G8R8A8_UNORM;
    if (format_.format == VK_FORMAT_R8G8B8A8_SRGB) return VK_FORMAT_R8G8B8A8_UNORM;
    return format_.format;
}

SemaphoreHandle Swapchain::make_semaphore() const {
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, nullptr, 0};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    vulkan::check(vkCreateSemaphore(context_->device(), &info, nullptr, &semaphore), "creating a semaphore");
    return {context_->device(), semaphore};
}

bool Swapchain::fit() {
    const PixelSize wanted = window_->framebuffer();
    if (wanted.width == 0 || wanted.height == 0) return false;
    if (!stale_ && wanted == size_) return true;
    VkSurfaceCapabilitiesKHR can{};
    vulkan::check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(context_->physical_device(), surface_, &can),
                  "asking what the window takes");
    VkExtent2D extent = can.currentExtent;
    if (extent.width == kAnySize)
        extent = {std::clamp(static_cast<std::uint32_t>(wanted.width), can.minImageExtent.width,
                             can.maxImageExtent.width),
                  std::clamp(static_cast<std::uint32_t>(wanted.height), can.minImageExtent.height,
                             can.maxImageExtent.height)};
    if (extent.width == 0 || extent.height == 0) return false;
    if (!(can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT))
        throw std::runtime_error("pictures cannot be copied to this window");
    vulkan::check(context_->wait_idle(), "waiting for the device");
    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = surface_;
    info.minImageCount =
        std::max(can.minImageCount, can.maxImageCount == 0 ? 3u : std::min(3u, can.maxImageCount));
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.preTransform = can.currentTransform;
    info.compositeAlpha = can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = mode_;
    info.clipped = VK_TRUE;
    info.oldSwapchain = chain_.get();
    VkSwapchainKHR chain = VK_NULL_HANDLE;
    vulkan::check(vkCreateSwapchainKHR(context_->device(), &info, nullptr, &chain), "creating the swapchain");
    chain_ = SwapchainHandle(context_->device(), chain);
    std::uint32_t count = 0;
    vkGetSwapchainImagesKHR(context_->device(), chain, &count, nullptr);
    images_.resize(count);
    vulkan::check(vkGetSwapchainImagesKHR(context_->device(), chain, &count, images_.data()),
                  "listing the swapchain's images");
    drawn_.clear();
    for (std::uint32_t i = 0; i < count; ++i) drawn_.push_back(make_semaphore());
    acquired_ = make_semaphore();
    size_ = {static_cast<int>(extent.width), static_cast<int>(extent.height)};
    stale_ = false;
    return true;
}

std::optional<std::uint32_t> Swapchain::acquire() {
    std::uint32_t index = 0;
    const VkResult result = vkAcquireNextImageKHR(context_->device(), chain_.get(), UINT64_MAX,
                                                  acquired_.get(), VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) {
        stale_ = true;
        return std::nullopt;
    }
    if (result == VK_SUBOPTIMAL_KHR) {
        stale_ = true;  // it can still be shown; the next fit() makes it anew
    } else {
        vulkan::check(result, "acquiring a picture of the window");
    }
    return index;
}

void Swapchain::present(std::uint32_t index) {
    const VkSemaphore wait = drawn_[index].get();
    const VkSwapchainKHR chain = chain_.get();
    VkPresentInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &wait;
    info.swapchainCount = 1;
    info.pSwapchains = &chain;
    info.pImageIndices = &index;
    const auto held = context_->hold_queue();
    const VkResult result = vkQueuePresentKHR(context_->queue(), &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) {
        stale_ = true;
    } else {
        vulkan::check(result, "showing a picture");
    }
}

}  // namespace relievo::gui
