#pragma once
// SPDX-License-Identifier: Apache-2.0
// For fuzzers of what is read from files: a folder of this process, in memory where the system has /dev/shm,
// and files in it. It goes at the end; after a crash it stays, with what was read last.

#include "base/byte_reader.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace ghost {

inline const std::filesystem::path& fuzz_folder() {
    namespace fs = std::filesystem;
    static const struct Folder {
        fs::path path;
        Folder() {
            const fs::path memory = "/dev/shm";
            std::string name =
                ((fs::exists(memory) ? memory : fs::temp_directory_path()) / "ghost_fuzz_XXXXXX").string();
            if (mkdtemp(name.data()) == nullptr) std::abort();
            path = name;
        }
        ~Folder() {
            std::error_code ignored;
            fs::remove_all(path, ignored);
        }
    } folder;
    return folder.path;
}

inline std::filesystem::path fuzz_file(const std::string& name, Bytes bytes) {
    const std::filesystem::path path = fuzz_folder() / name;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) std::abort();
    return path;
}

} // namespace ghost
