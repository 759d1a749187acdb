// SPDX-License-Identifier: Apache-2.0
// What the window says by itself: of a desk in its status bar, of what ends with it, of a size that is none.
#include "support/test_window.h"
#include "ui/window/window.h"

#include "disk/files.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

namespace ghost::ui {
namespace {

struct Told {
    Told() {
        window.show();
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    // Universes 1, 2 ..: whether each is silent.
    void hear(const std::vector<bool>& silent) {
        RigNow rig = four_lit();
        rig.from_desk = true;
        for (const bool one : silent)
            rig.universes.at(static_cast<std::uint16_t>(rig.universes.list.size() + 1)).lost = one;
        link.rig.put(std::move(rig));
        link.on_news();
        settle();
    }
    bool says(const QString& words) {
        const auto labels = window.statusBar()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* one) { return one->text() == words; });
    }

    Link link;
    Window window{link, {.remembers = false, .width = 900, .height = 600}};
};

TEST(StatusBar, a_desk_that_is_silent_is_called_so) {
    Told told;
    told.hear({false});
    EXPECT_TRUE(told.says("A desk: 1 universe"));
    told.hear({true});
    EXPECT_TRUE(told.says("A desk that is silent: 1 universe"));
    told.hear({false, true, true});
    EXPECT_TRUE(told.says("A desk: 3 universes, 2 of them silent"));
}

TEST(Export, a_size_that_is_none_is_said_before_a_file_is_asked_for) {
    Told told;
    ASSERT_TRUE(told.window.actions().run("panel-export on").ok());
    settle();
    QComboBox* size = nullptr;
    for (QComboBox* const one : told.window.findChildren<QComboBox*>())
        if (one->accessibleName() == "Size of pictures") size = one;
    ASSERT_TRUE(size);
    bool asked = false; // the dialog would wait for ever
    QTimer closer;
    QObject::connect(&closer, &QTimer::timeout, [&] {
        if (auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
            asked = true;
            dialog->reject();
        }
    });
    closer.start(20);
    for (const QString& button : {QString("Still..."), QString("Film...")}) {
        told.window.statusBar()->clearMessage();
        size->setEditText("60");
        for (QPushButton* const one : told.window.findChildren<QPushButton*>())
            if (one->text() == button) one->click();
        EXPECT_FALSE(asked) << button.toStdString();
        EXPECT_TRUE(told.window.statusBar()->currentMessage().contains("size like 1920x1080"))
            << told.window.statusBar()->currentMessage().toStdString();
    }
    size->setEditText("1280x720");
    for (QPushButton* const one : told.window.findChildren<QPushButton*>())
        if (one->text() == "Still...") one->click();
    EXPECT_TRUE(asked);
    const auto done = told.window.actions().run("export-still /tmp/x.png 60");
    ASSERT_FALSE(done.ok());
    EXPECT_NE(done.error().text().find("neither a size"), std::string::npos) << done.error().text();
}

} // namespace
} // namespace ghost::ui
