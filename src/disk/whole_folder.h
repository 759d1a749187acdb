#pragma once
// SPDX-License-Identifier: Apache-2.0
// WholeFolder: a folder of files that is put into its place whole, or not at all: it is written beside it
// under a temporary name. What stands in its place is replaced only where we made it, which a file in it
// tells. What killed programs left of theirs is removed. Errors name the folder. One thread at a time.

#include "base/result.h"

#include <filesystem>
#include <string>

namespace ghost {

class WholeFolder {
public:
    // marker: name of a file that every such folder has. Error: something else stands there, or the folder
    // around it is not there or cannot be written.
    static Result<WholeFolder> open(const std::filesystem::path& folder, const std::string& marker);

    WholeFolder(WholeFolder&& other) noexcept;
    WholeFolder& operator=(WholeFolder&&) = delete;
    ~WholeFolder(); // what was not committed goes

    const std::filesystem::path& written_to() const { return temporary_; }
    Result<void> make_folder(const std::string& name) const; // below written_to()
    Result<void> commit();

private:
    WholeFolder(std::filesystem::path folder, std::filesystem::path temporary)
        : folder_(std::move(folder)), temporary_(std::move(temporary)) {}

    std::filesystem::path folder_;
    std::filesystem::path temporary_; // empty: it is in its place
};

} // namespace ghost
