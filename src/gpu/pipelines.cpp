// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipelines.h"

#include "base/steady_time.h"
#include "gpu/device.h"

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

Pipeline Pipelines::get(const PipelineKey& key, const PipelineMade& what,
                        const std::function<Pipeline()>& make) {
    const auto found = all_.find(key);
    if (found != all_.end()) return found->second;
    const double begin_s = steady_now_s();
    const Pipeline pipeline = make();
    made_.push_back(what);
    made_.back().ms = 1e3 * (steady_now_s() - begin_s);
    if (keeps_statistics_) made_.back().statistics = statistics_of(pipeline.handle);
    return all_.emplace(key, pipeline).first->second;
}

std::vector<std::pair<std::string, double>> Pipelines::statistics_of(VkPipeline pipeline) const {
    const auto properties = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
        vkGetDeviceProcAddr(device_, "vkGetPipelineExecutablePropertiesKHR"));
    const auto statistics = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
        vkGetDeviceProcAddr(device_, "vkGetPipelineExecutableStatisticsKHR"));
    VkPipelineInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, nullptr, pipeline};
    std::uint32_t executables = 0;
    VK_CALL(properties(device_, &info, &executables, nullptr));
    std::vector<std::pair<std::string, double>> all;
    for (std::uint32_t k = 0; k < executables; ++k) {
        VkPipelineExecutableInfoKHR executable{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, nullptr,
                                               pipeline, k};
        std::uint32_t count = 0;
        VK_CALL(statistics(device_, &executable, &count, nullptr));
        std::vector<VkPipelineExecutableStatisticKHR> found(
            count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR, nullptr, {}, {}, {}, {}});
        VK_CALL(statistics(device_, &executable, &count, found.data()));
        for (const VkPipelineExecutableStatisticKHR& statistic : found) {
            double value = 0;
            switch (statistic.format) {
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
                value = statistic.value.b32;
                break;
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
                value = static_cast<double>(statistic.value.i64);
                break;
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
                value = static_cast<double>(statistic.value.u64);
                break;
            default:
                value = statistic.value.f64;
                break;
            }
            all.emplace_back(statistic.name, value);
        }
    }
    return all;
}

} // namespace ghost::gpu
