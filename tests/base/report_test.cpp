// SPDX-License-Identifier: Apache-2.0
#include "base/report.h"

#include <gtest/gtest.h>

namespace ghost {
namespace {

TEST(Report, has_an_end_which_is_said_and_keeps_what_is_rare) {
    Report report;
    for (std::size_t k = 0; k < kMostReported; ++k)
        report.add(Severity::warning, "show.toml:" + std::to_string(k),
                   "unknown key 'k" + std::to_string(k) + "'");
    ASSERT_EQ(report.messages.size(), kMostReported) << "as many as a person may want to see";
    for (int k = 0; k < 100'000; ++k)
        report.add(Severity::warning, "show.toml:9", "unknown key 'x" + std::to_string(k) + "'");
    EXPECT_FALSE(report.lost_anything());
    report.add(Severity::error, "show.toml:10", "stage: no such file");
    report.add(Severity::error, "show.toml:11", "stage: no such file");
    ASSERT_EQ(report.messages.size(), kMostReported + 2);
    EXPECT_EQ(report.messages[kMostReported].what,
              "100001 more messages are not listed, but the first of each kind: 1 loss, 100000 repairs");
    EXPECT_EQ(report.messages[kMostReported].severity, Severity::error);
    EXPECT_EQ(report.messages.back().what, "stage: no such file");
    EXPECT_TRUE(report.lost_anything());
    report.messages.clear(); // by who showed them
    report.add(Severity::note, "show.toml:12", "unknown key 'y'");
    EXPECT_EQ(report.messages.size(), 1u);
}

} // namespace
} // namespace ghost
