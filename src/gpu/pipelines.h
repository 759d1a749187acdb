#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pipelines: those of a device, each made once and kept as long as the device, for what is drawn with them
// comes and goes with every size of the picture, and drivers compile a shader only when it is first used.
// Known by the words of their shaders and all else that they are made from. Main thread.

#include "gpu/push_layout.h"
#include "gpu/shader.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
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

// How a pipeline came to be, for those who look at shaders.
struct PipelineMade {
    Shader shader; // of the fragment, where there are two
    std::vector<std::uint32_t> constants;
    bool is_raster = false;
    double ms = 0; // that the driver took
    // What the driver says, by its own names ("Registers", "VGPRs", "Spilled VGPRs"); see
    // DeviceOptions::pipeline_statistics.
    std::vector<std::pair<std::string, double>> statistics;
};

class Pipelines {
public:
    Pipelines(VkDevice device, bool keeps_statistics)
        : device_(device), keeps_statistics_(keeps_statistics) {}
    ~Pipelines();
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    // The one of that key; made by `make` when it is asked for first.
    Pipeline get(const PipelineKey& key, const PipelineMade& what, const std::function<Pipeline()>& make);
    const std::vector<PipelineMade>& made() const { return made_; } // in order
    std::size_t count() const { return all_.size(); }
    // For the `flags` of a pipeline that `make` makes.
    VkPipelineCreateFlags flags() const {
        return keeps_statistics_ ? VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR : 0;
    }

private:
    std::vector<std::pair<std::string, double>> statistics_of(VkPipeline pipeline) const;

    VkDevice device_;
    bool keeps_statistics_;
    std::vector<PipelineMade> made_;
    std::map<PipelineKey, Pipeline> all_;
};

} // namespace ghost::gpu
