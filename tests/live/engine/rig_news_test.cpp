// SPDX-License-Identifier: Apache-2.0
// What the window is told of heads that the picture leaves dark, for nobody asks for them: that they are
// dark.
#include "live/engine/rig_news.h"

#include "disk/files.h"
#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

namespace ghost::app {
namespace {

struct Told {
    ui::RigNow rig;
    std::vector<ui::Verdict> verdicts;

    float most_dimmer() const {
        float most = 0;
        for (const ui::FixtureNow& now : rig.fixtures) most = std::max(most, now.dimmer);
        return most;
    }
    std::ptrdiff_t lit() const {
        return std::count_if(verdicts.begin(), verdicts.end(), [](const ui::Verdict& verdict) {
            return verdict.visibility == scene::Visibility::lit ||
                   verdict.visibility == scene::Visibility::unseen;
        });
    }
    std::size_t unasked() const {
        return static_cast<std::size_t>(
            std::count_if(verdicts.begin(), verdicts.end(), [](const ui::Verdict& verdict) {
                return verdict.cause == scene::Cause::unasked &&
                       verdict.visibility == scene::Visibility::dark &&
                       verdict.group == "nobody asks for them while the work light is on";
            }));
    }
};

TEST(RigNews, heads_that_are_left_dark_are_dark_in_lists_and_verdicts) {
    SessionOptions options;
    options.show = DemoCopy::show();
    options.width = 64;
    options.height = 36;
    options.live = true;
    options.shadows = false;
    options.quiet = true;
    const auto session = must(open_session(options));
    session->show->motion = fixture::Motion::as_commanded;
    std::map<int, dmx::Levels> levels; // in the place of files that have their heads open
    for (const scene::PatchedFixture& fixture : session->show->fixtures) {
        const auto first = static_cast<std::size_t>(fixture.address) - 1;
        const bool is_wash = fixture.gdtf.string().find("Wash") != std::string::npos;
        dmx::Levels& of_universe = levels[fixture.universe];
        of_universe[first] = 255;                              // dimmer
        of_universe[first + 1] = of_universe[first + 3] = 128; // in the middle
        of_universe[first + (is_wash ? 9 : 16)] = 255;         // shutter, or iris
    }
    dmx::Universes full;
    for (const auto& [universe, values] : levels)
        full.at(static_cast<std::uint16_t>(universe)).levels = std::make_shared<const dmx::Levels>(values);
    const LiveInput input(nullptr);
    const bake::Tracer rays(session->live->solid());
    ui::Link link;
    link.on_news = [] {};
    RigNews news(link);
    double now_s = 0;
    const auto told = [&](bool leaves) {
        now_s += 10;
        session->rig->leave_unasked_dark(leaves);
        session->rig->step(full, 1);
        news.publish(*session, input, {}, session->lit(), {}, now_s);
        news.explain(
            {.fixture = {}, .hovered = {}, .all = true}, *session, input, {},
            [&]() -> const bake::Tracer& { return rays; }, now_s);
        return Told{link.rig.take().value(), link.verdicts.take().value()};
    };
    const Told shining = told(false);
    ASSERT_GT(shining.most_dimmer(), 0.5f);
    ASSERT_GT(shining.lit(), 0);
    const Told dark = told(true);
    EXPECT_EQ(dark.most_dimmer(), 0);
    EXPECT_EQ(dark.lit(), 0);
    EXPECT_GT(dark.unasked(), 0u);
    EXPECT_EQ(dark.unasked(), session->rig->left_dark());
    EXPECT_FALSE(shining.rig.fixtures.front().is_dark_without_hands);
    EXPECT_TRUE(dark.rig.fixtures.front().is_dark_without_hands);
    // Who selects another head waits for no turn.
    std::optional<std::size_t> last;
    for (const std::size_t fixture : {0u, 1u, 1u}) {
        now_s += 0.01;
        news.explain(
            {.fixture = fixture, .hovered = {}, .all = false}, *session, input, {},
            [&]() -> const bake::Tracer& { return rays; }, now_s);
        const auto explained = link.explained.take();
        if (fixture == last) {
            EXPECT_FALSE(explained) << "a quarter of a second has not gone by";
        } else {
            ASSERT_TRUE(explained);
            EXPECT_EQ(explained->fixture, fixture);
        }
        last = fixture;
    }
}

// What aims a head by hand needs to know which way a mover has turned it.
TEST(RigNews, a_head_on_a_turntable_is_turned_with_it) {
    SessionOptions options;
    options.show = DemoCopy::show();
    options.text = std::make_shared<const std::string>(
        *read_text_file(DemoCopy::show() / "show.toml", std::size_t{1} << 20) +
        "\n[[mover]]\nname = \"Table\"\nkind = \"revolve\"\ncentre_m = [0.0, 2.0, 0.0]\n"
        "fixtures = [\"Spot 1\"]\n[[mover.axis]]\nrange_deg = [0.0, 360.0]\n");
    options.width = 64;
    options.height = 36;
    options.live = true;
    options.shadows = false;
    options.quiet = true;
    const auto session = must(open_session(options));
    ASSERT_EQ(session->show->movers.size(), 1u);
    session->show->motion = fixture::Motion::as_commanded;
    session->rig->movers().drive(std::map<std::size_t, std::vector<float>>{{0, {90.0f}}});
    session->rig->step(dmx::Universes{}, 1);
    const LiveInput input(nullptr);
    ui::Link link;
    link.on_news = [] {};
    RigNews(link).publish(*session, input, {}, session->lit(), {}, 10);
    const ui::RigNow rig = link.rig.take().value();
    ASSERT_EQ(session->show->fixtures[0].name, "Spot 1");
    EXPECT_NEAR(std::abs(rig.fixtures[0].turned[0].y), 1, 1e-4f) << "a quarter about Z";
    EXPECT_EQ(rig.fixtures[1].turned, glm::mat3(1));
}

} // namespace
} // namespace ghost::app
