// SPDX-License-Identifier: Apache-2.0
// What shaders bind, read from their words.
#include "gpu/shader.h"
#include "support/made_shader.h"

#include <gtest/gtest.h>

namespace ghost::gpu {
namespace {

std::vector<VkDescriptorType> of(const BoundVariable& bound) {
    return bindings_of({"made", binding_module(bound)});
}

TEST(Shader, EachKindOfBinding) {
    using Types = std::vector<VkDescriptorType>;
    EXPECT_EQ(bindings_of(kNothing), Types{});
    EXPECT_EQ(of({.storage = 2}), Types{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER});
    EXPECT_EQ(of({.storage = 12}), Types{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER});
    EXPECT_EQ(of({.storage = 0, .image = 1}), Types{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER});
    EXPECT_EQ(of({.storage = 0, .image = 2}), Types{VK_DESCRIPTOR_TYPE_STORAGE_IMAGE});
    EXPECT_EQ(of({.storage = 12, .number = 2}),
              (Types{kNoBinding, kNoBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}));
}

TEST(ShaderDeathTest, WhatWeHaveNoWordForIsNamed) {
    EXPECT_DEATH((void)of({.set = 1, .number = 3}), "shader made: binding 3 is not of set 0");
    EXPECT_DEATH((void)of({.storage = 0, .image = 1, .in_array = true}), "shader made: binding 0: expected");
    EXPECT_DEATH((void)of({.storage = 9}), "shader made: binding 0: expected");
    const std::vector<std::uint32_t> cut(nothing_module().begin(), nothing_module().end() - 1);
    EXPECT_EQ(bindings_of({"cut", cut}).size(), 0u) << "an instruction less is none of our business";
    std::vector<std::uint32_t> torn = nothing_module();
    torn.back() = 5u << 16;
    EXPECT_DEATH((void)bindings_of({"torn", torn}), "shader torn: its words end in the middle");
}

} // namespace
} // namespace ghost::gpu
