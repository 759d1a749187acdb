// SPDX-License-Identifier: Apache-2.0
// glTF that asks for far more than it holds is refused before anything is made of it.
#include "stage/model_reader.h"
#include "support/tiny_glb.h"

#include <algorithm>

namespace ghost::scene {
namespace {

std::string fault_of(const std::string& json) {
    const auto checked = check_gltf_size(json, "a.glb");
    return checked.ok() ? "" : checked.error().text();
}

bool says(const std::string& fault, const std::string& words) {
    return fault.find(words) != std::string::npos;
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t k = 0; k < times; ++k) result += text;
    return result;
}

// Nodes of which each holds the next.
std::string chain(std::size_t nodes) {
    std::string json = R"({"scenes":[{"nodes":[0]}],"nodes":[)";
    for (std::size_t k = 1; k < nodes; ++k) json += R"({"children":[)" + std::to_string(k) + "]},";
    return json + "{}]}";
}

TEST(GltfSize, lists_in_each_other) {
    EXPECT_EQ(fault_of(repeated("[", 128) + repeated("]", 128)), "");
    EXPECT_TRUE(says(fault_of(repeated("[", 129)), "a.glb: has lists and objects more than 128 deep"));
    EXPECT_EQ(fault_of("{\"a\":\"" + repeated("[", 1000) + "\\\"{\"}"), "") << "within a string";
    // As a whole file: Assimp's reader of JSON would leave the stack.
    Report report;
    const auto model =
        load_model(glb_of(repeated("[", 5'000'000), {}), "glb", "deep.glb", ModelSource::archive, report);
    ASSERT_FALSE(model.ok());
    EXPECT_TRUE(says(model.error().text(), "deep.glb: has lists"));
}

TEST(GltfSize, more_things_than_a_model_has) {
    EXPECT_EQ(fault_of("[0" + repeated(",0", (4u << 20) - 1) + "]"), "");
    EXPECT_TRUE(says(fault_of("[0" + repeated(",0", 4u << 20) + "]"), "lists more than 4194304 things"));
}

TEST(GltfSize, nodes_in_each_other_in_circles_and_doubled) {
    EXPECT_EQ(fault_of(chain(256)), "");
    EXPECT_TRUE(says(fault_of(chain(257)), "more than 256 in each other"));
    Report report;
    EXPECT_FALSE(
        load_model(glb_of(chain(100'000), {}), "glb", "deep.glb", ModelSource::archive, report).ok());
    EXPECT_TRUE(says(fault_of(R"({"nodes":[{"children":[1]},{"children":[0]}]})"), "hold themselves"));
    std::string doubled = R"({"scenes":[{"nodes":[0]}],"nodes":[)";
    for (int k = 1; k <= 18; ++k)
        doubled += R"({"children":[)" + std::to_string(k) + "," + std::to_string(k) + "]},";
    EXPECT_TRUE(says(fault_of(doubled + "{}]}"), "a scene of more than 200000 nodes")) << "2^19 - 1 nodes";
    EXPECT_EQ(fault_of(R"({"scenes":[{"nodes":[7,-1,"a"]}],"nodes":[{"children":[9]},3]})"), "")
        << "the reader's business";
}

TEST(GltfSize, vertices_count_as_often_as_they_are_used) {
    const auto model = [](const std::string& primitives, std::size_t count) {
        return R"({"meshes":[{"primitives":[)" + primitives + R"(]}],"accessors":[{"count":)" +
               std::to_string(count) + R"(}]})";
    };
    const std::string mesh = R"({"attributes":{"POSITION":0}})"; // 16 bytes a vertex, 16 a corner
    EXPECT_EQ(fault_of(model(mesh, 1u << 25)), "");
    EXPECT_TRUE(says(fault_of(model(mesh, (1u << 25) + 32768)), "unpacks to 1025 MiB"));
    EXPECT_TRUE(says(fault_of(model(mesh + repeated("," + mesh, 9), 1u << 22)), "unpacks to 1280 MiB"));
    EXPECT_TRUE(says(fault_of(model(mesh, 18446744073709551615u)), "at most 1024 are allowed"));
    const std::string keys =
        R"({"animations":[{"samplers":[{"input":0,"output":0}]}],"accessors":[{"count":20000000}]})";
    EXPECT_TRUE(says(fault_of(keys), "unpacks to 1220 MiB"));
}

// Assimp makes each face of these from the one before, which is not there where an index was wrong.
TEST(GltfFaces, lines_and_fans_with_wrong_indices_are_left_out) {
    for (const char* mode : {R"("mode":2,)", R"("mode":3,)", R"("mode":6,)", R"("mode":2,"mode":4,)",
                             R"("m\u006fde":2,"mode":4,)"}) {
        SCOPED_TRACE(mode);
        TinyGlb tiny;
        tiny.indices = {9, 0, 1, 9, 2, 0};
        std::vector<std::uint8_t> bytes = tiny.bytes();
        std::string json(json_of_glb(bytes));
        json.insert(json.find(R"("attributes")"), mode);
        bytes = glb_with_json(bytes, json);
        Report report;
        const auto model = load_model(bytes, "glb", "lines.glb", ModelSource::archive, report);
        if (model.ok()) {
            for (const Mesh& mesh : model->meshes) EXPECT_TRUE(mesh.indices.size() % 3 == 0);
        }
        const bool fan = std::string(mode) == R"("mode":6,)";
        const bool said =
            std::any_of(report.messages.begin(), report.messages.end(),
                        [](const Message& message) { return says(message.what, "fans of triangles"); });
        EXPECT_EQ(said, fan);
    }
}

TEST(GltfFaces, what_is_safe_stays_as_it_is) {
    std::size_t lost = 0;
    const auto same = [&](const std::string& json) {
        const auto safe = without_unsafe_faces(json, "a.glb", lost);
        return safe.ok() && safe->empty() && lost == 0;
    };
    EXPECT_TRUE(same(std::string(json_of_glb(TinyGlb().bytes()))));
    EXPECT_TRUE(same(
        R"({"accessors":[{"count":4}],"meshes":[{"primitives":[{"mode":6,"attributes":{"POSITION":0}}]}]})"));
    EXPECT_FALSE(same(
        R"({"accessors":[{"count":2}],"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0}}]}]})"));
    EXPECT_EQ(lost, 1u);
    EXPECT_FALSE(without_unsafe_faces("{", "a.glb", lost).ok());
}

TEST(GltfSize, sparse_values_that_are_not_there) {
    const auto fault = [](const char* count, const char* view_bytes, const char* of = "3") {
        return fault_of(
            std::string(R"({"buffers":[{"byteLength":100}],"bufferViews":[{"buffer":0,"byteLength":)") +
            view_bytes + R"(}],"accessors":[{"count":)" + of +
            R"(,"componentType":5126,"type":"VEC3","sparse":{"count":)" + count +
            R"(,"indices":{"bufferView":0,"componentType":5123},"values":{"bufferView":0}}}]})");
    };
    EXPECT_EQ(fault("3", "36"), "");
    EXPECT_TRUE(says(fault("3", "35"), "accessor 0 has sparse values")) << "36 bytes of values";
    EXPECT_TRUE(says(fault("4", "100"), "accessor 0 has sparse values")) << "more than the accessor has";
    EXPECT_TRUE(says(fault("400000000", "100", "400000000"), "accessor 0 has sparse values"));
    EXPECT_TRUE(says(fault("3", "101"), "accessor 0 has sparse values")) << "a view beyond its buffer";
}

TEST(GltfFaces, a_strip_that_loses_triangles_is_said) {
    TinyGlb tiny;
    tiny.indices = {0, 1, 2, 9};
    std::vector<std::uint8_t> bytes = tiny.bytes();
    std::string json(json_of_glb(bytes));
    json.insert(json.find(R"("attributes")"), R"("mode":5,)");
    Report report;
    const auto model =
        load_model(glb_with_json(bytes, json), "glb", "strip.glb", ModelSource::archive, report);
    ASSERT_TRUE(model.ok()) << model.error().text();
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_TRUE(says(report.messages[0].what, "1 faces have vertices that do not exist"));
}

} // namespace
} // namespace ghost::scene
