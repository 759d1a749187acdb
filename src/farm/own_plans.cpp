// SPDX-License-Identifier: Apache-2.0
#include "farm/private/own_plans.h"

#include "bake/hasher.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "disk/user_cache.h"

#include <algorithm>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNotes = 200; // of the last plans, two each
constexpr const char* kFolder = "farm";

// What is written down of a file: where it is, and all that is in it.
std::string note_of(const fs::path& file, const std::string& text) {
    std::error_code code;
    return fs::weakly_canonical(file, code).string() + "\n" + text;
}

fs::path place_of(const fs::path& file) {
    std::error_code code;
    bake::Hasher hasher;
    hasher.text(fs::weakly_canonical(file, code).string());
    return user_state() / kFolder / hasher.hex();
}

void remove_oldest() {
    const auto folder = OwnFolder::open(user_state() / kFolder, user_state());
    if (!folder.ok()) return;
    std::vector<OwnFolder::File> files = folder->entries().files;
    if (files.size() <= kMostNotes) return;
    std::ranges::sort(files, {}, &OwnFolder::File::written);
    for (std::size_t k = 0; k < files.size() - kMostNotes; ++k) folder->remove_file(files[k].name);
}

} // namespace

Result<void> note_as_ours(const fs::path& file, const std::string& text) {
    if (user_state().empty())
        return Error{"you have no folder to note that it is yours (HOME)", file.string()};
    const fs::path place = place_of(file);
    std::error_code code;
    fs::create_directories(place.parent_path(), code);
    TRY_VOID(write_file_atomic(place, note_of(file, text)));
    remove_oldest();
    return {};
}

bool is_noted_as_ours(const fs::path& file, const std::string& text) {
    if (user_state().empty()) return false;
    const std::string expected = note_of(file, text);
    const auto noted = read_text_file(place_of(file), expected.size());
    return noted.ok() && *noted == expected;
}

} // namespace ghost::app
