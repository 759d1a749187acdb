// SPDX-License-Identifier: Apache-2.0
// read_model on anything, as GLB, glTF, OBJ and 3DS: what fixtures, plots and shows bring along.
#include "stage/model_file.h"

#include <cstdlib>
#include <string_view>

using namespace ghost;

// Assimp 5.2 forgets the meshes that it had begun when it gives up on a 3DS file: less than the file is long.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libassimp";
}

static const char* format_of(std::string_view bytes) {
    if (bytes.starts_with("gl")) return "glb";
    if (bytes.starts_with("{")) return "gltf";
    return bytes.starts_with("MM") ? "3ds" : "obj";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Report report;
    int asked = 0;
    const auto stage = scene::read_model(
        Bytes(data, size), format_of({reinterpret_cast<const char*>(data), size}), "fuzz.obj", report,
        [&](const std::string& name) -> Result<std::vector<std::uint8_t>> {
            // Every other file that it refers to is there, and is as odd as the model.
            if (++asked % 2 == 0) return Error{"is not there", name};
            return std::vector<std::uint8_t>(data, data + size);
        });
    if (!stage.ok()) return 0;
    for (const scene::Instance& instance : stage->instances)
        if (instance.mesh < 0 || static_cast<std::size_t>(instance.mesh) >= stage->meshes.size())
            std::abort();
    for (const scene::Mesh& mesh : stage->meshes) {
        if (mesh.normals.size() != mesh.positions.size()) std::abort();
        if (mesh.material < 0 || static_cast<std::size_t>(mesh.material) >= stage->materials.size())
            std::abort();
        for (const std::uint32_t index : mesh.indices)
            if (index >= mesh.positions.size()) std::abort();
        for (const glm::vec3& position : mesh.positions)
            if (0.0f * position != glm::vec3(0.0f)) std::abort();
    }
    return 0;
}
