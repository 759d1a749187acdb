#pragma once
// SPDX-License-Identifier: Apache-2.0
// Compute shaders in words (SPIR-V 1.5), "main" with groups of one that does nothing: alone, and with one
// variable that is bound.

#include "gpu/shader.h"

#include <cstdint>
#include <vector>

namespace ghost::gpu {

struct BoundVariable {
    std::uint32_t storage = 2; // its storage class: 0 uniform constant, 2 uniform, 12 storage buffer
    std::uint32_t image = 0;   // 0: a struct; 1: an image with a sampler; 2: one without
    bool in_array = false;
    std::uint32_t set = 0;
    std::uint32_t number = 0;
};

inline const std::vector<std::uint32_t>& nothing_module() {
    static const std::vector<std::uint32_t> words{
        0x07230203, 0x00010500, 0, 5, 0,       // SPIR-V 1.5, five ids
        0x00020011, 1, 0x0003000e, 0, 1,       // OpCapability Shader, OpMemoryModel Logical
                                               // GLSL450
        0x0005000f, 5, 3, 0x6e69616d, 0,       // OpEntryPoint GLCompute %3 "main"
        0x00060010, 3, 17, 1, 1, 1,            // OpExecutionMode %3 LocalSize 1 1 1
        0x00020013, 1, 0x00030021, 2, 1,       // %1 void, %2 void()
        0x00050036, 1, 3, 0, 2, 0x000200f8, 4, // %3 OpFunction, %4 OpLabel
        0x000100fd, 0x00010038,                // OpReturn, OpFunctionEnd
    };
    return words;
}
inline const Shader kNothing{"nothing", nothing_module()};

// Kept for the whole test.
inline std::span<const std::uint32_t> binding_module(const BoundVariable& bound) {
    static std::vector<std::vector<std::uint32_t>> kept;
    std::vector<std::uint32_t> words{0x07230203, 0x00010500, 0, 14, 0};
    const auto add = [&](std::initializer_list<std::uint32_t> more) {
        std::vector<std::uint32_t> part(more);
        part[0] |= static_cast<std::uint32_t>(part.size()) << 16; // length and operation
        words.insert(words.end(), part.begin(), part.end());
    };
    add({17, 1});                       // OpCapability Shader
    add({14, 0, 1});                    // OpMemoryModel Logical GLSL450
    add({15, 5, 3, 0x6e69616d, 0, 10}); // OpEntryPoint GLCompute %3 "main" %10
    add({16, 3, 17, 1, 1, 1});          // OpExecutionMode %3 LocalSize 1 1 1
    if (bound.image == 0) {
        add({71, 7, 2});        // OpDecorate %7 Block
        add({72, 7, 0, 35, 0}); // OpMemberDecorate %7 0 Offset 0
    }
    add({71, 10, 34, bound.set});    // OpDecorate %10 DescriptorSet
    add({71, 10, 33, bound.number}); // OpDecorate %10 Binding
    add({19, 1});                    // %1 void
    add({33, 2, 1});                 // %2 void()
    add({22, 5, 32});                // %5 float
    std::uint32_t type = 7;
    if (bound.image == 0) add({30, 7, 5});                                                     // %7 struct
    if (bound.image > 0) add({25, 7, 5, 1, 0, 0, 0, bound.image, bound.image == 2 ? 3u : 0u}); // %7 image 2D
    if (bound.image == 1) {
        add({27, 8, 7}); // %8 with a sampler
        type = 8;
    }
    if (bound.in_array) {
        add({21, 11, 32, 0});    // %11 uint
        add({43, 11, 12, 2});    // %12 = 2
        add({28, 13, type, 12}); // %13 array of two
        type = 13;
    }
    add({32, 9, bound.storage, type}); // %9 pointer
    add({59, 9, 10, bound.storage});   // %10 the variable
    add({54, 1, 3, 0, 2});             // %3 function
    add({248, 4});
    add({253});
    add({56});
    return kept.emplace_back(std::move(words));
}

} // namespace ghost::gpu
