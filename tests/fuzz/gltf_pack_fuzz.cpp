// SPDX-License-Identifier: Apache-2.0
// A .gltf of an archive with its buffers, made one .glb: what comes out is whole.
#include "stage/gltf_pack.h"
#include "stage/model_file.h"

#include <cstdlib>

using namespace ghost;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto glb = scene::glb_from_gltf(Bytes(data, size), "fuzz",
                                          [&](const std::string& name) -> Result<std::vector<std::uint8_t>> {
                                              if (name.size() % 2 == 0) return Error{"is not there", name};
                                              return std::vector<std::uint8_t>(data, data + size);
                                          });
    if (!glb.ok()) return 0;
    if (!scene::check_glb(*glb, "made").ok() || scene::json_of_glb(*glb).empty()) std::abort();
    std::size_t lost = 0;
    (void)scene::check_gltf_size(scene::json_of_glb(*glb), "made");
    (void)scene::without_unsafe_faces(scene::json_of_glb(*glb), "made", lost);
    (void)scene::gltf_extras(*glb);
    std::vector<std::uint8_t> repaired;
    if (scene::replace_non_numbers(*glb, repaired) > 0 && !scene::check_glb(repaired, "repaired").ok())
        std::abort();
    return 0;
}
