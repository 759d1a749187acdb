// SPDX-License-Identifier: Apache-2.0
// Paperwork and cue book from the window: where they go, what the command is given, what is seen of them.
#include "show/show.h"
#include "support/test_window.h"
#include "ui/language/language.h"
#include "ui/window/private/print_dialog.h"
#include "ui/window/window.h"

#include <QDir>
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

} // namespace
} // namespace ghost::ui
