// SPDX-License-Identifier: Apache-2.0
// The answer of a process that reads models, as somebody would write it who has taken that process over.
#include "stage/model_wire.h"

#include <cstdlib>
#include <cstring>

using namespace ghost;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::size_t at = 0;
    const auto received = scene::receive_model([&](std::span<std::uint8_t> bytes) {
        if (bytes.size() > size - at) return false;
        if (!bytes.empty()) std::memcpy(bytes.data(), data + at, bytes.size());
        at += bytes.size();
        return true;
    });
    if (!received.ok() || !received->model.ok()) return 0;
    const scene::Stage& stage = *received->model;
    for (const scene::Instance& instance : stage.instances)
        if (static_cast<std::size_t>(instance.mesh) >= stage.meshes.size()) std::abort();
    for (const scene::Mesh& mesh : stage.meshes) {
        if (static_cast<std::size_t>(mesh.material) >= stage.materials.size()) std::abort();
        if (mesh.normals.size() != mesh.positions.size()) std::abort();
        for (const std::uint32_t index : mesh.indices)
            if (index >= mesh.positions.size()) std::abort();
    }
    return 0;
}
