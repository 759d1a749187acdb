// SPDX-License-Identifier: Apache-2.0
#include "image/colour.h"
#include "image/ldr.h"
#include "show/show.h"
#include "show_folder/place_checks.h"
#include "stage/model_reader.h"
#include "support/tiny_glb.h"

#include <cmath>
#include <limits>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

Stage load(const TinyGlb& glb, Report& report) {
    const fs::path path = written(scratch_folder("stage") / "tiny.glb", glb.bytes());
    auto stage = load_stage_file(path, report);
    EXPECT_TRUE(stage.ok()) << stage.error().text();
    return stage.ok() ? std::move(*stage) : Stage{};
}

std::string all_text(const Report& report) {
    std::string text;
    for (const Message& message : report.messages) text += message.where + ": " + message.what + "\n";
    return text;
}

void expect_near(const glm::vec3& value, const glm::vec3& expected) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], 1e-5f) << "component " << k;
}

TEST(StageFile, TwoInstancesOfOneMesh) {
    TinyGlb glb;
    glb.nodes = R"([{"name":"root","translation":[10,0,0],"children":[1,2]},{"name":"left","mesh":0},
                    {"name":"right","mesh":0,"translation":[0,2,3]}])";
    Report report;
    const Stage stage = load(glb, report);
    EXPECT_TRUE(report.messages.empty()) << all_text(report);
    ASSERT_EQ(stage.meshes.size(), 1u);
    ASSERT_EQ(stage.instances.size(), 2u);
    EXPECT_EQ(stage.stored_triangles(), 1u);
    EXPECT_EQ(stage.drawn_triangles(), 2u);
    EXPECT_EQ(stage.instances[0].name, "left");
    EXPECT_EQ(stage.instances[1].name, "right");
    EXPECT_EQ(stage.instances[1].fixture, kNone);
    // glTF (x, y, z), Y up -> ours (x, -z, y).
    expect_near(stage.instances[1].world * glm::vec4(0, 0, 0, 1), {10, -3, 2});
    expect_near(stage.instances[0].world * glm::vec4(stage.meshes[0].positions[2], 1), {10, 0, 1});
    expect_near(stage.instances[0].world * glm::vec4(stage.meshes[0].normals[0], 0), {0, -1, 0});
}

TEST(StageFile, MessagesNameTheObjectAndNotItsMesh) {
    Report report;
    TinyGlb glb;
    glb.nodes = R"([{"name":"root","children":[1,2]},{"name":"riser","mesh":0},{"name":"copy","mesh":0}])";
    glb.with_normals = false;
    glb.indices = {0, 1, 2, 0, 1, 1, 0, 1, 9};
    (void)load(glb, report);
    const std::string said = all_text(report);
    for (const char* part : {"object 'riser': 1 faces", "without normals get smooth ones: 'riser'",
                             "no area; those are not seen: 'riser'"})
        EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
}

TEST(StageFile, TextureCoordinatesAndTangents) {
    Report report;
    TinyGlb glb;
    glb.uvs = {0, 1, 1, 1, 0, 0.25f};
    const Stage stage = load(glb, report);
    const Mesh& mesh = stage.meshes.at(0);
    ASSERT_EQ(mesh.uvs.size(), 3u);
    EXPECT_FLOAT_EQ(mesh.uvs[2].y, 0.25f) << "v points down, as in the file";
    ASSERT_EQ(mesh.tangents.size(), 3u);
    expect_near(mesh.tangents[0], {1, 0, 0});
    // The picture's top is at v = 0, which is up (+y) here: so is the bitangent.
    expect_near(glm::cross(mesh.normals[0], glm::vec3(mesh.tangents[0])) * mesh.tangents[0].w, {0, 1, 0});
}

TEST(StageFile, MaterialInWorkingColour) {
    TinyGlb glb;
    glb.materials =
        R"([{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.5],"metallicFactor":0.25,
        "roughnessFactor":0.75},"alphaMode":"MASK","alphaCutoff":0.375,"doubleSided":true,"emissiveFactor":[0,1,0],
        "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":20},
                      "KHR_materials_specular":{"specularFactor":0.5}}}])";
    Report report;
    const Stage stage = load(glb, report);
    const Material& material = stage.materials.at(static_cast<std::size_t>(stage.meshes.at(0).material));
    EXPECT_EQ(material.name, "paint");
    expect_near(material.base_colour, {0.62740f, 0.06910f, 0.01639f}); // BT.2087
    EXPECT_FLOAT_EQ(material.alpha, 0.5f);
    EXPECT_FLOAT_EQ(material.metalness, 0.25f);
    EXPECT_FLOAT_EQ(material.roughness, 0.75f);
    EXPECT_FLOAT_EQ(material.specular, 0.5f);
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.375f);
    EXPECT_TRUE(material.double_sided);
    expect_near(material.emission, image::rec709_to_rec2020({0, 20, 0}));
}

TEST(StageFile, TexturesAreFoundHoweverTheirNameIsWritten) {
    const fs::path folder = scratch_folder("spellings");
    fs::create_directories(folder / "my pictures");
    const image::Image8 grey(2, 2, 4);
    ASSERT_TRUE(image::write_png(folder / "my pictures" / "red.png", grey).ok());
    for (const char* uri : {"my pictures/red.png", "my%20pictures/red.png", "my pictures\\\\red.png"}) {
        TinyGlb glb;
        glb.more = std::string(R"("images":[{"uri":")") + uri + R"("}],"textures":[{"source":0}],)";
        glb.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";
        Report report;
        const auto stage = load_stage_file(written(folder / "tiny.glb", glb.bytes()), report);
        ASSERT_TRUE(stage.ok()) << stage.error().text();
        EXPECT_EQ(stage->textures.size(), 1u) << uri << all_text(report);
    }
}

TEST(StageFile, PictureOfTwoTexturesIsStoredOnceAndAMissingOneIsNamed) {
    const fs::path folder = scratch_folder("textures");
    image::Image8 red(2, 2, 4);
    for (std::size_t k = 0; k < red.samples.size(); ++k) red.samples[k] = k % 4 == 0 || k % 4 == 3 ? 255 : 0;
    ASSERT_TRUE(image::write_png(folder / "red.png", red).ok());
    TinyGlb glb;
    glb.more =
        R"("images":[{"uri":"red.png"},{"uri":"poster.png"}],"textures":[{"source":0},{"source":0},{"source":1}],)";
    glb.materials = R"([{"name":"paint","pbrMetallicRoughness":{"baseColorTexture":{"index":0}},
        "emissiveTexture":{"index":1},"normalTexture":{"index":2,"scale":0.5}}])";
    Report report;
    const auto stage = load_stage_file(written(folder / "tiny.glb", glb.bytes()), report);
    ASSERT_TRUE(stage.ok()) << stage.error().text();
    ASSERT_EQ(stage->textures.size(), 1u) << all_text(report);
    EXPECT_EQ(stage->textures[0].pixels.samples, red.samples);
    EXPECT_TRUE(stage->textures[0].is_colour);
    const Material& material = stage->materials.at(static_cast<std::size_t>(stage->meshes.at(0).material));
    EXPECT_EQ(material.base_texture, 0);
    EXPECT_EQ(material.emission_texture, 0);
    EXPECT_EQ(material.normal_texture, kNone);
    EXPECT_FLOAT_EQ(material.normal_scale, 0.5f);
    ASSERT_EQ(report.messages.size(), 1u) << all_text(report);
    EXPECT_EQ(report.messages[0].severity, Severity::error);
    EXPECT_NE(report.messages[0].what.find("texture 'poster.png' is missing"), std::string::npos);
    EXPECT_NE(report.messages[0].what.find("no such file"), std::string::npos);
}

TEST(StageFile, AModelHasSoManyTexturesAndNoMore) {
    constexpr std::size_t kMost = 1024;
    const fs::path png = scratch_folder("many") / "grey.png";
    ASSERT_TRUE(image::write_png(png, image::Image8(2, 2, 4)).ok());
    // Materials that nothing has are not read.
    const std::vector<std::uint8_t> one = TinyGlb{}.bytes();
    const std::size_t json_bytes = std::size_t{one[12]} | std::size_t{one[13]} << 8;
    const std::string json(one.begin() + 20, one.begin() + static_cast<std::ptrdiff_t>(20 + json_bytes));
    const std::string face =
        R"({"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":)";
    const std::size_t begin = json.find(face + "0}");
    ASSERT_NE(begin, std::string::npos) << json;
    for (const std::size_t count : {kMost, kMost + 1}) {
        std::string images, textures, materials, faces;
        for (std::size_t k = 0; k < count; ++k) {
            const std::string comma = k == 0 ? "" : ",", number = std::to_string(k);
            images += comma + R"({"uri":"t)" + number + R"(.png"})";
            textures += comma + R"({"source":)" + number + "}";
            materials += comma + R"({"name":"m)" + number +
                         R"(","pbrMetallicRoughness":{"baseColorTexture":{"index":)" + number + "}}}";
            faces += comma + face + number + "}";
        }
        std::string text = json;
        text.replace(begin, face.size() + 2, faces);
        const std::string old_materials = R"("materials":[{"name":"paint"}],)";
        ASSERT_NE(text.find(old_materials), std::string::npos);
        text.replace(text.find(old_materials), old_materials.size(),
                     R"("images":[)" + images + R"(],"textures":[)" + textures + R"(],"materials":[)" +
                         materials + "],");
        const std::size_t binary_at = 20 + json_bytes + 8;
        const std::vector<std::uint8_t> glb =
            glb_of(text, {one.begin() + static_cast<std::ptrdiff_t>(binary_at), one.end()});
        Report report;
        const auto stage = load_model(glb, "glb", "many.glb", ModelSource::folder, report,
                                      [&](const std::string&) { return read_file(png, 1000); });
        ASSERT_TRUE(stage.ok()) << stage.error().text();
        EXPECT_EQ(stage->textures.size(), kMost);
        if (count == kMost) {
            EXPECT_TRUE(report.messages.empty()) << all_text(report);
        } else {
            EXPECT_EQ(all_text(report),
                      "many.glb: texture 't1024.png' is missing: more than 1024 textures\n");
        }
    }
}

TEST(StageFile, EveryTruncationIsAnError) {
    const auto bytes = TinyGlb{}.bytes();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        Report report;
        const auto stage =
            load_model(Bytes(bytes).first(length), "glb", "cut.glb", ModelSource::archive, report);
        ASSERT_FALSE(stage.ok()) << length << " of " << bytes.size();
        EXPECT_EQ(stage.error().where, "cut.glb");
        EXPECT_NE(stage.error().what.find("cut short"), std::string::npos) << stage.error().what;
    }
}

TEST(StageFile, EveryOneByteChangeLoadsOrFailsCleanly) {
    const auto bytes = TinyGlb{}.bytes();
    std::size_t loaded = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        auto changed = bytes;
        changed[k] ^= 0x15;
        Report report;
        const auto stage = load_model(changed, "glb", "flip.glb", ModelSource::archive, report);
        loaded += stage.ok();
        if (!stage.ok()) continue;
        for (const Mesh& mesh : stage->meshes) {
            ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
            for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
            for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-3f);
        }
    }
    EXPECT_GT(loaded, 0u);
}

TEST(StageFile, VertexThatIsNoNumberCostsItsFacesOnly) {
    TinyGlb glb;
    glb.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0};
    glb.uvs = {0, 0, 1, 0, 0, 1, 0, 0};
    glb.indices = {0, 1, 2, 0, 1, 3};
    Report report;
    const Stage stage = load(glb, report);
    EXPECT_EQ(stage.drawn_triangles(), 1u);
    ASSERT_EQ(report.messages.size(), 1u) << all_text(report);
    EXPECT_EQ(report.messages[0].severity, Severity::error);
    EXPECT_NE(report.messages[0].what.find("object 'left'"), std::string::npos) << all_text(report);
    for (const glm::vec3& position : stage.meshes[0].positions) EXPECT_TRUE(std::isfinite(position.x));
}

TEST(StageFile, IndexBeyondTheVerticesCostsItsFacesOnly) {
    TinyGlb glb;
    glb.indices = {0, 1, 2, 0, 1, 700};
    Report report;
    const Stage stage = load(glb, report);
    EXPECT_EQ(stage.drawn_triangles(), 1u);
    EXPECT_TRUE(report.lost_anything());
    EXPECT_NE(all_text(report).find("object 'left'"), std::string::npos);
}

TEST(StageFile, AbsentNormalsAreMade) {
    TinyGlb glb;
    glb.with_normals = false;
    Report report;
    const Stage stage = load(glb, report);
    ASSERT_EQ(stage.meshes.at(0).normals.size(), 3u);
    expect_near(stage.meshes[0].normals[1], {0, 0, 1});
    ASSERT_EQ(report.messages.size(), 1u) << all_text(report);
    EXPECT_EQ(report.messages[0].severity, Severity::note);
    EXPECT_NE(report.messages[0].what.find("'left'"), std::string::npos);
}

TEST(StageFile, ObjectWithoutVolumeIsNamed) {
    TinyGlb glb;
    glb.nodes = R"([{"name":"good","mesh":0},{"name":"squashed","mesh":0,"scale":[0,1,1]}])";
    glb.roots = "[0,1]";
    Report report;
    const Stage stage = load(glb, report);
    EXPECT_EQ(stage.instances.size(), 1u);
    EXPECT_NE(all_text(report).find("'squashed'"), std::string::npos);
}

TEST(StageFile, WrongFiles) {
    const fs::path folder = scratch_folder("wrong");
    Report report;
    EXPECT_NE(load_stage_file(folder / "absent.glb", report).error().what.find("no such file"),
              std::string::npos);
    EXPECT_FALSE(
        load_stage_file(written(folder / "rubbish.glb", "what is this? surely no stage"), report).ok());
    EXPECT_FALSE(load_stage_file(written(folder / "no_extension", "text"), report).ok());
    EXPECT_FALSE(load_stage_file(written(folder / "stage.docx", "text"), report).ok());
    TinyGlb empty;
    empty.nodes = R"([{"name":"nothing"}])";
    EXPECT_NE(
        load_stage_file(written(folder / "empty.glb", empty.bytes()), report).error().what.find("no object"),
        std::string::npos);
}

TEST(StageFile, DemoStageIsWhatTheIssueAsksFor) {
    Report report;
    const auto stage = load_stage_file("assets/demo/stage.glb", report);
    ASSERT_TRUE(stage.ok()) << stage.error().text();
    EXPECT_FALSE(report.lost_anything()) << all_text(report);
    EXPECT_GE(stage->drawn_triangles(), 150'000u);
    EXPECT_LT(stage->stored_triangles(), stage->drawn_triangles());
    EXPECT_GE(stage->materials.size(), 24u);
}

// An octahedron of many triangles has its bounding box's corner outside: for so many cameras there it is not
// asked again and again, which is said.
TEST(StageChecks, WhatIsNotLookedAtIsSaid) {
    constexpr std::size_t kTimes = 25'000;
    Stage stage;
    stage.materials.emplace_back();
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.normals = mesh.positions;
    for (std::size_t k = 0; k < kTimes; ++k)
        for (const std::uint32_t x : {0u, 1u})
            for (const std::uint32_t y : {2u, 3u})
                for (const std::uint32_t z : {4u, 5u}) mesh.indices.insert(mesh.indices.end(), {x, y, z});
    stage.meshes.push_back(mesh);
    mesh.indices.resize(24);
    stage.meshes.push_back(mesh);
    stage.instances = {{"dome", 0, glm::mat4(1.0f), kNone}, {"crate", 1, glm::mat4(1.0f), kNone}};
    const auto warnings = [&](std::size_t cameras, const glm::vec3& place_m) {
        std::vector<Camera> eyes(cameras);
        for (Camera& eye : eyes) eye.position_m = place_m;
        Report report;
        check_places(Show{}, stage, eyes, report);
        return all_text(report);
    };
    EXPECT_EQ(warnings(90, glm::vec3(0.9f)), "");
    EXPECT_NE(warnings(110, glm::vec3(0.9f)).find("was not looked at, they have too many triangles: 'dome'"),
              std::string::npos);
    // The small one is looked at first.
    const std::string inside = warnings(1, glm::vec3(0.1f));
    EXPECT_NE(inside.find("stands inside 'crate'"), std::string::npos) << inside;
}

} // namespace
} // namespace ghost::scene
