#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hand-made shows in a folder of their own that goes away.

#include "bake/bake_show.h"
#include "fixture/type.h"
#include "support/test_folder.h"
#include "support/test_stage.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <memory>
#include <string>

namespace ghost::bake {

using ghost::TestFolder;

inline void add_fixture(scene::Show& show, const std::string& name, const glm::vec3& position_m) {
    static const auto type = [] {
        auto made = std::make_shared<fixture::Type>();
        made->modes.emplace_back();
        return made;
    }();
    scene::PatchedFixture fixture;
    fixture.name = name;
    fixture.type = type;
    fixture.position_m = position_m;
    show.fixtures.push_back(std::move(fixture));
}

// Bytes of every file below.
inline std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
    std::map<std::string, std::string> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        result[std::filesystem::relative(entry.path(), folder).string()] =
            std::string(std::istreambuf_iterator<char>(file), {});
    }
    return result;
}

} // namespace ghost::bake
