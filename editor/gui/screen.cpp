// Dear ImGui over Vulkan in one window.
#include "editor/gui/screen.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include "editor/gui/theme.h"
#include "renderer/vulkan/functions.h"

namespace relievo::gui {
namespace {

vulkan::DescriptorPoolHandle make_descriptor_pool(VkDevice device) {
    // Dear ImGui 1.86 needs one set: its font atlas.
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
    const VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          nullptr,
                                          VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT,
                                          1,
                                          1,
                                          &size};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    vulkan::check(vkCreateDescriptorPool(device, &info, nullptr, &pool), "creating a descriptor pool");
    return {device, pool};
}

vulkan::CommandPoolHandle make_command_pool(const vulkan::Context& context) {
    const VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr,
                                       VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                       context.queue_family()};
    VkCommandPool pool = VK_NULL_HANDLE;
    vulkan::check(vkCreateCommandPool(context.device(), &info, nullptr, &pool), "creating a command pool");
    return {context.device(), pool};
}

vulkan::FenceHandle make_signalled_fence(VkDevice device) {
    const VkFenceCreateInfo info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, VK_FENCE_CREATE_SIGNALED_BIT};
    VkFence fence = VK_NULL_HANDLE;
    vulkan::check(vkCreateFence(device, &info, nullptr, &fence), "creating a fence");
    return {device, fence};
}

// The image of a swapchain before and after it is copied to. The first waits in the transfer stage, where the
// semaphore of vkAcquireNextImageKHR is waited for.
void record_layout(VkCommandBuffer cmd, VkImage image, VkImageLayout from, VkImageLayout to) {
    const bool before = to == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = before ? 0 : VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = before ? VK_ACCESS_TRANSFER_WRITE_BIT : 0;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(cmd, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         before ? VK_PIPELINE_STAGE_TRANSFER_BIT : VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0, 0,
                         nullptr, 0, nullptr, 1, &barrier);
}

void begin_commands(VkCommandBuffer cmd) {
    const VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr,
                                        VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT, nullptr};
    vulkan::check(vkBeginCommandBuffer(cmd, &info), "beginning a command buffer");
}

}  // namespace

Screen::Screen(vulkan::Context& context, Window& window)
    : context_(&context),
      window_(&window),
      swapchain_(context, window),
      canvas_(context, swapchain_.canvas_format()),
      descriptors_(make_descriptor_pool(context.device())),
      pool_(make_command_pool(context)),
      done_(make_signalled_fence(context.device())) {
    const VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr,
                                           pool_.get(), VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    vulkan::check(vkAllocateCommandBuffers(context.device(), &info, &commands_),
                  "allocating a command buffer");
    start_ui(window);
}

void Screen::start_ui(Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    apply_theme(window.content_scale());
    ImGui_ImplGlfw_InitForVulkan(window.handle(), false);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = context_->instance();
    info.PhysicalDevice = context_->physical_device();
    info.Device = context_->device();
    info.QueueFamily = context_->queue_family();
    info.Queue = context_->queue();
    info.DescriptorPool = descriptors_.get();
    info.MinImageCount = info.ImageCount = 2;
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = [](VkResult result) { vulkan::check(result, "drawing the interface"); };
    ImGui_ImplVulkan_Init(&info, canvas_.render_pass());
    vulkan::Commands(*context_).run([](VkCommandBuffer cmd) { ImGui_ImplVulkan_CreateFontsTexture(cmd); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

Screen::~Screen() {
    context_->wait_idle();
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

bool Screen::begin() {
    if (!swapchain_.fit()) return false;
    const VkFence done = done_.get();
    vulkan::check(vkWaitForFences(context_->device(), 1, &done, VK_TRUE, UINT64_MAX), "waiting for a frame");
    canvas_.resize(swapchain_.size());
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    // A stroke that has come over a panel by now was not begun there.
    if (const auto at = window_->take_button_place())
        ImGui::GetIO().MousePos = {static_cast<float>(at->x), static_cast<float>(at->y)};
    ImGui::NewFrame();
    return true;
}

void Screen::end(std::span<const PictureStrip> strips, int x, int y) {
    ImGui::Render();
    begin_commands(commands_);
    canvas_.record(
        commands_,
        [&](VkCommandBuffer cmd) {
            const bool fits = !strips.empty() && x + strips.front().picture->size().width <= size().width &&
                              y + strips.front().picture->size().height <= size().height;
            if (!fits) canvas_.record_clear(cmd);  // in a tiny window
            for (const PictureStrip& strip : strips)
                if (fits) strip.picture->record_copy(cmd, canvas_.image(), x, y, strip.x0, strip.x1);
        },
        [](VkCommandBuffer cmd) { ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), cmd); });
    show();
}

// Copies the canvas to the window's next image, where there is one.
void Screen::show() {
    const std::optional<std::uint32_t> index = swapchain_.acquire();
    if (index) {
        const VkImage target = swapchain_.image(*index);
        record_layout(commands_, target, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        VkImageCopy copy{};
        copy.srcSubresource = copy.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        copy.extent = {static_cast<std::uint32_t>(size().width), static_cast<std::uint32_t>(size().height),
                       1};
        vkCmdCopyImage(commands_, canvas_.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
        record_layout(commands_, target, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                      VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    }
    vulkan::check(vkEndCommandBuffer(commands_), "ending a command buffer");
    const VkSemaphore wait = swapchain_.acquired();
    const VkSemaphore signal = index ? swapchain_.drawn(*index) : VK_NULL_HANDLE;
    const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_TRANSFER_BIT;
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands_;
    if (index) {
        submit.waitSemaphoreCount = submit.signalSemaphoreCount = 1;
        submit.pWaitSemaphores = &wait;
        submit.pWaitDstStageMask = &stage;
        submit.pSignalSemaphores = &signal;
    }
    const VkFence done = done_.get();
    vulkan::check(vkResetFences(context_->device(), 1, &done), "resetting a fence");
    {
        const auto held = context_->hold_queue();
        vulkan::check(vkQueueSubmit(context_->queue(), 1, &submit, done), "submitting a frame");
    }
    if (index) swapchain_.present(*index);
}

}  // namespace relievo::gui
