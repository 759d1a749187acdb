// SPDX-License-Identifier: Apache-2.0
#include "base/log.h"

#include "base/print.h"

#include <atomic>
#include <cstdio>

namespace ghost {
namespace {

std::atomic<LogLevel> g_level{LogLevel::info};

void print(LogLevel level, const char* prefix, const std::string& text) {
    if (level < g_level.load(std::memory_order_relaxed)) return;
    const std::string line =
        prefix + one_line(text) + "\n"; // one write, so lines of several threads stay whole
    std::fflush(stdout); // what was printed before comes before, where both go into one pipe
    std::fwrite(line.data(), 1, line.size(), stderr);
}

} // namespace

void set_log_level(LogLevel level) {
    g_level = level;
}
void log_debug(const std::string& text) {
    print(LogLevel::debug, "", text);
}
void log_info(const std::string& text) {
    print(LogLevel::info, "", text);
}
void log_warning(const std::string& text) {
    print(LogLevel::warning, "warning: ", text);
}
void log_error(const std::string& text) {
    print(LogLevel::error, "error: ", text);
}

} // namespace ghost
