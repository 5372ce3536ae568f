// The lattice of procedural heights is the same on the device as on the processor, bit for bit: places, and offsets for any
// vertex and seed, negative and huge ones too.
#include <cstring>
#include <random>

#include "renderer/bindings.h"
#include "renderer/procedural/evaluate.h"
#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/functions.h"
#include "renderer/vulkan/resources.h"
#include "spirv/lattice_offsets.h"
#include "tests/procedural/exemplars.h"
#include "tests/renderer/device.h"
#include "tests/renderer/lattice_offsets.h"

namespace relievo::test::lattice_offsets_test {
namespace {

using glm::ivec2;
using gpu::LatticeAnswer;
using gpu::LatticeQuestion;

constexpr int kMost = 2147483647, kLeast = -kMost - 1, kMostTexel = 1 << 22;

vulkan::PipelineHandle make_pipeline(VkPipelineLayout layout) {
    const VkDevice on = device().device();
    VkShaderModuleCreateInfo code{};
    code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    code.codeSize = sizeof(lattice_offsets);
    code.pCode = lattice_offsets;
    VkShaderModule module = VK_NULL_HANDLE;
    vulkan::check(vkCreateShaderModule(on, &code, nullptr, &module), "creating a shader module");
    const vulkan::ShaderHandle shader(on, module);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    vulkan::check(vkCreateComputePipelines(on, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
                  "creating a compute pipeline");
    return {on, pipeline};
}

vulkan::PipelineLayoutHandle make_layout(VkDescriptorSetLayout set) {
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    vulkan::check(vkCreatePipelineLayout(device().device(), &info, nullptr, &layout), "creating a pipeline layout");
    return {device().device(), layout};
}

VkDescriptorSet make_set(VkDescriptorPool pool, VkDescriptorSetLayout layout) {
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    vulkan::check(vkAllocateDescriptorSets(device().device(), &info, &set), "allocating a descriptor set");
    return set;
}

void bind(VkDescriptorSet set, std::uint32_t binding, const vulkan::Buffer& buffer) {
    const VkDescriptorBufferInfo info{buffer.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &info;
    vkUpdateDescriptorSets(device().device(), 1, &write, 0, nullptr);
}

vulkan::Buffer host_buffer(const void* data, std::size_t bytes) {
    vulkan::Buffer buffer(device(), bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::Access::read_back);
    if (data != nullptr) std::memcpy(buffer.mapped(), data, bytes);
    return buffer;
}

std::vector<LatticeAnswer> ask_device(const ProceduralSource& source, const std::vector<LatticeQuestion>& questions) {
    gpu::ObjectData object{};
    object.map_size = {source.width(), source.height()};
    const vulkan::Buffer objects = host_buffer(&object, sizeof(object)),
                         sources = host_buffer(&source.data(), sizeof(source.data())),
                         asked = host_buffer(questions.data(), questions.size() * sizeof(LatticeQuestion)),
                         answered = host_buffer(nullptr, questions.size() * sizeof(LatticeAnswer));
    const auto set_layout = make_set_layout(device(), 1, TracePath::bvh);
    const auto pool = make_pool(device(), 1, TracePath::bvh);
    const VkDescriptorSet set = make_set(pool.get(), set_layout.get());
    bind(set, gpu::kBindObjects, objects);
    bind(set, gpu::kBindProcedural, sources);
    bind(set, gpu::kBindPickRays, asked);
    bind(set, gpu::kBindPickResults, answered);
    const auto layout = make_layout(set_layout.get());
    const auto pipeline = make_pipeline(layout.get());
    vulkan::Commands(device()).run([&](VkCommandBuffer commands) {
        vulkan::memory_barrier(commands);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1, &set, 0, nullptr);
        vkCmdDispatch(commands, static_cast<std::uint32_t>(questions.size() / 64), 1, 1);
        vulkan::memory_barrier(commands);
    });
    const auto* first = answered.as<LatticeAnswer>();
    return {first, first + questions.size()};
}

LatticeAnswer ask_processor(const ProceduralSource& source, const LatticeQuestion& question) {
    const ExemplarView& view = source.view();
    LatticeAnswer answer{};
    procedural_float::lattice_coordinates(view.data, question.texel, answer.x, answer.y);
    const auto place = procedural_float::lattice_place(answer.x, answer.y);
    answer.beyond = place.beyond ? 1 : 0;
    answer.home = procedural_float::exemplar_home(view, question.texel);
    answer.texel_shift = procedural_float::vertex_shift(
        view, view.data.seed, procedural_float::lattice_vertex(place.square, place.beyond, 0));
    answer.vertex_shift = procedural_float::vertex_shift(view, question.seed, question.vertex);
    return answer;
}

// Near the origin, anywhere, and the extremes of all; a multiple of 64.
std::vector<LatticeQuestion> make_questions() {
    std::vector<LatticeQuestion> questions;
    const auto add = [&](ivec2 texel, ivec2 vertex, std::uint32_t seed) {
        questions.push_back({texel, vertex, seed});
    };
    for (const std::uint32_t seed : {0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
        for (const int x : {kLeast, -1, 0, 1, kMost})
            for (const int y : {kLeast, -1, 0, 1, kMost})
                add(glm::clamp(ivec2(x, y), -kMostTexel, kMostTexel - 1), {x, y}, seed);
    for (int y = -20; y < 20; ++y)
        for (int x = -20; x < 20; ++x) add({x, y}, {x, y}, 7);
    std::mt19937 random(6);
    const auto whole = [&] { return static_cast<int>(static_cast<std::uint32_t>(random())); };
    while (questions.size() < 64 * 256) add(ivec2(whole() >> 9, whole() >> 9), {whole(), whole()}, random());
    return questions;
}

void check_source(const Exemplar& exemplar, const Procedural& settings) {
    const ProceduralSource source = exemplar.source(settings);
    const std::vector<LatticeQuestion> questions = make_questions();
    const std::vector<LatticeAnswer> answers = ask_device(source, questions);
    int differ = 0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const LatticeAnswer expected = ask_processor(source, questions[i]);
        differ += std::memcmp(&answers[i], &expected, sizeof(expected)) == 0 ? 0 : 1;
    }
    EXPECT_EQ(differ, 0) << "of " << questions.size();
}

TEST(LatticeOffsets, AreTheProcessorsBitForBit) {
    constexpr std::uint32_t kMostSeed = 0xffffffffu;
    const Exemplar odd = noise_exemplar(33, 17), one = constant_exemplar(1, 1, 5), row = noise_exemplar(1024, 1);
    for (const double size : {Procedural::kLeastTriangle, 0.25, 0.3, Procedural::kMostTriangle}) {
        SCOPED_TRACE(size);
        check_source(odd, {{}, 1, {0, 0}, 3, size});
        check_source(one, {{}, 1, {-40, 7}, kMostSeed, size});
        check_source(row, {{}, 2, {0.3, 0.1}, 0, size});
    }
    check_source(noise_exemplar(128, 128), {{}, 1, {0, 0}, 12345, 0.25});
}

}  // namespace
}  // namespace relievo::test::lattice_offsets_test
