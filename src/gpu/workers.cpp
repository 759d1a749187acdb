// SPDX-License-Identifier: Apache-2.0
#include "gpu/workers.h"

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

namespace ghost::gpu {
namespace {

constexpr const char* kThreads = "LP_NUM_THREADS"; // of Mesa's driver
// With more cores than that a dispatch is better shared out to all of them than a light given to one.
constexpr unsigned kMostCores = 4;

VkInstance make_instance() {
    VkApplicationInfo application{
        VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "ghostlight", 1, "ghostlight", 1, VK_API_VERSION_1_3};
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    return vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS ? instance : VK_NULL_HANDLE;
}

// The driver reads the environment when it is first asked for its devices.
bool has_only_processors(VkInstance instance) {
    std::uint32_t count = 0;
    if (instance == VK_NULL_HANDLE || vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS)
        return false;
    std::vector<VkPhysicalDevice> all(count);
    if (count == 0 || vkEnumeratePhysicalDevices(instance, &count, all.data()) != VK_SUCCESS) return false;
    return std::all_of(all.begin(), all.end(), [](VkPhysicalDevice physical) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(physical, &properties);
        return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    });
}

std::vector<VkInstance>& instances() {
    static std::vector<VkInstance> all;
    return all;
}

} // namespace

void prepare_workers(unsigned count) {
    static bool has_tried = false;
    const unsigned cores = std::thread::hardware_concurrency();
    if (count == 0 && cores <= kMostCores) count = cores;
    if (std::exchange(has_tried, true) || count < 2 || std::getenv(kThreads)) return;
    setenv(kThreads, "0", 1);
    for (unsigned k = 0; k < count; ++k) {
        const VkInstance instance = make_instance();
        if (!has_only_processors(instance)) {
            if (instance != VK_NULL_HANDLE) vkDestroyInstance(instance, nullptr);
            break;
        }
        instances().push_back(instance);
    }
    unsetenv(kThreads);
    if (instances().size() > 1) return; // one alone would draw what the device draws with all cores
    for (const VkInstance instance : instances()) vkDestroyInstance(instance, nullptr);
    instances().clear();
}

std::span<const VkInstance> worker_instances() {
    return instances();
}

} // namespace ghost::gpu
