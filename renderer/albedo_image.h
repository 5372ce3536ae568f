// An object's albedo map on the device. Both sorts hold what the mandatory formats can filter: 8 bits as sRGB
// texels that the device decodes before it filters; 16 bits as linear half floats (at most 1/2048 off, which
// no picture shows; a 16-bit integer format need not be filterable, and knows no sRGB).
#pragma once

#include <span>

#include "renderer/beside.h"
#include "renderer/renderer.h"
#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/resources.h"

namespace relievo {

class AlbedoImage {
  public:
    AlbedoImage() = default;
    // An empty view makes one texel that nobody reads: descriptors need an image.
    AlbedoImage(vulkan::Context& context, vulkan::Commands& commands, const ColourView& colours, bool clamp,
                const WorkPart& part);

    bool is_map() const { return is_map_; }
    VkDescriptorImageInfo descriptor() const {
        return {sampler_.get(), image_.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    }
    std::uint64_t bytes() const { return image_.bytes(); }

    // `staging` is made larger where it is too small. std::logic_error where there is no map, or one of
    // another size or other bits.
    void upload(vulkan::Context& context, vulkan::Commands& commands, vulkan::Buffer& staging,
                const ColourView& colours, std::span<const TexelRegion> regions);

  private:
    void copy(vulkan::Context& context, vulkan::Commands& commands, vulkan::Buffer& staging,
              const ColourView& colours, std::span<const TexelRegion> regions);

    bool is_map_ = false;
    int bits_ = 8;
    vulkan::Image image_;
    vulkan::SamplerHandle sampler_;
};

}  // namespace relievo
