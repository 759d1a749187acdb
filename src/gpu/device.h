#pragma once
// SPDX-License-Identifier: Apache-2.0
// Device: one Vulkan 1.3 device with one queue. Whoever creates it keeps it alive until all that was made
// from it is gone. A failing Vulkan call (VK_CALL) throws a std::runtime_error that names the call, file and
// line; a lost device and memory that is not there have types of their own (gpu/device_failures.h). Main
// thread.

#include "base/result.h"
#include "gpu/instance.h"
#include "gpu/needed_limits.h"
#include "gpu/shader.h"

#include <memory>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

class DeviceMemory;
class PipelineCache;
class Pipelines;
class ShaderFolder;

// What was recorded and submitted so far, all together: work that does not hang on how fast a machine is.
struct RecordedWork {
    std::uint64_t dispatches = 0, draws = 0, barriers = 0, submissions = 0; // each submission is waited for
};

struct DeviceOptions {
    std::string
        name; // part of a device's name (case does not count), or its number in list_devices; empty: the best
    bool validation = false; // report misuse through the Khronos validation layer where it is installed
    std::uint64_t memory_limit_bytes = 0; // of all buffers and textures; 0: what the device has
    std::string
        shaders; // a folder that they are read from (gpu/private/shader_folder.h); empty: those built in
    bool pipeline_statistics = false; // keep what drivers say of pipelines, where they do (Pipelines::made)
    LoweredLimits lowered_limits;     // none
    bool workers = false;       // make those that there can be (gpu/workers.h); not where memory is limited
    std::string kept_pipelines; // a folder for them (gpu/pipeline_cache.h); empty: none is kept
    bool presents = false;      // its pictures may go to surfaces, where it can do that
};

class Device {
public:
    // Error: no Vulkan 1.3 device with the features that we need; the text lists what was found.
    static Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkDevice handle() const { return device_; }
    VkPhysicalDevice physical() const { return physical_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queue_family() const { return queue_family_; }
    PFN_vkCmdPushDescriptorSetKHR push_descriptors() const { return push_descriptors_; }

    Pipelines& pipelines() const { return *pipelines_; }
    void make_late_pipelines() const; // Pipelines::make_late, of its workers, too
    const PipelineCache& pipeline_cache() const { return *pipeline_cache_; }
    DeviceMemory& memory() const { return *memory_; }
    RecordedWork& work() const { return *work_; }
    // The one that is built in, or that of DeviceOptions::shaders.
    Shader current(const Shader& built_in) const;
    // DeviceOptions::shaders has newer ones than are drawn with: whoever draws opens a device anew.
    bool have_shaders_changed() const;

    const std::string& name() const { return name_; } // "llvmpipe (LLVM 15.0.6, 256 bits)"
    bool is_cpu() const { return is_cpu_; }           // lavapipe and its like
    double timestamp_period_ns() const { return timestamp_period_ns_; }
    const UsedLimits& limits() const { return limits_; }
    bool keeps_pipeline_statistics() const { return keeps_pipeline_statistics_; }
    std::size_t validation_errors() const { return owned_ ? owned_->validation_errors() : 0; }
    // That surfaces are made of (Instance::for_surfaces); null: its pictures cannot go to any.
    std::shared_ptr<Instance> instance_of_surfaces() const { return presents_ ? owned_ : nullptr; }

    // Devices beside this one, of a processor; empty: none.
    std::span<const std::unique_ptr<Device>> workers() const { return workers_; }
    // Which of them this is; -1: none.
    int worker() const { return worker_; }

    // The first of these formats whose images can do all that is wanted; the last one where none can.
    VkFormat first_format(std::span<const VkFormat> formats, VkFormatFeatureFlags wanted) const;

private:
    Device();
    Result<void> choose_physical(const DeviceOptions& options);
    void make_device(const DeviceOptions& options);
    void make_workers(const DeviceOptions& options);

    std::shared_ptr<Instance> owned_; // null: of a worker, whose instance lives as long as the program
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    PFN_vkCmdPushDescriptorSetKHR push_descriptors_ = nullptr;
    std::unique_ptr<PipelineCache> pipeline_cache_;
    std::unique_ptr<Pipelines> pipelines_;
    std::unique_ptr<ShaderFolder> shaders_; // or null
    std::unique_ptr<DeviceMemory> memory_;
    std::unique_ptr<RecordedWork> work_ = std::make_unique<RecordedWork>();
    std::uint32_t queue_family_ = 0;
    std::string name_;
    bool is_cpu_ = false;
    bool keeps_pipeline_statistics_ = false;
    std::vector<std::unique_ptr<Device>> workers_;
    int worker_ = -1;
    double timestamp_period_ns_ = 1;
    UsedLimits limits_;
    VkInstance instance_ = VK_NULL_HANDLE;
    bool presents_ = false;
};

[[noreturn]] void vulkan_failed(const char* call, const char* file, int line, VkResult result);

} // namespace ghost::gpu

#define VK_CALL(call)                                                                                        \
    do {                                                                                                     \
        const VkResult vk_result = (call);                                                                   \
        if (vk_result != VK_SUCCESS) ghost::gpu::vulkan_failed(#call, __FILE__, __LINE__, vk_result);        \
    } while (false)
