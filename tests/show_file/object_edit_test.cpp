// SPDX-License-Identifier: Apache-2.0
// An object of the stage that a show moves: an entry of its own, changed where there is one, the rest of the
// text byte for byte.
#include "show_file/object_edit.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

std::string moved(const std::string& text, const std::string& name, const glm::vec3& by_m) {
    const auto done = set_object_move(text, name, by_m);
    EXPECT_TRUE(done.ok()) << done.error().text();
    return done.ok() ? *done : "";
}

TEST(ObjectEdit, one_is_added_then_changed) {
    const std::string text = "# mine\n[show]\nstage = \"a.glb\" # here\n";
    const std::string once = moved(text, "riser", {0.5f, -1, 0});
    EXPECT_EQ(once, text + "\n[[object]]\nname = \"riser\"\nmove_m = [0.5, -1, 0]\n");
    const std::string twice = moved(once, "riser", {2, 0, 0});
    EXPECT_EQ(twice, text + "\n[[object]]\nname = \"riser\"\nmove_m = [2, 0, 0]\n");
}

TEST(ObjectEdit, an_entry_of_its_own_keeps_its_other_keys_and_a_later_pattern_is_not_overlooked) {
    const std::string own = "[[object]]\nname = \"riser\"\nshown = true # yes\n";
    EXPECT_EQ(moved(own, "riser", {1, 0, 0}),
              "[[object]]\nname = \"riser\"\nshown = true # yes\nmove_m = [1, 0, 0]\n");
    const std::string wins = own + "\n[[object]]\nname = \"ris*\"\nmove_m = [0, 3, 0]\n";
    EXPECT_EQ(moved(wins, "riser", {1, 3, 0}), wins + "\n[[object]]\nname = \"riser\"\nmove_m = [1, 3, 0]\n");
}

TEST(ObjectEdit, what_is_no_toml_is_an_error) {
    EXPECT_FALSE(set_object_move("[show\n", "riser", {1, 0, 0}).ok());
}

} // namespace
} // namespace ghost::scene
