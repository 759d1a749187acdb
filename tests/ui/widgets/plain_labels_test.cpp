// SPDX-License-Identifier: Apache-2.0
// Mark-up in names is shown as it is written, in labels and in tool tips.
#include "support/test_window.h"

#include "ui/widgets/plain_labels.h"

#include <QLabel>
#include <QToolTip>

namespace ghost::ui {
namespace {

const QString kName = "<b>Spot</b> <img src='file:///etc/passwd'>";

struct Filtered {
    Filtered() { qApp->installEventFilter(&filter); }
    ~Filtered() { qApp->removeEventFilter(&filter); }
    PlainLabels filter;
};

TEST(PlainLabels, a_tool_tip_is_plain) {
    const Filtered filtered;
    QWidget window;
    window.show();
    QToolTip::showText({10, 10}, kName, &window);
    int tips = 0;
    for (QWidget* const widget : QApplication::topLevelWidgets()) {
        if (!widget->inherits("QTipLabel")) continue;
        ++tips;
        EXPECT_EQ(static_cast<QLabel*>(widget)->text(), kName);
        EXPECT_EQ(static_cast<QLabel*>(widget)->textFormat(), Qt::PlainText);
    }
    EXPECT_EQ(tips, 1);
    QToolTip::hideText();
}

TEST(PlainLabels, a_label_is_plain_unless_it_says_that_it_is_rich) {
    const Filtered filtered;
    QLabel plain(kName), rich("<b>ours</b>");
    rich.setTextFormat(Qt::RichText);
    plain.show();
    rich.show();
    EXPECT_EQ(plain.textFormat(), Qt::PlainText);
    EXPECT_EQ(rich.textFormat(), Qt::RichText);
}

} // namespace
} // namespace ghost::ui
