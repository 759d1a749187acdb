#pragma once
// SPDX-License-Identifier: Apache-2.0
// Files of a person's own in a show's folder: show.toml, looks, plots. They may be links, and nothing of
// theirs is lost. Any thread.

#include "base/result.h"

#include <filesystem>
#include <string_view>

namespace ghost {

// As write_file_atomic, but a link stays one: what it leads to is written, with the permissions that it has.
// Error: it leads out of its folder.
Result<void> write_user_file(const std::filesystem::path& path, std::string_view text);

// Puts a temporary file (temporary_beside) where no file is. False: there is one, and the temporary stays.
Result<bool> commit_new(const std::filesystem::path& temporary, const std::filesystem::path& path);

} // namespace ghost
