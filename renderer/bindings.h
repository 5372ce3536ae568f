// The descriptor set that all passes share.
#pragma once

#include <cstddef>

#include "renderer/trace_path.h"
#include "renderer/vulkan/context.h"
#include "renderer/vulkan/handle.h"

namespace relievo {

// Every binding of shaders/shared.h that the path uses; textures as arrays of one an object.
vulkan::SetLayoutHandle make_set_layout(const vulkan::Context& context, std::size_t objects, TracePath path);
// Room for one such set.
vulkan::DescriptorPoolHandle make_pool(const vulkan::Context& context, std::size_t objects, TracePath path);

}  // namespace relievo
