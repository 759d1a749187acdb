// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/browser_panel.h"

#include "ui/language/language.h"
#include "ui/widgets/theme.h"
#include "web/invitation.h"
#include "web/qr.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr int kRefresh_ms = 500;
constexpr int kUsualPort = 8010;
constexpr int kCode_px = 190;
constexpr qint64 kControlShown_ms = 10 * 60 * 1000;

QString clock_text(double seconds) {
    const int whole = static_cast<int>(seconds);
    return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
}

Result<web::ServerOptions> options_from(const QString& place, web::ServerOptions options) {
    const QString host = place.contains(':') ? place.section(':', 0, 0) : "127.0.0.1";
    const auto parts = host.split('.');
    std::uint32_t address = 0;
    bool is_number = parts.size() == 4;
    for (const QString& part : parts) {
        bool ok = false;
        const unsigned byte = part.toUInt(&ok);
        is_number = is_number && ok && byte < 256;
        address = address << 8 | (byte & 255);
    }
    bool is_port = false;
    const unsigned port = place.section(':', -1).toUInt(&is_port);
    if (!is_number || !is_port || port == 0 || port > 65535)
        return Error{"'" + place.toStdString() + "', expected off, or a port like 8010 or 0.0.0.0:8010", ""};
    options.address = address;
    options.port = static_cast<std::uint16_t>(port);
    options.control = false;
    options.digits_now = false; // the panel shows them
    return options;
}

QLabel* small_label(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    return label;
}

} // namespace

void add_browser_actions(Actions& actions, web::Browsers& browsers) {
    const auto on_server = [&browsers](void (web::Server::*done)()) {
        return [&browsers, done](const QStringList&) -> Result<void> {
            if (!browsers.server()) return Error{"nothing listens to browsers: View, In browsers...", ""};
            (browsers.server()->*done)();
            return {};
        };
    };
    actions.add({"browsers",
                 "",
                 "browsers",
                 "",
                 "[ADDRESS:]PORT|off",
                 [&browsers](const QStringList& words) -> Result<void> {
                     if (words.value(0) == "off") {
                         browsers.close();
                         return {};
                     }
                     TRY(const web::ServerOptions options, options_from(words.value(0), browsers.options()));
                     return browsers.open(options);
                 },
                 {}});
    actions.add({"browsers-control",
                 "",
                 "browsers-control",
                 "",
                 "on|off",
                 [&browsers](const QStringList& words) -> Result<void> {
                     if (!browsers.server())
                         return Error{"nothing listens to browsers: View, In browsers...", ""};
                     browsers.server()->allow_control(words.value(0) == "on");
                     return {};
                 },
                 {}});
    actions.add(
        {"browsers-new-token", "", "browsers-new-token", "", "", on_server(&web::Server::renew_token), {}});
    actions.add({"browsers-away", "", "browsers-away", "", "", on_server(&web::Server::send_all_away), {}});
}

QrField::QrField(QWidget* parent) : QWidget(parent) {
    setFixedSize(sizeHint());
    setAccessibleName(translated("Browsers", "The address as a QR code"));
}

QSize QrField::sizeHint() const {
    return {kCode_px, kCode_px};
}

void QrField::show_text(const QString& text) {
    if (text == text_) return;
    text_ = text;
    update();
}

void QrField::paintEvent(QPaintEvent*) {
    constexpr int kQuiet = 4; // modules
    const auto code = web::qr_code(text_.toStdString());
    if (text_.isEmpty() || !code) return;
    QPainter painter(this);
    const int module_px = std::max(kCode_px / (code->side + 2 * kQuiet), 1);
    const int begin_px = (kCode_px - module_px * code->side) / 2;
    const int edge_px = kQuiet * module_px, whole_px = module_px * code->side + 2 * edge_px;
    painter.fillRect(begin_px - edge_px, begin_px - edge_px, whole_px, whole_px, Qt::white);
    for (int y = 0; y < code->side; ++y)
        for (int x = 0; x < code->side; ++x)
            if (code->is_dark(x, y))
                painter.fillRect(begin_px + x * module_px, begin_px + y * module_px, module_px, module_px,
                                 Qt::black);
}

BrowserPanel::BrowserPanel(web::Browsers& browsers, Actions& actions, QWidget* parent)
    : QWidget(parent), browsers_(browsers), actions_(actions) {
    auto* layout = new QVBoxLayout(this);
    add_place(*layout);
    way_in_ = new QWidget(this);
    auto* below = new QVBoxLayout(way_in_);
    below->setContentsMargins(0, 0, 0, 0);
    add_way_in(*below);
    add_who(*below);
    layout->addWidget(way_in_);
    layout->addStretch(1);
    timer_.setInterval(kRefresh_ms);
    connect(&timer_, &QTimer::timeout, this, &BrowserPanel::refresh);
    refresh();
}

void BrowserPanel::add_place(QVBoxLayout& layout) {
    auto* about = small_label(this);
    about->setText(translated(
        "Browsers", "Phones, tablets and laptops see the picture as it is drawn, and why a lamp is dark."));
    layout.addWidget(about);
    places_ = new QComboBox(this);
    places_->setAccessibleName(translated("Browsers", "Network in which browsers may look on"));
    port_ = new QSpinBox(this);
    port_->setRange(1024, 65535);
    port_->setValue(browsers_.options().port > 0 ? browsers_.options().port : kUsualPort);
    port_->setPrefix(translated("Browsers", "port "));
    port_->setAccessibleName(translated("Browsers", "TCP port"));
    layout.addWidget(places_);
    auto* row = new QHBoxLayout;
    listens_ = new QPushButton(this);
    connect(listens_, &QPushButton::clicked, this, [this] {
        if (browsers_.server())
            actions_.choose("browsers off");
        else
            choose_place();
        refresh();
    });
    row->addWidget(port_);
    row->addWidget(listens_, 1);
    layout.addLayout(row);
}

void BrowserPanel::add_way_in(QVBoxLayout& layout) {
    code_ = new QrField(way_in_);
    layout.addWidget(code_, 0, Qt::AlignHCenter);
    auto* row = new QHBoxLayout;
    address_ = new QLineEdit(way_in_);
    address_->setReadOnly(true);
    address_->setAccessibleName(translated("Browsers", "Address with its secret"));
    auto* copy = new QPushButton(translated("Browsers", "Copy"), way_in_);
    copy->setToolTip(translated("Browsers", "The address, to be sent to whom you let in"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(address_->text()); });
    row->addWidget(address_, 1);
    row->addWidget(copy);
    layout.addLayout(row);
    digits_ = small_label(way_in_);
    digits_->setTextFormat(Qt::RichText);
    digits_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout.addWidget(digits_);
    control_ = new QCheckBox(translated("Browsers", "Allow control"), way_in_);
    control_->setToolTip(translated(
        "Browsers",
        "An address of its own: who has it recalls looks, cues and cameras. A recalled look can be "
        "undone here. Off: whoever has it only looks on."));
    connect(control_, &QCheckBox::clicked, this, [this](bool on) {
        actions_.choose(QString("browsers-control ") + (on ? "on" : "off"));
        shows_control_->setChecked(on);
        refresh();
    });
    shows_control_ = new QPushButton(translated("Browsers", "Show the address with control"), way_in_);
    shows_control_->setCheckable(true);
    connect(shows_control_, &QPushButton::clicked, this, [this](bool on) {
        if (on) control_since_.restart();
        refresh();
    });
    layout.addWidget(control_);
    layout.addWidget(shows_control_);
    auto* plain = small_label(way_in_);
    plain->setText(
        translated("Browsers", "Plain HTTP: who listens to that network sees picture and secret."));
    plain->setStyleSheet("color: " + faint().name());
    layout.addWidget(plain);
}

void BrowserPanel::add_who(QVBoxLayout& layout) {
    who_ = small_label(way_in_);
    layout.addWidget(who_);
    auto* row = new QHBoxLayout;
    auto* token = new QPushButton(translated("Browsers", "New token"), way_in_);
    token->setToolTip(
        translated("Browsers", "Who looks on stays; nobody else comes in with the address that was"));
    connect(token, &QPushButton::clicked, this, [this] {
        actions_.choose("browsers-new-token");
        refresh();
    });
    auto* away = new QPushButton(translated("Browsers", "Send all away"), way_in_);
    away->setToolTip(translated("Browsers", "All lines end, and no address that was lets anybody in"));
    connect(away, &QPushButton::clicked, this, [this] {
        actions_.choose("browsers-away");
        refresh();
    });
    row->addWidget(token);
    row->addWidget(away);
    layout.addLayout(row);
}

void BrowserPanel::choose_place() {
    const auto address = places_->currentData().toUInt();
    actions_.choose(QString("browsers %1.%2.%3.%4:%5")
                        .arg(address >> 24)
                        .arg(address >> 16 & 255)
                        .arg(address >> 8 & 255)
                        .arg(address & 255)
                        .arg(port_->value()));
}

void BrowserPanel::showEvent(QShowEvent*) {
    const QVariant before = places_->currentData();
    places_->clear();
    for (const web::Place& place : web::places()) {
        const QString numbers = QString("%1.%2.%3.%4")
                                    .arg(place.address >> 24)
                                    .arg(place.address >> 16 & 255)
                                    .arg(place.address >> 8 & 255)
                                    .arg(place.address & 255);
        places_->addItem(said(place.name) + "  " + numbers, place.address);
    }
    const int index = places_->findData(before.isValid() ? before : QVariant(browsers_.options().address));
    places_->setCurrentIndex(std::max(index, 0));
    timer_.start();
    refresh();
}

void BrowserPanel::hideEvent(QHideEvent*) {
    timer_.stop();
    if (browsers_.server()) browsers_.server()->show_digits(false);
    digits_of_ = nullptr;
}

void BrowserPanel::refresh() {
    web::Server* const server = browsers_.server();
    listens_->setText(server ? translated("Browsers", "End it")
                             : translated("Browsers", "Let browsers look on"));
    places_->setEnabled(!server);
    port_->setEnabled(!server);
    way_in_->setVisible(server != nullptr);
    if (!server) {
        digits_of_ = nullptr;
        return;
    }
    port_->setValue(server->port());
    if (const int place = places_->findData(server->options().address); place >= 0)
        places_->setCurrentIndex(place);
    show_keys(*server);
    show_lookers(server->lookers());
}

void BrowserPanel::show_keys(web::Server& server) {
    web::Keys keys = server.keys();
    const bool is_new = digits_of_ != &server;
    if (isVisible() && (is_new || keys.digits.empty())) {
        server.show_digits(true);
        digits_of_ = &server;
        keys = server.keys();
    }
    if (keys.control_token != control_token_) {
        control_token_ = keys.control_token;
        control_since_.restart();
    }
    const bool may = !keys.control_token.empty();
    control_->setChecked(may);
    shows_control_->setVisible(may);
    if (!may || control_since_.elapsed() > kControlShown_ms) shows_control_->setChecked(false);
    const bool with_control = shows_control_->isChecked();
    const std::string address = web::addresses_of(server.options(), server.port()).front();
    const QString whole =
        QString::fromStdString(web::with_secret(address, with_control ? keys.control_token : keys.token));
    if (address_->text() != whole) {
        address_->setText(whole);
        address_->setCursorPosition(0);
    }
    code_->show_text(whole);
    code_->setAccessibleDescription(with_control ? translated("Browsers", "With control")
                                                 : translated("Browsers", "To look on"));
    const QString digits = QString::fromStdString(keys.digits);
    digits_->setText(digits.isEmpty()
                         ? QString()
                         : translated("Browsers", "Or <b>%1</b> and the digits <b>%2 %3</b>, for %4")
                               .arg(QString::fromStdString(address).toHtmlEscaped(), digits.left(3),
                                    digits.mid(3), clock_text(keys.digits_left_s)));
}

void BrowserPanel::show_lookers(const std::vector<web::Looker>& lookers) {
    QString text = lookers.empty() ? translated("Browsers", "Nobody looks on.")
                                   : translated("Browsers", "%n look(s) on:", nullptr, lookers.size());
    for (const web::Looker& looker : lookers)
        text += "\n" + (looker.controls ? translated("Browsers", "%1, %2, %3 pictures a second, may control")
                                        : translated("Browsers", "%1, %2, %3 pictures a second"))
                           .arg(QString::fromStdString(looker.from), clock_text(looker.seconds))
                           .arg(looker.rate_hz, 0, 'f', 0);
    if (who_->text() != text) who_->setText(text);
}

} // namespace ghost::ui
