// SPDX-License-Identifier: Apache-2.0
#include "gpu/device.h"

#include "base/log.h"
#include "base/text.h"
#include "gpu/device_failures.h"
#include "gpu/device_memory.h"
#include "gpu/pipeline_cache.h"
#include "gpu/pipelines.h"
#include "gpu/private/shader_folder.h"
#include "gpu/workers.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace ghost::gpu {
namespace {

bool has_extension(VkPhysicalDevice physical, const char* wanted) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, all.data());
    return std::any_of(all.begin(), all.end(), [&](const VkExtensionProperties& e) {
        return std::strcmp(e.extensionName, wanted) == 0;
    });
}

// What a device lacks for us, or "".
std::string missing(VkPhysicalDevice physical, const VkPhysicalDeviceProperties& properties,
                    const LoweredLimits& lowered) {
    if (properties.apiVersion < VK_API_VERSION_1_3) return "Vulkan 1.3";
    VkPhysicalDeviceVulkan13Features f13{};
    f13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceVulkan12Features f12{};
    f12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    f12.pNext = &f13;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &f12;
    vkGetPhysicalDeviceFeatures2(physical, &features);
    if (!features.features.shaderStorageImageExtendedFormats) return "shaderStorageImageExtendedFormats";
    if (!features.features.shaderStorageImageWriteWithoutFormat)
        return "shaderStorageImageWriteWithoutFormat";
    if (!f12.scalarBlockLayout) return "scalarBlockLayout";
    if (!f13.synchronization2) return "synchronization2";
    if (!f13.maintenance4) return "maintenance4";
    if (!f13.dynamicRendering) return "dynamicRendering";
    if (!has_extension(physical, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME))
        return VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME;
    return missing_limit(physical, properties.limits, lowered);
}

int rank(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 3;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 2;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 1;
    default:
        return 0;
    }
}

} // namespace

void vulkan_failed(const char* call, const char* file, int line, VkResult result) {
    if (result == VK_ERROR_DEVICE_LOST)
        throw DeviceLost("the graphics device was lost (reset, driver or cable); what was drawn is gone");
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
        throw OutOfDeviceMemory(
            "out of memory for drawing: a smaller picture (--size), fewer lights or smaller shadow maps "
            "(map_size) need less");
    throw std::runtime_error(std::string(file) + ":" + std::to_string(line) + ": " + call +
                             " failed with VkResult " + std::to_string(static_cast<int>(result)));
}

Result<std::unique_ptr<Device>> Device::create(const DeviceOptions& options) {
    std::unique_ptr<Device> device(new Device);
    TRY(device->owned_,
        options.presents ? Instance::for_surfaces(options.validation) : Instance::create(options.validation));
    device->instance_ = device->owned_->handle();
    TRY_VOID(device->choose_physical(options));
    device->make_device(options);
    if (!options.shaders.empty()) device->shaders_ = std::make_unique<ShaderFolder>(options.shaders);
    if (options.workers && device->is_cpu_ && options.memory_limit_bytes == 0) device->make_workers(options);
    return device;
}

void Device::make_workers(const DeviceOptions& options) {
    DeviceOptions same = options;
    same.name = name_;
    for (const VkInstance instance : worker_instances()) {
        std::unique_ptr<Device> worker(new Device);
        worker->instance_ = instance;
        worker->worker_ = static_cast<int>(workers_.size());
        bool serves = worker->choose_physical(same).ok() &&
                      has_extension(worker->physical_, VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);
        if (serves) {
            worker->make_device(same);
            serves = memory_->can_share_with(*worker);
        }
        if (!serves) {
            workers_.clear();
            return;
        }
        if (!options.shaders.empty()) worker->shaders_ = std::make_unique<ShaderFolder>(options.shaders);
        workers_.push_back(std::move(worker));
    }
}

Shader Device::current(const Shader& built_in) const {
    return shaders_ ? shaders_->current(built_in) : built_in;
}

void Device::make_late_pipelines() const {
    pipelines_->make_late();
    for (const auto& worker : workers_) worker->make_late_pipelines();
}

bool Device::have_shaders_changed() const {
    return shaders_ && shaders_->has_changed(std::chrono::steady_clock::now());
}

VkFormat Device::first_format(std::span<const VkFormat> formats, VkFormatFeatureFlags wanted) const {
    for (const VkFormat format : formats) {
        VkFormatProperties properties;
        vkGetPhysicalDeviceFormatProperties(physical_, format, &properties);
        if ((properties.optimalTilingFeatures & wanted) == wanted) return format;
    }
    return formats.back();
}

Result<void> Device::choose_physical(const DeviceOptions& options) {
    const std::string& wanted = options.name;
    std::uint32_t count = 0;
    VK_CALL(vkEnumeratePhysicalDevices(instance_, &count, nullptr));
    std::vector<VkPhysicalDevice> all(count);
    if (count > 0) VK_CALL(vkEnumeratePhysicalDevices(instance_, &count, all.data()));

    std::string found;
    int best = -1;
    for (std::uint32_t i = 0; i < count; ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(all[i], &properties);
        const std::string lack = missing(all[i], properties, options.lowered_limits);
        found += (i == 0 ? " " : ", ") + std::to_string(i) + ": " + properties.deviceName +
                 (lack.empty() ? "" : " (lacks " + lack + ")");
        if (!lack.empty()) continue;
        const bool matches = wanted.empty() || wanted == std::to_string(i) ||
                             lower(properties.deviceName).find(lower(wanted)) != std::string::npos;
        if (!matches || rank(properties.deviceType) <= best) continue;
        best = rank(properties.deviceType);
        physical_ = all[i];
        name_ = properties.deviceName;
        is_cpu_ = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
        timestamp_period_ns_ = static_cast<double>(properties.limits.timestampPeriod);
        limits_ = used_limits(properties.limits, options.lowered_limits);
    }
    if (physical_ != VK_NULL_HANDLE) return {};
    const std::string list =
        found.empty() ? " none; Mesa's software driver is Debian's package mesa-vulkan-drivers" : found;
    if (wanted.empty()) return Error{"no Vulkan device serves; found:" + list, ""};
    return Error{"no Vulkan device named '" + wanted + "' serves; found:" + list, "--device"};
}

void Device::make_device(const DeviceOptions& options) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
    constexpr VkQueueFlags kBoth = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool both = (families[i].queueFlags & kBoth) == kBoth;
        if (both || (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT)) queue_family_ = i;
        if (both) break;
    }

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = queue_family_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;

    VkPhysicalDeviceVulkan13Features f13{};
    f13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    f13.synchronization2 = VK_TRUE;
    f13.dynamicRendering = VK_TRUE;
    f13.maintenance4 = VK_TRUE; // glslc writes LocalSizeId
    VkPhysicalDeviceVulkan12Features has12{};
    has12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    VkPhysicalDeviceFeatures2 has{};
    has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    has.pNext = &has12;
    vkGetPhysicalDeviceFeatures2(physical_, &has);
    if (!has.features.shaderClipDistance) limits_.clip_distances = 0;
    if (!has12.shaderOutputLayer) limits_.drawn_layers = 1;
    VkPhysicalDeviceVulkan12Features f12{};
    f12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    f12.pNext = &f13;
    f12.scalarBlockLayout = VK_TRUE;
    f12.shaderOutputLayer = has12.shaderOutputLayer; // distance maps alone

    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &f12;
    features.features.shaderStorageImageExtendedFormats = VK_TRUE;          // rg32ui
    features.features.shaderClipDistance = has.features.shaderClipDistance; // distance maps alone
    features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;

    std::vector<const char*> extensions{VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{};
    executables.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    executables.pipelineExecutableInfo = VK_TRUE;
    keeps_pipeline_statistics_ =
        options.pipeline_statistics &&
        has_extension(physical_, VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
    if (keeps_pipeline_statistics_) {
        extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
        f13.pNext = &executables;
    }
    if (worker_ >= 0) extensions.push_back(VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);
    presents_ = options.presents && owned_ && has_extension(physical_, VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    if (presents_) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    VK_CALL(vkCreateDevice(physical_, &info, nullptr, &device_));
    vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
    // Workers are this processor once more: their drivers keep what they make in a place of their own. What
    // is measured is made.
    const bool keeps = worker_ < 0 && !keeps_pipeline_statistics_;
    pipeline_cache_ =
        std::make_unique<PipelineCache>(physical_, device_, keeps ? options.kept_pipelines : "");
    pipelines_ = std::make_unique<Pipelines>(device_, pipeline_cache_->handle(), keeps_pipeline_statistics_);
    push_descriptors_ = reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
        vkGetDeviceProcAddr(device_, "vkCmdPushDescriptorSetKHR"));
    memory_ = std::make_unique<DeviceMemory>(*this, options.memory_limit_bytes,
                                             has_extension(physical_, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME));
}

Device::Device() = default;

Device::~Device() {
    workers_.clear(); // they see our memory
    if (device_ != VK_NULL_HANDLE) {
        if (pipelines_) pipelines_->stop();
        pipelines_.reset(); // whoever gave it work waited for that (Commands)
        if (pipeline_cache_) pipeline_cache_->keep();
        pipeline_cache_.reset();
        memory_.reset();
        vkDestroyDevice(device_, nullptr);
    }
}

} // namespace ghost::gpu
