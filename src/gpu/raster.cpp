// SPDX-License-Identifier: Apache-2.0
#include "gpu/raster.h"

#include "base/check.h"
#include "gpu/buffer.h"
#include "gpu/private/shader_constants.h"
#include "gpu/push_layout.h"
#include "gpu/texture.h"

#include <array>

namespace ghost::gpu {
namespace {

constexpr VkShaderStageFlags kStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

VkShaderModule make_module(const Device& device, const std::vector<std::uint32_t>& words) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size() * sizeof words[0];
    info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    VK_CALL(vkCreateShaderModule(device.handle(), &info, nullptr, &module));
    return module;
}

VkRenderingAttachmentInfo attachment(const Texture& texture, Before before) {
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = texture.view();
    info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info.loadOp = before == Before::kept ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
}

Pipeline make_pipeline(const Device& device, const Shader& vertex, const Shader& fragment,
                       const std::vector<VkDescriptorType>& bindings, const RasterShape& shape) {
    Pipeline pipeline{make_push_layout(device, bindings, kStages), VK_NULL_HANDLE};
    std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
    const std::array<const Shader*, 2> shaders{&vertex, &fragment};
    for (std::size_t i = 0; i < stages.size(); ++i) {
        stages[i].sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stages[i].stage = i == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
        stages[i].module = make_module(device, with_constants(*shaders[i], shape.constants));
        stages[i].pName = "main";
    }

    const std::array<VkVertexInputBindingDescription, 2> buffers{
        {{0, shape.vertex_stride, VK_VERTEX_INPUT_RATE_VERTEX},
         {1, shape.instance_stride, VK_VERTEX_INPUT_RATE_INSTANCE}}};
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const VertexInput& input : shape.inputs)
        attributes.push_back({static_cast<std::uint32_t>(attributes.size()), 0, input.format, input.offset});
    for (const VertexInput& input : shape.of_instance)
        attributes.push_back({static_cast<std::uint32_t>(attributes.size()), 1, input.format, input.offset});
    VkPipelineVertexInputStateCreateInfo inputs{};
    inputs.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    inputs.vertexBindingDescriptionCount = shape.of_instance.empty() ? 1 : 2;
    inputs.pVertexBindingDescriptions = buffers.data();
    inputs.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
    inputs.pVertexAttributeDescriptions = attributes.data();

    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.cullMode = VK_CULL_MODE_NONE;
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo samples{};
    samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(shape.samples);
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_GREATER;
    VkPipelineColorBlendAttachmentState plain{};
    plain.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                           VK_COLOR_COMPONENT_A_BIT;
    const std::vector<VkPipelineColorBlendAttachmentState> writes(shape.colours.size(), plain);
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = static_cast<std::uint32_t>(writes.size());
    blend.pAttachments = writes.data();
    constexpr std::array<VkDynamicState, 2> kDynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(kDynamic.size());
    dynamic.pDynamicStates = kDynamic.data();
    VkPipelineRenderingCreateInfo targets{};
    targets.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    targets.colorAttachmentCount = static_cast<std::uint32_t>(shape.colours.size());
    targets.pColorAttachmentFormats = shape.colours.data();
    targets.depthAttachmentFormat = shape.depth;

    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &targets;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.flags = device.pipelines().flags();
    info.pVertexInputState = &inputs;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = pipeline.layout.pipeline;
    VK_CALL(vkCreateGraphicsPipelines(device.handle(), device.pipelines().cache(), 1, &info, nullptr,
                                      &pipeline.handle));
    for (const VkPipelineShaderStageCreateInfo& stage : stages)
        vkDestroyShaderModule(device.handle(), stage.module, nullptr);
    return pipeline;
}

PipelineKey key_of(const Shader& vertex, const Shader& fragment, const RasterShape& shape) {
    PipelineKey key;
    key.add(vertex.words);
    key.add(fragment.words);
    for (const std::vector<VertexInput>* inputs : {&shape.inputs, &shape.of_instance}) {
        key.add(inputs->size());
        for (const VertexInput& input : *inputs) {
            key.add(static_cast<std::uint64_t>(input.format));
            key.add(input.offset);
        }
    }
    key.add(shape.vertex_stride);
    key.add(shape.instance_stride);
    key.add(shape.constants.size());
    for (const std::uint32_t constant : shape.constants) key.add(constant);
    for (const VkFormat format : shape.colours) key.add(static_cast<std::uint64_t>(format));
    key.add(static_cast<std::uint64_t>(shape.depth));
    key.add(shape.samples);
    return key;
}

} // namespace

Raster::Raster(const Device& device, const Shader& built_in_vertex, const Shader& built_in_fragment,
               const RasterShape& shape)
    : Raster(device, built_in_fragment, device.current(built_in_vertex), device.current(built_in_fragment),
             shape) {}

Raster::Raster(const Device& device, const Shader& built_in, const Shader& vertex, const Shader& fragment,
               const RasterShape& shape)
    : name_(built_in.name), bindings_(bindings_of(fragment)), pipelines_(device.pipelines()),
      entry_(pipelines_.begin(key_of(vertex, fragment, shape), {built_in, shape.constants, true, 0, {}},
                              [&device, vertex, fragment, bindings = bindings_, shape] {
                                  return make_pipeline(device, vertex, fragment, bindings, shape);
                              })) {
    CHECK(bindings_of(vertex).empty());
}

namespace {

void begin_part(Commands& commands, const std::vector<VkRenderingAttachmentInfo>& attachments,
                const Texture& depth, Before before, std::uint32_t layers, const VkRect2D& area) {
    commands.barrier();
    const VkRenderingAttachmentInfo depth_attachment = attachment(depth, before);
    const TextureShape& shape = depth.shape();
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.renderArea = area;
    info.layerCount = layers;
    info.colorAttachmentCount = static_cast<std::uint32_t>(attachments.size());
    info.pColorAttachments = attachments.data();
    info.pDepthAttachment = &depth_attachment;
    vkCmdBeginRendering(commands.handle(), &info);
    const VkViewport viewport{0,    0,   static_cast<float>(shape.width), static_cast<float>(shape.height),
                              0.0f, 1.0f};
    vkCmdSetViewport(commands.handle(), 0, 1, &viewport);
    vkCmdSetScissor(commands.handle(), 0, 1, &area);
}

} // namespace

void begin_drawing(Commands& commands, const std::vector<const Texture*>& colours, const Texture& depth,
                   Before before) {
    std::vector<VkRenderingAttachmentInfo> attachments;
    for (const Texture* colour : colours) attachments.push_back(attachment(*colour, before));
    begin_part(commands, attachments, depth, before, 1,
               {{0, 0}, {depth.shape().width, depth.shape().height}});
}

void begin_drawing_layers(Commands& commands, const Texture& depth, std::uint32_t layers,
                          const VkRect2D& part) {
    CHECK(layers > 0 && layers <= depth.shape().layers);
    begin_part(commands, {}, depth, Before::cleared, layers, part);
}

void end_drawing(Commands& commands) {
    vkCmdEndRendering(commands.handle());
    commands.barrier();
}

void use_vertices(Commands& commands, const Buffer& vertices, const Buffer& indices) {
    VkBuffer buffer = vertices.handle();
    constexpr VkDeviceSize kOffset = 0;
    vkCmdBindVertexBuffers(commands.handle(), 0, 1, &buffer, &kOffset);
    vkCmdBindIndexBuffer(commands.handle(), indices.handle(), 0, VK_INDEX_TYPE_UINT32);
}

void use_instances(Commands& commands, const Buffer& instances) {
    VkBuffer buffer = instances.handle();
    constexpr VkDeviceSize kOffset = 0;
    vkCmdBindVertexBuffers(commands.handle(), 1, 1, &buffer, &kOffset);
}

void use_raster(Commands& commands, const Raster& raster) {
    vkCmdBindPipeline(commands.handle(), VK_PIPELINE_BIND_POINT_GRAPHICS, raster.handle());
}

void push_constants(Commands& commands, const Raster& raster, const void* push, std::uint32_t bytes) {
    CHECK(bytes <= kPushBytes);
    vkCmdPushConstants(commands.handle(), raster.layout(), kStages, 0, bytes, push);
}

void use_bindings(Commands& commands, const Device& device, const Raster& raster,
                  const std::vector<Binding>& bindings) {
    push_bindings(device, commands.handle(), VK_PIPELINE_BIND_POINT_GRAPHICS, raster.layout(), raster.name(),
                  raster.bindings(), bindings);
}

void draw_triangles(Commands& commands, const DrawRange& range) {
    draw_instances(commands, range, 0, 1);
}

void draw_instances(Commands& commands, const DrawRange& range, std::uint32_t first_instance,
                    std::uint32_t count) {
    ++commands.device().work().draws;
    vkCmdDrawIndexed(commands.handle(), range.index_count, count, range.first_index, range.first_vertex,
                     first_instance);
}

} // namespace ghost::gpu
