// The ray-traced picture as the window shows it: a copy of the renderer's image, or of colours made from its
// layers, taken when and where it is fit to be seen, so that the renderer may change its size or start anew
// meanwhile.
#pragma once

#include <vector>

#include "editor/gui/window.h"
#include "renderer/renderer.h"
#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/resources.h"

namespace relievo::gui {

class Picture {
  public:
    // `format`: the canvas's, so that frames copy bytes.
    Picture(vulkan::Context& context, VkFormat format);
    ~Picture();  // waits for the last frame that shows it
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    PixelSize size() const { return {image_.width(), image_.height()}; }
    // What was shown is stretched to the new size until something new is copied.
    void resize(PixelSize size);
    // Takes a window of the renderer's image; where the sizes differ, the whole image is stretched.
    void copy(const Renderer& renderer, const PixelRect& window);
    // A window of the renderer's image, as write() takes it, but of the window's pixels alone.
    std::vector<std::uint8_t> read(const Renderer& renderer, const PixelRect& window);
    // As copy(), from pixels of 4 bytes, sRGB-encoded, row 0 at the top: an image of `size` of which `window`
    // counts.
    void write(const std::vector<std::uint8_t>& rgba, PixelSize size, const PixelRect& window);
    // Records the copy of the columns x0 to x1 to an image in layout TRANSFER_DST_OPTIMAL, in which the
    // picture's top left corner is at (x, y).
    void record_copy(VkCommandBuffer commands, VkImage to, int x, int y, int x0, int x1) const;

  private:
    void blit(VkCommandBuffer commands, VkImage from, PixelSize from_size, const PixelRect& window);

    vulkan::Context* context_;
    VkFormat format_;
    vulkan::Commands commands_;
    vulkan::Image image_;    // in layout TRANSFER_SRC_OPTIMAL between calls
    vulkan::Image written_;  // of write(): likewise
    vulkan::Buffer staging_, reading_;
};

// Columns of a picture that are on screen.
struct PictureStrip {
    const Picture* picture;
    int x0, x1;
};

}  // namespace relievo::gui
