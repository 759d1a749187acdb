// SPDX-License-Identifier: Apache-2.0
// Contrast of the theme, by the formula of WCAG 2.1 (relative luminance, clause 1.4.3): 4.5:1 for all words
// that can be read, 3:1 for the ring of the focus.
#include "support/test_window.h"
#include "ui/widgets/theme.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFocusFrame>
#include <QMenuBar>
#include <QPalette>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <memory>

namespace ghost::ui {
namespace {

double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

TEST(Theme, the_formula_knows_black_on_white) {
    EXPECT_NEAR(contrast(Qt::black, Qt::white), 21, 1e-6);
    EXPECT_NEAR(contrast(QColor(119, 119, 119), Qt::white), 4.48, 0.01);
}

TEST(Theme, words_have_a_contrast_of_4_5_on_every_ground) {
    set_theme(*qApp);
    const QPalette palette = qApp->palette();
    using Role = QPalette::ColorRole;
    const std::pair<Role, Role> kPairs[] = {
        {QPalette::WindowText, QPalette::Window},      {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},     {QPalette::ButtonText, QPalette::Button},
        {QPalette::PlaceholderText, QPalette::Base},   {QPalette::HighlightedText, QPalette::Highlight},
        {QPalette::ToolTipText, QPalette::ToolTipBase}};
    for (const auto& [words, ground] : kPairs)
        EXPECT_GE(contrast(palette.color(words), palette.color(ground)), 4.5) << words << " on " << ground;
    // What is disabled need not be read, but here it says what there is.
    for (const auto& [words, ground] : {kPairs[0], kPairs[1], kPairs[3]})
        EXPECT_GE(
            contrast(palette.color(QPalette::Disabled, words), palette.color(QPalette::Disabled, ground)),
            4.5)
            << words << " on " << ground;
    for (const QColor& colour : {accent(), bad(), good(), faint()})
        for (const Role ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase})
            EXPECT_GE(contrast(colour, palette.color(ground)), 4.5) << colour.name().toStdString();
}

TEST(Theme, the_ring_of_the_focus_is_seen_on_every_ground) {
    set_theme(*qApp);
    for (const QPalette::ColorRole ground : {QPalette::Window, QPalette::Base, QPalette::Button})
        EXPECT_GE(contrast(accent(), qApp->palette().color(ground)), 3);
}

TEST(Theme, the_words_of_the_menus_stand_at_the_height_of_what_stands_beside_them) {
    set_theme(*qApp);
    QMenuBar bar;
    QAction* const word = bar.addAction("Show");
    auto* const beside = new QComboBox(&bar);
    bar.setCornerWidget(beside);
    bar.resize(600, bar.sizeHint().height());
    bar.show();
    settle();
    EXPECT_NEAR(bar.actionGeometry(word).center().y(), beside->geometry().center().y(), 1);
}

TEST(Theme, a_button_that_is_on_is_seen_to_be) {
    set_theme(*qApp);
    for (const bool is_tool : {true, false}) {
        const std::unique_ptr<QAbstractButton> button(is_tool ? static_cast<QAbstractButton*>(new QToolButton)
                                                              : new QPushButton);
        button->setCheckable(true);
        button->resize(60, 24);
        const auto differs = [&](const QImage& one, const QImage& other) {
            int pixels = 0;
            for (int y = 0; y < one.height(); ++y)
                for (int x = 0; x < one.width(); ++x)
                    pixels += contrast(one.pixelColor(x, y), other.pixelColor(x, y)) >= 3 ? 1 : 0;
            return pixels;
        };
        const QImage off = button->grab().toImage();
        button->setChecked(true);
        EXPECT_GE(differs(button->grab().toImage(), off), 100) << "a line round it, at least";
    }
}

// A box of buttons is no larger than they are.
TEST(Theme, the_ring_of_the_focus_is_whole_round_the_buttons_of_a_dialog) {
    set_theme(*qApp);
    QDialog dialog;
    auto* const layout = new QVBoxLayout(&dialog);
    auto* const box = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, &dialog);
    layout->addWidget(box);
    dialog.show();
    QFocusFrame ring(&dialog);
    ring.setWidget(box->button(QDialogButtonBox::Save));
    settle();
    ASSERT_TRUE(ring.isVisible());
    EXPECT_EQ(ring.visibleRegion().boundingRect(), ring.rect());
}

TEST(Theme, the_buttons_of_a_panel_are_as_fine_as_a_display_at_scale_2) {
    set_theme(*qApp);
    for (const QStyle::StandardPixmap kind :
         {QStyle::SP_TitleBarNormalButton, QStyle::SP_TitleBarCloseButton}) {
        const QList<QSize> sizes = qApp->style()->standardIcon(kind).availableSizes();
        EXPECT_TRUE(std::any_of(sizes.begin(), sizes.end(), [](QSize size) { return size.width() >= 32; }));
    }
}

// Arrows of what finds no room in a line are light on dark.
TEST(Theme, the_arrows_for_more_are_seen) {
    set_theme(*qApp);
    for (const QStyle::StandardPixmap kind :
         {QStyle::SP_ToolBarHorizontalExtensionButton, QStyle::SP_ToolBarVerticalExtensionButton}) {
        const QImage arrows = qApp->style()->standardIcon(kind).pixmap(16, 16).toImage();
        int light = 0;
        for (int y = 0; y < arrows.height(); ++y)
            for (int x = 0; x < arrows.width(); ++x) {
                const QColor pixel = arrows.pixelColor(x, y);
                light +=
                    pixel.alpha() > 128 && contrast(pixel, qApp->palette().color(QPalette::Window)) >= 4.5;
            }
        EXPECT_GT(light, 10);
    }
}

} // namespace
} // namespace ghost::ui
