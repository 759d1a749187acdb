#pragma once
// SPDX-License-Identifier: Apache-2.0
// Program: a compute shader; its pipeline stays with the device (gpu/pipelines.h). Commands: records
// dispatches, runs them and waits; measures named spans of GPU time. One Commands per thread.

#include "gpu/device.h"
#include "gpu/pipelines.h"
#include "gpu/shader.h"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ghost::gpu {

class Buffer;
class Texture;

// What a shader finds at a binding of set 0. There is no empty one, so that a shader's <Name>Bindings
// (cmake/embed.cmake) compile only with every member given.
struct Binding {
    Binding(VkDescriptorType kind, const Buffer& at, std::uint64_t at_offset)
        : type(kind), buffer(&at), offset(at_offset) {}
    Binding(VkDescriptorType kind, const Texture& at) : type(kind), texture(&at) {}

    VkDescriptorType type;
    const Buffer* buffer = nullptr;
    const Texture* texture = nullptr;
    std::uint64_t offset = 0; // into the buffer
    bool is_level = false;    // of the texture one level alone
    std::uint32_t level = 0;
};
Binding uniform(const Buffer& buffer, std::uint64_t offset = 0);
Binding storage(const Buffer& buffer);
Binding sampled(const Texture& texture);
Binding stored(const Texture& texture);
Binding stored_level(const Texture& texture, std::uint32_t level); // not of workers

// Pushes the bindings 0, 1, .. of set 0 at a pipeline; types: as its shaders bind them (bindings_of), without
// those that glslc took out as unused. Fewer or others are a bug of ours and end the program with the
// shader's name.
void push_bindings(const Device& device, VkCommandBuffer commands, VkPipelineBindPoint point,
                   VkPipelineLayout layout, std::string_view shader,
                   const std::vector<VkDescriptorType>& types, const std::vector<Binding>& bindings);

// A compute shader. constants: its specialisation constants 0, 1, ..
class Program {
public:
    Program(const Device& device, const Shader& built_in, const std::vector<std::uint32_t>& constants = {});
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    VkPipeline handle() const { return pipelines_.finish(entry_).handle; }
    VkPipelineLayout layout() const { return pipelines_.finish(entry_).layout.pipeline; }
    const std::vector<VkDescriptorType>& bindings() const { return bindings_; }
    std::string_view name() const { return name_; }

private:
    Program(const Device& device, const Shader& built_in, const Shader& shader,
            const std::vector<std::uint32_t>& constants);

    std::string_view name_;
    std::vector<VkDescriptorType> bindings_;
    Pipelines& pipelines_;
    Pipelines::Entry& entry_;
};

// A program that may never be used: on a processor, which compiles as long as it would draw pictures, it is
// made when it is first asked for, on a GPU beside the others. The device and the words must outlive it.
class LateProgram {
public:
    LateProgram() = default;
    LateProgram(const Device& device, const Shader& shader, std::vector<std::uint32_t> constants = {})
        : device_(&device), shader_(shader), constants_(std::move(constants)) {
        if (!device.is_cpu()) (void)get();
    }

    const Program& get() {
        if (!program_) program_ = std::make_unique<Program>(*device_, shader_, constants_);
        return *program_;
    }
    // It may well be used: made when there is time (Pipelines::make_late).
    void expect() const;

private:
    const Device* device_ = nullptr;
    Shader shader_;
    std::vector<std::uint32_t> constants_;
    std::unique_ptr<Program> program_;
};

// Workgroups of so many items each that it takes.
inline std::uint32_t groups(std::uint32_t items, std::uint32_t size) {
    return (items + size - 1) / size;
}

struct Span {
    std::string name;
    double ms = 0;
};

class Commands {
public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    void begin();
    // push: at most 128 bytes; bindings: as the program declares them, best by name as its <Name>Bindings;
    // groups: workgroups in x, y.
    template <class Push>
    void dispatch(const Program& program, const Push& push, const std::vector<Binding>& bindings,
                  std::uint32_t groups_x, std::uint32_t groups_y = 1) {
        static_assert(sizeof(Push) <= 128);
        prepare(program, &push, sizeof(Push), bindings);
        vkCmdDispatch(handle(), groups_x, groups_y, 1);
    }
    // The numbers of workgroups lie in a buffer, at an offset.
    template <class Push>
    void dispatch_indirect(const Program& program, const Push& push, const std::vector<Binding>& bindings,
                           const Buffer& groups, std::uint64_t offset) {
        static_assert(sizeof(Push) <= 128);
        prepare(program, &push, sizeof(Push), bindings);
        dispatch_from(groups, offset);
    }
    // Writes at most 64 KiB to the start of a buffer, in order with the dispatches.
    template <class Value>
    void write(const Buffer& to, const std::vector<Value>& values) {
        write_bytes(to, values.data(), values.size() * sizeof(Value));
    }
    // All that was recorded is done and visible to what follows, shaders and host. Nothing where it is
    // already.
    void barrier();
    void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes);
    void copy(const Texture& from, const Buffer& to); // level 0, layer 0, tightly packed
    // Fills all levels of a layer, which stand one after the other, tightly packed, from the offset on.
    void copy(const Buffer& from, std::uint64_t offset, const Texture& to, std::uint32_t layer);
    // Parts of an image of the same shape, every sample of a pixel; from a layer to a layer.
    void copy(const Texture& from, const Texture& to, const std::vector<VkRect2D>& parts,
              std::uint32_t from_layer = 0, std::uint32_t to_layer = 0);
    void clear(const Texture& texture); // every layer to zero
    void fill_zero(const Buffer& buffer);
    void begin_span(const std::string& name); // up to the next begin_span or the end
    void submit_and_wait();                   // nothing where nothing was recorded
    // Its two halves, for what runs beside: between them nothing is recorded here.
    void submit() { submit(VK_NULL_HANDLE, VK_NULL_HANDLE); }
    // Likewise, begun when one semaphore is signalled; the other one is when it is done.
    void submit(VkSemaphore after, VkSemaphore done);
    void wait();

    // For a command that may have to be waited for.
    VkCommandBuffer handle() {
        is_settled_ = is_empty_ = false;
        return commands_;
    }
    const Device& device() const { return device_; }
    const std::vector<Span>& spans() const { return spans_; } // of the last submit_and_wait

private:
    void prepare(const Program& program, const void* push, std::uint32_t bytes,
                 const std::vector<Binding>& bindings);
    void dispatch_from(const Buffer& groups, std::uint64_t offset);
    void write_bytes(const Buffer& to, const void* data, std::uint64_t bytes);

    const Device& device_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    VkQueryPool queries_ = VK_NULL_HANDLE;
    bool is_settled_ = true; // nothing was recorded since the last barrier
    bool is_empty_ = true;   // nor since the beginning
    std::vector<std::string> names_;
    std::vector<Span> spans_;
};

} // namespace ghost::gpu
