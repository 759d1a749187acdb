#pragma once
// SPDX-License-Identifier: Apache-2.0
// Raster: a pipeline that draws triangles into attachments (dynamic rendering, one vertex and one fragment
// shader). Depth is reversed: 0 is infinitely far, the larger value wins. Both sides of a triangle are drawn;
// front faces are counter-clockwise in the picture. Recorded into Commands between begin_drawing and
// end_drawing, which wait for what was recorded before and make the result visible to what follows. Must not
// outlive its Device.

#include "gpu/commands.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ghost::gpu {

// Where a shader's input location reads its values.
struct VertexInput {
    VkFormat format = VK_FORMAT_R32G32B32_SFLOAT;
    std::uint32_t offset = 0; // bytes
};

struct RasterShape {
    std::vector<VertexInput> inputs;      // of locations 0, 1, ..
    std::uint32_t vertex_stride = 0;      // bytes of a vertex
    std::vector<VertexInput> of_instance; // of the locations that follow, one value for a whole draw
    std::uint32_t instance_stride = 0;    // bytes
    std::vector<std::uint32_t> constants; // specialisation constants 0, 1, .. of both shaders
    std::vector<VkFormat> colours;        // of the attachments
    VkFormat depth = VK_FORMAT_D32_SFLOAT;
    std::uint32_t samples = 1;
};

class Raster {
public:
    // Of the two the fragment shader alone binds anything.
    Raster(const Device& device, const Shader& built_in_vertex, const Shader& built_in_fragment,
           const RasterShape& shape);
    Raster(const Raster&) = delete;
    Raster& operator=(const Raster&) = delete;
    VkPipeline handle() const { return pipelines_.finish(entry_).handle; }
    VkPipelineLayout layout() const { return pipelines_.finish(entry_).layout.pipeline; }
    const std::vector<VkDescriptorType>& bindings() const { return bindings_; }
    std::string_view name() const { return name_; }

private:
    Raster(const Device& device, const Shader& built_in, const Shader& vertex, const Shader& fragment,
           const RasterShape& shape);

    std::string_view name_;
    std::vector<VkDescriptorType> bindings_;
    Pipelines& pipelines_;
    Pipelines::Entry& entry_;
};

enum class Before { cleared, kept };

// Clears all attachments to zero (or goes on with what they hold) and begins; they have one size and number
// of samples.
void begin_drawing(Commands& commands, const std::vector<const Texture*>& colours, const Texture& depth,
                   Before before = Before::cleared);
// The same of depth alone, of a part of its first layers: shaders say to which.
void begin_drawing_layers(Commands& commands, const Texture& depth, std::uint32_t layers,
                          const VkRect2D& part);
void end_drawing(Commands& commands);

// A part of an index buffer (32 bit).
struct DrawRange {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::int32_t first_vertex = 0; // added to each index
};

// The buffers of the following draws.
void use_vertices(Commands& commands, const Buffer& vertices, const Buffer& indices);
// What RasterShape::of_instance reads.
void use_instances(Commands& commands, const Buffer& instances);
// What the following draws use; bytes of push: at most 128, seen by both shaders.
void use_raster(Commands& commands, const Raster& raster);
void push_constants(Commands& commands, const Raster& raster, const void* push, std::uint32_t bytes);
void use_bindings(Commands& commands, const Device& device, const Raster& raster,
                  const std::vector<Binding>& bindings);
void draw_triangles(Commands& commands, const DrawRange& range);
// So many times, each with its instance.
void draw_instances(Commands& commands, const DrawRange& range, std::uint32_t first_instance,
                    std::uint32_t count);

} // namespace ghost::gpu
