// SPDX-License-Identifier: Apache-2.0
// How many small pictures of looks there are, and how often one is made; what they show: side_views_test.cpp.
#include "live/engine/look_pictures.h"

#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

TEST(LookPictures, are_made_one_a_second_and_a_hundred_at_most) {
    constexpr std::size_t kMost = 100;
    SessionOptions options;
    options.show = DemoCopy::show();
    options.width = 64;
    options.height = 36;
    options.live = true;
    options.shadows = false;
    options.quiet = true;
    const auto session = must(open_session(options));
    ui::Link link;
    link.on_news = [] {};
    LookPictures pictures(link);
    for (const std::size_t count : {std::size_t{2}, kMost + 1}) {
        auto looks = std::make_shared<std::vector<scene::StoredLook>>(count); // all dark
        for (std::size_t k = 0; k < count; ++k) (*looks)[k].name = std::to_string(k);
        ui::LooksNow now;
        now.looks = looks;
        link.looks.put(now);
        pictures.forget();
        std::vector<ui::NamedPicture> made;
        const auto draw = [&](double now_s) {
            pictures.draw(*session, now_s, [] { return false; });
            if (auto news = link.look_pictures.take()) made = std::move(*news);
            return made.size();
        };
        EXPECT_EQ(draw(0), 1u);
        EXPECT_EQ(draw(0.9), 1u) << "a second has not passed";
        for (std::size_t second = 1; second < count + 5; ++second) draw(static_cast<double>(second));
        ASSERT_EQ(made.size(), std::min(count, kMost));
        EXPECT_EQ(made.back().name, std::to_string(std::min(count, kMost) - 1));
        ASSERT_TRUE(made.back().image);
        EXPECT_EQ(made.back().image->width, 320);
    }
}

} // namespace
} // namespace ghost::app
