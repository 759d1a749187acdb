// SPDX-License-Identifier: Apache-2.0
#include "gpu/instance.h"

#include "base/log.h"
#include "base/text.h"
#include "gpu/device.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
// Those of one system or another, by name, for their headers are each system's own; and formats beyond sRGB.
constexpr std::array<const char*, 8> kSurfaceExtensions{
    "VK_KHR_surface",       "VK_KHR_xcb_surface",   "VK_KHR_xlib_surface",     "VK_KHR_wayland_surface",
    "VK_KHR_win32_surface", "VK_EXT_metal_surface", "VK_EXT_headless_surface", "VK_EXT_swapchain_colorspace"};

bool is_layer_there() {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> all(count);
    vkEnumerateInstanceLayerProperties(&count, all.data());
    return std::any_of(all.begin(), all.end(), [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, kValidationLayer) == 0;
    });
}

void add_surface_extensions(std::vector<const char*>& extensions) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> all(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, all.data());
    for (const char* const name : kSurfaceExtensions)
        if (std::any_of(all.begin(), all.end(), [&](const VkExtensionProperties& one) {
                return std::strcmp(one.extensionName, name) == 0;
            }))
            extensions.push_back(name);
}

} // namespace

VKAPI_ATTR VkBool32 VKAPI_CALL Instance::on_validation(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                       VkDebugUtilsMessageTypeFlagsEXT,
                                                       const VkDebugUtilsMessengerCallbackDataEXT* data,
                                                       void* user) {
    ++static_cast<Instance*>(user)->validation_errors_;
    for (const std::string_view line : split(data->pMessage, '\n'))
        log_error("Vulkan validation: " + std::string(line));
    return VK_FALSE;
}

Result<std::shared_ptr<Instance>> Instance::create(bool validation) {
    return make(validation, false);
}

Result<std::shared_ptr<Instance>> Instance::for_surfaces(bool validation) {
    static std::mutex mutex;
    static std::array<std::weak_ptr<Instance>, 2> all;
    const std::lock_guard lock(mutex);
    std::weak_ptr<Instance>& known = all[validation ? 1 : 0];
    if (std::shared_ptr<Instance> there = known.lock()) return there;
    auto made = make(validation, true);
    if (made.ok()) known = *made;
    return made;
}

Result<std::shared_ptr<Instance>> Instance::make(bool validation, bool surfaces) {
    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    if (validation) {
        if (!is_layer_there())
            return Error{"the Vulkan validation layer is not installed (package vulkan-validationlayers)",
                         ""};
        layers.push_back(kValidationLayer);
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    if (surfaces) add_surface_extensions(extensions);
    VkApplicationInfo application{
        VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "ghostlight", 1, "ghostlight", 1, VK_API_VERSION_1_3};
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    std::shared_ptr<Instance> made(new Instance);
    if (vkCreateInstance(&info, nullptr, &made->handle_) != VK_SUCCESS)
        return Error{"no Vulkan driver found; Mesa's software driver is Debian's package mesa-vulkan-drivers",
                     ""};
    if (validation) {
        VkDebugUtilsMessengerCreateInfoEXT messenger{};
        messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
        messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
        messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
        messenger.pfnUserCallback = &Instance::on_validation;
        messenger.pUserData = made.get();
        const auto create_messenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(made->handle_, "vkCreateDebugUtilsMessengerEXT"));
        VK_CALL(create_messenger(made->handle_, &messenger, nullptr, &made->messenger_));
    }
    return made;
}

Instance::~Instance() {
    if (messenger_ != VK_NULL_HANDLE) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(handle_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(handle_, messenger_, nullptr);
    }
    if (handle_ != VK_NULL_HANDLE) vkDestroyInstance(handle_, nullptr);
}

} // namespace ghost::gpu
