#pragma once
// SPDX-License-Identifier: Apache-2.0
// Instance: a Vulkan instance, with the validation layer where it is asked for. A device has one of its own,
// or, where its pictures go to a window, that of all such devices: a surface belongs to an instance and
// outlives devices, which come and go with what is opened. Any thread.

#include "base/result.h"

#include <atomic>
#include <memory>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

class Instance {
public:
    // Error: no driver, or no validation layer.
    static Result<std::shared_ptr<Instance>> create(bool validation);
    // With what surfaces need, as far as this system has it: the same one as long as anybody holds it.
    static Result<std::shared_ptr<Instance>> for_surfaces(bool validation);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle() const { return handle_; }
    std::size_t validation_errors() const { return validation_errors_; }

private:
    Instance() = default;
    static VKAPI_ATTR VkBool32 VKAPI_CALL on_validation(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                        VkDebugUtilsMessageTypeFlagsEXT,
                                                        const VkDebugUtilsMessengerCallbackDataEXT*, void*);
    static Result<std::shared_ptr<Instance>> make(bool validation, bool surfaces);

    VkInstance handle_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::atomic<std::size_t> validation_errors_ = 0; // drivers are called on several threads
};

} // namespace ghost::gpu
