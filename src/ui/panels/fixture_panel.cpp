// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/fixture_panel.h"

#include "show/show.h"
#include "ui/actions/patch_actions.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"
#include "ui/widgets/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMetaProperty>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

// What a person types or chooses goes to all that are selected, also where it is what stood there.
class CellEditor : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        return noticed(QStyledItemDelegate::createEditor(parent, option, index));
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        const QVariant words = editor->property(editor->metaObject()->userProperty().name());
        if (words.toString() != index.data(Qt::EditRole).toString())
            QStyledItemDelegate::setModelData(editor, model, index);
        else if (editor->property(kTouched).toBool())
            model->setData(index, words, FixtureList::kTyped);
    }

protected:
    static QWidget* noticed(QWidget* editor) {
        const auto touched = [editor] { editor->setProperty(kTouched, true); };
        if (auto* const field = qobject_cast<QLineEdit*>(editor))
            connect(field, &QLineEdit::textEdited, field, touched);
        if (auto* const list = qobject_cast<QComboBox*>(editor))
            connect(list, &QComboBox::activated, list, touched);
        return editor;
    }

private:
    static constexpr const char* kTouched = "touched";
};

// Modes are chosen from those that the fixture has.
class ModeDelegate : public CellEditor {
public:
    ModeDelegate(AppModel& app, QObject* parent) : CellEditor(parent), app_(app) {}
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        const auto* sorted = qobject_cast<const QSortFilterProxyModel*>(index.model());
        const auto row = static_cast<std::size_t>(sorted->mapToSource(index).row());
        if (!app_.show() || row >= app_.show()->fixtures.size() || !app_.show()->fixtures[row].type)
            return CellEditor::createEditor(parent, option, index);
        auto* modes = new QComboBox(parent);
        for (const fixture::Mode& mode : app_.show()->fixtures[row].type->modes)
            modes->addItem(QString::fromStdString(mode.name));
        modes->setCurrentText(index.data().toString());
        return noticed(modes);
    }

private:
    AppModel& app_;
};

// What is wrong stays red in a row that is selected; styles give those one colour of their own.
class CellPainter : public CellEditor {
public:
    using CellEditor::CellEditor;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        CellEditor::initStyleOption(option, index);
        const bool is_wrong = index.data(FixtureList::kIsWrong).toBool();
        if (!is_wrong && !index.data(FixtureList::kIsByHand).toBool()) return;
        const QColor colour = is_wrong ? bad() : accent();
        option->palette.setColor(QPalette::Text, colour);
        option->palette.setColor(QPalette::HighlightedText, colour);
    }
};

// The colour of the light, which the mark of a chosen row leaves free.
class SwatchPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        if (const QVariant light = index.data(FixtureList::kLight); light.isValid())
            painter->fillRect(option.rect.adjusted(3, 3, -3, -3), screen_colour(light.value<glm::vec3>()));
    }
};

} // namespace

FixturePanel::FixturePanel(AppModel& app, ShowDocument& document, QWidget* parent)
    : QWidget(parent), app_(app), document_(document) {
    search_ = new QLineEdit(this);
    search_->setPlaceholderText(translated("Fixtures", "Search"));
    search_->setToolTip(translated("Fixtures", "In names, addresses, types and modes"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(translated("Fixtures", "Search fixtures"));
    title_ = new QLabel(this);
    title_->setWordWrap(true);
    group_ = new QComboBox(this);
    group_->setAccessibleName(translated("Fixtures", "Group of fixtures"));
    group_->setToolTip(
        translated("Fixtures", "One type, layer or truss alone; Enter in the search selects what is listed"));
    group_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    group_->setMinimumContentsLength(7);
    dark_ = new QToolButton(this);
    dark_->setText(translated("Fixtures", "Dark"));
    dark_->setCheckable(true);
    dark_->setToolTip(translated("Fixtures", "Only fixtures that do not shine, by reasons"));
    list_ = new FixtureList(app, this);
    list_->edit = [this](FixtureList::Column column, const QString& words) {
        const Result<void> done = edit(column, words);
        if (!done.ok() && complain) complain(done.error());
        return done.ok();
    };
    sorted_ = new FixtureFilter(this);
    sorted_->setSourceModel(list_);
    table_ = new FixtureTable(this);
    table_->setTabKeyNavigation(false); // Tab leaves it
    table_->setModel(sorted_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    // Numbers that tell lamps apart stand at the end, where one line of wrapped words would end before them.
    table_->setTextElideMode(Qt::ElideMiddle);
    table_->setWordWrap(false);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    table_->setItemDelegate(new CellPainter(table_));
    table_->setItemDelegateForColumn(FixtureList::mode, new ModeDelegate(app, table_));
    table_->setItemDelegateForColumn(FixtureList::colour, new SwatchPainter(table_));
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
    table_->horizontalHeader()->setMinimumSectionSize(2 * table_->fontMetrics().averageCharWidth());
    table_->setAccessibleName(translated("Fixtures", "Fixtures"));
    const int letter = table_->fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair{FixtureList::name, 18},
                                          {FixtureList::patch, 9},
                                          {FixtureList::level, 8},
                                          {FixtureList::colour, 4},
                                          {FixtureList::type, 18},
                                          {FixtureList::mode, 14},
                                          {FixtureList::x, 7},
                                          {FixtureList::y, 7},
                                          {FixtureList::z, 7}})
        table_->setColumnWidth(column, letters * letter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    auto* choice = new QHBoxLayout;
    choice->addWidget(search_, 3);
    choice->addWidget(group_, 2);
    choice->addWidget(dark_);
    layout->addWidget(title_);
    layout->addLayout(choice);
    layout->addWidget(table_);
    connect(&app_, &AppModel::opened_show, this, [this] {
        // What was searched, or chosen, in another show would hide most of this one.
        if (!app_.opened().is_edit && !app_.opened().again) {
            search_->clear();
            group_->setCurrentIndex(0);
        }
        list_groups();
    });
    // Rows of another show are sorted by what its heads do, which comes after it. Later changes move no row:
    // levels change all the time.
    connect(list_, &FixtureList::modelReset, this, [this] { since_reset_.start(); });
    connect(&app_, &AppModel::rig_came, this, [this] {
        if (!app_.show() || app_.rig().fixtures.size() != app_.show()->fixtures.size()) return;
        constexpr int kLampsCome_ms = 2000;
        if (!since_reset_.isValid() || sorted_->sortColumn() != FixtureList::level) return;
        if (since_reset_.elapsed() > kLampsCome_ms) since_reset_.invalidate();
        const Following following(follows_);
        sorted_->invalidate();
    });
    connect(&app_, &AppModel::verdicts_came, this, [this] {
        if (dark_->isChecked()) list_groups();
    });
    connect(dark_, &QToolButton::toggled, this, [this](bool on) {
        app_.change_request([on](ViewRequest& request) { request.explains_all = on; });
        list_groups();
    });
    connect(group_, &QComboBox::activated, this, &FixturePanel::show_group);
    connect(&app_, &AppModel::selection_changed, this, &FixturePanel::count);
    count();
    // What is searched away stays selected, and rows that go say nothing: each would be a selection.
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
        {
            const Following following(follows_);
            sorted_->setFilterFixedString(text);
        }
        show_selection();
    });
    connect(search_, &QLineEdit::returnPressed, this, [this] {
        if (sorted_->rowCount() == 0) return;
        table_->setFocus();
        table_->setCurrentIndex(sorted_->index(0, FixtureList::name)); // that F2 edits
        table_->selectAll();
        take_selection(); // where they were selected already, the table says nothing
    });
    connect(&app_, &AppModel::selection_changed, this, &FixturePanel::show_selection);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &FixturePanel::take_selection);
}

Result<void> FixturePanel::edit(FixtureList::Column column, const QString& words) {
    PatchEdit edit(app_, document_);
    const QStringList parts = words.split(' ', Qt::SkipEmptyParts);
    constexpr double kMost_m = 100000;
    switch (column) {
    case FixtureList::name:
        return edit.rename(words);
    case FixtureList::patch: {
        TRY(const fixture::Address address,
            address_of(words == translated("Fixtures", "none") ? "none" : words));
        return edit.set_address(address);
    }
    case FixtureList::mode:
        return edit.set_mode(words);
    case FixtureList::turn: {
        glm::vec3 turn_deg{0};
        for (int i = 0; i < 3; ++i) {
            TRY(const double degrees, number_of(parts, i, "degrees", -360, 360));
            turn_deg[i] = static_cast<float>(degrees);
        }
        return edit.set_rotation(turn_deg);
    }
    default: {
        TRY(const double metres, number_of(parts, 0, "metres", -kMost_m, kMost_m));
        return edit.set_axis(column - FixtureList::x, static_cast<float>(metres));
    }
    }
}

// The chosen group stays chosen where it is still there.
void FixturePanel::list_groups() {
    const QString before = group_->currentData().toString();
    groups_ = !app_.show()         ? std::vector<FixtureGroup>{}
              : dark_->isChecked() ? dark_groups_of(app_.verdicts())
                                   : groups_of(*app_.show(), app_.opened().objects);
    group_->clear();
    std::size_t dark = 0;
    for (const FixtureGroup& group : groups_) dark += group.fixtures.size();
    const QString held = held_back(app_.request(), app_.rig().remote);
    group_->addItem(!dark_->isChecked()       ? translated("Fixtures", "All fixtures")
                    : !held.isEmpty()         ? held
                    : app_.verdicts().empty() ? translated("Fixtures", "Asking why ...")
                    : dark == 0               ? translated("Fixtures", "None is dark")
                                              : translated("Fixtures", "Dark: %1").arg(dark));
    for (const FixtureGroup& group : groups_)
        group_->addItem(QString("%1 (%2)").arg(group.title).arg(group.fixtures.size()), group.title);
    group_->setCurrentIndex(before.isEmpty() ? 0 : std::max(group_->findData(before), 0));
    show_group();
    count();
}

void FixturePanel::show_group() {
    std::optional<std::set<std::size_t>> only;
    const int index = group_->currentIndex() - 1;
    if (index >= 0 && static_cast<std::size_t>(index) < groups_.size()) {
        only = groups_[static_cast<std::size_t>(index)].fixtures;
    } else if (dark_->isChecked() && !app_.verdicts().empty()) {
        only.emplace();
        for (const FixtureGroup& group : groups_) only->insert(group.fixtures.begin(), group.fixtures.end());
    }
    {
        const Following following(follows_);
        sorted_->show_only(std::move(only));
    }
    show_selection();
}

std::optional<std::set<std::size_t>> FixturePanel::listed() const {
    if (!isVisible() || sorted_->rowCount() == list_->rowCount({})) return std::nullopt;
    std::set<std::size_t> rows;
    for (int row = 0; row < sorted_->rowCount(); ++row)
        rows.insert(static_cast<std::size_t>(sorted_->mapToSource(sorted_->index(row, 0)).row()));
    return rows;
}

void FixturePanel::count() {
    const std::size_t all = app_.show() ? app_.show()->fixtures.size() : 0;
    QString words = translated("Fixtures", "%n fixture(s)", nullptr, all);
    if (!app_.selection().empty())
        words = translated("Fixtures", "%1, %2 selected").arg(words).arg(app_.selection().size());
    title_->setText(words);
}

void FixturePanel::show_selection() {
    QItemSelection rows;
    QModelIndex first;
    for (const std::size_t fixture : app_.selection()) {
        const QModelIndex index = sorted_->mapFromSource(list_->index(static_cast<int>(fixture), 0));
        if (!index.isValid()) continue; // searched away
        rows.select(index, index);
        if (!first.isValid()) first = index;
    }
    {
        const Following following(follows_);
        table_->selectionModel()->select(rows,
                                         QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    }
    if (first.isValid() && !table_->hasFocus()) table_->scrollTo(first);
}

void FixturePanel::take_selection() {
    if (follows_) return;
    std::set<std::size_t> selection;
    // What is chosen beside the others lets go of none that is searched away.
    if (table_->adds())
        for (const std::size_t fixture : app_.selection())
            if (!sorted_->mapFromSource(list_->index(static_cast<int>(fixture), 0)).isValid())
                selection.insert(fixture);
    for (const QModelIndex& index : table_->selectionModel()->selectedRows())
        selection.insert(static_cast<std::size_t>(sorted_->mapToSource(index).row()));
    app_.select(std::move(selection));
}

} // namespace ghost::ui
