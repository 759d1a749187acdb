// SPDX-License-Identifier: Apache-2.0
// Names in the order that people count in.
#include "base/natural_order.h"

#include <gtest/gtest.h>

#include <string>

namespace ghost {
namespace {

TEST(NaturalOrder, is_that_of_people) {
    EXPECT_TRUE(natural_less("Spot 2", "Spot 10"));
    EXPECT_FALSE(natural_less("Spot 10", "Spot 2"));
    EXPECT_TRUE(natural_less("Spot 09", "Spot 10"));
    EXPECT_FALSE(natural_less("Spot 1", "Spot 1"));
    EXPECT_TRUE(natural_less("Spot", "Spot 1"));
    EXPECT_TRUE(natural_less("", "a"));
    EXPECT_TRUE(natural_less(std::string(1000, '1'), std::string(1001, '1')));
    EXPECT_TRUE(natural_less("Spot 01", "Spot 1")) << "not the same, or groups would mix";
    EXPECT_FALSE(natural_less("Spot 1", "Spot 01"));
    EXPECT_TRUE(natural_less("Pixel z", "Pixel \xC3\xA9")) << "by bytes, whatever sign a char has";
}

} // namespace
} // namespace ghost
