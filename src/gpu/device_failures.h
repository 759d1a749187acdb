#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a Vulkan call (VK_CALL) throws where the program can go on. All that was made from the device can only
// be destroyed then.

#include <stdexcept>

namespace ghost::gpu {

// The driver gave the device up: a reset, a driver that was replaced, a GPU that was pulled out. Another
// device may work.
struct DeviceLost : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// There is not as much memory as was asked for. A device with a lower limit (DeviceOptions) may do.
struct OutOfDeviceMemory : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace ghost::gpu
