// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"
#include "light/bodies.h"
#include "shared/attenuation.h"
#include "show/show.h"
#include "show_folder/load_show.h"
#include "stage/overrides.h"
#include "support/tiny_glb.h"

#include <cmath>
#include <limits>

namespace ghost::scene {
namespace {

TEST(Matches, StarsAndQuestionMarks) {
    EXPECT_TRUE(matches("drum_kit", "drum_kit"));
    EXPECT_FALSE(matches("drum_kit", "drum_kit2"));
    EXPECT_FALSE(matches("drum_kit", "Drum_kit")) << "capitals count";
    EXPECT_TRUE(matches("drum*", "drum"));
    EXPECT_TRUE(matches("drum*", "drum_kit"));
    EXPECT_FALSE(matches("drum*", "a_drum"));
    EXPECT_TRUE(matches("*kit", "drum_kit_kit"));
    EXPECT_TRUE(matches("*a*b*", "xxaxxbxx"));
    EXPECT_FALSE(matches("*a*b*", "xxbxxaxx"));
    EXPECT_TRUE(matches("deck_?_?", "deck_0_4"));
    EXPECT_FALSE(matches("deck_?", "deck_"));
    EXPECT_FALSE(matches("deck_?", "deck_10"));
    EXPECT_TRUE(matches("B?hne", "B\xc3\xbchne")) << "one letter, two bytes";
    EXPECT_TRUE(matches("*hne", "B\xc3\xbchne"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("", ""));
    EXPECT_FALSE(matches("", "x"));
    EXPECT_FALSE(matches("?", ""));
}

// Each of ten entries would take seconds by itself, and a show may have a thousand, for a hundred times as
// many objects.
TEST(Overrides, PatternsThatNearlyMatchManyNamesHaveAnEndWhichIsSaid) {
    Stage stage;
    stage.materials.resize(1);
    stage.meshes.resize(1);
    stage.meshes[0].material = 0;
    for (int k = 0; k < 200; ++k)
        stage.instances.push_back({.name = std::string(4090, 'a') + std::to_string(k), .mesh = 0});
    std::vector<ObjectSettings> objects(10);
    for (std::size_t k = 0; k < objects.size(); ++k) {
        objects[k].name = "*" + std::string(998, 'a') + "b";
        objects[k].where = "show.toml:" + std::to_string(k + 1);
    }
    objects[0].name = "*aa7";
    objects[0].shown = false;
    Report report;
    apply_objects(stage, objects, report);
    EXPECT_FALSE(stage.instances[7].shown);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_EQ(report.messages[0].where, "show.toml:2");
    EXPECT_EQ(report.messages[0].severity, Severity::error);
    EXPECT_NE(report.messages[0].what.find("[[object]] has more patterns with * and ? than"),
              std::string::npos)
        << report.messages[0].what;
}

TEST(Matches, ManyStarsTakeNoTime) {
    const std::string name(1000, 'a');
    std::string pattern;
    for (int k = 0; k < 200; ++k) pattern += "*a";
    EXPECT_TRUE(matches(pattern, name));
    EXPECT_FALSE(matches(pattern + "b", name));
}

TEST(Shininess, KnownAnswers) {
    EXPECT_NEAR(roughness_from_shininess(0), 1.0f, 1e-6f);
    EXPECT_NEAR(roughness_from_shininess(30), 0.5f, 1e-6f); // alpha = sqrt(2 / 32) = 1 / 4
    EXPECT_NEAR(roughness_from_shininess(510), 0.25f, 1e-6f);
}

// Two drums and a stool share the mesh "shell" with the paint "red"; the wall has a mesh of its own, but the
// same paint; the floor is "wood".
Stage small_stage() {
    Stage stage;
    for (const char* name : {"red", "wood"}) {
        Material material;
        material.name = name;
        material.base_colour = {0.4f, 0.2f, 0.1f};
        material.base_texture = 7;
        stage.materials.push_back(material);
    }
    for (const auto& [name, material] : {std::pair{"shell", 0}, {"board", 0}, {"slab", 1}}) {
        Mesh mesh;
        mesh.name = name;
        mesh.positions.resize(3);
        mesh.normals.resize(3, {0, 0, 1});
        mesh.indices = {0, 1, 2};
        mesh.material = material;
        stage.meshes.push_back(mesh);
    }
    for (const auto& [name, mesh] :
         {std::pair{"Drum 1", 0}, {"Drum 2", 0}, {"Stool", 0}, {"Wall", 1}, {"Floor", 2}}) {
        Instance instance;
        instance.name = name;
        instance.mesh = mesh;
        instance.world[3] = {1, 2, 3, 1};
        stage.instances.push_back(instance);
    }
    return stage;
}

ObjectSettings named(const std::string& name) {
    ObjectSettings settings;
    settings.name = name;
    settings.where = "show.toml:7";
    return settings;
}

const Mesh& mesh_of(const Stage& stage, std::size_t instance) {
    return stage.meshes.at(static_cast<std::size_t>(stage.instances.at(instance).mesh));
}

const Material& material_of(const Stage& stage, std::size_t instance) {
    return stage.materials.at(static_cast<std::size_t>(mesh_of(stage, instance).material));
}

Stage applied(const std::vector<ObjectSettings>& objects) {
    Stage stage = small_stage();
    Report report;
    apply_objects(stage, objects, report);
    for (const Message& message : report.messages) ADD_FAILURE() << message.what;
    return stage;
}

TEST(Overrides, SharedMeshesAndMaterialsAreCopied) {
    ObjectSettings drums = named("Drum*");
    drums.diffuse = {0, 0, 1};
    drums.specular = 0.5f;
    drums.roughness = 0.25f;
    drums.metalness = 0.75f;
    const Stage stage = applied({drums});
    for (const std::size_t k : {0u, 1u}) {
        EXPECT_EQ(material_of(stage, k).base_colour, glm::vec3(0, 0, 1));
        EXPECT_EQ(material_of(stage, k).specular, 0.5f);
        EXPECT_EQ(material_of(stage, k).roughness, 0.25f);
        EXPECT_EQ(material_of(stage, k).metalness, 0.75f);
        EXPECT_EQ(material_of(stage, k).name, "red");
        EXPECT_EQ(material_of(stage, k).base_texture, 7) << "its picture stays";
    }
    for (const std::size_t k : {2u, 3u, 4u}) {
        EXPECT_EQ(material_of(stage, k).base_colour, glm::vec3(0.4f, 0.2f, 0.1f)) << k;
        EXPECT_EQ(material_of(stage, k).roughness, 1.0f) << k;
    }
    EXPECT_EQ(stage.instances[0].mesh, stage.instances[1].mesh) << "both share one copy";
    EXPECT_EQ(stage.meshes.size(), 4u);
    EXPECT_EQ(stage.materials.size(), 3u);
    EXPECT_EQ(mesh_of(stage, 0).positions.size(), 3u);
    EXPECT_EQ(mesh_of(stage, 0).name, "shell");
}

TEST(Overrides, WhatNobodyElseUsesChangesInPlace) {
    ObjectSettings floor = named("Floor");
    floor.diffuse = {1, 1, 1};
    const Stage stage = applied({floor});
    EXPECT_EQ(stage.meshes.size(), 3u);
    EXPECT_EQ(stage.materials.size(), 2u);
    EXPECT_EQ(material_of(stage, 4).base_colour, glm::vec3(1));
}

TEST(Overrides, AMeshOfItsOwnWithASharedMaterial) {
    ObjectSettings wall = named("Wall");
    wall.roughness = 0.1f;
    const Stage stage = applied({wall});
    EXPECT_EQ(stage.meshes.size(), 3u) << "only the material is copied";
    EXPECT_EQ(stage.materials.size(), 3u);
    EXPECT_EQ(material_of(stage, 3).roughness, 0.1f);
    EXPECT_EQ(material_of(stage, 0).roughness, 1.0f);
}

TEST(Overrides, ObjectsBeforeMeshesBeforeMaterials) {
    ObjectSettings mesh = named("shell");
    mesh.roughness = 0.3f;
    Stage stage = applied({mesh});
    EXPECT_EQ(material_of(stage, 2).roughness, 0.3f);
    EXPECT_EQ(material_of(stage, 3).roughness, 1.0f);

    ObjectSettings material = named("red");
    material.roughness = 0.3f;
    stage = applied({material});
    for (const std::size_t k : {0u, 1u, 2u, 3u}) EXPECT_EQ(material_of(stage, k).roughness, 0.3f) << k;
    EXPECT_EQ(material_of(stage, 4).roughness, 1.0f);
    EXPECT_EQ(stage.materials.size(), 2u) << "all of its users change: in place";

    // "*o*" are Stool and Floor, although a mesh (board) and a material (wood) have an o as well.
    ObjectSettings both = named("*o*");
    both.roughness = 0.3f;
    stage = applied({both});
    EXPECT_EQ(material_of(stage, 2).roughness, 0.3f);
    EXPECT_EQ(material_of(stage, 3).roughness, 1.0f);
    EXPECT_EQ(material_of(stage, 4).roughness, 0.3f);
}

TEST(Overrides, LaterEntriesWinKeyByKey) {
    ObjectSettings all = named("*");
    all.diffuse = {1, 0, 0};
    all.roughness = 0.5f;
    all.shown = false;
    all.move_m = {1, 0, 0};
    ObjectSettings drum = named("Drum 2");
    drum.diffuse_factor = 0.5f;
    drum.shown = true;
    drum.move_m = {0, 0, -1};
    const Stage stage = applied({all, drum});
    EXPECT_EQ(material_of(stage, 0).base_colour, glm::vec3(1, 0, 0));
    EXPECT_EQ(material_of(stage, 1).base_colour, glm::vec3(0.2f, 0.1f, 0.05f)) << "half of the model's";
    EXPECT_EQ(material_of(stage, 1).roughness, 0.5f);
    EXPECT_FALSE(stage.instances[0].shown);
    EXPECT_TRUE(stage.instances[1].shown);
    EXPECT_EQ(glm::vec3(stage.instances[0].world[3]), glm::vec3(2, 2, 3));
    EXPECT_EQ(glm::vec3(stage.instances[1].world[3]), glm::vec3(1, 2, 2));
    EXPECT_EQ(stage.instances[0].world[3].w, 1.0f);
}

TEST(Overrides, NoSurfaceGivesBackMoreThanItGets) {
    ObjectSettings floor = named("Floor");
    floor.diffuse_factor = 4;
    EXPECT_EQ(material_of(applied({floor}), 4).base_colour, glm::vec3(1, 0.8f, 0.4f));
}

TEST(Overrides, NamesOfNothing) {
    const auto message = [](const std::string& name) {
        Stage stage = small_stage();
        Report report;
        ObjectSettings settings = named(name);
        settings.roughness = 0;
        settings.shown = false;
        apply_objects(stage, {settings}, report);
        for (const Instance& instance : stage.instances) EXPECT_TRUE(instance.shown);
        EXPECT_EQ(stage.materials.size(), 2u);
        EXPECT_EQ(report.messages.size(), 1u);
        if (report.messages.empty()) return std::string();
        EXPECT_EQ(report.messages[0].severity, Severity::warning);
        EXPECT_EQ(report.messages[0].where, "show.toml:7");
        return report.messages[0].what;
    };
    EXPECT_NE(message("Stol").find("'Stol' is that of no object, mesh or material of the stage, did you mean "
                                   "'Stool'?"),
              std::string::npos)
        << message("Stol");
    EXPECT_NE(message("drum*").find("did you mean 'Drum 1'? (capitals count)"), std::string::npos);
    EXPECT_NE(message("Flor*").find("did you mean 'Floor'?"), std::string::npos);
    EXPECT_NE(message("dru").find("did you mean 'Drum 1'?"), std::string::npos) << "a part of the name";
    EXPECT_EQ(message("qqqqqqqqq").find("did you mean"), std::string::npos);
}

TEST(Overrides, BrokenStagesAreLeftAlone) {
    Stage stage = small_stage();
    stage.instances[0].mesh = 99;
    stage.instances[1].mesh = kNone;
    stage.meshes[1].material = 99;
    ObjectSettings all = named("*");
    all.roughness = 0.5f;
    Report report;
    apply_objects(stage, {all}, report);
    EXPECT_EQ(material_of(stage, 2).roughness, 0.5f);
    EXPECT_EQ(stage.instances[0].mesh, 99);
}

TEST(Overrides, HiddenObjectsAreDroppedOrKept) {
    Show show;
    show.stage = small_stage();
    ObjectSettings drums = named("Drum*");
    drums.shown = false;
    show.objects = {drums};
    Report report;
    const Stage drawn = stage_with_bodies(show, report);
    ASSERT_EQ(drawn.instances.size(), 3u);
    EXPECT_EQ(drawn.instances[0].name, "Stool");
    EXPECT_EQ(drawn.drawn_triangles(), 3u);
    const Stage all = stage_with_bodies(show, report, HiddenObjects::kept);
    ASSERT_EQ(all.instances.size(), 5u);
    EXPECT_FALSE(all.instances[1].shown);
    EXPECT_TRUE(all.instances[2].shown);
    EXPECT_TRUE(show.stage.instances[0].shown) << "the model itself stays";
    EXPECT_TRUE(report.messages.empty());
    show.stage = {};
    EXPECT_TRUE(stage_with_bodies(show, report).instances.empty());
    EXPECT_TRUE(report.messages.empty()) << "a stage that could not be read is not reported twice";
}

TEST(Overrides, FromTheFile) {
    const auto folder = scratch_folder("objects");
    TinyGlb glb;
    glb.nodes = R"([{"name":"left","mesh":0},{"name":"right","mesh":0,"translation":[0,2,3]}])";
    glb.roots = "[0,1]";
    written(folder / "tiny.glb", glb.bytes());
    written(folder / "show.toml", std::string_view(R"([show]
name = "x"
stage = "tiny.glb"
[[camera]]
name = "house"
position_m = [0, -10, 2]
target_m = [0, 0, 2]
[[object]]
name = "left"
diffuse = "#ffffff"
shininess = 30
[[object]]
name = "rigt"
shown = false
)"));
    Report report;
    const auto show = load_show(folder, true, report);
    ASSERT_TRUE(show.ok());
    EXPECT_TRUE(report.messages.empty());
    const Stage stage = stage_with_bodies(*show, report);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_TRUE(report.messages[0].where.ends_with("show.toml:13")) << report.messages[0].where;
    EXPECT_NE(report.messages[0].what.find("did you mean 'right'?"), std::string::npos);
    ASSERT_EQ(stage.instances.size(), 2u);
    const std::size_t left = stage.instances[0].name == "left" ? 0 : 1;
    EXPECT_NEAR(material_of(stage, left).roughness, 0.5f, 1e-6f);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(material_of(stage, left).base_colour[k], 1.0f, 1e-3f);
    EXPECT_EQ(material_of(stage, 1 - left).roughness, 1.0f);
}

TEST(AttenuationFactor, InverseSquareIsExactlyOne) {
    const shared::Attenuation physical{0, 0, 1};
    for (const float d : {0.0f, 1e-30f, 1e-3f, 0.1f, 1.0f / 3.0f, 7.3f, 123.4f, 1e4f, 1e30f})
        EXPECT_EQ(shared::attenuation_factor(physical, d), 1.0f) << d;
}

TEST(AttenuationFactor, KnownAnswers) {
    // d^2 / (c + l d + q d^2)
    EXPECT_NEAR(shared::attenuation_factor({1, 2, 3}, 2.0f), 4.0f / 17.0f, 1e-6f);
    EXPECT_NEAR(shared::attenuation_factor({0, 0.5f, 0}, 10.0f), 20.0f, 1e-4f);
    EXPECT_NEAR(shared::attenuation_factor({4, 0, 0}, 6.0f), 9.0f, 1e-5f);
    // Near the light a constant part takes the inverse square back: the product stays finite.
    EXPECT_NEAR(shared::attenuation_factor({1, 0, 0}, 0.01f) / (0.01f * 0.01f), 1.0f, 1e-5f);
}

TEST(AttenuationFactor, IsAlwaysFinite) {
    for (const shared::Attenuation& a :
         {shared::Attenuation{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1000, 1000, 1000}, {0, 1e-30f, 0}})
        for (const float d : {0.0f, 1e-30f, 1.0f, 1e4f, std::numeric_limits<float>::max()}) {
            const float factor = shared::attenuation_factor(a, d);
            EXPECT_TRUE(std::isfinite(factor)) << d;
            EXPECT_GE(factor, 0.0f);
            EXPECT_LE(factor, shared::kAttenuationMost * 1.0001f);
        }
    EXPECT_NEAR(shared::attenuation_factor({0, 0, 0}, 5.0f), shared::kAttenuationMost, 1.0f);
}

} // namespace
} // namespace ghost::scene
