#pragma once
// SPDX-License-Identifier: Apache-2.0
// ShaderFolder: shaders from files instead of those that were built in, for whoever writes them while a
// picture runs: NAME.spv, as a build leaves them in generated/shaders. One that is missing, no SPIR-V, or
// binds something else than the one built in stays as that, with a warning. Main thread.

#include "gpu/shader.h"

#include <chrono>
#include <filesystem>
#include <list>
#include <map>
#include <string>
#include <vector>

namespace ghost::gpu {

class ShaderFolder {
public:
    explicit ShaderFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // The words live as long as this.
    Shader current(const Shader& built_in);
    // One that was asked for was written since, or since the last call that said so. Looks at the disk once a
    // second at most.
    bool has_changed(std::chrono::steady_clock::time_point now);

private:
    std::filesystem::path folder_;
    std::map<std::string, std::filesystem::file_time_type> times_; // of those that were asked for
    std::list<std::vector<std::uint32_t>> words_;
    std::chrono::steady_clock::time_point looked_{};
};

} // namespace ghost::gpu
