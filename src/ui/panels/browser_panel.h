#pragma once
// SPDX-License-Identifier: Apache-2.0
// BrowserPanel: who may look on in a browser, and how he comes in: the network, an address as a QR code and
// in letters, six digits while the panel is seen, control and for whom, who looks on, and sending away.
// Window thread.

#include "ui/actions/actions.h"
#include "web/browsers.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QWidget>

class QVBoxLayout;

namespace ghost::ui {

// "browsers 0.0.0.0:8010", "browsers-control on" and so on: what the panel's buttons do.
void add_browser_actions(Actions& actions, web::Browsers& browsers);

// A QR code, dark on light with its quiet zone.
class QrField : public QWidget {
    Q_OBJECT
public:
    explicit QrField(QWidget* parent);
    void show_text(const QString& text); // empty: nothing is shown
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString text_;
};

class BrowserPanel : public QWidget {
    Q_OBJECT
public:
    BrowserPanel(web::Browsers& browsers, Actions& actions, QWidget* parent);

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void add_place(QVBoxLayout& layout);
    void add_way_in(QVBoxLayout& layout);
    void add_who(QVBoxLayout& layout);
    void choose_place();
    void refresh();
    void show_keys(web::Server& server);
    void show_lookers(const std::vector<web::Looker>& lookers);

    web::Browsers& browsers_;
    Actions& actions_;
    QComboBox* places_;
    QSpinBox* port_;
    QPushButton* listens_;
    QWidget* way_in_; // all that there is while something listens
    QrField* code_;
    QLineEdit* address_;
    QLabel* digits_;
    QCheckBox* control_;
    QPushButton* shows_control_;
    QLabel* who_;
    QTimer timer_;
    std::string control_token_;   // as it was seen last
    QElapsedTimer control_since_; // its address is shown for a while
    web::Server* digits_of_ = nullptr;
};

} // namespace ghost::ui
