// SPDX-License-Identifier: Apache-2.0
#include "ui/fixture_panel.h"

#include "ui/hand.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

QString text_of(const scene::PatchedFixture& fixture, int column) {
    switch (column) {
    case FixtureModel::name:
        return QString::fromStdString(fixture.name);
    case FixtureModel::patch:
        return fixture.address > 0
                   ? QString("%1.%2").arg(fixture.universe).arg(fixture.address, 3, 10, QChar('0'))
                   : QString("none");
    case FixtureModel::type:
        return fixture.type ? QString::fromStdString(fixture.type->name) : QString("file cannot be read");
    case FixtureModel::mode:
        return fixture.type ? QString::fromStdString(fixture.patch().mode_of().name) : QString();
    default:
        return {};
    }
}

} // namespace

FixtureModel::FixtureModel(Studio& studio, QObject* parent) : QAbstractTableModel(parent), studio_(studio) {
    connect(&studio_, &Studio::opened_show, this, [this] {
        beginResetModel();
        shared_.clear();
        std::vector<fixture::Patch> patches;
        std::vector<std::size_t> of_patch;
        const std::vector<scene::PatchedFixture>& fixtures = studio_.show()->fixtures;
        for (std::size_t i = 0; i < fixtures.size(); ++i) {
            if (!fixtures[i].type) continue;
            patches.push_back(fixtures[i].patch());
            of_patch.push_back(i);
        }
        for (const fixture::Overlap& overlap : fixture::find_overlaps(patches))
            shared_.insert({of_patch[overlap.first], of_patch[overlap.second]});
        endResetModel();
    });
    const auto refresh = [this] {
        if (rowCount() > 0) Q_EMIT dataChanged(index(0, level), index(rowCount() - 1, colour));
    };
    connect(&studio_, &Studio::rig_came, this, refresh);
    connect(&studio_, &Studio::look_changed, this, refresh);
}

int FixtureModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !studio_.show() ? 0 : static_cast<int>(studio_.show()->fixtures.size());
}

int FixtureModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant FixtureModel::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (!studio_.show() || row >= studio_.show()->fixtures.size()) return {};
    const scene::PatchedFixture& fixture = studio_.show()->fixtures[row];
    const FixtureNow* now = row < studio_.rig().fixtures.size() ? &studio_.rig().fixtures[row] : nullptr;
    if (role == Qt::DisplayRole && index.column() == level)
        return now ? QString("%1 %").arg(100 * static_cast<double>(now->dimmer), 0, 'f', 0) : QString();
    if (role == Qt::DisplayRole) return text_of(fixture, index.column());
    if (role == Qt::BackgroundRole && index.column() == colour && now && now->candela > 0)
        return screen_colour(now->colour);
    if (role == Qt::TextAlignmentRole && index.column() == level)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    if (role == Qt::ForegroundRole) {
        if (index.column() == patch && (fixture.address <= 0 || shared_.contains(row))) return bad();
        if (index.column() == type && !fixture.type) return bad();
        if (index.column() == level && studio_.look().fixtures.contains(row)) return accent();
    }
    if (role == Qt::ToolTipRole) {
        if (shared_.contains(row)) return "Another fixture reads a channel of this one.";
        if (studio_.look().fixtures.contains(row)) return "Set by hand; R releases it.";
        return QString::fromStdString(fixture.gdtf.string());
    }
    return {};
}

QVariant FixtureModel::headerData(int section, Qt::Orientation orientation, int role) const {
    static const char* const kTitles[kColumns] = {"Name", "Patch", "Light", "", "Type", "Mode"};
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return kTitles[section];
}

FixturePanel::FixturePanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    search_ = new QLineEdit(this);
    search_->setPlaceholderText("Search name, patch, type, mode");
    search_->setClearButtonEnabled(true);
    model_ = new FixtureModel(studio, this);
    sorted_ = new QSortFilterProxyModel(this);
    sorted_->setSourceModel(model_);
    sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    sorted_->setFilterKeyColumn(-1);
    sorted_->setDynamicSortFilter(false); // levels change all the time
    table_ = new QTableView(this);
    table_->setModel(sorted_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
    table_->horizontalHeader()->setStretchLastSection(true);
    const int letter = table_->fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair{FixtureModel::name, 14},
                                          {FixtureModel::patch, 9},
                                          {FixtureModel::level, 8},
                                          {FixtureModel::colour, 4},
                                          {FixtureModel::type, 18}})
        table_->setColumnWidth(column, letters * letter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(search_);
    layout->addWidget(table_);
    connect(search_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
    connect(&studio_, &Studio::selection_changed, this, &FixturePanel::show_selection);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &FixturePanel::take_selection);
}

void FixturePanel::show_selection() {
    QItemSelection rows;
    QModelIndex first;
    for (const std::size_t fixture : studio_.selection()) {
        const QModelIndex index = sorted_->mapFromSource(model_->index(static_cast<int>(fixture), 0));
        if (!index.isValid()) continue; // searched away
        rows.select(index, index);
        if (!first.isValid()) first = index;
    }
    follows_ = true;
    table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    follows_ = false;
    if (first.isValid() && !table_->hasFocus()) table_->scrollTo(first);
}

void FixturePanel::take_selection() {
    if (follows_) return;
    std::set<std::size_t> selection;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows())
        selection.insert(static_cast<std::size_t>(sorted_->mapToSource(index).row()));
    studio_.select(std::move(selection));
}

} // namespace ghost::ui
