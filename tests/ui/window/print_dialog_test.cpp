// SPDX-License-Identifier: Apache-2.0
// Paperwork and cue book from the window: where they go, what the command is given, what is seen of them.
#include "show/show.h"
#include "support/test_window.h"
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

} // namespace
} // namespace ghost::ui
