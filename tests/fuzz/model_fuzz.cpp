// SPDX-License-Identifier: Apache-2.0
// load_model on anything, as 3DS and as GLB: what fixtures and plots bring along. Seeds: any model of these
// kinds.
#include "scene/model_file.h"

#include <cmath>
#include <cstdlib>

using namespace ghost;

// Assimp 5.2 forgets the meshes that it had begun when it gives up on a 3DS file: less than the file is long.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libassimp";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const char* const format = size >= 4 && data[0] == 'g' && data[1] == 'l' ? "glb" : "3ds";
    scene::Report report;
    const auto stage =
        scene::load_model(Bytes(data, size), format, "fuzz", {}, report, [](const std::string& name) {
            return Result<std::vector<std::uint8_t>>(Error{"is not there", name});
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
            if (!std::isfinite(position.x + position.y + position.z)) std::abort();
    }
    return 0;
}
