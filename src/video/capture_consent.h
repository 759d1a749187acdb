#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which video devices shows may open on this machine: a show comes from anywhere, and a camera looks into a
// room. The user's own list, ghostlight/capture-devices in the folder for settings (XDG_CONFIG_HOME, or
// ~/.config), a device a line, wherever links lead. Any thread.

#include "base/result.h"

#include <filesystem>

namespace ghost::video {

bool may_capture(const std::filesystem::path& device);
// From now on, for every show. Error: the list cannot be written.
Result<void> allow_capture(const std::filesystem::path& device);
// No more; nothing where it was not allowed.
Result<void> forbid_capture(const std::filesystem::path& device);

} // namespace ghost::video
