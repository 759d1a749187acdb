#pragma once
// SPDX-License-Identifier: Apache-2.0
// PipelineCache: what a driver made of our shaders, kept for the next start: one file for each device and
// driver, in a folder of the user's. Drivers believe what they wrote, so a file is taken only if every byte
// is as it was written and it is of this very device and driver; another one is said and made anew. Read and
// kept on the thread of the device; the handle is for any thread.

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

class PipelineCache {
public:
    // folder: made where it is missing; empty: nothing is read, nothing kept.
    PipelineCache(VkPhysicalDevice physical, VkDevice device, const std::filesystem::path& folder);
    ~PipelineCache();
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_; }
    const std::filesystem::path& file() const { return file_; } // empty: none
    std::size_t bytes_read() const { return read_.size(); } // that it began with; 0: it began with nothing
    // Writes what there is now, where that is something else than was read; files of the same device and
    // another driver go. What cannot be written is a warning.
    void keep() const;

private:
    Result<std::vector<std::uint8_t>> contents(const VkPhysicalDeviceProperties& properties) const;
    void remove_older() const;

    VkDevice device_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::filesystem::path file_;
    std::vector<std::uint8_t> read_; // as the driver gave it
};

} // namespace ghost::gpu
