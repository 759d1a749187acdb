#pragma once
// SPDX-License-Identifier: Apache-2.0
// Messages for people, one line each, on standard error. Thread-safe. Standard output stays free for what a
// command is asked to print.

#include <string>

namespace ghost {

enum class LogLevel { debug, info, warning, error, silent };

void set_log_level(LogLevel level); // default: info
void log_debug(const std::string& text);
void log_info(const std::string& text);
void log_warning(const std::string& text); // prefixed "warning: "
void log_error(const std::string& text);   // prefixed "error: "

} // namespace ghost
