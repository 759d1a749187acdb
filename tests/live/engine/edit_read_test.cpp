// SPDX-License-Identifier: Apache-2.0
// A head that comes or goes: until the show is read anew, hands hold the same heads in what is drawn.
#include "live/engine/opened_engine.h"
#include "live/session/applied_look.h"
#include "show_file/show_edit.h"
#include "support/must.h"

#include "disk/files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace ghost::app {
namespace {

TEST(EditRead, hands_light_the_same_heads_until_the_show_is_read) {
    OpenedEngine demo;
    ASSERT_TRUE(demo.opened);
    ui::Link& link = demo.link;
    ui::ViewRequest& request = demo.request;
    std::optional<ui::Opened>& opened = demo.opened;
    const std::shared_ptr<const scene::Show> before = opened->show;
    const std::size_t count = before->fixtures.size();
    ASSERT_GT(count, 3u);
    demo.look_from_first_camera(64, 36);
    request.input = ui::Input::desk; // that nobody hears
    request.counted = before;
    const auto light = [&](std::size_t fixtures, std::size_t one) {
        request.look.fixtures.clear();
        for (std::size_t i = 0; i < fixtures; ++i)
            request.look.fixtures[i].intensity = i == one ? 1.0f : 0.0f;
    };
    light(count, 1);
    request.number = 2;
    link.request.put(request);
    const auto are_right = [](const ui::RigNow& rig) {
        return rig.fixtures[1].dimmer > 0.99f && rig.fixtures[2].dimmer < 0.01f;
    };
    ASSERT_TRUE(comes_within(60, [&] {
        const auto rig = link.rig.take();
        return rig && are_right(*rig);
    }));

    const std::string text = must(read_text_file(before->file, 1 << 20));
    request.text = std::make_shared<const std::string>(must(scene::copy_fixture(text, 0, {.name = "Copy"})));
    auto shown = std::make_shared<scene::Show>(*before);
    shown->fixtures.insert(shown->fixtures.begin() + 1, shown->fixtures[0]);
    shown->fixtures[1].name = "Copy";
    request.counted = shown;
    light(count + 1, 2);
    request.explained = 2; // that was the second one
    request.number = 3;
    link.request.put(request);
    int seen = 0, wrong = 0;
    std::vector<ui::Explained> explained;
    ASSERT_TRUE(comes_within(60, [&] {
        if (const auto rig = link.rig.take(); rig && rig->fixtures.size() == count) {
            ++seen;
            wrong += are_right(*rig) ? 0 : 1;
        }
        opened = link.opened.take();
        if (auto news = link.explained.take(); news && !opened) explained.push_back(std::move(*news));
        return opened.has_value();
    }));
    ASSERT_FALSE(explained.empty());
    for (const ui::Explained& one : explained) {
        EXPECT_EQ(one.fixture, 1u) << "as it is counted in what is drawn";
        EXPECT_EQ(one.explanation.fixture, before->fixtures[1].name);
    }
    ASSERT_EQ(opened->show->fixtures.size(), count + 1);
    EXPECT_GT(seen, 3);
    EXPECT_EQ(wrong, 0) << "of " << seen;
    EXPECT_TRUE(comes_within(60, [&] {
        const auto rig = link.rig.take();
        return rig && rig->fixtures.size() == count + 1 && rig->fixtures[1].dimmer < 0.01f &&
               rig->fixtures[2].dimmer > 0.99f;
    }));
}

scene::Show show_of(const std::vector<const char*>& names) {
    scene::Show show;
    for (const char* const name : names) {
        show.fixtures.emplace_back().name = name;
        show.fixtures.back().address = name[0];
    }
    for (const char* const name : {"Lift", "Truss"}) {
        show.movers.emplace_back().name = name;
        show.movers.back().axes.resize(1);
    }
    return show;
}

TEST(EditRead, a_look_is_counted_by_names) {
    const scene::Show drawn = show_of({"A", "B", "C"});
    ui::Look look;
    look.fixtures[0].intensity = 0.1f;
    look.fixtures[2].intensity = 0.3f;
    look.solo = {2};
    look.movers[1] = {2};
    look.scene.smoke = 2.0f;
    const ui::Look removed = counted_as(drawn, look, show_of({"B", "C", "New"}));
    EXPECT_EQ(removed.fixtures.at(1).intensity, 0.1f);
    EXPECT_EQ(removed.fixtures.at(0).intensity, 0.0f) << "not one of those alone";
    EXPECT_FALSE(removed.fixtures.contains(2));
    EXPECT_TRUE(removed.solo.empty());
    EXPECT_EQ(removed.movers, look.movers);
    EXPECT_EQ(removed.scene.smoke, 2.0f);
    const ui::Look renamed = counted_as(drawn, look, show_of({"Front", "B", "C"}));
    EXPECT_EQ(renamed, look);
    scene::Show without_lift = show_of({"A", "B", "C"});
    without_lift.movers.erase(without_lift.movers.begin());
    look.movers = {{0, {2}}};
    EXPECT_EQ(counted_as(drawn, look, without_lift).movers,
              (std::map<std::size_t, std::vector<float>>{{1, {2}}}));
}

} // namespace
} // namespace ghost::app
