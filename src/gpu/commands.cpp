// SPDX-License-Identifier: Apache-2.0
#include "gpu/commands.h"

#include "base/check.h"
#include "base/log.h"
#include "gpu/buffer.h"
#include "gpu/private/shader_constants.h"
#include "gpu/push_layout.h"
#include "gpu/texture.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace ghost::gpu {
namespace {

constexpr std::uint32_t kMaxSpans = 8192;
constexpr std::uint32_t kQueriesAtOnce = 32;
constexpr std::uint64_t kUniformBytes = 64 * 1024; // what every desktop device and lavapipe bind at once

[[noreturn]] void refuse_bindings(std::string_view shader, const std::string& why) {
    log_error("shader " + std::string(shader) + " is given " + why);
    std::abort();
}

} // namespace

Binding uniform(const Buffer& buffer, std::uint64_t offset) {
    return {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, buffer, offset};
}
Binding storage(const Buffer& buffer) {
    return {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffer, 0};
}
Binding sampled(const Texture& texture) {
    return {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, texture};
}
Binding stored(const Texture& texture) {
    return {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, texture};
}
Binding stored_level(const Texture& texture, std::uint32_t level) {
    Binding binding = stored(texture);
    binding.is_level = true;
    binding.level = level;
    return binding;
}

void push_bindings(const Device& device, VkCommandBuffer commands, VkPipelineBindPoint point,
                   VkPipelineLayout layout, std::string_view shader,
                   const std::vector<VkDescriptorType>& types, const std::vector<Binding>& bindings) {
    if (bindings.size() < types.size())
        refuse_bindings(shader, std::to_string(bindings.size()) + " bindings, it has " +
                                    std::to_string(types.size()));
    std::vector<VkDescriptorBufferInfo> buffers(types.size());
    std::vector<VkDescriptorImageInfo> images(types.size());
    std::vector<VkWriteDescriptorSet> writes;
    writes.reserve(types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        const Binding& binding = bindings[i];
        if (types[i] == kNoBinding) continue;
        if (binding.type != types[i])
            refuse_bindings(shader, "a binding " + std::to_string(i) + " of another kind");
        VkWriteDescriptorSet& write = writes.emplace_back();
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstBinding = static_cast<std::uint32_t>(i);
        write.descriptorCount = 1;
        write.descriptorType = binding.type;
        if (binding.buffer) {
            const std::uint64_t left = binding.buffer->bytes() - binding.offset;
            const bool is_uniform = binding.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
            buffers[i] = {binding.buffer->handle(device), binding.offset,
                          is_uniform ? std::min(left, kUniformBytes) : left};
            write.pBufferInfo = &buffers[i];
        } else {
            const Texture::Handles& image = binding.texture->handles(device);
            const VkImageView view =
                binding.is_level ? binding.texture->level_view(binding.level) : image.view;
            images[i] = {image.sampler, view, VK_IMAGE_LAYOUT_GENERAL};
            write.pImageInfo = &images[i];
        }
    }
    device.push_descriptors()(commands, point, layout, 0, static_cast<std::uint32_t>(writes.size()),
                              writes.data());
}

namespace {

Pipeline make_pipeline(const Device& device, const Shader& shader,
                       const std::vector<VkDescriptorType>& bindings,
                       const std::vector<std::uint32_t>& constants) {
    Pipeline pipeline{make_push_layout(device, bindings, VK_SHADER_STAGE_COMPUTE_BIT), VK_NULL_HANDLE};
    const std::vector<std::uint32_t> words = with_constants(shader, constants);
    VkShaderModuleCreateInfo module_info{};
    module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module_info.codeSize = words.size() * sizeof words[0];
    module_info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    VK_CALL(vkCreateShaderModule(device.handle(), &module_info, nullptr, &module));
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = pipeline.layout.pipeline;
    info.flags = device.pipelines().flags();
    VK_CALL(vkCreateComputePipelines(device.handle(), device.pipelines().cache(), 1, &info, nullptr,
                                     &pipeline.handle));
    vkDestroyShaderModule(device.handle(), module, nullptr);
    return pipeline;
}

PipelineKey key_of(const Shader& shader, const std::vector<std::uint32_t>& constants) {
    PipelineKey key;
    key.add(shader.words);
    for (const std::uint32_t constant : constants) key.add(constant);
    return key;
}

} // namespace

Program::Program(const Device& device, const Shader& built_in, const std::vector<std::uint32_t>& constants)
    : Program(device, built_in, device.current(built_in), constants) {}

Program::Program(const Device& device, const Shader& built_in, const Shader& shader,
                 const std::vector<std::uint32_t>& constants)
    : name_(built_in.name), bindings_(bindings_of(shader)), pipelines_(device.pipelines()),
      entry_(pipelines_.begin(key_of(shader, constants), {built_in, constants, false, 0, {}},
                              [&device, shader, bindings = bindings_, constants] {
                                  return make_pipeline(device, shader, bindings, constants);
                              })) {}

void LateProgram::expect() const {
    if (program_) return;
    const Shader shader = device_->current(shader_);
    device_->pipelines().begin_late(key_of(shader, constants_), {shader_, constants_, false, 0, {}},
                                    [device = device_, shader, constants = constants_] {
                                        return make_pipeline(*device, shader, bindings_of(shader), constants);
                                    });
}

namespace {

// The queries of spans are made and reset where there are any: most commands (uploads) have none, and a reset
// of thousands took the validation layer longer than all that a frame records.
void write_timestamp(const Device& device, VkCommandBuffer commands, VkQueryPool& queries,
                     std::uint32_t index) {
    if (queries == VK_NULL_HANDLE) {
        VkQueryPoolCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = kMaxSpans + kQueriesAtOnce;
        VK_CALL(vkCreateQueryPool(device.handle(), &info, nullptr, &queries));
    }
    if (index % kQueriesAtOnce == 0) vkCmdResetQueryPool(commands, queries, index, kQueriesAtOnce);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries, index);
}

} // namespace

Commands::Commands(const Device& device) : device_(device) {
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool.queueFamilyIndex = device.queue_family();
    VK_CALL(vkCreateCommandPool(device.handle(), &pool, nullptr, &pool_));
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    VK_CALL(vkAllocateCommandBuffers(device.handle(), &allocate, &commands_));
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VK_CALL(vkCreateFence(device.handle(), &fence, nullptr, &fence_));
}

Commands::~Commands() {
    vkDestroyQueryPool(device_.handle(), queries_, nullptr);
    vkDestroyFence(device_.handle(), fence_, nullptr);
    vkDestroyCommandPool(device_.handle(), pool_, nullptr);
}

void Commands::begin() {
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    VK_CALL(vkBeginCommandBuffer(commands_, &info));
    is_settled_ = is_empty_ = true;
    names_.clear();
}

void Commands::prepare(const Program& program, const void* push, std::uint32_t bytes,
                       const std::vector<Binding>& bindings) {
    ++device_.work().dispatches;
    push_bindings(device_, commands_, VK_PIPELINE_BIND_POINT_COMPUTE, program.layout(), program.name(),
                  program.bindings(), bindings);
    vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, program.handle());
    vkCmdPushConstants(commands_, program.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, bytes, push);
}

void Commands::dispatch_from(const Buffer& groups, std::uint64_t offset) {
    vkCmdDispatchIndirect(handle(), groups.handle(device_), offset);
}

void Commands::write_bytes(const Buffer& to, const void* data, std::uint64_t bytes) {
    barrier(); // earlier readers of the buffer are done
    vkCmdUpdateBuffer(handle(), to.handle(device_), 0, bytes, data);
    barrier();
}

void Commands::fill_zero(const Buffer& buffer) {
    barrier(); // earlier readers of the buffer are done
    vkCmdFillBuffer(handle(), buffer.handle(device_), 0, VK_WHOLE_SIZE, 0);
}

void Commands::barrier() {
    if (std::exchange(is_settled_, true)) return;
    ++device_.work().barriers;
    VkMemoryBarrier2 memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    memory.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
    memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands_, &info);
}

void Commands::copy(const Buffer& from, const Buffer& to, std::uint64_t bytes) {
    const VkBufferCopy region{0, 0, bytes};
    vkCmdCopyBuffer(handle(), from.handle(device_), to.handle(device_), 1, &region);
    barrier();
}

void Commands::copy(const Texture& from, const Buffer& to) {
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {from.shape().width, from.shape().height, 1};
    vkCmdCopyImageToBuffer(handle(), from.handles(device_).image, VK_IMAGE_LAYOUT_GENERAL, to.handle(device_),
                           1, &region);
    barrier();
}

void Commands::copy(const Buffer& from, std::uint64_t offset, const Texture& to, std::uint32_t layer) {
    constexpr std::uint64_t kTexelBytes = 4;
    CHECK(to.shape().format == VK_FORMAT_R8G8B8A8_SRGB || to.shape().format == VK_FORMAT_R8G8B8A8_UNORM);
    CHECK(layer < to.shape().layers);
    std::vector<VkBufferImageCopy> regions;
    for (std::uint32_t level = 0; level < to.shape().levels; ++level) {
        VkBufferImageCopy region{};
        region.bufferOffset = offset;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, layer, 1};
        region.imageExtent = {std::max(to.shape().width >> level, 1u),
                              std::max(to.shape().height >> level, 1u), 1};
        offset += kTexelBytes * region.imageExtent.width * region.imageExtent.height;
        regions.push_back(region);
    }
    CHECK(offset <= from.bytes());
    vkCmdCopyBufferToImage(handle(), from.handle(device_), to.handles(device_).image, VK_IMAGE_LAYOUT_GENERAL,
                           static_cast<std::uint32_t>(regions.size()), regions.data());
    barrier();
}

void Commands::copy(const Texture& from, const Texture& to, const std::vector<VkRect2D>& parts,
                    std::uint32_t from_layer, std::uint32_t to_layer) {
    CHECK(from.shape().format == to.shape().format && from.shape().samples == to.shape().samples);
    const VkImageSubresourceLayers source{from.aspect(), 0, from_layer, 1};
    const VkImageSubresourceLayers target{from.aspect(), 0, to_layer, 1};
    std::vector<VkImageCopy> regions;
    for (const VkRect2D& part : parts) {
        const VkOffset3D at{part.offset.x, part.offset.y, 0};
        regions.push_back({source, at, target, at, {part.extent.width, part.extent.height, 1}});
    }
    if (regions.empty()) return;
    vkCmdCopyImage(handle(), from.handles(device_).image, VK_IMAGE_LAYOUT_GENERAL, to.handles(device_).image,
                   VK_IMAGE_LAYOUT_GENERAL, static_cast<std::uint32_t>(regions.size()), regions.data());
    barrier();
}

void Commands::clear(const Texture& texture) {
    barrier(); // earlier readers are done
    const VkClearColorValue zero{};
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, texture.shape().levels, 0,
                                      texture.shape().layers};
    vkCmdClearColorImage(handle(), texture.handles(device_).image, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &all);
    barrier();
}

void Commands::begin_span(const std::string& name) {
    if (names_.size() >= kMaxSpans || !device_.limits().timestamps) return;
    is_empty_ = false;
    write_timestamp(device_, commands_, queries_, static_cast<std::uint32_t>(names_.size()));
    // lavapipe reads the clock when what follows waits, not before: without this a span has the time of the
    // next.
    if (device_.is_cpu()) {
        is_settled_ = false;
        barrier();
    }
    names_.push_back(name);
}

void Commands::submit_and_wait() {
    submit();
    wait();
}

void Commands::submit(VkSemaphore after, VkSemaphore done) {
    const auto count = static_cast<std::uint32_t>(names_.size());
    if (count > 0) write_timestamp(device_, commands_, queries_, count);
    barrier();
    VK_CALL(vkEndCommandBuffer(commands_));
    spans_.clear();
    if (is_empty_) return;
    VkCommandBufferSubmitInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffer.commandBuffer = commands_;
    VkSemaphoreSubmitInfo waits{}, signals{};
    waits.sType = signals.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
    waits.stageMask = signals.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    waits.semaphore = after;
    signals.semaphore = done;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.waitSemaphoreInfoCount = after != VK_NULL_HANDLE ? 1 : 0;
    submit.pWaitSemaphoreInfos = &waits;
    submit.signalSemaphoreInfoCount = done != VK_NULL_HANDLE ? 1 : 0;
    submit.pSignalSemaphoreInfos = &signals;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    ++device_.work().submissions;
    VK_CALL(vkQueueSubmit2(device_.queue(), 1, &submit, fence_));
}

void Commands::wait() {
    if (is_empty_) return;
    const auto count = static_cast<std::uint32_t>(names_.size());
    VK_CALL(vkWaitForFences(device_.handle(), 1, &fence_, VK_TRUE, UINT64_MAX));
    VK_CALL(vkResetFences(device_.handle(), 1, &fence_));

    if (count == 0) return;
    std::vector<std::uint64_t> ticks(count + 1);
    VK_CALL(vkGetQueryPoolResults(device_.handle(), queries_, 0, count + 1,
                                  ticks.size() * sizeof(std::uint64_t), ticks.data(), sizeof(std::uint64_t),
                                  VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
    for (std::uint32_t i = 0; i < count; ++i)
        spans_.push_back(
            {names_[i], static_cast<double>(ticks[i + 1] - ticks[i]) * device_.timestamp_period_ns() * 1e-6});
}

} // namespace ghost::gpu
