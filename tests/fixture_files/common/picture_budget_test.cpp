// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/picture_budget.h"

#include <gtest/gtest.h>

namespace ghost::fixture {
namespace {

Type with_pictures(std::size_t bytes) {
    Type type;
    for (int k = 0; k < 2; ++k) type.media.emplace_back().rgba.resize(bytes / 2);
    return type;
}

TEST(PictureBudget, GobosOfAllFilesHaveAnEndTogether) {
    PictureBudget budget(1000);
    Report report;
    Type first = with_pictures(600), second = with_pictures(600), third = with_pictures(400),
         fourth = with_pictures(2);
    budget.take(first, "a.gdtf", report);
    EXPECT_TRUE(report.messages.empty());
    budget.take(second, "b.gdtf", report);
    budget.take(third, "c.gdtf", report);
    budget.take(fourth, "d.gdtf", report);
    EXPECT_EQ(first.media[1].rgba.size(), 300u);
    EXPECT_EQ(third.media[1].rgba.size(), 200u) << "it fits";
    for (const Type* const type : {&second, &fourth})
        for (const Media& media : type->media) EXPECT_TRUE(media.rgba.empty());
    ASSERT_EQ(report.messages.size(), 1u) << "once";
    EXPECT_EQ(report.messages[0].where, "b.gdtf");
    EXPECT_NE(report.messages[0].what.find("need more than 4 GiB"), std::string::npos);
}

} // namespace
} // namespace ghost::fixture
