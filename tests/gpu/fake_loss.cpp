// SPDX-License-Identifier: Apache-2.0
// A graphics device that is lost, for programs that load this library before all others (LD_PRELOAD): each
// time that the file $FAKE_LOSS is there, it is removed, and what is to be drawn next is answered with
// VK_ERROR_DEVICE_LOST. $FAKE_SURFACE_LOSS likewise: what is to be shown next, with
// VK_ERROR_SURFACE_LOST_KHR.
#include <cstdint>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>
#include <vulkan/vulkan.h>

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit2(VkQueue queue, std::uint32_t count,
                                                         const VkSubmitInfo2* submits, VkFence fence) {
    static const char* const file = std::getenv("FAKE_LOSS");
    if (file && unlink(file) == 0) return VK_ERROR_DEVICE_LOST;
    static const auto real = reinterpret_cast<PFN_vkQueueSubmit2>(dlsym(RTLD_NEXT, "vkQueueSubmit2"));
    return real(queue, count, submits, fence);
}

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkQueuePresentKHR(VkQueue queue, const VkPresentInfoKHR* info) {
    static const auto real = reinterpret_cast<PFN_vkQueuePresentKHR>(dlsym(RTLD_NEXT, "vkQueuePresentKHR"));
    const VkResult done = real(queue, info); // its semaphores are used all the same
    static const char* const file = std::getenv("FAKE_SURFACE_LOSS");
    return file && unlink(file) == 0 ? VK_ERROR_SURFACE_LOST_KHR : done;
}
