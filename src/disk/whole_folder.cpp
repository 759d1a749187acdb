// SPDX-License-Identifier: Apache-2.0
#include "disk/whole_folder.h"

#include "disk/files.h"
#include "disk/temporary.h"

#include <utility>
#include <vector>

namespace ghost {
namespace fs = std::filesystem;
namespace {

Error failed(const std::string& what, const std::error_code& code, const fs::path& path) {
    return Error{what + ": " + code.message(), path.string()};
}

// Those of programs that were killed.
void remove_leftovers_of(const fs::path& folder) {
    const std::string start = "." + folder.stem().string() + ".part";
    std::error_code code;
    std::vector<fs::path> left;
    for (fs::directory_iterator entry(folder.parent_path(), code), end; !code && entry != end;
         entry.increment(code))
        if (entry->path().filename().string().starts_with(start) && !entry->is_symlink(code) &&
            writer_of(entry->path()) == Writer::gone)
            left.push_back(entry->path());
    for (const fs::path& one : left) fs::remove_all(one, code);
}

} // namespace

Result<WholeFolder> WholeFolder::open(const fs::path& folder, const std::string& marker) {
    std::error_code code;
    fs::path place = fs::absolute(folder, code).lexically_normal();
    if (!place.has_filename()) place = place.parent_path(); // "book/"
    if (code || !place.has_filename()) return Error{"is no name for a folder", folder.string()};
    if (!fs::is_directory(place.parent_path(), code))
        return Error{"no such folder", place.parent_path().string()};
    const fs::file_status there = fs::symlink_status(place, code);
    if (fs::exists(there)) {
        const bool is_ours =
            fs::is_directory(there) && (fs::exists(place / marker, code) || fs::is_empty(place, code));
        if (!is_ours)
            return Error{"is there and has no " + marker +
                             ": only a folder that this command made is replaced",
                         place.string()};
    }
    remove_leftovers_of(place);
    fs::path temporary = temporary_beside(place);
    if (!fs::create_directory(temporary, code)) return failed("cannot be made", code, place);
    return WholeFolder(std::move(place), std::move(temporary));
}

WholeFolder::WholeFolder(WholeFolder&& other) noexcept
    : folder_(std::move(other.folder_)), temporary_(std::exchange(other.temporary_, {})) {}

WholeFolder::~WholeFolder() {
    std::error_code code;
    if (!temporary_.empty()) fs::remove_all(temporary_, code);
}

Result<void> WholeFolder::make_folder(const std::string& name) const {
    std::error_code code;
    fs::create_directories(temporary_ / name, code);
    if (code) return failed("cannot make '" + name + "' in it", code, folder_);
    return {};
}

Result<void> WholeFolder::commit() {
    std::error_code code;
    fs::path before;
    if (fs::exists(folder_, code)) {
        before = temporary_beside(folder_);
        fs::rename(folder_, before, code);
        if (code) return failed("cannot be replaced", code, folder_);
    }
    fs::rename(temporary_, folder_, code);
    if (code) {
        const Error error = failed("cannot be put into place", code, folder_);
        if (!before.empty()) fs::rename(before, folder_, code);
        return error;
    }
    temporary_.clear();
    if (!before.empty()) fs::remove_all(before, code);
    return {};
}

} // namespace ghost
