// SPDX-License-Identifier: Apache-2.0
// The panel In browsers: what listens, which address is shown, control, sending away.
#include "support/test_window.h"
#include "ui/panels/browser_panel.h"
#include "ui/window/window.h"
#include "web/browsers.h"

#include <QDockWidget>
#include <QPushButton>

namespace ghost::ui {
namespace {

struct WithBrowsers {
    WithBrowsers() {
        window.show();
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    std::string error_of(const QString& line) {
        const Result<void> done = window.actions().run(line);
        settle();
        return done.ok() ? "" : done.error().text();
    }
    QString address() {
        for (const QLineEdit* one : panel()->findChildren<QLineEdit*>())
            if (one->accessibleName() == "Address with its secret") return one->text();
        return {};
    }
    BrowserPanel* panel() { return window.findChild<BrowserPanel*>(); }
    QAbstractButton* button(const QString& text) {
        for (QAbstractButton* one : panel()->findChildren<QAbstractButton*>())
            if (one->text() == text) return one;
        return nullptr;
    }
    void click(const QString& text) {
        QAbstractButton* const one = button(text);
        ASSERT_TRUE(one) << text.toStdString();
        one->click();
        settle();
    }

    Link link;
    web::Browsers browsers{link};
    Window window{link, {.remembers = false, .width = 1100, .height = 800, .browsers = &browsers}};
};

TEST(BrowserPanel, nothing_listens_until_it_is_said) {
    WithBrowsers in;
    EXPECT_EQ(in.browsers.server(), nullptr);
    EXPECT_FALSE(in.panel()->isVisible()) << "the picture first";
    EXPECT_EQ(in.error_of("in-browsers"), "");
    EXPECT_TRUE(in.panel()->isVisible());
    EXPECT_EQ(in.browsers.server(), nullptr) << "to look at the panel lets nobody in";
    EXPECT_NE(in.error_of("browsers-away").find("nothing listens"), std::string::npos);
    for (const char* wrong : {"browsers", "browsers 0", "browsers here:8010", "browsers 1.2.3:8010",
                              "browsers 65536", "browsers 1.2.3.256:8010", "browsers on"})
        EXPECT_NE(in.error_of(wrong), "") << wrong;
    EXPECT_EQ(in.browsers.server(), nullptr);
}

TEST(BrowserPanel, lets_in_allows_control_and_sends_away) {
    WithBrowsers in;
    EXPECT_EQ(in.error_of("in-browsers"), "");
    // A port that is free now; another program may take it meanwhile, so some are tried.
    for (int port = 28010; port < 28060 && !in.browsers.server(); ++port)
        (void)in.error_of(QString("browsers 127.0.0.1:%1").arg(port));
    ASSERT_TRUE(in.browsers.server());
    wait_ms(700); // the panel looks twice a second
    const web::Keys keys = in.browsers.server()->keys();
    EXPECT_EQ(keys.control_token, "");
    EXPECT_EQ(keys.digits.size(), 6u) << "while the panel is seen";
    EXPECT_TRUE(in.address().endsWith("#t=" + QString::fromStdString(keys.token)));

    in.click("Allow control");
    const std::string control = in.browsers.server()->keys().control_token;
    EXPECT_EQ(control.size(), 32u);
    EXPECT_TRUE(in.address().endsWith(QString::fromStdString(control)));
    in.click("Show the address with control");
    EXPECT_TRUE(in.address().endsWith(QString::fromStdString(keys.token)));
    in.click("Allow control");
    EXPECT_EQ(in.browsers.server()->keys().control_token, "");

    in.click("New token");
    const std::string second = in.browsers.server()->keys().token;
    EXPECT_NE(second, keys.token);
    in.click("Send all away");
    EXPECT_NE(in.browsers.server()->keys().token, second);
    EXPECT_EQ(in.error_of("panel-browsers off"), "");
    EXPECT_EQ(in.browsers.server()->keys().digits, "") << "nobody sees them";
    in.click("End it");
    EXPECT_EQ(in.browsers.server(), nullptr);
}

} // namespace
} // namespace ghost::ui
