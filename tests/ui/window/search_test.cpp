// SPDX-License-Identifier: Apache-2.0
// The search of the fixture list: what Ctrl+A selects while something is searched, and how long it stays.
#include "support/test_window.h"
#include "ui/window/window.h"

#include <QLineEdit>

namespace ghost::ui {
namespace {

using Fixtures = std::set<std::size_t>;

struct Searching {
    Searching() {
        window.show();
        open(false);
    }
    void open(bool again) {
        Opened opened = four_lamps();
        opened.again = again;
        link.opened.put(std::move(opened));
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    QLineEdit& search() {
        for (QLineEdit* const one : window.findChildren<QLineEdit*>())
            if (one->accessibleName() == "Search fixtures") return *one;
        ADD_FAILURE() << "no search";
        return *window.findChild<QLineEdit*>();
    }
    const Fixtures& selection() { return window.app().selection(); }

    Link link;
    Window window{link, {.remembers = false, .width = 1500, .height = 800}};
};

TEST(Search, a_hand_selects_all_that_is_listed_and_a_script_all) {
    Searching in;
    in.search().setText("Lamp 2");
    settle();
    in.window.actions().choose("select-all");
    EXPECT_EQ(in.selection(), (Fixtures{1}));
    for (const char* const line : {"select *", "select-all"}) {
        in.window.app().select({});
        ASSERT_TRUE(in.window.actions().run(line).ok());
        EXPECT_EQ(in.selection(), (Fixtures{0, 1, 2, 3})) << line;
    }
    in.search().clear();
    settle();
    in.window.app().select({});
    in.window.actions().choose("select-all");
    EXPECT_EQ(in.selection(), (Fixtures{0, 1, 2, 3}));
    // Where the list is out of sight, nobody sees what is searched.
    in.search().setText("Lamp 2");
    ASSERT_TRUE(in.window.actions().run("panel-fixtures off").ok());
    settle();
    in.window.actions().choose("select-all");
    EXPECT_EQ(in.selection(), (Fixtures{0, 1, 2, 3}));
}

TEST(Search, is_empty_when_another_show_opens_and_stays_when_the_same_is_read_again) {
    Searching in;
    in.search().setText("Lamp 2");
    in.open(true);
    EXPECT_EQ(in.search().text(), "Lamp 2");
    in.open(false);
    EXPECT_EQ(in.search().text(), "");
}

} // namespace
} // namespace ghost::ui
