// SPDX-License-Identifier: Apache-2.0
#include "disk/own_program.h"

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace ghost {
namespace {

namespace fs = std::filesystem;

TEST(OwnProgram, is_the_launcher_in_a_bundle) {
    const TestFolder bundle;
    const fs::path program = bundle.path / "libexec/ghostlight", launcher = bundle.path / "bin/ghostlight";
    EXPECT_EQ(starter_of(program), program);
    fs::create_directories(launcher.parent_path());
    std::ofstream(launcher) << "#!/bin/sh\n";
    EXPECT_EQ(starter_of(program), launcher);
    // Beside a folder bin, but in no libexec: as a package and a build have it.
    EXPECT_EQ(starter_of(bundle.path / "build/ghostlight"), bundle.path / "build/ghostlight");
}

TEST(OwnProgram, is_there) {
    EXPECT_TRUE(fs::is_regular_file(own_program()));
}

} // namespace
} // namespace ghost
