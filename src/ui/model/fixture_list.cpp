// SPDX-License-Identifier: Apache-2.0
#include "ui/model/fixture_list.h"

#include "show/show.h"
#include "ui/language/language.h"

#include <algorithm>
#include <limits>

namespace ghost::ui {
namespace {

QString number(float value) {
    return QString::number(static_cast<double>(value), 'g', 6);
}

// waits: the show is being read.
QString text_of(const scene::PatchedFixture& fixture, int column, bool waits) {
    switch (column) {
    case FixtureList::name:
        return QString::fromStdString(fixture.name);
    case FixtureList::patch:
        return fixture.address > 0 ? address_words(fixture.universe, fixture.address)
                                   : translated("Fixtures", "none");
    case FixtureList::type:
        if (fixture.type) return QString::fromStdString(fixture.type->name);
        return waits ? translated("Fixtures", "file is being read")
                     : translated("Fixtures", "file cannot be read");
    case FixtureList::mode:
        return fixture.type ? QString::fromStdString(fixture.patch().mode_of().name) : QString();
    case FixtureList::x:
    case FixtureList::y:
    case FixtureList::z:
        return number(fixture.position_m[column - FixtureList::x]);
    case FixtureList::turn:
        return number(fixture.rotation_deg.x) + " " + number(fixture.rotation_deg.y) + " " +
               number(fixture.rotation_deg.z);
    default:
        return {};
    }
}

// Names and modes by their letters, all that is a number by that; what is not patched comes last.
QVariant order_of(const scene::PatchedFixture& fixture, const FixtureNow* now, int column) {
    switch (column) {
    case FixtureList::patch:
        return fixture.address > 0 ? 512.0 * fixture.universe + fixture.address
                                   : std::numeric_limits<double>::infinity();
    case FixtureList::level:
        return now ? static_cast<double>(now->dimmer) : -1.0;
    case FixtureList::x:
    case FixtureList::y:
    case FixtureList::z:
        return static_cast<double>(fixture.position_m[column - FixtureList::x]);
    default:
        return text_of(fixture, column, false);
    }
}

} // namespace

QString address_words(int universe, int channel) {
    return QString("%1.%2").arg(universe).arg(channel, 3, 10, QChar('0'));
}

FixtureList::FixtureList(AppModel& app, QObject* parent) : QAbstractTableModel(parent), app_(app) {
    connect(&app_, &AppModel::opened_show, this, &FixtureList::take_show);
    const auto refresh = [this] {
        if (rowCount() > 0) Q_EMIT dataChanged(index(0, level), index(rowCount() - 1, colour));
    };
    connect(&app_, &AppModel::rig_came, this, refresh);
    connect(&app_, &AppModel::look_changed, this, refresh);
}

void FixtureList::take_show() {
    const std::vector<scene::PatchedFixture>& fixtures = app_.show()->fixtures;
    // Rows that stay keep their place, and who types in one goes on.
    const bool stays = app_.opened().is_edit && rows_ == static_cast<int>(fixtures.size());
    if (!stays) beginResetModel();
    rows_ = static_cast<int>(fixtures.size());
    shared_.clear();
    std::vector<fixture::Patch> patches;
    std::vector<std::size_t> of_patch;
    for (std::size_t i = 0; i < fixtures.size(); ++i) {
        if (!fixtures[i].type) continue;
        patches.push_back(fixtures[i].patch());
        of_patch.push_back(i);
    }
    for (const fixture::Overlap& overlap : fixture::find_overlaps(patches))
        shared_.insert({of_patch[overlap.first], of_patch[overlap.second]});
    if (!stays)
        endResetModel();
    else if (rows_ > 0)
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, kColumns - 1));
}

int FixtureList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows_;
}

int FixtureList::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant FixtureList::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (!app_.show() || row >= app_.show()->fixtures.size()) return {};
    const scene::PatchedFixture& fixture = app_.show()->fixtures[row];
    const FixtureNow* now = row < app_.rig().fixtures.size() ? &app_.rig().fixtures[row] : nullptr;
    if (role == Qt::DisplayRole && index.column() == level)
        return now ? QString("%1 %").arg(100 * static_cast<double>(now->dimmer), 0, 'f', 0) : QString();
    if (role == Qt::DisplayRole || role == Qt::EditRole)
        return text_of(fixture, index.column(), app_.is_taking_edit());
    if (role == kOrder) return order_of(fixture, now, index.column());
    if (role == kLight && index.column() == colour && now && now->candela > 0)
        return QVariant::fromValue(now->colour);
    if (role == Qt::TextAlignmentRole && index.column() == level)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    const bool is_unread = !fixture.type && !app_.is_taking_edit();
    if (role == kIsWrong)
        return (index.column() == patch && (fixture.address <= 0 || shared_.contains(row))) ||
               ((index.column() == name || index.column() == type) && is_unread);
    if (role == kIsByHand) return index.column() == level && app_.look().fixtures.contains(row);
    if (role == Qt::ToolTipRole) {
        if (shared_.contains(row))
            return translated("Fixtures", "Another fixture reads a channel of this one.");
        if (app_.look().fixtures.contains(row))
            return translated("Fixtures", "Set by hand; R gives it back.");
        const QString file = QString::fromStdString(fixture.gdtf.string());
        return is_unread ? translated("Fixtures", "Its file cannot be read: %1").arg(file) : file;
    }
    return {};
}

QVariant FixtureList::headerData(int section, Qt::Orientation orientation, int role) const {
    static const char* const kTitles[kColumns] = {QT_TRANSLATE_NOOP("Fixtures", "Name"),
                                                  QT_TRANSLATE_NOOP("Fixtures", "Patch"),
                                                  QT_TRANSLATE_NOOP("Fixtures", "Light"),
                                                  "",
                                                  QT_TRANSLATE_NOOP("Fixtures", "Type"),
                                                  QT_TRANSLATE_NOOP("Fixtures", "Mode"),
                                                  "X m",
                                                  "Y m",
                                                  "Z m",
                                                  QT_TRANSLATE_NOOP("Fixtures", "Turn")};
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return translated("Fixtures", kTitles[section]);
}

Qt::ItemFlags FixtureList::flags(const QModelIndex& index) const {
    const int column = index.column();
    const bool is_patch = column != level && column != colour && column != type;
    return QAbstractTableModel::flags(index) | (is_patch ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

bool FixtureList::setData(const QModelIndex& index, const QVariant& value, int role) {
    const auto row = static_cast<std::size_t>(index.row());
    const QString words = value.toString().trimmed();
    if (role != Qt::EditRole && role != kTyped) return false;
    const bool is_same = words == data(index, Qt::EditRole).toString();
    if (is_same && (role != kTyped || !others_have_else(index))) return false;
    if (!app_.selection().contains(row)) app_.select({row});
    return edit && edit(static_cast<Column>(index.column()), words);
}

// Names are each one's own.
bool FixtureList::others_have_else(const QModelIndex& index) const {
    const std::set<std::size_t>& chosen = app_.selection();
    if (index.column() == name || !chosen.contains(static_cast<std::size_t>(index.row()))) return false;
    const QVariant own = data(index, Qt::EditRole);
    return std::any_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
        return data(this->index(static_cast<int>(other), index.column()), Qt::EditRole) != own;
    });
}

FixtureFilter::FixtureFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setFilterCaseSensitivity(Qt::CaseInsensitive);
    setFilterKeyColumn(-1);
    setDynamicSortFilter(false); // levels change all the time
    collator_.setNumericMode(true);
    collator_.setCaseSensitivity(Qt::CaseInsensitive);
}

void FixtureFilter::show_only(std::optional<std::set<std::size_t>> fixtures) {
    if (fixtures == only_) return;
    only_ = std::move(fixtures);
    invalidateFilter();
}

bool FixtureFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (only_ && !only_->contains(static_cast<std::size_t>(row))) return false;
    return QSortFilterProxyModel::filterAcceptsRow(row, parent);
}

bool FixtureFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const QVariant a = left.data(FixtureList::kOrder), b = right.data(FixtureList::kOrder);
    if (a.typeId() == QMetaType::Double) return a.toDouble() < b.toDouble();
    return collator_.compare(a.toString(), b.toString()) < 0;
}

} // namespace ghost::ui
