// The descriptor set that all passes share.
#pragma once

#include <cstddef>

#include "renderer/vulkan/context.h"
#include "renderer/vulkan/handle.h"

namespace relievo {

// Every binding of shaders/shared.h; textures as arrays of one an object.
vulkan::SetLayoutHandle make_set_layout(const vulkan::Context& context, std::size_t objects);
// Room for one such set.
vulkan::DescriptorPoolHandle make_pool(const vulkan::Context& context, std::size_t objects);

}  // namespace relievo
