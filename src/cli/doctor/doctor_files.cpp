// SPDX-License-Identifier: Apache-2.0
#include "cli/doctor/doctor_files.h"

#include "base/interrupt.h"
#include "base/text.h"
#include "fixture_files/load_type.h"

#include <algorithm>
#include <fstream>
#include <set>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLookedBytes = 64 << 10; // of a .json, for the words of a fixture

bool is_file(const fs::path& path) {
    std::error_code code;
    return fs::is_regular_file(path, code);
}

bool is_folder(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(path, code);
}

// Many programs write .json; fixtures of the Open Fixture Library have these words early.
bool is_ofl(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string start(kLookedBytes, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    for (const char* word :
         {"\"availableChannels\"", "\"templateChannels\"", "open-fixture-library.org/schemas"})
        if (start.find(word) != std::string::npos) return true;
    return false;
}

void search(const fs::path& folder, FileSearch& found, std::set<std::string>& known) {
    std::error_code code;
    std::size_t entries = 0;
    const auto take = [&](const fs::path& path) {
        if (known.insert(path.lexically_normal().string()).second) found.files.push_back(path.string());
    };
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, code), end; !code && entry != end;
         entry.increment(code)) {
        if (interrupted()) return;
        if (++entries > kMaxSearchedEntries || found.files.size() >= kMaxCheckedFiles) {
            found.limits.push_back(folder.string() + ": more than " +
                                   (found.files.size() >= kMaxCheckedFiles
                                        ? std::to_string(kMaxCheckedFiles) + " files to check"
                                        : std::to_string(kMaxSearchedEntries) + " entries") +
                                   "; the rest is not looked at");
            return;
        }
        const fs::path& path = entry->path();
        if (is_folder(path)) {
            if (path.filename().string().starts_with('.'))
                entry.disable_recursion_pending();
            else if (is_file(path / "show.toml")) { // a show: what it needs lies in it
                entry.disable_recursion_pending();
                take(path);
            } else if (entry.depth() + 1 >= kMaxSearchDepth) {
                entry.disable_recursion_pending();
                found.limits.push_back(path.string() + ": folders in folders more than " +
                                       std::to_string(kMaxSearchDepth) + " deep; not looked at");
            }
            continue;
        }
        if (!is_file(path)) continue;
        const std::string ending = lower(path.extension().string());
        if (ending == ".json" && !is_ofl(path))
            ++found.other_json;
        else if (ending == ".mvr" || fixture::has_type_extension(path))
            take(path);
    }
    if (code) found.limits.push_back(folder.string() + ": " + code.message() + "; the rest is not looked at");
}

} // namespace

FileSearch find_files(const std::vector<std::string>& arguments) {
    FileSearch found;
    std::set<std::string> known;
    for (const std::string& argument : arguments) {
        const fs::path path(argument);
        if (is_folder(path) && !is_file(path / "show.toml")) {
            found.is_search = true;
            search(path, found, known);
        } else if (known.insert(path.lexically_normal().string()).second) {
            found.files.push_back(argument);
        }
    }
    std::sort(found.files.begin(), found.files.end());
    return found;
}

std::vector<fs::path> fixture_files(const fs::path& folder, std::size_t limit, int depth) {
    std::vector<fs::path> files;
    std::error_code code;
    std::size_t entries = 0;
    for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, code),
         end;
         !code && entry != end && files.size() < limit && ++entries < kMaxSearchedEntries;
         entry.increment(code)) {
        if (entry.depth() >= depth) entry.disable_recursion_pending();
        if (fixture::has_type_extension(entry->path()) && is_file(entry->path()))
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

fs::path own_folder(const std::string& name) {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code); // empty on other systems
    const fs::path here = program.parent_path();
    for (const fs::path& folder :
         {here / "../share/ghostlight" / name, here / "../../assets" / name, fs::path("assets") / name})
        if (is_folder(folder)) return folder.lexically_normal();
    return {};
}

} // namespace ghost::app
