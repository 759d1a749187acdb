#pragma once
// SPDX-License-Identifier: Apache-2.0
// scene::Bounce on disk, .ghost/bounce/LEVEL.bin: what was made for a stage is taken up again as long as its
// key is that of the stage. Errors: unreadable, damaged (the file and why). Any thread.

#include "base/result.h"
#include "bounce/bounce.h"
#include "show/bounce_detail.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ghost::scene {

struct Show;

std::filesystem::path bounce_file(const Show& show, BounceDetail level);

Result<void> write_bounce(const std::filesystem::path& file, const std::string& key, const Bounce& bounce);
// Nothing: there is no such file, or it is of another stage.
Result<std::optional<Bounce>> read_bounce(const std::filesystem::path& file, const std::string& key);

} // namespace ghost::scene
