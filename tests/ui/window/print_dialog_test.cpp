// SPDX-License-Identifier: Apache-2.0
// Paperwork and cue book from the window: where they go, what the command is given, what is seen of them.
#include "book/paper_pages.h"
#include "disk/files.h"
#include "show/show.h"
#include "support/test_window.h"
#include "ui/language/language.h"
#include "ui/window/private/print_dialog.h"
#include "ui/window/window.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QStyleOptionComboBox>
#include <QTemporaryDir>

namespace ghost::ui {
namespace {

// The folder of the show is the working directory.
struct Printing {
    explicit Printing(const char* file = "show.toml") {
        QDir::setCurrent(place.path());
        window.show();
        open(file);
    }
    ~Printing() { QDir::setCurrent(before); }
    void open(const char* file) {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->folder.clear();
        show->file = file;
        opened.show = show;
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    PrintDialog& dialog(const char* action) {
        EXPECT_TRUE(window.actions().run(action).ok()) << action;
        settle();
        return *window.findChild<PrintDialog*>(action);
    }
    // By its name for screen readers.
    template <class Widget>
    static Widget* named(const PrintDialog& dialog, const QString& name) {
        for (Widget* const one : dialog.findChildren<Widget*>())
            if (one->accessibleName() == name) return one;
        ADD_FAILURE() << name.toStdString();
        return nullptr;
    }
    static QLineEdit& folder_of(const PrintDialog& dialog) {
        return *named<QLineEdit>(dialog, "Folder to make");
    }

    QString before = QDir::currentPath();
    QTemporaryDir place;
    Link link;
    Window window{link, WindowOptions{.remembers = false, .width = 900, .height = 600}};
};

TEST(PrintDialog, opens_for_a_show_by_its_bare_name) {
    Printing in("tour.mvr");
    const QDir here(QDir::currentPath());
    EXPECT_EQ(in.folder_of(in.dialog("paperwork")).text(), here.filePath("paper"));
    EXPECT_EQ(in.folder_of(in.dialog("cue-book")).text(), here.filePath("book"));
}

TEST(PrintDialog, says_where_what_is_made_is_seen_until_something_is) {
    Printing in;
    for (const char* const action : {"paperwork", "cue-book"}) {
        const PrintDialog& dialog = in.dialog(action);
        int says = 0;
        for (const QLabel* const one : dialog.findChildren<QLabel*>())
            says += one->isVisible() && one->text() == "What is made is shown here." ? 1 : 0;
        EXPECT_EQ(says, 1) << action;
        for (const QComboBox* const one : dialog.findChildren<QComboBox*>())
            EXPECT_FALSE(one->isVisible() && one->count() == 0) << "a list of nothing";
    }
}

TEST(PrintDialog, a_book_has_a_language_units_and_marks) {
    Printing in;
    const PrintDialog& book = in.dialog("cue-book");
    const auto choose = [&](const char* name, const QString& value) {
        QComboBox& box = *in.named<QComboBox>(book, name);
        box.setCurrentIndex(box.findData(value));
    };
    EXPECT_TRUE(book.options().contains("--language \"en\" --units \"metric\""))
        << book.options().toStdString();
    choose("Language", "de");
    choose("Units", "imperial");
    EXPECT_TRUE(book.options().contains("--language \"de\" --units \"imperial\""))
        << book.options().toStdString();
    QLineEdit& marks = *in.named<QLineEdit>(book, "File of the marks");
    EXPECT_FALSE(marks.isEnabled());
    marks.setText("cues.csv");
    EXPECT_FALSE(book.options().contains("cues.csv"));
    choose("Entries", "--marks");
    EXPECT_TRUE(marks.isEnabled());
    EXPECT_TRUE(book.options().contains("--marks \"cues.csv\"")) << book.options().toStdString();
}

TEST(PrintDialog, paper_has_the_choices_of_plan_and_focus_charts) {
    Printing in;
    const PrintDialog& paper = in.dialog("paperwork");
    QComboBox& scale = *in.named<QComboBox>(paper, "Scale");
    EXPECT_GE(scale.findData("1:50"), 0);
    QComboBox& units = *in.named<QComboBox>(paper, "Units");
    units.setCurrentIndex(units.findData("imperial"));
    EXPECT_LT(scale.findData("1:50"), 0);
    scale.setCurrentIndex(scale.findData("1:48"));
    QLineEdit& section = *in.named<QLineEdit>(paper, "Where the section is cut");
    section.setText("-2.5");
    in.named<QLineEdit>(paper, "Date in the title block")->setText("1 May");
    QComboBox& moment = *in.named<QComboBox>(paper, "Moment of the focus charts");
    moment.addItem("Cue Blue", QStringList{"--cue", "Blue"});
    moment.setCurrentIndex(moment.count() - 1);
    EXPECT_FALSE(section.isEnabled());
    EXPECT_FALSE(paper.options().contains("--section"));
    EXPECT_FALSE(paper.options().contains("--cue"));
    for (QCheckBox* const box : paper.findChildren<QCheckBox*>()) box->setChecked(true);
    EXPECT_TRUE(section.isEnabled());
    for (const char* part : {"--scale \"1:48\"", "--section \"-2.5\"", "--date \"1 May\"", "--cue \"Blue\""})
        EXPECT_TRUE(paper.options().contains(part)) << part << ": " << paper.options().toStdString();
}

TEST(PrintDialog, a_book_is_seen_from_where_the_cues_put_it_or_from_a_camera_by_name) {
    Printing in;
    const PrintDialog& book = in.dialog("cue-book");
    QComboBox& camera = *in.named<QComboBox>(book, "Camera");
    EXPECT_EQ(camera.itemText(0), "Where the cues put the picture");
    EXPECT_FALSE(book.options().contains("--view")) << book.options().toStdString();
    ASSERT_EQ(camera.count(), 1 + static_cast<int>(in.window.app().show()->cameras.size()));
    const QString first = QString::fromStdString(in.window.app().show()->cameras.front().name);
    camera.setCurrentIndex(camera.findData(first));
    EXPECT_TRUE(book.options().contains("--view \"" + first + "\"")) << book.options().toStdString();
    in.open("show.toml");
    EXPECT_EQ(camera.currentData(), first) << "an edit leaves what is chosen";
}

TEST(PrintDialog, a_german_window_makes_german_books) {
    set_language("de");
    {
        Printing in;
        EXPECT_TRUE(in.dialog("cue-book").options().contains("--language \"de\""));
    }
    set_language("en");
}

TEST(PrintDialog, blanks_in_a_value_stay) {
    Printing in;
    const PrintDialog& book = in.dialog("cue-book");
    in.named<QLineEdit>(book, "An older show, plot or book to compare with")->setText("last  night/tour  a");
    const Result<QStringList> words = split_line(book.options());
    ASSERT_TRUE(words.ok());
    EXPECT_TRUE(words->contains("last  night/tour  a")) << book.options().toStdString();
}

TEST(PrintDialog, a_folder_that_was_typed_stays) {
    Printing in;
    QLineEdit& folder = in.folder_of(in.dialog("paperwork"));
    in.open("tour/show.toml");
    EXPECT_TRUE(folder.text().endsWith("tour/paper")) << folder.text().toStdString();
    folder.setText("mine");
    in.open("show.toml");
    EXPECT_EQ(folder.text(), "mine");
}

TEST(PrintDialog, says_in_plain_words_that_no_folder_is_named) {
    Printing in;
    const PrintDialog& paper = in.dialog("paperwork");
    in.folder_of(paper).clear();
    for (QPushButton* const button : paper.findChildren<QPushButton*>())
        if (button->text() == "Make") button->click();
    QStringList said;
    for (const QLabel* const label : paper.findChildren<QLabel*>()) said << label->text();
    EXPECT_TRUE(said.contains("Say in which folder it is to lie."));
    EXPECT_TRUE(in.window.app().jobs().all().empty());
}

// What was said of a show that is not saved does not outlive its saving, which works from there.
TEST(PrintDialog, ctrl_s_saves_the_show_and_what_was_said_of_it_goes) {
    Printing in;
    const std::filesystem::path file = std::filesystem::path(in.place.path().toStdString()) / "show.toml";
    ASSERT_TRUE(write_file_atomic(file, "[show]\n[[camera]]\nname = \"front\"\n").ok());
    in.open(file.c_str());
    PrintDialog& book = in.dialog("cue-book");
    const auto says = [&](const QString& words) {
        const auto labels = book.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* one) { return one->text().contains(words); });
    };
    ASSERT_TRUE(in.window.actions().run("clouds 0.5").ok());
    for (QPushButton* const button : book.findChildren<QPushButton*>())
        if (button->text() == "Make") button->click();
    ASSERT_TRUE(says("save the show first"));
    QAction* const save = in.window.actions().item("save");
    ASSERT_TRUE(book.actions().contains(save)) << "Ctrl+S is dead there";
    save->trigger();
    settle();
    EXPECT_FALSE(says("save the show first"));
    EXPECT_TRUE(says("Saved: show.toml"));
    EXPECT_NE(read_text_file(file, 1 << 16)->find("[haze]"), std::string::npos);
}

TEST(PrintDialog, nothing_in_it_is_cut) {
    for (const char* const words : {"en", "de"}) {
        set_language(words);
        Printing in;
        for (const char* const name : {"paperwork", "cue-book"}) {
            PrintDialog& dialog = in.dialog(name);
            settle();
            for (const QComboBox* const box : dialog.findChildren<QComboBox*>()) {
                if (!box->isVisible()) continue;
                int wide = 0;
                for (int i = 0; i < box->count(); ++i)
                    wide = std::max(wide, box->fontMetrics().horizontalAdvance(box->itemText(i)));
                QStyleOptionComboBox option;
                option.initFrom(box);
                const QRect room = box->style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                                QStyle::SC_ComboBoxEditField, box);
                EXPECT_LE(wide, room.width())
                    << words << " " << name << " " << box->accessibleName().toStdString();
            }
            for (const QLineEdit* const line : dialog.findChildren<QLineEdit*>()) {
                if (!line->isVisible() || line->placeholderText().isEmpty()) continue;
                EXPECT_LE(line->fontMetrics().horizontalAdvance(line->placeholderText()) + 8, line->width())
                    << words << " " << name << " " << line->placeholderText().toStdString();
            }
        }
    }
    set_language("en");
}

// 1366x768 at twice the size, less a frame and a title.
TEST(PrintDialog, fits_a_small_display) {
    for (const char* const words : {"en", "de"}) {
        set_language(words);
        Printing in;
        for (const char* const name : {"paperwork", "cue-book"}) {
            PrintDialog& dialog = in.dialog(name);
            const QSize least = dialog.minimumSizeHint();
            EXPECT_LE(least.width(), 643) << name << " " << words;
            EXPECT_LE(least.height(), 344) << name << " " << words;
            dialog.resize(643, 344);
            settle();
            for (const QPushButton* const button : dialog.findChildren<QPushButton*>()) {
                if (button->visibleRegion().isEmpty()) continue; // one that is scrolled to
                const QRect place(button->mapTo(&dialog, QPoint()), button->size());
                EXPECT_TRUE(dialog.rect().contains(place)) << name << " " << button->text().toStdString();
            }
        }
    }
    set_language("en");
}

TEST(PrintPreview, names_tables_as_the_page_does_and_says_what_they_leave_empty) {
    QTemporaryDir place;
    scene::Paper paper;
    paper.style = {scene::Language::german, scene::Units::metric};
    paper.tables = {{"patch", "Belegung & Freies", {{"Adresse"}}, {{{"1.1"}}}, {"'Spot <1>': \"leer\""}},
                    {"instruments", "Geräteliste", {}, {}, {}}};
    const std::filesystem::path folder = place.path().toStdString();
    for (const scene::PaperTable& table : paper.tables)
        ASSERT_TRUE(write_file_atomic(folder / (table.file + ".csv"), scene::csv_of(table)).ok());
    ASSERT_TRUE(write_file_atomic(folder / "focus.csv", std::string_view("a\r\n")).ok());
    ASSERT_TRUE(
        write_file_atomic(folder / "index.html", scene::html_of(paper, scene::PaperSize::a4, {})).ok());
    const std::vector<PrintedTable> tables = printed_tables(place.path());
    ASSERT_EQ(tables.size(), 3u);
    EXPECT_EQ(tables[0].title, "Belegung & Freies");
    EXPECT_EQ(tables[0].unknown, QStringList{"'Spot <1>': \"leer\""});
    EXPECT_EQ(tables[1].title, "Geräteliste");
    EXPECT_TRUE(tables[1].unknown.isEmpty());
    EXPECT_EQ(tables[2].title, "Focus charts");
    const PrintedRows rows = printed_rows(tables[0].file);
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(rows.rows[1], QStringList{"1.1"});
    EXPECT_TRUE(rows.is_whole);
}

TEST(PrintPreview, says_why_there_is_nothing_of_a_book) {
    QTemporaryDir place;
    const std::filesystem::path file = std::filesystem::path(place.path().toStdString()) / "book.json";
    ASSERT_TRUE(
        write_file_atomic(file, std::string_view(R"({"entries": [{"name": "One"}], "unknown": ["no cues"]})"))
            .ok());
    EXPECT_EQ(printed_book(place.path()).entries.size(), 1);
    EXPECT_EQ(printed_book(place.path()).unknown, QStringList{"no cues"});
    ASSERT_TRUE(write_file_atomic(file, std::string_view("{")).ok());
    EXPECT_TRUE(printed_book(place.path()).unknown.first().contains("cannot be read"));
    ASSERT_TRUE(write_file_atomic(file, "{\"entries\": []" + std::string(4 << 20, ' ') + "}").ok());
    EXPECT_TRUE(printed_book(place.path()).unknown.first().contains("larger than what is shown"));
}

} // namespace
} // namespace ghost::ui
