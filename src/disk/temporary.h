#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whose a temporary file (temporary_beside in disk/files.h) is. Its name holds process, machine and a random
// number, for several machines may write into one folder. Any thread.

#include <filesystem>
#include <string>

namespace ghost {

enum class Writer {
    none,     // it is no temporary file
    gone,     // a process of this machine that has ended
    here,     // one that runs
    elsewhere // of another machine, whose processes cannot be seen from here
};
Writer writer_of(const std::filesystem::path& path);

int own_process();            // its number
bool is_running(int process); // of this machine

std::string host_name(); // of this machine; "": the system does not say

} // namespace ghost
