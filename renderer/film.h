// What the passes write: sums of samples, the picture on display, the layers; and how they are read back.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/renderer.h"
#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/resources.h"
#include "shaders/shared.h"

namespace relievo {

class Film {
  public:
    Film() = default;
    Film(vulkan::Context& context, vulkan::Commands& commands, int width, int height);
    // Throws std::invalid_argument when the device's largest buffer does not hold the image.
    static void check_size(const vulkan::Context& context, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    const vulkan::Image& display() const { return display_; }

    void clear(vulkan::Commands& commands, const PixelRect& window) const;
    void make_aov(vulkan::Context& context);  // at the first wish for a layer
    // Rows of the image that the AOV buffer holds at once: all, but of images beyond the device's largest buffer.
    int aov_rows() const { return aov_rows_; }
    // After a window of so many rows at most was traced: it is kept where the buffer does not hold the whole image.
    void keep_aov(const PixelRect& window);
    bool has_aov() const { return aov_.bytes() > 64; }
    void make_ray_counts(vulkan::Context& context);  // at the first wish for them
    bool has_ray_counts() const { return ray_counts_.bytes() > 64; }
    void clear_ray_counts(VkCommandBuffer cmd, int row_begin, int row_end) const;

    void write_bindings(VkDevice device, VkDescriptorSet set) const;

    std::vector<float> beauty(vulkan::Context& context, vulkan::Commands& commands, const PixelRect& window) const;
    // From the buffers as last traced: Layer::counts, and any other layer but the beauty.
    std::vector<float> ray_counts(vulkan::Context& context, vulkan::Commands& commands, const PixelRect& window) const;
    std::vector<float> layer(Layer layer, const PixelRect& window) const;
    std::vector<std::uint8_t> display_pixels(vulkan::Context& context, vulkan::Commands& commands) const;

    std::uint64_t image_bytes() const;
    std::uint64_t aov_bytes() const { return has_aov() ? aov_.bytes() : 0; }
    std::uint64_t ray_counts_bytes() const { return has_ray_counts() ? ray_counts_.bytes() : 0; }

  private:
    int width_ = 0, height_ = 0;
    int aov_rows_ = 0;
    vulkan::Buffer accumulation_, counts_, aov_, ray_counts_;
    std::vector<gpu::AovPixel> kept_aov_;  // the whole image, where the buffer does not hold it
    vulkan::Image display_;  // in layout GENERAL, but for the moment of a copy
};

}  // namespace relievo
