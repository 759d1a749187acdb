// SPDX-License-Identifier: Apache-2.0
// The palettes in the programmer: the name of one that was just stored is typed while the engine reads the
// show with it.
#include "support/test_desk.h"

#include "ui/panel_parts/palette_box.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>

namespace ghost::ui {
namespace {

struct Palettes : Desk {
    Palettes() {
        add_palette_actions(actions, palettes);
        open();
        box.show();
        app.select({0, 1});
        Look look;
        look.fixtures[0].colour = look.fixtures[1].colour = glm::vec3(1, 0.5f, 0);
        app.set_look(look, "colour");
        press("Colour");
    }
    // By its words, or by what it is called to who does not see it.
    void press(const QString& name) {
        for (QAbstractButton* const one : box.findChildren<QAbstractButton*>())
            if (one->text() == name || one->accessibleName() == name) one->click();
    }
    void key(QWidget& widget, int which) {
        for (const QEvent::Type type : {QEvent::ShortcutOverride, QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent event(type, which, Qt::NoModifier);
            QCoreApplication::sendEvent(&widget, &event);
        }
        settle();
    }

    QWidget window;
    Actions actions{window};
    PaletteList palettes{app, document};
    PaletteBox box{app, palettes, actions, nullptr};
};

TEST(PaletteBox, who_types_the_name_of_a_new_one_goes_on_while_it_is_read) {
    Palettes in;
    in.press("Store palette");
    ASSERT_EQ(in.palettes.all().size(), 1u);
    const QPointer<QLineEdit> field = in.box.list()->findChild<QLineEdit*>();
    ASSERT_TRUE(field && field->isVisible());
    field->setText("Front");
    in.follow(); // the engine has it
    ASSERT_TRUE(field && field->isVisible());
    EXPECT_EQ(field->text(), "Front");
    in.key(*field, Qt::Key_Return);
    EXPECT_EQ(in.palettes.all()[0].name, "Front");
    in.follow();
    ASSERT_EQ(in.box.list()->count(), 1);
    EXPECT_EQ(in.box.list()->item(0)->text(), "Front");
    EXPECT_EQ(in.box.list()->item(0)->data(Qt::UserRole).toString(), "Front");
}

TEST(PaletteBox, another_list_and_another_colour_are_shown) {
    Palettes in;
    in.press("Store palette");
    const QString tip = in.box.list()->item(0)->toolTip();
    Look look = in.app.look();
    look.fixtures[1].colour = glm::vec3(0, 0, 1); // each has its own now
    in.app.set_look(look, "colour");
    ASSERT_TRUE(in.actions.run("palette-store colour \"Colour 1\"").ok());
    EXPECT_NE(in.box.list()->item(0)->toolTip(), tip);
    in.box.list()->item(0)->setText(""); // refused
    settle();
    EXPECT_EQ(in.box.list()->item(0)->text(), "Colour 1");
    in.press("Position");
    EXPECT_EQ(in.box.list()->count(), 0);
}

} // namespace
} // namespace ghost::ui
