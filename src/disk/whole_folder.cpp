// SPDX-License-Identifier: Apache-2.0
#include "disk/whole_folder.h"

#include "disk/crc32.h"
#include "disk/files.h"
#include "disk/links.h"
#include "disk/temporary.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ghost {
namespace fs = std::filesystem;
namespace {

// "Ghostlight cue book", then a file a line, in order: "1a2b3c4d pictures/1.png", its CRC-32 in front.
constexpr const char* kListName = ".ghostlight";
constexpr const char* kMaker = "Ghostlight ";
constexpr std::size_t kSumLetters = 8;
constexpr std::uint64_t kMostListBytes = std::uint64_t{64} << 20;

Error failed(const std::string& what, const std::error_code& code, const fs::path& path) {
    return Error{what + ": " + code.message(), path.string()};
}

void remove_leftovers_of(const fs::path& folder) {
    const std::string start = "." + folder.stem().string() + ".part";
    std::error_code code;
    std::vector<fs::path> left;
    for (fs::directory_iterator entry(folder.parent_path(), code), end; !code && entry != end;
         entry.increment(code))
        if (entry->path().filename().string().starts_with(start) && !is_link(entry->path()) &&
            writer_of(entry->path()) == Writer::gone)
            left.push_back(entry->path());
    for (const fs::path& one : left) remove_whole(one);
}

// From the folder on; of folders those with nothing in them, as "old/".
Result<std::set<std::string>> files_in(const fs::path& folder) {
    std::set<std::string> files;
    std::error_code code;
    for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end;
         entry.increment(code)) {
        const std::string name = entry->path().lexically_relative(folder).generic_string();
        const bool leads_elsewhere = is_link(entry->path());
        if (leads_elsewhere) entry.disable_recursion_pending();
        if (leads_elsewhere || !entry->is_directory(code))
            files.insert(name);
        else if (fs::is_empty(entry->path(), code))
            files.insert(name + "/");
    }
    if (code) return failed("cannot be read", code, folder);
    files.erase(kListName);
    return files;
}

// Nothing: no file, or one that cannot be read.
std::optional<std::uint32_t> sum_of(const fs::path& file) {
    if (is_link(file) || !fs::is_regular_file(fs::symlink_status(file))) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::uint8_t> part(std::size_t{1} << 16);
    std::uint32_t sum = 0;
    while (stream) {
        stream.read(reinterpret_cast<char*>(part.data()), static_cast<std::streamsize>(part.size()));
        sum = crc32({part.data(), static_cast<std::size_t>(stream.gcount())}, sum);
    }
    return stream.eof() ? std::optional(sum) : std::nullopt;
}

std::string sum_text(std::uint32_t sum) {
    char text[kSumLetters + 1];
    std::snprintf(text, sizeof text, "%08x", sum);
    return text;
}

// The files of a list by name, each with its sum; lists of older versions have names alone.
std::map<std::string, std::optional<std::uint32_t>> files_of_list(std::string_view list) {
    std::map<std::string, std::optional<std::uint32_t>> files;
    for (std::size_t begin = 0, end; begin < list.size(); begin = end + 1) {
        end = std::min(list.find('\n', begin), list.size());
        const std::string_view line = list.substr(begin, end - begin);
        std::uint32_t sum = 0;
        const std::size_t most = std::min(kSumLetters, line.size());
        const auto read = std::from_chars(line.data(), line.data() + most, sum, 16);
        if (line.size() > kSumLetters && line[kSumLetters] == ' ' && read.ptr == line.data() + most)
            files.emplace(line.substr(kSumLetters + 1), sum);
        else
            files.emplace(line, std::nullopt);
    }
    return files;
}

// Error: it is not all ours. folder: where it lies now; place: as people know it.
Result<void> check_ours(const fs::path& folder, const fs::path& place, const std::string& kind) {
    if (is_link(folder) || !fs::is_directory(fs::symlink_status(folder)))
        return Error{"is there and is no folder: it is not replaced", place.string()};
    TRY(const std::set<std::string> files, files_in(folder));
    std::error_code code;
    if (files.empty() && !fs::exists(folder / kListName, code)) return {};
    const Result<std::string> list = read_text_file(folder / kListName, kMostListBytes);
    const std::string head = kMaker + kind + "\n";
    if (!list.ok() || !list->starts_with(head))
        return Error{
            "is there and is no " + kind + " that Ghostlight made (which .ghostlight in it would tell)" +
                (files.empty() ? "" : ", with '" + *files.begin() + "' in it") + ": it is not replaced",
            place.string()};
    const auto made = files_of_list(std::string_view(*list).substr(head.size()));
    for (const std::string& file : files) {
        // A folder out of which somebody took our files is ours.
        const auto within = made.lower_bound(file);
        const bool is_folder = file.ends_with('/');
        if (within == made.end() ||
            !(within->first == file || (is_folder && within->first.starts_with(file))))
            return Error{"has '" + file +
                             "', which Ghostlight did not make: it is not replaced before that is elsewhere",
                         place.string()};
        if (!is_folder && within->second && sum_of(folder / file) != within->second)
            return Error{"has '" + file +
                             "', which somebody changed: it is not replaced before that is elsewhere",
                         place.string()};
    }
    return {};
}

} // namespace

Result<WholeFolder> WholeFolder::open(const fs::path& folder, const std::string& kind) {
    std::error_code code;
    fs::path place = fs::absolute(folder, code).lexically_normal();
    if (!place.has_filename()) place = place.parent_path(); // "book/"
    if (code || !place.has_filename()) return Error{"is no name for a folder", folder.string()};
    if (!fs::is_directory(place.parent_path(), code))
        return Error{"no such folder", place.parent_path().string()};
    if (fs::exists(fs::symlink_status(place, code))) TRY_VOID(check_ours(place, place, kind));
    remove_leftovers_of(place);
    fs::path temporary = temporary_beside(place);
    if (!fs::create_directory(temporary, code)) return failed("cannot be made", code, place);
    return WholeFolder(std::move(place), std::move(temporary), kind);
}

void WholeFolder::remove_leftovers(const fs::path& folder) {
    std::error_code code;
    const fs::path place = fs::absolute(folder, code).lexically_normal();
    if (!code) remove_leftovers_of(place.has_filename() ? place : place.parent_path());
}

WholeFolder::WholeFolder(WholeFolder&& other) noexcept
    : folder_(std::move(other.folder_)), temporary_(std::exchange(other.temporary_, {})),
      kind_(std::move(other.kind_)) {}

WholeFolder::~WholeFolder() {
    if (!temporary_.empty()) remove_whole(temporary_);
}

Result<void> WholeFolder::make_folder(const std::string& name) const {
    std::error_code code;
    fs::create_directories(temporary_ / name, code);
    if (code) return failed("cannot make '" + name + "' in it", code, folder_);
    return {};
}

Result<void> WholeFolder::commit() {
    std::string list = kMaker + kind_ + "\n";
    TRY(const std::set<std::string> files, files_in(temporary_));
    for (const std::string& file : files) {
        const std::optional<std::uint32_t> sum = file.ends_with('/') ? 0 : sum_of(temporary_ / file);
        if (!sum) return Error{"'" + file + "' in it cannot be read again", folder_.string()};
        list += sum_text(*sum) + " " + file + "\n";
    }
    TRY_VOID(write_file_atomic(temporary_ / kListName, list));
    std::error_code code;
    fs::path before;
    if (fs::exists(fs::symlink_status(folder_, code))) {
        TRY_VOID(check_ours(folder_, folder_, kind_)); // since open() somebody may have put something there
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
    // Looked at once more, for here nobody puts anything any more; and after both names have changed, so that
    // no end of this program leaves the place empty for long.
    if (const Result<void> ours = before.empty() ? Result<void>() : check_ours(before, folder_, kind_);
        !ours.ok()) {
        fs::rename(folder_, temporary_, code);
        fs::rename(before, folder_, code);
        return ours.error();
    }
    temporary_.clear();
    if (!before.empty()) remove_whole(before);
    return {};
}

} // namespace ghost
