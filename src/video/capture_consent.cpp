// SPDX-License-Identifier: Apache-2.0
#include "video/capture_consent.h"

#include "disk/files.h"

#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <system_error>

namespace ghost::video {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxListBytes = 1u << 16;

// Empty: the user has no folder.
fs::path settings_folder() {
    const char* const own = std::getenv("XDG_CONFIG_HOME");
    if (own && *own == '/') return own;
    const char* const home = std::getenv("HOME");
    return home && *home == '/' ? fs::path(home) / ".config" : fs::path();
}

fs::path list_file() {
    return settings_folder() / "ghostlight" / "capture-devices";
}

std::string real_name(const fs::path& device) {
    std::error_code code;
    const fs::path real = fs::weakly_canonical(device, code);
    return (code ? device : real).string();
}

std::set<std::string> allowed() {
    std::set<std::string> devices;
    const auto text = read_text_file(list_file(), kMaxListBytes);
    if (!text.ok()) return devices;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) devices.insert(line);
    return devices;
}

Result<void> write(const std::set<std::string>& devices) {
    if (settings_folder().empty()) return Error{"there is no folder for your settings (HOME)", ""};
    std::error_code code;
    fs::create_directories(list_file().parent_path(), code);
    std::string text;
    for (const std::string& device : devices) text += device + "\n";
    return write_file_atomic(list_file(), text);
}

} // namespace

bool may_capture(const fs::path& device) {
    return !settings_folder().empty() && allowed().contains(real_name(device));
}

Result<void> allow_capture(const fs::path& device) {
    const std::string name = real_name(device);
    if (name.find('\n') != std::string::npos) return Error{"has a line break in its name", name};
    std::set<std::string> devices = allowed();
    return devices.insert(name).second ? write(devices) : Result<void>();
}

Result<void> forbid_capture(const fs::path& device) {
    std::set<std::string> devices = allowed();
    return devices.erase(real_name(device)) > 0 ? write(devices) : Result<void>();
}

} // namespace ghost::video
