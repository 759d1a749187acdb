// SPDX-License-Identifier: Apache-2.0
#include "gpu/private/shader_constants.h"
#include "support/made_shader.h"

#include <gtest/gtest.h>

namespace ghost::gpu {
namespace {

using Words = std::vector<std::uint32_t>;

// Instructions: operation and operands.
Words module_of(const std::vector<Words>& instructions) {
    Words words{0x07230203, 0x00010600, 0, 20, 0};
    for (const Words& instruction : instructions) {
        words.push_back(static_cast<std::uint32_t>(instruction.size()) << 16 | instruction[0]);
        words.insert(words.end(), instruction.begin() + 1, instruction.end());
    }
    return words;
}

// Constants 0: a number, 5; 1: true; 2: false; and what is worked out of them: the number less itself,
// whether it is 9, one of two numbers, a pair, and a sum, for which we have no word, with a pair of it.
Words constants_module() {
    return module_of({
        {71, 10, 1, 0}, // OpDecorate %10 SpecId 0
        {71, 11, 1, 1},
        {71, 12, 1, 2},
        {71, 9, 33, 1},               // OpDecorate %9 Binding 1
        {20, 3},                      // %3 bool
        {43, 2, 19, 9},               // OpConstant %19 9
        {50, 2, 10, 5},               // OpSpecConstant %10 5
        {48, 3, 11},                  // OpSpecConstantTrue %11
        {49, 3, 12},                  // OpSpecConstantFalse %12
        {52, 2, 13, 130, 10, 10},     // OpSpecConstantOp %13 ISub
        {52, 3, 14, 170, 10, 19},     // IEqual
        {52, 2, 15, 169, 11, 10, 19}, // Select
        {51, 4, 16, 10, 15},          // OpSpecConstantComposite
        {52, 2, 17, 128, 10, 10},     // IAdd
        {51, 4, 18, 10, 17},
    });
}

Words plain_module(std::uint32_t number, bool first, bool second) {
    const auto truth = [](bool value) { return value ? 41u : 42u; };
    return module_of({
        {71, 9, 33, 1},
        {20, 3},
        {43, 2, 19, 9},
        {43, 2, 10, number},
        {truth(first), 3, 11},
        {truth(second), 3, 12},
        {43, 2, 13, 0},
        {truth(number == 9), 3, 14},
        {43, 2, 15, first ? number : 9},
        {44, 4, 16, 10, 15},
        {52, 2, 17, 128, 10, 10},
        {51, 4, 18, 10, 17},
    });
}

TEST(ShaderConstants, ThoseGivenReplaceWhatTheShaderSays) {
    const Words module = constants_module();
    EXPECT_EQ(with_constants({"made", module}, Words{7, 0, 1}), plain_module(7, false, true));
}

TEST(ShaderConstants, ThoseLeftOutAreWhatTheShaderSays) {
    const Words module = constants_module();
    EXPECT_EQ(with_constants({"made", module}, {}), plain_module(5, true, false));
    EXPECT_EQ(with_constants({"made", module}, Words{9}), plain_module(9, true, false));
}

TEST(ShaderConstants, AShaderWithoutAnyIsTheSame) {
    EXPECT_EQ(with_constants(kNothing, Words{1, 2}), nothing_module());
}

} // namespace
} // namespace ghost::gpu
