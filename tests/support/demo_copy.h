#pragma once
// SPDX-License-Identifier: Apache-2.0
// A copy of the demo show in a folder of its own that goes away, so that tests bake beside nobody else's
// passes. The large files are links. One per test binary.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace ghost::app {

class DemoCopy {
public:
    static const std::filesystem::path& show() {
        static const DemoCopy copy;
        return copy.show_;
    }

private:
    DemoCopy() {
        namespace fs = std::filesystem;
        folder_ = fs::temp_directory_path() / ("ghost_demo_" + std::to_string(::getpid()));
        show_ = folder_ / "demo";
        fs::create_directories(show_);
        const fs::path assets = fs::absolute("assets");
        fs::create_directory_symlink(assets / "fixtures", folder_ / "fixtures");
        fs::create_symlink(assets / "demo" / "stage.glb", show_ / "stage.glb");
        fs::create_symlink(assets / "demo" / "demo.show", show_ / "demo.show");
        fs::copy_file(assets / "demo" / "show.toml", show_ / "show.toml");
    }
    ~DemoCopy() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::filesystem::path folder_;
    std::filesystem::path show_;
};

} // namespace ghost::app
