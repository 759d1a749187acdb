// SPDX-License-Identifier: Apache-2.0
// [[model]]: models beside the stage stand where they are put, behind its objects, and one that is not there
// costs a sentence.
#include "show_file/show_edit.h"
#include "show_folder/load_show.h"
#include "show_folder/private/extra_models.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

struct Loaded {
    Show show;
    Report report;
};

Loaded loaded(const std::string& models) {
    Loaded made;
    const std::string text =
        "[show]\nname = \"Models\"\nstage = \"assets/optics/stage.glb\"\n[[camera]]\nname = "
        "\"a\"\nposition_m = [0, -5, 2]\ntarget_m = [0, 0, 2]\n" +
        models;
    const fs::path file = fs::current_path() / "show.toml"; // the tests run in the source folder
    auto show = load_show_text(file, text, true, made.report, {});
    EXPECT_TRUE(show.ok()) << (show.ok() ? "" : show.error().text());
    if (show.ok()) made.show = std::move(*show);
    return made;
}

std::string said(const Report& report) {
    std::string all;
    for (const Message& message : report.messages) all += message.where + ": " + message.what + "\n";
    return all;
}

TEST(Models, stand_beside_the_stage) {
    const Loaded alone = loaded(""), more = loaded("[[model]]\nfile = \"assets/optics/stage.glb\"\n"
                                                   "position_m = [1, 2, 3]\nscale = 2\n"
                                                   "[[model]]\nfile = \"assets/optics/stage.glb\"\n"
                                                   "rotation_deg = [0, 0, 90]\n");
    const std::vector<Instance>&before = alone.show.stage.instances, &now = more.show.stage.instances;
    ASSERT_FALSE(before.empty());
    ASSERT_EQ(now.size(), 3 * before.size()) << said(more.report);
    EXPECT_EQ(now[0].name, before[0].name) << "the stage's own stay the first";
    EXPECT_EQ(now[0].world, before[0].world);
    const glm::vec4 corner = before[0].world * glm::vec4(1, 1, 1, 1);
    const glm::vec4 put = now[before.size()].world * glm::vec4(1, 1, 1, 1);
    EXPECT_NEAR(glm::distance(put, glm::vec4(2.0f * glm::vec3(corner) + glm::vec3(1, 2, 3), 1)), 0, 1e-4);
    const glm::vec4 turned = now[2 * before.size()].world * glm::vec4(1, 1, 1, 1);
    EXPECT_NEAR(glm::distance(turned, glm::vec4(-corner.y, corner.x, corner.z, 1)), 0, 1e-4);
    EXPECT_LT(now.back().mesh, static_cast<int>(more.show.stage.meshes.size()));
    for (const Mesh& mesh : more.show.stage.meshes)
        EXPECT_LT(mesh.material, static_cast<int>(more.show.stage.materials.size()));
}

TEST(Models, that_cannot_be_read_are_said_and_left_out) {
    const Loaded made = loaded("[[model]]\nfile = \"assets/no/such.glb\"\n"
                               "[[model]]\nfile = \"README.md\"\n"
                               "[[model]]\nscale = 0\n");
    EXPECT_EQ(made.show.stage.instances.size(), loaded("").show.stage.instances.size());
    const std::string words = said(made.report);
    EXPECT_NE(words.find("show.toml:9: [[model]] file: no such file"), std::string::npos) << words;
    EXPECT_NE(words.find("README.md"), std::string::npos) << words;
    EXPECT_NE(words.find("the name of a model file"), std::string::npos) << words;
    EXPECT_NE(words.find("scale"), std::string::npos) << words;
}

TEST(Models, are_added_to_the_text) {
    const auto text = add_model("[show]\nstage = \"a.glb\"\n", "piano.glb", {1, 2.5, 0});
    ASSERT_TRUE(text.ok());
    EXPECT_NE(text->find("[[model]]\nfile = \"piano.glb\"\nposition_m = [1, 2.5, 0]\n"), std::string::npos)
        << *text;
}

} // namespace
} // namespace ghost::scene
