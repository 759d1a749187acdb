// SPDX-License-Identifier: Apache-2.0
// The rows of the fixture list: what they say, which of them are listed, and where that goes which is typed.
#include "support/test_window.h"
#include "ui/model/fixture_list.h"

#include <array>

namespace ghost::ui {
namespace {

struct Listed {
    explicit Listed(Opened opened) {
        filter.setSourceModel(&list);
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    std::vector<std::string> column(int which) const {
        std::vector<std::string> rows;
        for (int row = 0; row < filter.rowCount(); ++row)
            rows.push_back(filter.index(row, which).data().toString().toStdString());
        return rows;
    }

    // Each of the four lamps of its own brightness.
    void shine() {
        RigNow rig;
        rig.fixtures.resize(4);
        for (std::size_t i = 0; i < 4; ++i) rig.fixtures[i].dimmer = std::array{1.0f, 0.05f, 0.4f, 0.0f}[i];
        link.rig.put(rig);
        link.on_news();
        settle();
    }

    Link link;
    AppModel app{link};
    FixtureList list{app, nullptr};
    FixtureFilter filter{nullptr};
};
using Texts = std::vector<std::string>;

TEST(FixtureList, rows_have_the_order_of_the_show) {
    const Listed listed(four_lamps());
    EXPECT_EQ(listed.column(FixtureList::name), (Texts{"Lamp 1", "Lamp 2", "Lamp 3", "Lamp 4"}));
    EXPECT_EQ(listed.column(FixtureList::patch), (Texts{"1.001", "1.017", "1.033", "1.049"}));
    EXPECT_EQ(listed.column(FixtureList::x), (Texts{"-3", "-1", "1", "3"}));
    EXPECT_EQ(listed.column(FixtureList::level), (Texts{"0 %", "0 %", "0 %", "0 %"}))
        << "dark until news come";
}

TEST(FixtureList, numbers_are_sorted_by_what_they_are) {
    Opened opened = four_lamps();
    scene::Show show = *opened.show;
    const char* const names[] = {"Lamp 10", "lamp 9", "Lamp 1", "Spot"};
    for (std::size_t i = 0; i < 4; ++i) show.fixtures[i].name = names[i];
    show.fixtures[0].universe = 10;
    show.fixtures[1].universe = 9;
    show.fixtures[2].address = 0;
    show.fixtures[0].position_m.x = 12.5f;
    show.fixtures[3].position_m.x = -10;
    opened.show = std::make_shared<const scene::Show>(show);
    Listed listed(std::move(opened));
    listed.shine();
    listed.filter.sort(FixtureList::name);
    EXPECT_EQ(listed.column(FixtureList::name), (Texts{"Lamp 1", "lamp 9", "Lamp 10", "Spot"}));
    listed.filter.sort(FixtureList::patch);
    EXPECT_EQ(listed.column(FixtureList::patch), (Texts{"1.049", "9.017", "10.001", "none"}));
    listed.filter.sort(FixtureList::level, Qt::DescendingOrder);
    EXPECT_EQ(listed.column(FixtureList::level), (Texts{"100 %", "40 %", "5 %", "0 %"}));
    listed.filter.sort(FixtureList::x);
    EXPECT_EQ(listed.column(FixtureList::x), (Texts{"-10", "-1", "1", "12.5"}));
    listed.filter.sort(-1);
    EXPECT_EQ(listed.column(FixtureList::name), (Texts{"Lamp 10", "lamp 9", "Lamp 1", "Spot"}));
}

TEST(FixtureList, search_and_group_both_hold) {
    Listed listed(four_lamps());
    listed.filter.show_only(std::set<std::size_t>{1, 3});
    EXPECT_EQ(listed.column(FixtureList::name), (Texts{"Lamp 2", "Lamp 4"}));
    listed.filter.setFilterFixedString("lamp 4");
    EXPECT_EQ(listed.column(FixtureList::name), Texts{"Lamp 4"});
    listed.filter.setFilterFixedString("033"); // of an address, and not of this group
    EXPECT_EQ(listed.column(FixtureList::name), Texts{});
    listed.filter.show_only(std::nullopt);
    EXPECT_EQ(listed.column(FixtureList::name), Texts{"Lamp 3"});
}

TEST(FixtureList, what_is_wrong_or_set_by_hand_is_marked_in_its_cell_alone) {
    Opened opened = four_lamps();
    scene::Show show = *opened.show;
    show.fixtures[0].address = 0;
    opened.show = std::make_shared<const scene::Show>(show);
    Listed listed(std::move(opened));
    Look look = listed.app.look();
    look.fixtures[2].intensity = 1;
    listed.app.set_look(look, "intensity");
    const auto marked = [&](int role) {
        std::set<std::pair<int, int>> cells;
        for (int row = 0; row < listed.list.rowCount(); ++row)
            for (int column = 0; column < FixtureList::kColumns; ++column)
                if (listed.list.index(row, column).data(role).toBool()) cells.insert({row, column});
        return cells;
    };
    EXPECT_EQ(marked(FixtureList::kIsByHand), (std::set<std::pair<int, int>>{{2, FixtureList::level}}));
    EXPECT_EQ(marked(FixtureList::kIsWrong), (std::set<std::pair<int, int>>{{0, FixtureList::patch},
                                                                            {0, FixtureList::name},
                                                                            {0, FixtureList::type},
                                                                            {1, FixtureList::name},
                                                                            {1, FixtureList::type},
                                                                            {2, FixtureList::name},
                                                                            {2, FixtureList::type},
                                                                            {3, FixtureList::name},
                                                                            {3, FixtureList::type}}))
        << "these lamps have no file";
}

TEST(FixtureList, what_is_typed_goes_to_the_selected_or_else_to_its_row) {
    Listed listed(four_lamps());
    std::vector<std::pair<int, QString>> edits;
    listed.list.edit = [&](FixtureList::Column column, const QString& words) {
        edits.emplace_back(column, words);
        return words != "no";
    };
    listed.app.select({1, 2});
    EXPECT_TRUE(listed.list.setData(listed.list.index(2, FixtureList::name), " Spot ", Qt::EditRole));
    EXPECT_EQ(listed.app.selection(), (std::set<std::size_t>{1, 2}));
    EXPECT_FALSE(listed.list.setData(listed.list.index(3, FixtureList::patch), "no", Qt::EditRole));
    EXPECT_EQ(listed.app.selection(), std::set<std::size_t>{3});
    EXPECT_FALSE(listed.list.setData(listed.list.index(3, FixtureList::name), "Lamp 4", Qt::EditRole));
    EXPECT_EQ(edits,
              (std::vector<std::pair<int, QString>>{{FixtureList::name, "Spot"}, {FixtureList::patch, "no"}}))
        << "the same words are no edit";
}

TEST(FixtureList, what_is_typed_although_it_stood_there_goes_to_those_that_have_something_else) {
    Listed listed(four_lamps()); // X is -3, -1, 1, 3
    QStringList edits;
    listed.list.edit = [&](FixtureList::Column, const QString& words) {
        edits << words;
        return true;
    };
    const auto type = [&](int row, int column, const char* words) {
        listed.list.setData(listed.list.index(row, column), QString(words), FixtureList::kTyped);
    };
    type(0, FixtureList::x, "-3");
    EXPECT_TRUE(edits.isEmpty()) << "alone it is no edit";
    listed.app.select({0, 2});
    type(0, FixtureList::x, "-3");
    EXPECT_EQ(edits, QStringList{"-3"});
    type(0, FixtureList::z, "4");
    type(0, FixtureList::name, "Lamp 1");
    type(3, FixtureList::x, "3");
    EXPECT_EQ(edits.size(), 1) << "all have it, it is a name, or the row is not one of them";
    EXPECT_EQ(listed.app.selection(), (std::set<std::size_t>{0, 2}));
}

// After an edit the show is read again, which takes as long as the machine is busy.
TEST(FixtureList, a_file_that_is_not_read_yet_is_not_one_that_cannot_be_read) {
    Listed listed(four_lamps()); // without types
    EXPECT_EQ(listed.column(FixtureList::type)[0], "file cannot be read");
    const auto text = std::make_shared<const std::string>("edited");
    listed.app.put_edit(text, *listed.app.show(), {}, {});
    EXPECT_EQ(listed.column(FixtureList::type)[0], "file is being read");
    Opened done = listed.app.opened();
    done.text = text;
    done.is_edit = true;
    listed.link.opened.put(std::move(done));
    listed.link.on_news();
    settle();
    EXPECT_EQ(listed.column(FixtureList::type)[0], "file cannot be read");
}

// An edit is listed at once; what is said of the rig is of the show before until it is read.
TEST(FixtureList, levels_stay_with_their_fixtures_while_an_edit_is_read) {
    Listed listed(four_lamps());
    listed.shine();
    scene::Show show = *listed.app.show();
    show.fixtures.insert(show.fixtures.begin() + 1, show.fixtures[0]);
    show.fixtures[1].name = "Lamp 5";
    const auto text = std::make_shared<const std::string>("edited");
    listed.app.put_edit(text, show, {}, {});
    const Texts levels{"100 %", "0 %", "5 %", "40 %", "0 %"};
    EXPECT_EQ(listed.column(FixtureList::level), levels);
    listed.shine();
    EXPECT_EQ(listed.column(FixtureList::level), levels);
    show.fixtures[2].name = "Other";
    listed.app.put_edit(std::make_shared<const std::string>("again"), show, {}, {});
    EXPECT_EQ(listed.column(FixtureList::level), levels) << "one that was renamed";
}

} // namespace
} // namespace ghost::ui
