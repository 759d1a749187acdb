// SPDX-License-Identifier: Apache-2.0
// What stands in Export: of which camera, and from when to when.
#include "support/test_desk.h"
#include "ui/panels/export_panel.h"

namespace ghost::ui {
namespace {

struct Exports : Desk {
    Exports() {
        open();
        panel.show();
    }
    QComboBox* box(const QString& name) {
        for (QComboBox* const one : panel.findChildren<QComboBox*>())
            if (one->accessibleName() == name) return one;
        return nullptr;
    }
    QDoubleSpinBox* number(const QString& name) {
        for (QDoubleSpinBox* const one : panel.findChildren<QDoubleSpinBox*>())
            if (one->accessibleName() == name) return one;
        return nullptr;
    }
    QWidget widget;
    Actions actions{widget};
    ExportPanel panel{app, actions, nullptr};
};

TEST(ExportPanel, a_chosen_camera_stays_chosen_under_another_name) {
    Exports exports;
    for (const char* const name : {"Camera of pictures", "Camera to bake"}) {
        QComboBox* const box = exports.box(name);
        ASSERT_TRUE(box) << name;
        box->setCurrentText("front");
        ASSERT_EQ(box->currentIndex(), 1);
    }
    ASSERT_TRUE(exports.edit.rename_camera("front", "Balcony").ok());
    exports.follow();
    for (const char* const name : {"Camera of pictures", "Camera to bake"})
        EXPECT_EQ(exports.box(name)->currentText(), "Balcony") << name;
}

TEST(ExportPanel, a_film_of_another_show_begins_at_its_beginning) {
    Exports exports;
    QDoubleSpinBox* const from = exports.number("Begin of the film");
    ASSERT_TRUE(from);
    from->setValue(120);
    ASSERT_TRUE(exports.edit.keep_camera("Second").ok());
    exports.follow();
    EXPECT_EQ(from->value(), 120) << "an edit";
    exports.open();
    EXPECT_EQ(from->value(), 0);
}

} // namespace
} // namespace ghost::ui
