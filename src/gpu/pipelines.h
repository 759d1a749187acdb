#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pipelines: those of a device, each made once and kept as long as the device, for what is drawn with them
// comes and goes with every size of the picture, and drivers compile a shader only when it is first used.
// Known by the words of their shaders and all else that they are made from. Main thread.

#include "gpu/push_layout.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace ghost::gpu {

struct Pipeline {
    PushLayout layout;
    VkPipeline handle = VK_NULL_HANDLE;
};

// What a pipeline is made from, as numbers.
class PipelineKey {
public:
    void add(std::uint64_t number) { numbers_.push_back(number); }
    void add(std::span<const std::uint32_t> words);
    bool operator<(const PipelineKey& other) const { return numbers_ < other.numbers_; }

private:
    std::vector<std::uint64_t> numbers_;
};

class Pipelines {
public:
    explicit Pipelines(VkDevice device) : device_(device) {}
    ~Pipelines();
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    // The one of that key; made by `make` when it is asked for first.
    Pipeline get(const PipelineKey& key, const std::function<Pipeline()>& make);
    std::size_t count() const { return all_.size(); }

private:
    VkDevice device_;
    std::map<PipelineKey, Pipeline> all_;
};

} // namespace ghost::gpu
