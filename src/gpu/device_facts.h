#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a device is, in words and numbers, for a report. Any thread.

#include "gpu/device.h"

#include <string>
#include <utility>
#include <vector>

namespace ghost::gpu {

// Name -> value, in the words of Vulkan: driver, memory, and the limits that what we draw may meet.
std::vector<std::pair<std::string, std::string>> facts_of(const Device& device);

} // namespace ghost::gpu
