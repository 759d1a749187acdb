// SPDX-License-Identifier: Apache-2.0
// A fixture that gets another name keeps what refers to it by name: looks, palettes, trackers and movers, as
// one step of undo.
#include "support/test_desk.h"

#include "ui/model/looks.h"
#include "ui/window/window.h"

namespace ghost::ui {
namespace {

const std::string kReferences = R"(
[[tracker]]
id = 3
fixtures = ["Lamp 1", "Lamp 3"] # the singer

[[mover]]
name = "Truss"
kind = "hoists"
fixtures = ["Lamp *"]
[[mover.axis]]
point_m = [0, 0, 6]
range_m = [0, -4]
fixture = "Lamp 1"
attribute = "XYZ_Z"

[[palette]]
name = "Drums"
kind = "position"
[[palette.fixture]]
name = "Lamp 1"
pan_deg = 12.5
)";

const std::string kLooks = R"([[look]]
name = "Verse"

[[look.fixture]]
name = "Lamp 1"
intensity = 0.25

[[look.fixture]]
name = "Lamp 2"
intensity = 0.5
)";

struct Renaming : Desk {
    Renaming() {
        EXPECT_TRUE(write_file_atomic(file, kShow + kReferences).ok());
        EXPECT_TRUE(write_file_atomic(looks_file(), kLooks).ok());
        QObject::connect(&document, &ShowDocument::fixtures_renamed, &looks, &Looks::rename_fixtures);
        QObject::connect(&app, &AppModel::failed, [this](const QString& words) { said << words; });
        open();
    }
    fs::path looks_file() const { return fs::path(folder) / "looks.toml"; }
    std::string looks_text() const { return *read_text_file(looks_file(), 1 << 20); }
    void rename(std::set<std::size_t> which, const QString& name) {
        app.select(std::move(which));
        const Result<void> done = edit.rename(name);
        ASSERT_TRUE(done.ok()) << done.error().text();
        follow();
    }
    float look_of(std::size_t index) {
        EXPECT_TRUE(looks.recall("Verse", 0).ok());
        const auto found = app.look().fixtures.find(index);
        return found == app.look().fixtures.end() ? -1 : found->second.intensity.value_or(-1);
    }

    QStringList said;
    Looks looks{app};
};

TEST(Rename, what_refers_to_a_fixture_goes_with_its_name) {
    Renaming desk;
    desk.rename({0}, "Solo");
    EXPECT_EQ(desk.said, QStringList()) << "a look with values for no fixture";
    const std::string& text = desk.document.text();
    EXPECT_NE(text.find("fixtures = [\"Solo\", \"Lamp 3\"] # the singer"), std::string::npos) << text;
    EXPECT_NE(text.find("fixtures = [\"Lamp *\", \"Solo\"]"), std::string::npos) << text;
    EXPECT_NE(text.find("fixture = \"Solo\""), std::string::npos) << text;
    EXPECT_NE(text.find("[[palette.fixture]]\nname = \"Solo\""), std::string::npos) << text;
    EXPECT_EQ(text.find("\"Lamp 1\""), std::string::npos) << text;
    EXPECT_NE(desk.looks_text().find("\"Solo\""), std::string::npos) << desk.looks_text();
    EXPECT_EQ(desk.looks_text().find("\"Lamp 1\""), std::string::npos) << desk.looks_text();
    EXPECT_EQ(desk.app.undo_stack().count(), 1);
    EXPECT_EQ(desk.look_of(0), 0.25f);
    desk.app.undo_stack().undo();

    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow + kReferences);
    EXPECT_NE(desk.looks_text().find("\"Lamp 1\""), std::string::npos) << desk.looks_text();
    EXPECT_EQ(desk.look_of(0), 0.25f);
    desk.app.undo_stack().undo();
    desk.app.undo_stack().redo();
    EXPECT_EQ(desk.look_of(0), 0.25f);
}

TEST(Rename, two_that_take_each_others_names_keep_their_values) {
    Renaming desk;
    desk.rename({0, 1}, "Lamp 2"); // Lamp 2 and, as Lamp 3 is another one, Lamp 4
    EXPECT_EQ(desk.fixture(0).name, "Lamp 2");
    EXPECT_EQ(desk.fixture(1).name, "Lamp 4");
    EXPECT_EQ(desk.look_of(0), 0.25f);
    EXPECT_EQ(desk.look_of(1), 0.5f);
}

TEST(Rename, a_pattern_that_fits_nothing_any_more_goes) {
    Renaming desk;
    desk.rename({0, 1, 2}, "Spot");
    EXPECT_NE(desk.document.text().find("fixtures = [\"Spot 1\", \"Spot 2\", \"Spot 3\"]"), std::string::npos)
        << desk.document.text();
    EXPECT_EQ(desk.said, QStringList());
}

TEST(Rename, looks_with_a_mistake_stay_and_it_is_said) {
    Renaming desk;
    const std::string damaged = "[[look]]\nname = \"A\"\nsmoke = \"thick\"\n";
    ASSERT_TRUE(write_file_atomic(desk.looks_file(), damaged).ok());
    desk.rename({0}, "Solo");
    EXPECT_EQ(desk.fixture(0).name, "Solo");
    EXPECT_EQ(desk.looks_text(), damaged);
    ASSERT_FALSE(desk.said.isEmpty());
    EXPECT_TRUE(desk.said.last().contains("keep the old names")) << desk.said.last().toStdString();
}

// Looks are written at once, the show is not: who drops what was not saved has both as they were.
TEST(Rename, changes_that_are_dropped_give_looks_the_names_back) {
    const QTemporaryDir place;
    {
        Desk first(place.path().toStdString());
        Looks looks(first.app);
        QObject::connect(&first.document, &ShowDocument::fixtures_renamed, &looks, &Looks::rename_fixtures);
        ASSERT_TRUE(write_file_atomic(fs::path(first.folder) / "looks.toml", kLooks).ok());
        first.open();
        first.app.select({0});
        ASSERT_TRUE(first.edit.rename("Solo").ok());
        // Others that came do not hide which is which.
        first.app.select({1});
        ASSERT_TRUE(first.edit.duplicate({1, 0, 0}).ok());
        ASSERT_TRUE(first.document.keep().ok());
    }
    Desk second(place.path().toStdString());
    Looks looks(second.app);
    QObject::connect(&second.document, &ShowDocument::fixtures_renamed, &looks, &Looks::rename_fixtures);
    second.open();
    ASSERT_FALSE(second.draft.isEmpty());
    ASSERT_TRUE(looks.all()[0].fixtures.contains("Solo"));
    ASSERT_TRUE(second.document.drop_draft().ok());
    EXPECT_TRUE(looks.all()[0].fixtures.contains("Lamp 1"));
}

TEST(Rename, in_the_window_looks_are_renamed) {
    const Desk place; // its folder
    const fs::path looks_file = fs::path(place.folder) / "looks.toml";
    ASSERT_TRUE(write_file_atomic(looks_file, kLooks).ok());
    Link link;
    Window window(link,
                  WindowOptions{.demo = "assets/demo", .remembers = false, .width = 900, .height = 600});
    Report report;
    auto parsed = scene::parse_show(kShow, place.file, report);
    ASSERT_TRUE(parsed.ok());
    Opened opened;
    opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
    link.opened.put(std::move(opened));
    link.on_news();
    settle();
    for (const char* const line : {"select \"Lamp 1\"", "rename Solo"}) {
        const Result<void> done = window.actions().run(line);
        ASSERT_TRUE(done.ok()) << done.error().text();
    }
    const std::string looks = *read_text_file(looks_file, 1 << 20);
    EXPECT_NE(looks.find("\"Solo\""), std::string::npos) << looks;
}

} // namespace
} // namespace ghost::ui
