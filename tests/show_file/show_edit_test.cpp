// SPDX-License-Identifier: Apache-2.0
// Edits of show.toml as text: what was asked for is there, everything else is the same byte for byte, and
// what cannot be edited is refused with the text as it was.
#include "show/show.h"
#include "show_file/show_edit.h"
#include "show_file/show_toml.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <random>

namespace ghost::scene {
namespace {

const std::string kShow = R"(# Café Écran, spring
[show]
name = "Café" # the owner's spelling
stage = "club.glb"

[[camera]]
name = "house"
position_m = [0, -12, 3]
target_m = [0, 2, 3]

# front truss
[[fixture]]
name = "Spöt 1"   # left
gdtf = "spot.gdtf"
universe = 1
address = 1
position_m = [
    -2, # left of the middle
    4,
    6,
]

[[fixture]]
gdtf = "spot.gdtf"
address = 40 # after the first
position_m = [2, 4, 6]
[fixture.track]
stops_m = [[2, 4, 6], [3, 4, 6]]
universe = 2
address = 1

# the end
[haze]
preset = "haze"
)";

ParsedShow parsed_of(const std::string& text) {
    Report report;
    return must(parse_show(text, "show.toml", report));
}

// With the words that changed cut out of both, the texts are the same.
void expect_only(const std::string& before, const std::string& after, const std::string& from,
                 const std::string& to) {
    std::string expected = before;
    const std::size_t at = expected.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    expected.replace(at, from.size(), to);
    EXPECT_EQ(after, expected);
}

TEST(ShowEdit, a_value_is_replaced_where_it_stands) {
    const auto edited = edit_fixtures(kShow, {{{0, ""}, {.address = fixture::Address{1, 17}}}});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    expect_only(kShow, *edited, "address = 1\nposition_m = [\n", "address = 17\nposition_m = [\n");
    const auto renamed = edit_fixtures(kShow, {{{0, ""}, {.name = "Spöt (2)"}}});
    ASSERT_TRUE(renamed.ok()) << renamed.error().text();
    expect_only(kShow, *renamed, "\"Spöt 1\"", "\"Spöt (2)\"");
    const auto mode = edit_fixtures(*renamed, {{{0, ""}, {.mode = R"(16" \ extended)"}}});
    ASSERT_TRUE(mode.ok()) << mode.error().text();
    EXPECT_EQ(parsed_of(*mode).sources[0].mode, R"(16" \ extended)");
}

TEST(ShowEdit, a_value_of_several_lines_goes_whole) {
    const auto edited = edit_fixtures(kShow, {{{0, ""}, {.position_m = glm::vec3(-1.5f, 0, 7.25f)}}});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    expect_only(kShow, *edited, "[\n    -2, # left of the middle\n    4,\n    6,\n]", "[-1.5, 0, 7.25]");
}

TEST(ShowEdit, a_key_that_is_missing_comes_behind_the_others_of_its_table) {
    const auto edited =
        edit_fixtures(kShow, {{{1, ""}, {.mode = "Extended", .address = fixture::Address{3, 40}}}});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    const ParsedShow parsed = parsed_of(*edited);
    EXPECT_EQ(parsed.show.fixtures[1].universe, 3);
    EXPECT_EQ(parsed.sources[1].mode, "Extended");
    ASSERT_TRUE(parsed.show.fixtures[1].track);
    EXPECT_EQ(parsed.show.fixtures[1].track->universe, 2) << "the track's own";
    EXPECT_NE(edited->find("# after the first"), std::string::npos);
}

TEST(ShowEdit, an_address_of_0_unpatches) {
    const auto edited = edit_fixtures(kShow, {{{0, ""}, {.address = fixture::Address{1, 0}}}});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    expect_only(kShow, *edited, "address = 1\nposition_m = [\n", "position_m = [\n");
    EXPECT_EQ(parsed_of(*edited).show.fixtures[0].address, 0);
}

TEST(ShowEdit, objects_of_a_plot_get_a_change_of_their_own) {
    const FixturePlace lamp{7, "8B1A-77"};
    const auto first = edit_fixtures(kShow, {{lamp, {.address = fixture::Address{4, 0}, .hidden = true}}});
    ASSERT_TRUE(first.ok()) << first.error().text();
    EXPECT_TRUE(first->starts_with(kShow));
    EXPECT_EQ(first->substr(kShow.size()),
              "\n[[change]]\nuuid = \"8B1A-77\"\nuniverse = 4\naddress = 0\nhidden = true\n");
    const auto second = edit_fixtures(*first, {{lamp, {.position_m = glm::vec3(1, 2, 3)}}});
    ASSERT_TRUE(second.ok()) << second.error().text();
    EXPECT_EQ(*second, *first + "position_m = [1, 2, 3]\n") << "not a second [[change]]";
}

TEST(ShowEdit, a_copy_has_all_keys_and_stands_behind) {
    const auto edited = copy_fixture(kShow, 1, {.name = "Two", .address = fixture::Address{1, 80}});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    const ParsedShow parsed = parsed_of(*edited);
    ASSERT_EQ(parsed.show.fixtures.size(), 3u);
    EXPECT_EQ(parsed.show.fixtures[2].name, "Two");
    EXPECT_EQ(parsed.show.fixtures[2].address, 80);
    EXPECT_TRUE(parsed.show.fixtures[2].track);
    EXPECT_EQ(parsed.show.fixtures[1].address, 40);
    const auto gone = remove_fixtures(*edited, {2});
    ASSERT_TRUE(gone.ok()) << gone.error().text();
    EXPECT_EQ(*gone, kShow);
}

TEST(ShowEdit, what_is_added_and_removed_again_leaves_no_byte) {
    const NewFixture wash{
        "wash.gdtf", {.name = "Wash", .address = fixture::Address{2, 1}, .position_m = glm::vec3(0, 1, 5)}};
    for (const std::string& text :
         {kShow, std::string("[show]\nstage = \"a.glb\"\n[[camera]]\nname = \"c\"")}) {
        const auto added = add_fixture(text, wash);
        ASSERT_TRUE(added.ok()) << added.error().text();
        const ParsedShow parsed = parsed_of(*added);
        EXPECT_EQ(parsed.show.fixtures.back().name, "Wash");
        EXPECT_EQ(parsed.show.fixtures.back().universe, 2);
        EXPECT_EQ(parsed.show.fixtures.back().gdtf, "wash.gdtf");
    }
    const auto both = remove_fixtures(kShow, {0, 1});
    ASSERT_TRUE(both.ok()) << both.error().text();
    EXPECT_TRUE(parsed_of(*both).show.fixtures.empty());
    EXPECT_NE(both->find("# front truss"), std::string::npos);
    EXPECT_NE(both->find("# the end\n[haze]"), std::string::npos);
}

TEST(ShowEdit, lines_may_end_as_on_windows) {
    std::string text;
    for (const char letter : kShow) text += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
    const auto edited =
        copy_fixture(text, 0, {.address = fixture::Address{5, 6}, .rotation_deg = glm::vec3(180, 0, 0)});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    for (std::size_t at = edited->find('\n'); at != std::string::npos; at = edited->find('\n', at + 1))
        ASSERT_EQ((*edited)[at - 1], '\r') << at;
    EXPECT_EQ(parsed_of(*edited).show.fixtures[1].universe, 5);
}

TEST(ShowEdit, what_cannot_be_edited_is_refused) {
    const std::string in_line = "fixture = [{gdtf = \"a.gdtf\", address = 1, position_m = [0, 0, 5]}]\n"
                                "[show]\nstage = \"a.glb\"\n[[camera]]\nname = \"c\"\n";
    EXPECT_FALSE(edit_fixtures(in_line, {{{0, ""}, {.mode = "x"}}}).ok());
    EXPECT_FALSE(copy_fixture(in_line, 0, {}).ok());
    EXPECT_FALSE(remove_fixtures(in_line, {0}).ok());
    const auto value = edit_fixtures(in_line, {{{0, ""}, {.address = fixture::Address{1, 9}}}});
    EXPECT_FALSE(value.ok()) << "universe is missing";
    EXPECT_FALSE(edit_fixtures(kShow, {{{2, ""}, {.name = "none"}}}).ok());
    EXPECT_FALSE(edit_fixtures("[show", {{{0, ""}, {.name = "none"}}}).ok());
}

// Any sequence of edits is a show that says what was asked for.
TEST(ShowEdit, any_sequence_says_what_was_asked_for) {
    std::mt19937 random(7);
    std::string text = kShow;
    for (int round = 0; round < 300; ++round) {
        const std::size_t count = parsed_of(text).show.fixtures.size();
        const auto pick = [&](int below) {
            return static_cast<int>(random() % static_cast<unsigned>(below));
        };
        const auto number = static_cast<std::size_t>(pick(static_cast<int>(count)));
        FixtureEdit edit;
        if (pick(2)) edit.name = "N" + std::to_string(round);
        if (pick(2)) edit.address = fixture::Address{1 + pick(9), pick(3) ? 1 + pick(500) : 0};
        if (pick(2)) edit.position_m = glm::vec3(glm::ivec3(pick(100), -pick(100), 35)) / 7.0f;
        const int what = pick(5);
        const auto after = what == 0 && count < 12  ? copy_fixture(text, number, edit)
                           : what == 1 && count > 1 ? remove_fixtures(text, {number})
                                                    : edit_fixtures(text, {{{number, ""}, edit}});
        ASSERT_TRUE(after.ok()) << after.error().text() << "\n" << text;
        text = *after;
        const ParsedShow parsed = parsed_of(text);
        if (what == 1 && count > 1) continue;
        const PatchedFixture& fixture = parsed.show.fixtures[number + (what == 0 && count < 12 ? 1 : 0)];
        if (edit.name) {
            EXPECT_EQ(fixture.name, *edit.name);
        }
        if (edit.address) {
            EXPECT_EQ(fixture.address, edit.address->channel);
        }
        if (edit.position_m && !fixture.track) {
            EXPECT_EQ(fixture.position_m, *edit.position_m);
        }
    }
    EXPECT_TRUE(text.starts_with("# Café Écran, spring\n[show]\nname = \"Café\" # the owner's spelling\n"));
    EXPECT_TRUE(text.ends_with("# the end\n[haze]\npreset = \"haze\"\n"));
}

TEST(ShowEdit, another_stage_is_one_value_and_a_plot_one_line) {
    const auto stage = set_of_show(kShow, "stage", "other \"one\".glb");
    ASSERT_TRUE(stage.ok()) << stage.error().text();
    expect_only(kShow, *stage, "stage = \"club.glb\"", "stage = \"other \\\"one\\\".glb\"");
    const auto plot = set_of_show(kShow, "plot", "tour.mvr");
    ASSERT_TRUE(plot.ok()) << plot.error().text();
    Report report;
    const auto parsed = parse_show(*plot, "show.toml", report);
    ASSERT_TRUE(parsed.ok());
    EXPECT_EQ(parsed->show.plot_file.filename(), "tour.mvr");
    EXPECT_EQ(parsed->show.stage_file.filename(), "club.glb");
    const auto anew = set_of_show("# nothing yet\n", "stage", "a.glb");
    ASSERT_TRUE(anew.ok()) << anew.error().text();
    EXPECT_TRUE(anew->starts_with("# nothing yet\n")) << *anew;
    EXPECT_NE(anew->find("[show]\nstage = \"a.glb\""), std::string::npos) << *anew;
    EXPECT_FALSE(set_of_show("[show\n", "stage", "a.glb").ok());
}

TEST(ShowEdit, a_camera_is_added_at_the_end) {
    Camera camera;
    camera.name = "from the bar";
    camera.position_m = {1.5f, -4, 1.625f};
    camera.target_m = {0, 3, 2};
    camera.fov_y_deg = 55;
    camera.width = 1024;
    camera.height = 300;
    camera.ev100 = 5.5f;
    const auto added = add_camera(kShow, camera);
    ASSERT_TRUE(added.ok()) << added.error().text();
    EXPECT_TRUE(added->starts_with(kShow)) << *added;
    const ParsedShow parsed = parsed_of(*added);
    ASSERT_EQ(parsed.show.cameras.size(), 2u);
    const Camera& made = parsed.show.cameras[1];
    EXPECT_EQ(made.name, camera.name);
    EXPECT_EQ(made.position_m, camera.position_m);
    EXPECT_EQ(made.target_m, camera.target_m);
    EXPECT_EQ(made.fov_y_deg, camera.fov_y_deg);
    EXPECT_EQ(std::pair(made.width, made.height), std::pair(1024, 300));
    EXPECT_EQ(made.ev100, camera.ev100);
    camera.name = "automatic";
    camera.auto_exposure = true;
    const auto both = add_camera(*added, camera);
    ASSERT_TRUE(both.ok());
    EXPECT_TRUE(parsed_of(*both).show.cameras[2].auto_exposure);
}

} // namespace
} // namespace ghost::scene
