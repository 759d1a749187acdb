#pragma once
// SPDX-License-Identifier: Apache-2.0
// DeviceLost: thrown by a Vulkan call (VK_CALL) where the driver gave the device up: a reset, a driver that
// was replaced, a GPU that was pulled out. All that was made from the device can only be destroyed; another
// device may work.

#include <stdexcept>

namespace ghost::gpu {

struct DeviceLost : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace ghost::gpu
