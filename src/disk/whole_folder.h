#pragma once
// SPDX-License-Identifier: Apache-2.0
// WholeFolder: a folder of files that is put into its place whole, or not at all: it is written beside it
// under a temporary name. What stands in its place is replaced only where it is empty or we made all of it,
// and nobody changed it since, which is looked at in the beginning and in the end: a list in it,
// ".ghostlight", tells its kind, its files and their sums. What killed programs left of theirs is removed.
// Errors name the folder. One thread at a time.

#include "base/result.h"

#include <filesystem>
#include <string>

namespace ghost {

class WholeFolder {
public:
    // kind: "cue book". Error: something else stands there, or one of that kind with work of somebody else,
    // or the folder around it is not there or cannot be written.
    static Result<WholeFolder> open(const std::filesystem::path& folder, const std::string& kind);

    // What programs that were killed left beside it.
    static void remove_leftovers(const std::filesystem::path& folder);

    WholeFolder(WholeFolder&& other) noexcept;
    WholeFolder& operator=(WholeFolder&&) = delete;
    ~WholeFolder(); // what was not committed goes

    const std::filesystem::path& written_to() const { return temporary_; }
    Result<void> make_folder(const std::string& name) const; // below written_to()
    // Error: since open() something of somebody else came there; it stays.
    Result<void> commit();

private:
    WholeFolder(std::filesystem::path folder, std::filesystem::path temporary, std::string kind)
        : folder_(std::move(folder)), temporary_(std::move(temporary)), kind_(std::move(kind)) {}

    std::filesystem::path folder_;
    std::filesystem::path temporary_; // empty: it is in its place
    std::string kind_;
};

} // namespace ghost
