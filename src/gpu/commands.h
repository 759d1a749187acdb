#pragma once
// SPDX-License-Identifier: Apache-2.0
// Program: a compute shader. Commands: records dispatches, runs them and waits; measures named spans of GPU
// time. One Commands per thread.

#include "gpu/device.h"

#include <span>
#include <string>
#include <vector>

namespace ghost::gpu {

class Buffer;
class TextureArray;

class Program {
public:
    Program(const Device& device, std::span<const std::uint32_t> spirv);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    VkPipeline handle() const { return pipeline_; }

private:
    const Device& device_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

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
    void bind(const TextureArray& texture); // for the dispatches that follow
    // push: at most 128 bytes; groups: workgroups in x, y.
    template <class Push>
    void dispatch(const Program& program, const Push& push, std::uint32_t groups_x,
                  std::uint32_t groups_y = 1) {
        static_assert(sizeof(Push) <= 128);
        dispatch_bytes(program, &push, sizeof(Push), groups_x, groups_y);
    }
    // All that was recorded is done and visible to what follows, shaders and host.
    void barrier();
    void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes);
    void begin_span(const std::string& name); // up to the next begin_span or the end
    void submit_and_wait();

    VkCommandBuffer handle() const { return commands_; }
    const std::vector<Span>& spans() const { return spans_; } // of the last submit_and_wait

private:
    void dispatch_bytes(const Program& program, const void* push, std::uint32_t bytes, std::uint32_t x,
                        std::uint32_t y);

    const Device& device_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    VkQueryPool queries_ = VK_NULL_HANDLE;
    std::vector<std::string> names_;
    std::vector<Span> spans_;
};

} // namespace ghost::gpu
