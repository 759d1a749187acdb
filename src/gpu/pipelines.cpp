// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipelines.h"

#include <string_view>

namespace ghost::gpu {

void PipelineKey::add(std::span<const std::uint32_t> words) {
    add(words.size());
    add(std::hash<std::string_view>{}({reinterpret_cast<const char*>(words.data()), words.size_bytes()}));
}

Pipelines::~Pipelines() {
    for (const auto& [key, pipeline] : all_) {
        vkDestroyPipeline(device_, pipeline.handle, nullptr);
        vkDestroyPipelineLayout(device_, pipeline.layout.pipeline, nullptr);
        vkDestroyDescriptorSetLayout(device_, pipeline.layout.set, nullptr);
    }
}

Pipeline Pipelines::get(const PipelineKey& key, const std::function<Pipeline()>& make) {
    const auto found = all_.find(key);
    return found == all_.end() ? all_.emplace(key, make()).first->second : found->second;
}

} // namespace ghost::gpu
