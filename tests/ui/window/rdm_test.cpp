// SPDX-License-Identifier: Apache-2.0
// What desks want by RDM as edits of the show, each a step that comes back byte for byte.
#include "support/test_desk.h"

#include "ui/panel_parts/rdm_box.h"
#include "ui/window/rdm_edits.h"

#include <QComboBox>

namespace ghost::ui {
namespace {

struct RdmTrial : Desk {
    RdmEdits edits{app, document, nullptr};
    std::vector<std::string> complaints;

    RdmTrial() {
        edits.complain = [this](const Error& error) { complaints.push_back(error.text()); };
        open();
        edits.set_access(RdmAccess::edit);
    }
    void ask(RdmEdit one) {
        ASSERT_TRUE(link.rdm_edits.put(std::move(one)));
        link.on_news();
        settle();
    }
};

RdmEdit edit_of(std::uint64_t number, std::size_t fixture, const std::string& name) {
    RdmEdit edit;
    edit.number = number;
    edit.fixture = fixture;
    edit.name = name;
    return edit;
}

TEST(RdmEdits, each_edit_is_a_step_whatever_is_selected) {
    RdmTrial desk;
    EXPECT_EQ(desk.app.request().rdm, RdmAccess::edit);
    desk.app.select({2});
    RdmEdit address = edit_of(1, 0, "Lamp 1"), mode = edit_of(2, 1, "Lamp 2"),
            label = edit_of(3, 0, "Lamp 1");
    address.address = 101;
    mode.mode = 1;
    label.label = "FOH left";
    desk.ask(address);
    EXPECT_EQ(desk.fixture(0).address, 101);
    EXPECT_EQ(desk.app.request().rdm_answered, 1u);
    EXPECT_EQ(desk.app.undo_stack().undoText(), "Address of Lamp 1 by RDM");
    desk.ask(mode);
    desk.ask(label);
    EXPECT_EQ(desk.fixture(0).name, "FOH left");
    EXPECT_NE(desk.document.text().find("mode = \"Short\""), std::string::npos);
    EXPECT_EQ(desk.app.selection(), std::set<std::size_t>{2});
    EXPECT_EQ(desk.app.undo_stack().count(), 3);
    for (int i = 0; i < 3; ++i) desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
    EXPECT_TRUE(desk.complaints.empty());
}

TEST(RdmEdits, many_at_once_are_done_one_after_the_other) {
    RdmTrial desk;
    for (int i = 0; i < 50; ++i) {
        RdmEdit one = edit_of(static_cast<std::uint64_t>(i + 1), 1, "Lamp 2");
        one.address = 100 + i;
        ASSERT_TRUE(desk.link.rdm_edits.put(one));
    }
    desk.link.on_news();
    for (int i = 0; i < 100 && desk.app.request().rdm_answered < 50; ++i) settle();
    EXPECT_EQ(desk.fixture(1).address, 149);
    EXPECT_EQ(desk.app.undo_stack().count(), 50);
}

TEST(RdmEdits, what_is_not_there_any_more_is_said_and_answered) {
    RdmTrial desk;
    RdmEdit moved = edit_of(1, 0, "Lamp 3"), gone = edit_of(2, 1, "Lamp 9"), mode = edit_of(3, 0, "Lamp 1");
    moved.address = 200;
    gone.address = 1;
    mode.mode = 7;
    desk.ask(moved);
    EXPECT_EQ(desk.fixture(2).address, 200) << "it has another place in the list now";
    desk.ask(gone);
    desk.ask(mode);
    EXPECT_EQ(desk.complaints.size(), 2u);
    EXPECT_EQ(desk.app.request().rdm_answered, 3u);
    EXPECT_EQ(desk.app.undo_stack().count(), 1);
}

TEST(RdmEdits, a_show_that_cannot_be_edited_is_only_read) {
    Bench bench; // its show has no file
    ShowDocument document(bench.app);
    RdmEdits edits(bench.app, document, nullptr);
    edits.set_access(RdmAccess::edit);
    EXPECT_EQ(bench.app.request().rdm, RdmAccess::read) << "nothing is open";
    EXPECT_EQ(edits.access(), RdmAccess::edit);
    edits.set_access(RdmAccess::off);
    EXPECT_EQ(bench.app.request().rdm, RdmAccess::off);
}

TEST(RdmBox, says_what_desks_know) {
    Bench bench;
    bench.open();
    QWidget window;
    Actions actions(window);
    RdmBox box(bench.app, actions, nullptr);
    box.show();
    settle();
    auto* const table = box.findChild<QTableWidget*>();
    EXPECT_FALSE(table->isVisible()) << "off";
    RdmNow now;
    now.access = RdmAccess::read;
    now.heads = {{0, "7ff0:00000001", true, 5, true},
                 {1, "7ff0:00000002", true, 0, false},
                 {2, "7ff0:00000003", false, 0, false}};
    now.messages = 5;
    now.refused = 1;
    bench.link.rdm.put(now);
    bench.link.on_news();
    settle();
    ASSERT_TRUE(table->isVisible());
    ASSERT_EQ(table->rowCount(), 3);
    EXPECT_EQ(table->item(0, 0)->text(), "Lamp 1");
    EXPECT_EQ(table->item(0, 2)->text(), "1.001");
    EXPECT_EQ(table->item(0, 4)->text(), "identifies itself");
    EXPECT_EQ(table->item(1, 4)->text(), "is found");
    EXPECT_EQ(table->item(2, 4)->text(), "waits");
    EXPECT_EQ(words_of(now, *bench.app.show()),
              "2 of 3 fixtures were found by a desk, 5 messages, 1 refused; Lamp 1 identifies itself");
}

} // namespace
} // namespace ghost::ui
