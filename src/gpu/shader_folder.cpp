// SPDX-License-Identifier: Apache-2.0
#include "gpu/private/shader_folder.h"

#include "base/log.h"
#include "disk/files.h"

#include <cstring>
#include <utility>

namespace ghost::gpu {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr std::uint32_t kMagic = 0x07230203; // of SPIR-V
constexpr std::chrono::seconds kLookEvery{1};

std::filesystem::file_time_type time_of(const std::filesystem::path& file) {
    std::error_code code;
    const auto time = std::filesystem::last_write_time(file, code);
    return code ? std::filesystem::file_time_type{} : time;
}

} // namespace

Shader ShaderFolder::current(const Shader& built_in) {
    const std::filesystem::path file = folder_ / (std::string(built_in.name) + ".spv");
    times_[std::string(built_in.name)] = time_of(file);
    const auto keep = [&](const std::string& why) {
        log_warning(file.string() + ": " + why + "; the shader that was built in is used");
        return built_in;
    };
    const auto bytes = read_file(file, kMostBytes);
    if (!bytes.ok()) return keep(bytes.error().what);
    std::vector<std::uint32_t> words(bytes->size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes->data(), words.size() * sizeof(std::uint32_t));
    if (words.empty() || words[0] != kMagic || bytes->size() % sizeof(std::uint32_t) != 0)
        return keep("is no SPIR-V");
    const Shader read{built_in.name, words_.emplace_back(std::move(words))};
    if (bindings_of(read) != bindings_of(built_in)) return keep("binds something else");
    return read;
}

bool ShaderFolder::has_changed(std::chrono::steady_clock::time_point now) {
    if (now - looked_ < kLookEvery) return false;
    looked_ = now;
    bool changed = false;
    for (auto& [name, time] : times_) {
        const auto newest = time_of(folder_ / (name + ".spv"));
        changed |= newest != std::exchange(time, newest);
    }
    return changed;
}

} // namespace ghost::gpu
