// SPDX-License-Identifier: Apache-2.0
// Pictures for the strip of cameras: all of them while the stage rests, not more than one a second; while it
// moves only for browsers, and rarely; none where nobody wants them.
#include "live/engine/opened_engine.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace ghost::app {
namespace {

TEST(CameraPictures, come_one_by_one_while_nothing_moves_and_rarely_while_it_does) {
    OpenedEngine demo;
    ASSERT_TRUE(demo.opened);
    ui::Link& link = demo.link;
    ui::ViewRequest& request = demo.request;
    std::optional<ui::Opened>& opened = demo.opened;
    const std::size_t count = opened->show->cameras.size();
    ASSERT_GE(count, 2u);
    const auto ask = [&](auto change) {
        change(request);
        demo.send();
    };
    const auto settles = [&] {
        return comes_within(120, [&] {
            const auto settled = link.settled.take();
            return settled && *settled == request.number;
        });
    };
    ask([&](ui::ViewRequest& wanted) {
        wanted.camera = opened->show->cameras.front();
        wanted.camera.width = 96;
        wanted.camera.height = 54;
        wanted.transport.seeks = 1;
        wanted.transport.at_s = 36;
        wanted.frozen = true;
    });
    ASSERT_TRUE(settles());
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    EXPECT_FALSE(link.camera_pictures.take()) << "nobody wants them";

    const auto asked = std::chrono::steady_clock::now();
    ask([](ui::ViewRequest& wanted) { wanted.wants_camera_pictures = true; });
    std::vector<ui::NamedPicture> pictures;
    std::size_t seen = 0;
    ASSERT_TRUE(comes_within(60 + 3 * static_cast<double>(count), [&] {
        auto news = link.camera_pictures.take();
        if (!news) return false;
        // Starts are a second apart; ends may be nearer on a busy machine.
        EXPECT_GE(std::chrono::steady_clock::now() - asked + std::chrono::milliseconds(500),
                  std::chrono::seconds(news->size() - 1));
        seen = news->size();
        pictures = std::move(*news);
        return seen == count;
    }));
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(pictures[i].name, opened->show->cameras[i].name);
        EXPECT_EQ(pictures[i].image->width, 160);
    }
    EXPECT_NE(pictures[0].image->samples, pictures[1].image->samples);
    // Distance maps that are ready late light the picture once more, and the small ones with it.
    EXPECT_TRUE(comes_within(60, [&] {
        (void)link.camera_pictures.take();
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
        return !link.camera_pictures.take();
    })) << "they are those of what rests";

    ask([](ui::ViewRequest& wanted) {
        wanted.frozen = false;
        wanted.transport.playing = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(3000));
    EXPECT_FALSE(link.camera_pictures.take()) << "while the recording plays";
    link.wants_small_pictures = true;
    EXPECT_TRUE(comes_within(60, [&] { return link.camera_pictures.take().has_value(); }))
        << "browsers do not wait for a rest";
    const auto first = std::chrono::steady_clock::now();
    EXPECT_TRUE(comes_within(60, [&] { return link.camera_pictures.take().has_value(); }));
    EXPECT_GE(std::chrono::steady_clock::now() - first, std::chrono::seconds(4)) << "rarely";
    link.wants_small_pictures = false;
    ask([](ui::ViewRequest& wanted) { wanted.frozen = true; });
    EXPECT_TRUE(comes_within(60, [&] { return link.camera_pictures.take().has_value(); }))
        << "as it rests now";
}

} // namespace
} // namespace ghost::app
