#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the file of a Hold says. One thread.

#include <ctime>
#include <filesystem>
#include <string>

namespace ghost {

inline constexpr int kTries = 3; // where others take and give back at the same time

struct Holder {
    std::string host, since;
    int process = 0;
};

std::string text_of_this_hold(); // host, process, since when: a line each
Holder holder_in(const std::filesystem::path& file);
bool local_time(std::time_t time, std::tm& local); // by the system's file
bool is_alive(const Holder& holder);               // as far as can be told from here

} // namespace ghost
