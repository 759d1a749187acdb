// SPDX-License-Identifier: Apache-2.0
// The engine is told by which show the look counts heads: it may still draw the one before.
#include "support/test_desk.h"

namespace ghost::ui {
namespace {

TEST(CountedLook, a_look_goes_with_the_show_by_whose_numbers_it_is) {
    Desk desk;
    desk.open();
    EXPECT_EQ(desk.app.request().counted, desk.app.show());
    std::vector<std::size_t> sizes; // of each request with a text
    QObject::connect(&desk.app, &AppModel::request_changed, [&] {
        if (desk.app.request().text) sizes.push_back(desk.app.request().counted->fixtures.size());
    });
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.duplicate({1, 0, 0}).ok());
    ASSERT_FALSE(sizes.empty());
    for (const std::size_t size : sizes) EXPECT_EQ(size, 4u);
    // What is met is met in what is drawn.
    desk.link.picked.put({desk.app.pick({0, -9, 2}, {0, 1, 0}), true, {}, std::size_t{1}, "Lamp 2 yoke"});
    desk.link.on_news();
    settle();
    EXPECT_EQ(desk.app.picked().fixture, 2u) << "the copy stands before it";
    desk.follow();
    EXPECT_EQ(desk.app.request().counted, desk.app.show());
    EXPECT_EQ(desk.app.show()->fixtures.size(), 4u);
}

} // namespace
} // namespace ghost::ui
