// SPDX-License-Identifier: Apache-2.0
#include "show_folder/hold.h"

#include "disk/files.h"
#include "disk/temporary.h"
#include "show_folder/private/hold_text.h"

#include <array>
#include <charconv>
#include <ctime>
#include <sstream>
#include <utility>

namespace ghost {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMostBytes = 1024;
constexpr std::size_t kShownBytes = 64;

} // namespace

std::string text_of_this_hold() {
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> since{};
    std::tm local{};
    if (local_time(now, local)) std::strftime(since.data(), since.size(), "%Y-%m-%d %H:%M", &local);
    return host_name() + "\n" + std::to_string(own_process()) + "\n" + since.data() + "\n";
}

Holder holder_in(const fs::path& file) {
    Holder holder;
    const auto text = read_text_file(file, kMostBytes);
    if (!text.ok()) return holder;
    std::istringstream lines(*text);
    std::string process;
    std::getline(lines, holder.host);
    std::getline(lines, process);
    std::getline(lines, holder.since);
    std::from_chars(process.data(), process.data() + process.size(), holder.process);
    return holder;
}

bool is_alive(const Holder& holder) {
    if (holder.process <= 0) return false;
    return holder.host != host_name() || is_running(holder.process);
}

Hold::Hold(Hold&& other) noexcept
    : file_(std::move(other.file_)), handle_(std::exchange(other.handle_, -1)) {}

Hold& Hold::operator=(Hold&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(handle_, other.handle_);
    return *this;
}

std::string Hold::holder() const {
    const Holder holder = holder_in(file_);
    return "process " + std::to_string(holder.process) + " on " + holder.host.substr(0, kShownBytes) +
           ", since " + holder.since.substr(0, kShownBytes);
}

} // namespace ghost
