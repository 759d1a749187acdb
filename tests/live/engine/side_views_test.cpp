// SPDX-License-Identifier: Apache-2.0
// Pictures from elsewhere for browsers: side views with what is measured in them, and small ones of looks; a
// processor draws them while the show rests.
#include "live/engine/opened_engine.h"

#include <gtest/gtest.h>

#include <chrono>

namespace ghost::app {
namespace {

float brightness(const image::Image8& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.samples.size(); ++i)
        if (i % 4 != 3) sum += image.samples[i];
    return static_cast<float>(sum / static_cast<double>(image.samples.size()));
}

// An engine with the demo at a moment of light that stands still.
class StillDemo : public OpenedEngine {
public:
    StillDemo() {
        look_from_first_camera(96, 54);
        request.transport.seeks = 1;
        request.transport.at_s = 36;
        request.frozen = true;
        send();
    }
    void want(std::vector<ui::SideView> views) {
        link.side_views.put(std::move(views));
        link.wake.raise();
    }
    // All that there are, once there are so many.
    std::vector<ui::SidePicture> sides(std::size_t count) {
        std::vector<ui::SidePicture> newest;
        EXPECT_TRUE(comes_within(120, [&] {
            if (auto all = link.side_pictures.take()) newest = std::move(*all);
            return newest.size() >= count;
        }));
        return newest;
    }
};

// One for all tests: to open the demo takes longer than any of them.
class SideViewsOfDemo : public ::testing::Test {
protected:
    static void SetUpTestSuite() { still_ = std::make_unique<StillDemo>(); }
    static void TearDownTestSuite() { still_.reset(); }
    static inline std::unique_ptr<StillDemo> still_;

    std::vector<ui::SidePicture> sides(std::size_t count) { return still_->sides(count); }
    void want(std::vector<ui::SideView> views) { still_->want(std::move(views)); }
    ui::Link& link = still_->link;
    const ui::Opened& opened = *still_->opened;
};

TEST_F(SideViewsOfDemo, another_camera_is_drawn_and_measured_and_the_main_picture_stays) {
    // Straight down on the middle of the stage: a surface is met.
    const ui::SideView stored{.number = 1, .camera = opened.show->cameras.back(), .probe = {}};
    ui::SideView down{.number = 2, .camera = stored.camera, .probe = glm::vec2(0.5f)};
    down.camera.position_m = glm::vec3(0, 1, 5);
    down.camera.target_m = {0, 2, -1};
    const ui::SideView third{.number = 3, .camera = stored.camera, .probe = {}};
    want({stored, down, third});
    const std::vector<ui::SidePicture> drawn = sides(ui::kMostSideViews);
    ASSERT_EQ(drawn.size(), ui::kMostSideViews) << "no third one";
    const ui::SidePicture& first = drawn[0];
    ASSERT_EQ(first.number, 1u);
    EXPECT_GT(brightness(*first.image), 1);
    EXPECT_FALSE(first.measure);
    ASSERT_TRUE(drawn[1].measure);
    const ui::SideMeasure& measured = *drawn[1].measure;
    EXPECT_TRUE(measured.hit);
    EXPECT_GT(measured.distance_m, 0);
    EXPECT_GE(measured.lux, 0);
    EXPECT_FALSE(measured.object.empty());
    EXPECT_EQ(first.is_still, opened.device.find("llvmpipe") != std::string::npos)
        << "a processor draws them when the lamps rest";
    const auto main = link.picture.take();
    ASSERT_TRUE(main);
    EXPECT_EQ(main->camera.name, opened.show->cameras.front().name) << "the window's own is where it was";
}

TEST_F(SideViewsOfDemo, come_while_the_show_plays_too) {
    still_->request.frozen = false;
    still_->request.transport.playing = true;
    still_->send();
    want({{.number = 11, .camera = opened.show->cameras.back(), .probe = {}}});
    const auto of_11 = [&](int width) {
        const auto all = link.side_pictures.take();
        return all && all->size() == 1 && all->front().number == 11 &&
               (width == 0 || all->front().image->width == width);
    };
    EXPECT_TRUE(comes_within(60, [&] { return of_11(0); })) << "nobody waits for a rest";
    still_->request.frozen = true;
    still_->send();
    if (opened.device.find("llvmpipe") != std::string::npos) {
        EXPECT_TRUE(comes_within(60, [&] { return of_11(640); })) << "and whole when the lamps rest";
    }
    want({});
}

TEST_F(SideViewsOfDemo, looks_are_drawn_as_they_would_be) {
    std::vector<scene::StoredLook> looks(2);
    looks[0].name = "all on";
    for (const scene::PatchedFixture& fixture : opened.show->fixtures)
        looks[0].fixtures[fixture.name].intensity = 1.0f;
    looks[1].name = "none";
    for (const scene::PatchedFixture& fixture : opened.show->fixtures)
        looks[1].fixtures[fixture.name].intensity = 0.0f;
    link.looks.put({std::make_shared<const std::vector<scene::StoredLook>>(looks), ""});
    link.wants_small_pictures = true;
    std::vector<ui::NamedPicture> pictures;
    ASSERT_TRUE(comes_within(120, [&] {
        if (auto news = link.look_pictures.take()) pictures = std::move(*news);
        return pictures.size() == 2;
    }));
    EXPECT_EQ(pictures[0].name, "all on");
    EXPECT_GT(brightness(*pictures[0].image), brightness(*pictures[1].image) + 2);
}

TEST_F(SideViewsOfDemo, a_command_is_done_and_answered) {
    ASSERT_TRUE(link.commands.put({7, "camera", {opened.show->cameras.back().name, 0.0}}));
    ASSERT_TRUE(link.commands.put({8, "look", {std::string("Verse"), 2.0}}));
    ASSERT_TRUE(link.commands.put({9, "nothing", {}}));
    link.wake.raise();
    std::vector<ui::CommandAnswer> answers;
    ASSERT_TRUE(comes_within(60, [&] {
        for (auto& answer : link.command_answers.take()) answers.push_back(std::move(answer));
        return answers.size() == 3;
    }));
    EXPECT_EQ(answers[0].refused, "");
    EXPECT_EQ(answers[1].refused, "");
    EXPECT_EQ(answers[2].number, 9u);
    EXPECT_NE(answers[2].refused.find("no address of ours"), std::string::npos);
    const auto camera = link.camera_call.take();
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->camera.name, opened.show->cameras.back().name);
    const auto look = link.look_call.take();
    ASSERT_TRUE(look);
    EXPECT_EQ(look->name, "Verse");
    EXPECT_EQ(look->seconds, 2);
}

} // namespace
} // namespace ghost::app
