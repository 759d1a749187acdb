// SPDX-License-Identifier: Apache-2.0
#include "gpu/private/shader_folder.h"

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace ghost::gpu {
namespace {

using namespace std::chrono_literals;

TEST(ShaderFolder, a_file_that_is_written_anew_is_said_once) {
    const TestFolder folder;
    const std::filesystem::path file = folder.path / "one.spv";
    std::ofstream(file) << "no shader";
    ShaderFolder shaders(folder.path);
    const std::vector<std::uint32_t> words{1, 2, 3};
    const Shader built_in{"one", words};
    EXPECT_EQ(shaders.current(built_in).words.data(), words.data()) << "what is no SPIR-V is left alone";
    const auto start = std::chrono::steady_clock::now();
    EXPECT_FALSE(shaders.has_changed(start));
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + 1s);
    EXPECT_FALSE(shaders.has_changed(start + 500ms)) << "it looks once a second";
    EXPECT_TRUE(shaders.has_changed(start + 2s));
    EXPECT_FALSE(shaders.has_changed(start + 4s));
    std::filesystem::remove(file);
    EXPECT_TRUE(shaders.has_changed(start + 6s));
    EXPECT_FALSE(shaders.has_changed(start + 8s));
}

} // namespace
} // namespace ghost::gpu
