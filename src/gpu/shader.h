#pragma once
// SPDX-License-Identifier: Apache-2.0
// Shader: the words of a compiled shader (SPIR-V 1.6) with its name, as the build makes them of shaders/, and
// what it binds, read from the words: nobody has to say it again. Values only, any thread.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <vulkan/vulkan.h>

namespace ghost::gpu {

struct Shader {
    std::string_view name;
    std::span<const std::uint32_t> words;
};

// What stands at a number that a shader leaves out.
inline constexpr VkDescriptorType kNoBinding = VK_DESCRIPTOR_TYPE_MAX_ENUM;

// Types of the bindings 0, 1, .. of set 0. A shader that binds anything else (another set, an array, a kind
// that gpu/commands.h has no word for) is a bug of ours and ends the program with the shader's name.
std::vector<VkDescriptorType> bindings_of(const Shader& shader);

} // namespace ghost::gpu
