// SPDX-License-Identifier: Apache-2.0
#include "gpu/kept_devices.h"

#include "gpu/pipelines.h"

#include <exception>
#include <iterator>
#include <mutex>
#include <utility>
#include <vector>

namespace ghost::gpu {
namespace {

struct Kept {
    std::mutex mutex;
    std::size_t room = 0;
    std::vector<DriverDevice> devices; // the newest last

    // The oldest that there is no room for; called until there is none.
    std::optional<DriverDevice> take_oldest() {
        if (devices.size() <= room) return std::nullopt;
        std::optional<DriverDevice> oldest = std::move(devices.front());
        devices.erase(devices.begin());
        return oldest;
    }
};

Kept& kept() {
    static Kept all;
    return all;
}

} // namespace

KeptDevices::KeptDevices(std::size_t room) : room_(room) {
    const std::lock_guard lock(kept().mutex);
    kept().room += room_;
}

KeptDevices::~KeptDevices() {
    const std::lock_guard lock(kept().mutex);
    kept().room -= room_;
    while (kept().take_oldest()) {
    }
}

DriverDevice::DriverDevice() = default;

DriverDevice::DriverDevice(DriverDevice&& other) noexcept {
    *this = std::move(other);
}

DriverDevice& DriverDevice::operator=(DriverDevice&& other) noexcept {
    std::swap(instance, other.instance);
    std::swap(physical, other.physical);
    std::swap(device, other.device);
    std::swap(queue_family, other.queue_family);
    std::swap(validation, other.validation);
    std::swap(pipelines, other.pipelines);
    return *this;
}

void DriverDevice::drop_device() {
    if (pipelines) pipelines->stop();
    pipelines.reset(); // whoever gave the device work waited for that (Commands)
    if (device != VK_NULL_HANDLE) vkDestroyDevice(std::exchange(device, VK_NULL_HANDLE), nullptr);
}

DriverDevice::~DriverDevice() {
    drop_device();
    if (instance != VK_NULL_HANDLE) vkDestroyInstance(instance, nullptr);
}

bool are_devices_kept() {
    const std::lock_guard lock(kept().mutex);
    return kept().room > 0;
}

bool are_all_made(Pipelines& pipelines) {
    try {
        (void)pipelines.made();
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

bool keep(DriverDevice& device) {
    if (vkDeviceWaitIdle(device.device) != VK_SUCCESS) return false; // lost
    std::optional<DriverDevice> oldest;                              // goes after the lock
    const std::lock_guard lock(kept().mutex);
    if (kept().room == 0) return false;
    kept().devices.push_back(std::move(device));
    oldest = kept().take_oldest();
    return true;
}

std::optional<DriverDevice> take_kept(bool validation) {
    const std::lock_guard lock(kept().mutex);
    auto& devices = kept().devices;
    for (auto device = devices.rbegin(); device != devices.rend(); ++device)
        if (device->validation == validation) {
            std::optional<DriverDevice> taken = std::move(*device);
            devices.erase(std::next(device).base());
            return taken;
        }
    return std::nullopt;
}

} // namespace ghost::gpu
