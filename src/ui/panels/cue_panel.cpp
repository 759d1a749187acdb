// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/cue_panel.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/typed_delegate.h"

#include <QBrush>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

enum CueColumn { number, name, look, fade, follow, at, camera, flight, page, notes, kCueColumns };
constexpr const char* kWhat[kCueColumns] = {"number", "name",   "look",   "fade", "follow",
                                            "at",     "camera", "flight", "page", "notes"};

QString seconds(const std::optional<float>& value) {
    return value ? QString::number(static_cast<double>(*value), 'g', 6) : QString();
}

QString text_of(const scene::Cue& cue, int column) {
    switch (column) {
    case number:
        return QString::fromStdString(cue.number);
    case page:
        return QString::fromStdString(cue.page);
    case name:
        return QString::fromStdString(cue.name);
    case look:
        return QString::fromStdString(cue.look);
    case fade:
        return seconds(cue.fade_s);
    case follow:
        return seconds(cue.follow_s);
    case at:
        return cue.at_s ? QString::number(*cue.at_s, 'g', 8) : QString();
    case camera:
        return QString::fromStdString(cue.camera);
    case flight:
        return cue.flight_s > 0 ? seconds(cue.flight_s) : QString();
    default:
        return QString::fromStdString(cue.notes);
    }
}

// Looks and cameras are chosen from those that the show has.
class ChoiceDelegate : public QStyledItemDelegate {
public:
    ChoiceDelegate(std::function<QStringList()> names, QObject* parent)
        : QStyledItemDelegate(parent), names_(std::move(names)) {}
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                          const QModelIndex& index) const override {
        auto* box = new QComboBox(parent);
        box->addItem("");
        box->addItems(names_());
        box->setCurrentText(index.data().toString());
        return box;
    }
    void setEditorData(QWidget*, const QModelIndex&) const override {} // it has it from the beginning

private:
    std::function<QStringList()> names_;
};

} // namespace

CuePanel::CuePanel(AppModel& app, CueList& cues, Looks& looks, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), cues_(cues), looks_(looks), actions_(actions), next_(new QLabel(this)),
      table_(new QTableWidget(0, kCueColumns, this)) {
    table_->setTabKeyNavigation(false); // Tab leaves it
    next_->setWordWrap(true);
    table_->setAccessibleName(translated("Cues", "Cues"));
    table_->setHorizontalHeaderLabels({translated("Cues", "Number"), translated("Cues", "Cue"),
                                       translated("Cues", "Look"), translated("Cues", "Fade s"),
                                       translated("Cues", "Follow s"), translated("Cues", "At s"),
                                       translated("Cues", "Camera"), translated("Cues", "Flight s"),
                                       translated("Cues", "Page"), translated("Cues", "Notes")});
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->setToolTip(translated(
        "Cues", "Double click or F2: change what stands there. Fade: empty is that of the look. Follow: the "
                "next cue goes by itself that long after this one."));
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->setItemDelegate(new TypedDelegate(table_));
    table_->setItemDelegateForColumn(look, new ChoiceDelegate(
                                               [this] {
                                                   QStringList names;
                                                   for (const scene::StoredLook& one : looks_.all())
                                                       names << QString::fromStdString(one.name);
                                                   return names;
                                               },
                                               table_));
    table_->setItemDelegateForColumn(camera, new ChoiceDelegate(
                                                 [this] {
                                                     QStringList names;
                                                     for (const scene::Camera& one : app_.show()->cameras)
                                                         names << QString::fromStdString(one.name);
                                                     return names;
                                                 },
                                                 table_));
    connect(table_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
        if (follows_) return;
        actions_.choose(QString("cue-set %1 %2 %3")
                            .arg(item->row() + 1)
                            .arg(kWhat[item->column()], quoted(item->text().trimmed())));
        // What was refused is not left standing; the table is not filled while it tells of a change.
        QMetaObject::invokeMethod(this, &CuePanel::fill, Qt::QueuedConnection);
    });
    go_ = add_button(translated("Cues", "Go"), translated("Cues", "The next cue (Ctrl+G)"),
                     [] { return QString("cue-go"); });
    go_->setMinimumHeight(40);
    back_ = add_button(translated("Cues", "Back"), translated("Cues", "The cue before (Ctrl+Shift+G)"),
                       [] { return QString("cue-back"); });
    call_ = add_button(translated("Cues", "Go to this"), translated("Cues", "The chosen cue"),
                       [this] { return "cue " + chosen(); });
    QPushButton* const add =
        add_button(translated("Cues", "Add"),
                   translated("Cues", "A cue of the look that was recalled or stored last, or of this "
                                      "moment of the recording"),
                   [this] {
                       const QString of = QString::fromStdString(looks_.meant());
                       return "cue-add \"\" " + quoted(of);
                   });
    remove_ = add_button(translated("Cues", "Remove"), translated("Cues", "Can be undone"),
                         [this] { return "cue-remove " + chosen(); });
    up_ = add_button(translated("Cues", "Up"), translated("Cues", "Earlier in the list"),
                     [this] { return "cue-move " + chosen() + " up"; });
    down_ = add_button(translated("Cues", "Down"), translated("Cues", "Later in the list"),
                       [this] { return "cue-move " + chosen() + " down"; });
    // After the action: the cue stays chosen where it went, and the one that came is.
    connect(up_, &QPushButton::clicked, this, [this] { choose(table_->currentRow() - 1); });
    connect(down_, &QPushButton::clicked, this, [this] { choose(table_->currentRow() + 1); });
    connect(add, &QPushButton::clicked, this, [this] { choose(table_->rowCount() - 1); });
    auto* follows = new QCheckBox(translated("Cues", "Follow the recording"), this);
    follows->setToolTip(
        translated("Cues", "A cue with a second is called when the recording, or its time code, comes by"));
    connect(follows, &QCheckBox::toggled, this, [this](bool on) { cues_.set_follows_recording(on); });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 6, 4, 6); // the narrowest column has room for it
    layout->addWidget(next_);
    auto* buttons = new QGridLayout;
    buttons->setHorizontalSpacing(4);
    buttons->addWidget(go_, 0, 0, 1, 2);
    buttons->addWidget(back_, 0, 2);
    buttons->addWidget(call_, 1, 0, 1, 2);
    buttons->addWidget(add, 1, 2);
    buttons->addWidget(up_, 2, 0);
    buttons->addWidget(down_, 2, 1);
    buttons->addWidget(remove_, 2, 2);
    buttons->addWidget(follows, 3, 0, 1, 3);
    layout->addWidget(table_, 1);
    layout->addLayout(buttons);
    connect(&cues_, &CueList::changed, this, [this, follows] {
        follows->setChecked(cues_.follows_recording());
        fill();
    });
    countdown_.setInterval(200);
    connect(&countdown_, &QTimer::timeout, this, &CuePanel::show_next);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &CuePanel::show_next);
    fill();
}

QPushButton* CuePanel::add_button(const QString& text, const QString& tip, std::function<QString()> line) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, line] { actions_.choose(line()); });
    return button;
}

void CuePanel::fill_menu(QMenu& menu) {
    if (table_->currentRow() < 0) return;
    const auto add = [&](const QString& text, const QString& line, bool can = true) {
        QAction* const item = menu.addAction(text);
        item->setEnabled(can);
        connect(item, &QAction::triggered, this, [this, line] { actions_.choose(line); });
    };
    add(translated("Cues", "Go to this"), "cue " + chosen());
    menu.addSeparator();
    add(translated("Cues", "Up"), "cue-move " + chosen() + " up", up_->isEnabled());
    add(translated("Cues", "Down"), "cue-move " + chosen() + " down", down_->isEnabled());
    menu.addSeparator();
    add(translated("Cues", "Remove"), "cue-remove " + chosen());
}

void CuePanel::choose(int row) {
    if (row < 0 || row >= table_->rowCount()) return;
    table_->setCurrentCell(row, std::max(table_->currentColumn(), 0),
                           QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

QString CuePanel::chosen() const {
    return table_->currentRow() < 0 ? QString("\"\"") : QString::number(table_->currentRow() + 1);
}

void CuePanel::fill() {
    setEnabled(app_.show() != nullptr);
    const Following following(follows_);
    const std::vector<scene::Cue>& cues = cues_.all();
    const int row_before = table_->currentRow(), column_before = table_->currentColumn();
    table_->setRowCount(static_cast<int>(cues.size()));
    for (std::size_t i = 0; i < cues.size(); ++i) {
        // Seen in a selected row, too, which has a colour of its own.
        const QString place = QString::number(i + 1);
        auto* const mark = new QTableWidgetItem(cues_.current() == i ? "\u25B6 " + place : place);
        if (cues_.current() == i) mark->setForeground(accent());
        table_->setVerticalHeaderItem(static_cast<int>(i), mark);
        for (int column = 0; column < kCueColumns; ++column) {
            QTableWidgetItem* item = table_->item(static_cast<int>(i), column);
            if (!item) {
                item = new QTableWidgetItem;
                table_->setItem(static_cast<int>(i), column, item);
            }
            item->setText(text_of(cues[i], column));
            item->setData(Qt::ForegroundRole, cues_.current() == i ? QVariant(QBrush(accent())) : QVariant());
        }
    }
    if (!cues.empty())
        table_->setCurrentCell(std::clamp(row_before, 0, static_cast<int>(cues.size()) - 1),
                               column_before < 0 ? name : column_before,
                               QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    show_next();
}

void CuePanel::show_next() {
    const std::vector<scene::Cue>& cues = cues_.all();
    const std::size_t next = cues_.current() ? *cues_.current() + 1 : 0;
    const double follows_s = cues_.follows_in_s();
    next_->setText(cues.empty() ? translated("Cues", "No cues yet. Store looks, recall one and add it here.")
                   : next >= cues.size() ? translated("Cues", "This was the last cue.")
                   : follows_s < 0
                       ? translated("Cues", "Next: %1").arg(QString::fromStdString(cues[next].name))
                       : translated("Cues", "Next: %1, in %2 s")
                             .arg(QString::fromStdString(cues[next].name))
                             .arg(follows_s, 0, 'f', 1));
    if (follows_s >= 0 && !countdown_.isActive()) countdown_.start();
    if (follows_s < 0) countdown_.stop();
    go_->setEnabled(next < cues.size());
    back_->setEnabled(cues_.current() && *cues_.current() > 0);
    const int row = table_->currentRow();
    for (QPushButton* const of_chosen : {call_, remove_}) of_chosen->setEnabled(row >= 0);
    up_->setEnabled(row > 0);
    down_->setEnabled(row >= 0 && row + 1 < table_->rowCount());
}

} // namespace ghost::ui
