#pragma once
// SPDX-License-Identifier: Apache-2.0
// KeptDevices: while one lives, the driver's device of a gpu::Device that goes is kept, with all pipelines
// that were made on it, until a Device::create with the same validation takes it up: a show that is opened
// anew does not wait for fifty pipelines again. None is kept that was lost, that reads its shaders from a
// folder or that keeps statistics. Any thread.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

class Pipelines;

class KeptDevices {
public:
    explicit KeptDevices(std::size_t room = 1); // for so many more; the newest stay
    ~KeptDevices();
    KeptDevices(const KeptDevices&) = delete;
    KeptDevices& operator=(const KeptDevices&) = delete;

private:
    std::size_t room_;
};

// What the driver made for a Device; nothing else is left of it.
struct DriverDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    bool validation = false;
    std::unique_ptr<Pipelines> pipelines;

    DriverDevice();
    ~DriverDevice();
    DriverDevice(DriverDevice&&) noexcept;
    DriverDevice& operator=(DriverDevice&&) noexcept;
    void drop_device();
};

bool are_devices_kept();
// Waits for them; false: one failed.
bool are_all_made(Pipelines& pipelines);
// All pipelines are made. False: it is not kept, and as it was.
bool keep(DriverDevice& device);
std::optional<DriverDevice> take_kept(bool validation);

} // namespace ghost::gpu
