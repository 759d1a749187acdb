#pragma once
// SPDX-License-Identifier: Apache-2.0
// A folder of a show's own: .ghost, or one in it. A show may come from elsewhere, with links planted where we
// write and clean up. So such a folder is reached from the show's, step by step, and no step follows a link;
// what is in it counts only where it is a plain file or a folder. Errors name the step. Any thread.

#include "base/result.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace ghost {

class OwnFolder {
public:
    enum class Missing { is_error, is_made };
    // home: the show's folder, which is to be there and may itself be a link. folder: home, or one below it.
    static Result<OwnFolder> open(const std::filesystem::path& folder, const std::filesystem::path& home,
                                  Missing missing = Missing::is_error);
    Result<OwnFolder> below(const std::string& name) const;

    OwnFolder(OwnFolder&& other) noexcept;
    OwnFolder& operator=(OwnFolder&& other) noexcept;
    ~OwnFolder();

    struct File {
        std::string name;
        std::chrono::system_clock::time_point written;
    };
    struct Entries { // by name
        std::vector<File> files;
        std::vector<std::string> folders;
    };
    Entries entries() const;

    // Of a name of entries(); false: it stays.
    bool remove_file(const std::string& name) const;
    bool remove_empty_folder(const std::string& name) const;

private:
    OwnFolder(int handle, std::filesystem::path path) : handle_(handle), path_(std::move(path)) {}

    int handle_ = -1;
    std::filesystem::path path_; // for messages
};

} // namespace ghost
