// SPDX-License-Identifier: Apache-2.0
// looks.toml from anybody: never a crash, whatever is kept is within its limits, and written again it says
// the same.
#include "base/check.h"
#include "show/looks.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ghost::Report report;
    const auto looks = ghost::scene::parse_looks(std::string(reinterpret_cast<const char*>(data), size),
                                                 "fuzz/looks.toml", report);
    if (!looks.ok()) return 0;
    CHECK(looks->size() <= ghost::scene::kMostLooks);
    for (const auto& look : *looks) {
        CHECK(ghost::scene::check_stored_name("look", look.name).ok());
        CHECK(look.fade_s >= 0 && look.fade_s <= ghost::scene::kLongestFade_s);
        for (const auto& [name, programmer] : look.fixtures) {
            CHECK(!programmer.is_empty());
            CHECK(!programmer.intensity || (*programmer.intensity >= 0 && *programmer.intensity <= 1));
        }
    }
    ghost::Report again;
    const auto read = ghost::scene::parse_looks(ghost::scene::text_of(*looks), "fuzz/again.toml", again);
    CHECK(read.ok());
    CHECK_EQ(read->size(), looks->size());
    return 0;
}
