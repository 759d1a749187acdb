#pragma once
// SPDX-License-Identifier: Apache-2.0
// The file by which this program is started, for those that start it once more: tasks of a farm, benches. In
// a bundle (tools/make_bundle.sh) that is its launcher, which finds the libraries, not the program itself.
// Any thread.

#include <filesystem>

namespace ghost {

// "" where the system does not say.
std::filesystem::path own_program();
// program: the file that runs.
std::filesystem::path starter_of(const std::filesystem::path& program);

} // namespace ghost
