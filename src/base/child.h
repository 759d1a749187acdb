#pragma once
// SPDX-License-Identifier: Apache-2.0
// Other programs, started and waited for. Main thread.

#include "base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ghost {

struct ChildResult {
    int exit_code = 0;  // 128 and the number of the signal that ended it
    std::string output; // both streams, the last kMostChildOutput bytes
};
inline constexpr std::size_t kMostChildOutput = std::size_t{1} << 20;

// words[0] is looked for in PATH where it has no slash. from: the folder that it starts in; "": ours. shown:
// what it says appears on our standard error, too. Error: it cannot be started.
Result<ChildResult> run_child(const std::vector<std::string>& words, const std::filesystem::path& from,
                              bool shown);
// Goes on by itself; wait_for_child() says which of them has ended, and -1 where none is left.
Result<int> start_child(const std::vector<std::string>& words);
int wait_for_child();

} // namespace ghost
