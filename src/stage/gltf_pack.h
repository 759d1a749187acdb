#pragma once
// SPDX-License-Identifier: Apache-2.0
// A .gltf and the buffers that it names, as one .glb: plots hold their meshes in an archive, where a loader
// finds no files. Pictures stay where they are. Pure.

#include "base/byte_reader.h"
#include "base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ghost::scene {

// read: the bytes of a file beside the .gltf. name is for messages. All buffers together have at most 512
// MiB.
Result<std::vector<std::uint8_t>>
glb_from_gltf(Bytes gltf, const std::string& name,
              const std::function<Result<std::vector<std::uint8_t>>(const std::string& file)>& read);

} // namespace ghost::scene
