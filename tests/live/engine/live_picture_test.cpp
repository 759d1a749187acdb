// SPDX-License-Identifier: Apache-2.0
// Pixels of the live picture of the demo: fewer while anything moves, all at rest, those that memory holds.
#include "live/engine/live_picture.h"

#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

class LivePictureTest : public testing::Test {
protected:
    void open(std::uint64_t memory_bytes = 0) {
        SessionOptions options;
        options.show = DemoCopy::show();
        options.width = 160;
        options.height = 90;
        options.live = true;
        options.parks = true;
        options.shadows = false;
        options.quiet = true;
        options.memory_limit_bytes = memory_bytes;
        session_ = must(open_session(options));
        camera_ = session_->live->camera();
        camera_.auto_exposure = false;
        link_.on_news = [] {};
        picture_.begin();
        picture_.begin_show(session_->show->fixtures.size());
    }
    LivePicture::Drawn draw(double now_s, bool moves, const std::function<bool()>& stop = {}) {
        LivePicture::Drawn drawn = picture_.draw(*session_,
                                                 {.camera = camera_,
                                                  .quality = quality_,
                                                  .has_work_light = has_work_light_,
                                                  .measure = ui::Measure::none,
                                                  .moves = moves,
                                                  .air_s = 0},
                                                 shown_, now_s, stop);
        if (drawn.from) shown_ = *drawn.from;
        return drawn;
    }

    std::unique_ptr<Session> session_;
    ui::Link link_;
    MessageBoard messages_{link_};
    LivePicture picture_{messages_};
    scene::Camera camera_, shown_;
    ui::PictureQuality quality_;
    bool has_work_light_ = false;
};

TEST_F(LivePictureTest, has_fewer_pixels_while_anything_moves_and_all_of_them_at_rest) {
    open();
    const auto first = draw(1, false);
    EXPECT_TRUE(first.changed) << "its camera";
    ASSERT_TRUE(first.from);
    EXPECT_LT(first.from->width, 160);
    EXPECT_FALSE(picture_.is_whole(*first.from));
    EXPECT_EQ(session_->relighter->width(), first.from->width);
    EXPECT_TRUE(session_->flies);

    const auto moved = draw(1.1, true);
    EXPECT_FALSE(moved.changed);
    EXPECT_EQ(moved.from->width, first.from->width);
    EXPECT_TRUE(session_->flies) << "it moved a moment ago";

    const auto rests = draw(1.1 + LivePicture::kRest_s, false);
    EXPECT_EQ(glm::ivec2(rests.from->width, rests.from->height), glm::ivec2(160, 90));
    EXPECT_TRUE(picture_.is_whole(*rests.from));
    EXPECT_FALSE(session_->flies);
    EXPECT_FALSE(session_->relighter->is_coarse());
    EXPECT_TRUE(draw(2, false).statistics.spans.empty()) << "nothing is left to draw";

    quality_.percent = 25;
    EXPECT_EQ(draw(3, false).from->width, 80);
}

TEST_F(LivePictureTest, lands_where_lights_move_when_its_stage_is_drawn) {
    open();
    (void)draw(1, true);
    const double rests_s = 1 + LivePicture::kRest_s;
    (void)draw(rests_s, true);
    EXPECT_TRUE(session_->flies) << "the flight's picture goes on, the next one's stage is begun";
    camera_.position_m.x += 0.1f;
    (void)draw(rests_s + 0.1, true);
    EXPECT_TRUE(session_->flies) << "it moved again";
    int pictures = 0;
    for (; session_->flies && pictures < 1000; ++pictures) (void)draw(rests_s + 1 + 0.01 * pictures, true);
    EXPECT_GE(pictures, 2);
    EXPECT_FALSE(session_->flies);
    EXPECT_EQ(shown_.position_m, camera_.position_m);
    EXPECT_FALSE(session_->live->g_buffer().pose().single);
    (void)session_->draw();
    const auto landed = session_->relighter->picture();
    session_->drop_parked();
    session_->relighter->draw_anew();
    (void)session_->draw();
    EXPECT_EQ(session_->relighter->picture().samples, landed.samples);
}

TEST_F(LivePictureTest, what_rests_can_be_stopped_before_it_is_begun) {
    open();
    (void)draw(1, true);
    camera_.position_m.x += 1; // of that view no picture with all pixels is kept
    (void)draw(1.1, true);
    const scene::Camera before = shown_;
    const auto stopped = draw(2, false, [] { return true; });
    EXPECT_TRUE(stopped.statistics.stopped);
    EXPECT_FALSE(stopped.from);
    EXPECT_EQ(session_->relighter->width(), before.width);
    EXPECT_EQ(draw(3, false).from->width, 160);
}

TEST_F(LivePictureTest, a_landing_that_is_stopped_is_taken_up_again) {
    open();
    quality_.percent = 100; // a flight is as large as what rests
    (void)draw(1, true);
    camera_.position_m.x += 1; // nothing that rests is kept from there
    (void)draw(1.1, true);
    ASSERT_TRUE(session_->flies);
    EXPECT_TRUE(draw(2, false, [] { return true; }).statistics.stopped);
    EXPECT_TRUE(session_->flies);
    (void)draw(3, false);
    EXPECT_FALSE(session_->flies);
    EXPECT_FALSE(session_->live->g_buffer().pose().single);
}

TEST_F(LivePictureTest, work_light_changes_it_and_goes_with_the_exposure) {
    open();
    (void)draw(1, true);
    EXPECT_FALSE(picture_.has_work_light());
    has_work_light_ = true;
    EXPECT_TRUE(draw(2, true).changed);
    EXPECT_TRUE(picture_.has_work_light());
    EXPECT_FALSE(draw(2.1, true).changed);
    camera_.ev100 += 1;
    EXPECT_TRUE(draw(2.2, true).changed);
    has_work_light_ = false;
    EXPECT_TRUE(draw(2.3, true).changed);
    EXPECT_FALSE(picture_.has_work_light());
}

TEST_F(LivePictureTest, is_as_large_as_memory_holds_which_is_said_once) {
    open(std::uint64_t{1} << 30);
    camera_.width = 8000;
    camera_.height = 4000;
    quality_.percent = 1;
    const auto drawn = draw(1, true);
    ASSERT_TRUE(drawn.from);
    EXPECT_LT(drawn.from->width, 400) << "a tenth of what fits, not of what is wanted";
    (void)draw(2, true);
    const auto said = link_.messages.take();
    ASSERT_TRUE(said);
    ASSERT_EQ(said->size(), 1u);
    EXPECT_NE(said->front().what.find("memory is short for a picture of 8000x4000"), std::string::npos);
}

} // namespace
} // namespace ghost::app
