// See single_rays.h.
#include "renderer/single_rays.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "shaders/shared.h"

namespace relievo {
namespace {

constexpr std::size_t kNotesHead = 16;  // the number of notes, before them
constexpr std::size_t kNotesBytes = kNotesHead + gpu::kMaxNotes * sizeof(gpu::Note);

vulkan::Buffer make(vulkan::Context& context, std::size_t bytes, vulkan::Access access) {
    return vulkan::Buffer(context, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, access);
}

}  // namespace

SingleRays::SingleRays(vulkan::Context& context)
    : rays_(make(context, 0, vulkan::Access::host)), results_(make(context, 0, vulkan::Access::read_back)),
      notes_(make(context, 0, vulkan::Access::read_back)) {}

bool SingleRays::has_picks() const {
    return rays_.bytes() >= kBatch * sizeof(gpu::PickRay);
}
bool SingleRays::has_notes() const {
    return notes_.bytes() >= kNotesBytes;
}

bool SingleRays::make_picks(vulkan::Context& context) {
    if (has_picks()) return false;
    rays_ = make(context, kBatch * sizeof(gpu::PickRay), vulkan::Access::host);
    results_ = make(context, kBatch * sizeof(gpu::PickResult), vulkan::Access::read_back);
    return true;
}

bool SingleRays::make_notes(vulkan::Context& context) {
    if (has_notes()) return false;
    notes_ = make(context, kNotesBytes, vulkan::Access::read_back);
    return true;
}

void SingleRays::write_bindings(VkDevice device, VkDescriptorSet set) const {
    const std::array<VkDescriptorBufferInfo, 3> buffers{
        VkDescriptorBufferInfo{rays_.get(), 0, VK_WHOLE_SIZE},
        VkDescriptorBufferInfo{results_.get(), 0, VK_WHOLE_SIZE},
        VkDescriptorBufferInfo{notes_.get(), 0, VK_WHOLE_SIZE}};
    constexpr std::array<std::uint32_t, 3> kBindings{gpu::kBindPickRays, gpu::kBindPickResults,
                                                     gpu::kBindNotes};
    std::array<VkWriteDescriptorSet, 3> writes{};
    for (std::size_t i = 0; i < writes.size(); ++i) {
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set;
        writes[i].dstBinding = kBindings[i];
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        writes[i].pBufferInfo = &buffers[i];
    }
    vkUpdateDescriptorSets(device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

void SingleRays::put(std::span<const Ray> rays) {
    auto* to = rays_.as<gpu::PickRay>();
    for (std::size_t i = 0; i < rays.size(); ++i)
        to[i] = {rays[i].origin, 1e30f, glm::normalize(rays[i].direction), 0};
    if (has_notes()) *notes_.as<std::uint32_t>() = 0;
}

void SingleRays::take(const MendedMeshes& mended, std::span<const Ray> rays, std::span<PickHit> hits) const {
    const auto* from = results_.as<gpu::PickResult>();
    for (std::size_t i = 0; i < hits.size(); ++i) {
        PickHit& hit = hits[i];
        hit.hit = from[i].t >= 0;
        if (!hit.hit) continue;
        hit.object = from[i].object;
        const FacePoint base = mended.on_base(from[i].object, {from[i].face, from[i].b1, from[i].b2});
        hit.face = base.face;
        hit.b1 = base.b1;
        hit.b2 = base.b2;
        hit.distance = from[i].t;
        hit.normal = from[i].normal;
        hit.position = rays[i].origin + glm::normalize(rays[i].direction) * from[i].t;
    }
}

TraceLog SingleRays::log(const GpuScene& scene) const {
    const std::uint32_t count = *notes_.as<std::uint32_t>(), kept = std::min(count, gpu::kMaxNotes);
    const auto* first = reinterpret_cast<const gpu::Note*>(notes_.as<std::uint8_t>() + kNotesHead);
    TraceLog log;
    log.left_out = count - kept;
    for (const gpu::Note& n : std::span(first, kept)) {
        const PrimitiveId id = scene.primitive_id(n.primitive);
        log.notes.push_back(
            {static_cast<TraceNote::Kind>(n.kind), id.object, id.face, n.t, n.height, n.texel, n.extent});
    }
    log.distance = results_.as<gpu::PickResult>()->t;
    log.hit = log.distance >= 0;
    return log;
}

}  // namespace relievo
