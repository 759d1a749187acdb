// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/welcome.h"

#include "show/show.h"
#include "ui/language/language.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QPixmap>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace ghost::ui {
namespace {

constexpr QSize kPicture{176, 99};

} // namespace

Welcome::Welcome(Actions& actions, AppModel& app, RecentShows& recent, bool has_demo, QWidget* over)
    : QWidget(over), actions_(actions), app_(app), recent_(recent), says_(new QLabel(this)),
      ways_(new QWidget(this)), recent_title_(new QLabel(translated("Welcome", "Opened last"), this)),
      recent_list_(new QListWidget(this)) {
    setObjectName("welcome");
    setAutoFillBackground(true);
    auto* title = new QLabel("Ghostlight", this);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 2.2);
    title->setFont(font);
    says_->setWordWrap(true);
    auto* ways = new QHBoxLayout(ways_);
    ways->setContentsMargins(0, 0, 0, 0);
    ways->addWidget(add_button("open", translated("Welcome", "Open a show..."),
                               translated("Welcome", "A folder with show.toml")));
    QPushButton* const demo = add_button("open-demo", translated("Welcome", "Open the demo"),
                                         translated("Welcome", "Ten moving heads, with a recording"));
    demo->setEnabled(has_demo);
    ways->addWidget(demo);
    ways->addWidget(add_button("import-plot", translated("Welcome", "Import a plot..."),
                               translated("Welcome", "MVR of Vectorworks, Capture, grandMA3 ...")));
    recent_list_->setAccessibleName(translated("Welcome", "Shows that were opened last"));
    recent_list_->setViewMode(QListView::IconMode);
    recent_list_->setMovement(QListView::Static);
    recent_list_->setResizeMode(QListView::Adjust);
    recent_list_->setIconSize(kPicture);
    recent_list_->setSpacing(6);
    recent_list_->setFrameShape(QFrame::NoFrame);
    recent_list_->setStyleSheet("QListView { background: transparent; }");
    auto* const middle = new QWidget(this);
    middle->setMaximumWidth(820);
    auto* column = new QVBoxLayout(middle);
    column->addStretch(1);
    for (QWidget* const one : std::initializer_list<QWidget*>{title, says_, ways_, recent_title_}) {
        column->addWidget(one);
        column->addSpacing(10);
    }
    column->addWidget(recent_list_, 4);
    column->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->addStretch(1);
    row->addWidget(middle, 8);
    row->addStretch(1);
    connect(recent_list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        actions_.choose("open " + quoted(item->data(Qt::UserRole).toString()));
    });
    connect(recent_list_, &QListWidget::itemClicked, recent_list_, &QListWidget::itemActivated);
    connect(&recent_, &RecentShows::changed, this, &Welcome::fill);
    for (const auto signal : {&AppModel::opened_show, &AppModel::activity_came, &AppModel::not_opened})
        connect(&app_, signal, this, &Welcome::refresh);
    QWidget* before = over; // else Tab goes through panels that are not there yet
    for (QWidget* const one : ways_->findChildren<QPushButton*>()) {
        setTabOrder(before, one);
        before = one;
    }
    setTabOrder(before, recent_list_);
    over->installEventFilter(this);
    resize(over->size());
    fill();
    refresh();
}

QPushButton* Welcome::add_button(const QString& action, const QString& text, const QString& words) {
    auto* button = new QPushButton(text + "\n" + words, ways_);
    button->setMinimumHeight(64);
    button->setStyleSheet("padding: 6px 14px;");
    button->setToolTip(actions_.item(action)->shortcut().toString(QKeySequence::NativeText));
    connect(button, &QPushButton::clicked, this, [this, action] { actions_.choose(action); });
    return button;
}

void Welcome::fill() {
    recent_list_->clear();
    for (const RecentShows::One& one : recent_.all()) {
        QPixmap picture(one.picture);
        if (picture.isNull()) {
            picture = QPixmap(kPicture);
            picture.fill(QColor(10, 10, 12));
        }
        const std::vector<RecentShows::One>& all = recent_.all();
        const bool is_alone = std::count_if(all.begin(), all.end(), [&](const RecentShows::One& other) {
                                  return other.name == one.name;
                              }) == 1;
        const QDir folder = QFileInfo(one.path).dir();
        const QString file = QFileInfo(one.path).fileName();
        const QString place = QFileInfo(folder.path()).dir().dirName() + "/" + folder.dirName() +
                              (file == "show.toml" ? QString() : "/" + file);
        auto* item =
            new QListWidgetItem(QIcon(picture), is_alone ? one.name : one.name + "\n" + place, recent_list_);
        item->setData(Qt::UserRole, one.path);
        item->setToolTip(one.path);
    }
    recent_title_->setVisible(!recent_.all().empty());
    recent_list_->setVisible(!recent_.all().empty());
}

void Welcome::refresh() {
    if (app_.show()) {
        hide();
        return;
    }
    const QString doing = said(app_.activity());
    says_->setText(
        !doing.isEmpty()
            ? doing + " ..."
            : translated("Welcome",
                         "Drop a show or an .mvr anywhere here; a model or a fixture once a show is open. A "
                         "desk that sends sACN or Art-Net is heard then, too."));
    ways_->setEnabled(doing.isEmpty());
}

bool Welcome::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize) resize(static_cast<QWidget*>(object)->size());
    return QWidget::eventFilter(object, event);
}

} // namespace ghost::ui
