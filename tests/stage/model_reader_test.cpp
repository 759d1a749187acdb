// SPDX-License-Identifier: Apache-2.0
// The process apart that reads models: what it may do, what a fault in it costs, and which files it is given.
// What it does for models of certain names stands in tests/reader_main.cpp.
#include "support/plot_files.h"

#include "stage/model_reader.h"
#include "stage/model_wire.h"

#include <cstring>
#include <thread>

namespace ghost::scene {
namespace {

Result<Stage> read_tiny(const std::string& name, Report& report) {
    return load_model(TinyGlb{}.bytes(), "glb", name, ModelSource::archive, report);
}

std::string reading_fault(const std::string& name) {
    Report report;
    const auto model = read_tiny(name, report);
    return model.ok() ? "" : model.error().text();
}

void expect_readable() {
    Report report;
    const auto model = read_tiny("good.glb", report);
    ASSERT_TRUE(model.ok()) << model.error().text();
    EXPECT_EQ(model->drawn_triangles(), 1u);
}

TEST(ModelReader, ACrashCostsThatOneModelAndIsSaid) {
    expect_readable();
    const std::string fault = reading_fault("a.mvr: crashes.glb");
    EXPECT_NE(fault.find("a.mvr: crashes.glb: the process that read it ended"), std::string::npos) << fault;
    EXPECT_NE(fault.find("given up"), std::string::npos) << fault;
    expect_readable();
}

TEST(ModelReader, OneThatTakesTooLongIsGivenUp) {
    const std::string fault = reading_fault("a.mvr: spins.glb");
    EXPECT_NE(fault.find("more than 10 s of the processor"), std::string::npos) << fault;
    expect_readable();
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ModelReader, ItsMemoryHasAnEnd) {
    const std::string fault = reading_fault("a.mvr: is-hungry.glb");
    EXPECT_NE(fault.find("out of memory after "), std::string::npos) << fault;
    EXPECT_EQ(fault.find("out of memory after 8"), std::string::npos) << fault;
    expect_readable();
}

TEST(ModelReader, MayOpenReachAndStartNothing) {
    EXPECT_EQ(reading_fault("a.mvr: tries.glb"),
              "open refused; socket refused; unlink refused; fork refused; exec refused; ");
}
#endif

TEST(ModelReader, AModelAsksForSoManyOtherFilesAndNoMore) {
    constexpr int kMost = 4096;
    for (const int count : {kMost, kMost + 1}) {
        std::string text;
        for (int k = 0; k < count; ++k) text += "mtllib m" + std::to_string(k) + ".mtl\n";
        text += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        const std::string paint = "newmtl paint\nKd 1 1 1\n";
        int asked = 0;
        Report report;
        const auto model = load_model(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()),
                                      "obj", "many.obj", ModelSource::folder, report,
                                      [&](const std::string&) -> Result<std::vector<std::uint8_t>> {
                                          ++asked;
                                          return std::vector<std::uint8_t>(paint.begin(), paint.end());
                                      });
        EXPECT_EQ(asked, count);
        if (count == kMost) {
            ASSERT_TRUE(model.ok()) << model.error().text();
            EXPECT_EQ(model->drawn_triangles(), 1u);
        } else {
            ASSERT_FALSE(model.ok());
            EXPECT_NE(
                model.error().text().find("many.obj: the process that read it asked for more than 4096"),
                std::string::npos)
                << model.error().text();
        }
    }
    expect_readable();
}

TEST(ModelReader, AnAnswerIsTheSameAsReadHere) {
    const std::vector<std::uint8_t> bytes = *read_file("assets/demo/stage.glb", 512u << 20);
    Report here_report, there_report;
    const auto none = [](const std::string& name) -> Result<std::vector<std::uint8_t>> {
        return Error{"is not there", name};
    };
    const auto here = read_model(bytes, "glb", "stage.glb", here_report, none);
    const auto there = load_model(bytes, "glb", "stage.glb", ModelSource::archive, there_report);
    ASSERT_TRUE(here.ok() && there.ok());
    const auto sent = [](const Result<Stage>& stage, const Report& report) {
        std::vector<std::uint8_t> all;
        send_model(
            [&](Bytes piece) {
                all.insert(all.end(), piece.begin(), piece.end());
                return true;
            },
            stage, report);
        return all;
    };
    EXPECT_EQ(sent(here, here_report), sent(there, there_report));
    EXPECT_GT(sent(there, there_report).size(), 1'000'000u);
}

TEST(ModelReader, ManyThreadsReadAtOnce) {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([t] {
            for (int k = 0; k < 5; ++k)
                if (t == 0)
                    EXPECT_NE(reading_fault("crashes.glb"), "");
                else
                    expect_readable();
        });
}

// A list of one and a list of 300,000 corners: Assimp 5.2.5 writes beyond its memory.
std::string deadly_ply() {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                       "property float z\nelement face 2\nproperty list uint int vertex_indices\nend_header\n"
                       "0 0 0\n1 0 0\n0 1 0\n1 0\n300000";
    for (int k = 0; k < 300'000; ++k) text += " 0";
    return text + "\n";
}

std::string said_of_mesh(const std::string& file, const std::string& content) {
    const fs::path folder = scratch("kinds");
    write_mvr(
        folder / "plot.mvr",
        small_xml(object_xml(1, "Bad", kIdentity + "{0,0,0}", "<Geometry3D fileName=\"" + file + "\"/>") +
                  object_xml(2, "Sail", kIdentity + "{0,0,0}", "<Geometry3D fileName=\"Sail.glb\"/>")),
        {{file, content}});
    Report report;
    const Show show = opened(folder / "plot.mvr", report);
    EXPECT_EQ(show.stage.instances.size(), 1u) << "the other mesh is there";
    return messages_of(report);
}

TEST(ModelReader, AnArchiveMayHoldThreeKindsOnly) {
    const std::string said = said_of_mesh("bad.ply", deadly_ply());
    EXPECT_NE(said.find("is a model of the kind .ply, expected .glb, .gltf or .3ds in an archive"),
              std::string::npos)
        << said;
    for (const std::string kind : {"obj", "fbx", "dae", "stl", "blend", "x"}) {
        const std::string other = said_of_mesh("bad." + kind, "v 0 0 0");
        EXPECT_NE(other.find("is a model of the kind ." + kind + ","), std::string::npos) << other;
    }
}

// Assimp looks through all its loaders where a file is not what its name says.
TEST(ModelReader, WhatAFileSaysItIsDoesNotChooseTheLoader) {
    const std::string said = said_of_mesh("bad.3ds", deadly_ply());
    EXPECT_NE(said.find("no 3DS file"), std::string::npos) << said;
    TinyGlb glb;
    std::vector<std::uint8_t> bytes = glb.bytes();
    const std::string version = "\"version\":\"2.0\"";
    const auto at = std::search(bytes.begin(), bytes.end(), version.begin(), version.end());
    ASSERT_NE(at, bytes.end());
    at[11] = '1';
    Report report;
    const auto model = load_model(bytes, "glb", "old.glb", ModelSource::archive, report);
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.error().text().find("not a readable glb model"), std::string::npos)
        << model.error().text();
}

constexpr std::string_view kBinChunk("BIN\0", 4);

// Assimp looks for buffers by itself.
TEST(ModelReader, ABufferOfAnArchiveIsNotTakenFromTheWorkingDirectory) {
    const fs::path folder = scratch("buffers");
    const fs::path before = fs::current_path();
    std::vector<std::uint8_t> bytes = TinyGlb{}.bytes();
    std::string json(json_of_glb(bytes));
    for (std::size_t at = 0; (at = json.find("\"buffer\":0", at)) != std::string::npos;) json[at + 9] = '1';
    const std::size_t end = json.find("}],\"bufferViews\"");
    ASSERT_NE(end, std::string::npos);
    fs::current_path(folder);
    const auto binary = std::search(bytes.begin(), bytes.end(), kBinChunk.begin(), kBinChunk.end());
    ASSERT_NE(binary, bytes.end());
    const std::string buffer(binary + kBinChunk.size(), bytes.end()); // which the model could be made of
    std::ofstream("beside.bin", std::ios::binary) << buffer;
    json.insert(end + 1, ",{\"uri\":\"beside.bin\",\"byteLength\":" + std::to_string(buffer.size()) + "}");
    Report report;
    const auto model =
        load_model(glb_with_json(bytes, json), "glb", "plot.mvr: a.glb", ModelSource::archive, report);
    fs::current_path(before);
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.error().text().find("beside.bin"), std::string::npos) << model.error().text();
}

TEST(ModelReader, WhatAStageRefersToLiesInTheShowsFolder) {
    const fs::path folder = scratch("home");
    fs::create_directories(folder / "show" / "models");
    fs::create_directories(folder / "show" / "paint");
    const std::string red = "newmtl red\nKd 1 0 0\n";
    std::ofstream(folder / "show" / "paint" / "own.mtl") << red;
    std::ofstream(folder / "outside.mtl") << red;
    fs::create_symlink("../../outside.mtl", folder / "show" / "models" / "link.mtl");
    const auto materials = [&](const std::string& library) {
        const fs::path path = folder / "show" / "models" / "wall.obj";
        std::ofstream(path) << "mtllib " << library << "\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        Report report;
        const auto stage = load_stage_file(path, folder / "show", report);
        if (!stage.ok()) return std::pair(false, stage.error().text());
        const glm::vec3 colour =
            stage->materials[static_cast<std::size_t>(stage->meshes.front().material)].base_colour;
        return std::pair(colour.x > 0.5f && colour.y < 0.2f, messages_of(report));
    };
    EXPECT_TRUE(materials("../paint/own.mtl").first);
    for (const std::string library : {"../../outside.mtl", "link.mtl", "../paint/../../outside.mtl"}) {
        const auto [is_red, said] = materials(library);
        EXPECT_FALSE(is_red) << library;
        EXPECT_NE(said.find("refers to " + library), std::string::npos) << said;
    }
    EXPECT_FALSE(materials(fs::absolute(folder / "outside.mtl").string()).first);
}

// By itself Assimp writes to nowhere, and gives up an .obj whose material has an anisotropy.
TEST(ModelReader, MaterialsOfAnObjAreReadAsTheyAreWritten) {
    const fs::path folder = scratch("mtl");
    const fs::path path = folder / "wall.obj";
    std::ofstream(path) << "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string red = "newmtl red\nKd 1 0 0\n";
    for (const std::string& text :
         {red, "a 1\n" + red, "# whose\n  map_Kd b.png\n" + red, "bump b.png\r\n" + red, "Pr 0.5\n" + red,
          red + "aniso 0.5\nanisor 0\n"}) {
        std::ofstream(folder / "a.mtl") << text;
        Report report;
        const auto stage = load_stage_file(path, report);
        ASSERT_TRUE(stage.ok()) << text << stage.error().text();
        const glm::vec3 colour =
            stage->materials[static_cast<std::size_t>(stage->meshes.front().material)].base_colour;
        EXPECT_TRUE(colour.x > 0.5f && colour.y < 0.2f) << text;
    }
}

// The other end may be in the hands of who wrote the file.
TEST(ModelWire, WhatComesBackIsLookedAt) {
    Stage stage;
    stage.materials.emplace_back();
    stage.meshes.push_back(
        {"m", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {}, {}, {0, 1, 2}, 0});
    stage.instances.push_back({"i", 0, glm::mat4(1.0f), kNone});
    const auto answer = [](const Stage& sent, std::size_t cut = 0, std::size_t flip = 0) {
        std::vector<std::uint8_t> all;
        send_model(
            [&](Bytes piece) {
                all.insert(all.end(), piece.begin(), piece.end());
                return true;
            },
            sent, Report{});
        if (cut > 0) all.resize(std::min(cut, all.size()));
        if (flip > 0) all[flip % all.size()] ^= 0x80;
        std::size_t at = 0;
        const auto received = receive_model([&](std::span<std::uint8_t> bytes) {
            if (bytes.size() > all.size() - at) return false;
            if (!bytes.empty()) std::memcpy(bytes.data(), all.data() + at, bytes.size());
            at += bytes.size();
            return true;
        });
        return std::pair(received.ok(), all.size());
    };
    const auto [good, size] = answer(stage);
    EXPECT_TRUE(good);
    for (std::size_t cut = 1; cut < size; ++cut) EXPECT_FALSE(answer(stage, cut).first) << cut;
    for (std::size_t flip = 1; flip < size; ++flip) answer(stage, 0, flip); // no more than an error
    Stage wrong = stage;
    wrong.meshes[0].indices[1] = 3;
    EXPECT_FALSE(answer(wrong).first);
    wrong = stage;
    wrong.instances[0].mesh = 1;
    EXPECT_FALSE(answer(wrong).first);
    wrong = stage;
    wrong.meshes[0].material = -1;
    EXPECT_FALSE(answer(wrong).first);
    wrong = stage;
    wrong.materials[0].normal_texture = 0;
    EXPECT_FALSE(answer(wrong).first);
    wrong = stage;
    wrong.meshes[0].normals.pop_back();
    EXPECT_FALSE(answer(wrong).first);
    wrong = stage;
    wrong.meshes[0].positions[0].x = NAN;
    EXPECT_FALSE(answer(wrong).first);
}

std::size_t most_address_space_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmPeak:")) return std::stoull(line.substr(7)) << 10;
    return 0;
}

// A number alone asks for nothing: no 7 GiB for a texture of which nothing comes.
TEST(ModelWire, LengthsAreBelievedAsFarAsBytesCome) {
    const std::size_t before = most_address_space_bytes();
    ASSERT_GT(before, 0u);
    std::vector<std::uint8_t> answer;
    const auto put = [&](std::uint64_t number, std::size_t bytes) {
        for (std::size_t k = 0; k < bytes; ++k)
            answer.push_back(static_cast<std::uint8_t>(number >> (8 * k)));
    };
    put(1, 8); // a model
    put(1, 8); // one texture
    put(0, 8); // without a name
    for (const int side : {9, 9, 4, 1}) put(static_cast<std::uint64_t>(side), 4);
    put(std::uint64_t{7} << 30, 8); // bytes of pixels
    std::size_t at = 0;
    const auto received = receive_model([&](std::span<std::uint8_t> bytes) {
        if (bytes.size() > answer.size() - at) return false;
        if (!bytes.empty()) std::memcpy(bytes.data(), answer.data() + at, bytes.size());
        at += bytes.size();
        return true;
    });
    ASSERT_FALSE(received.ok());
    EXPECT_EQ(at, answer.size()) << received.error().text();
    EXPECT_LT(most_address_space_bytes() - before, std::size_t{1} << 30);
}

} // namespace
} // namespace ghost::scene
