// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/stage_tree.h"

#include "ui/language/language.h"
#include "ui/widgets/following.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include <array>
#include <map>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kObject = Qt::UserRole;

// f of each that stands for an object, with its groups left out.
template <class F>
void for_each_object(QTreeWidgetItem* item, F&& f) {
    if (item->childCount() == 0) return f(item);
    for (int i = 0; i < item->childCount(); ++i) for_each_object(item->child(i), f);
}

std::size_t object_of(const QTreeWidgetItem* item) {
    while (item->childCount() > 0) item = item->child(0);
    return item->data(0, kObject).toUInt();
}

} // namespace

std::string without_number(const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::size_t end = name.find_last_not_of(" _.-#", digits == 0 ? 0 : digits - 1);
    return digits == 0 || digits == name.size() || end == std::string::npos ? name : name.substr(0, end + 1);
}

StageTree::StageTree(AppModel& app, QWidget* parent)
    : QWidget(parent), app_(app), search_(new QLineEdit(this)), tree_(new QTreeWidget(this)) {
    search_->setAccessibleName(translated("Scene", "Search objects and materials"));
    search_->setPlaceholderText(translated("Scene", "Search objects and materials"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, &StageTree::search);
    tree_->setAccessibleName(translated("Scene", "Objects of the stage"));
    tree_->setHeaderLabels({translated("Scene", "Object"), translated("Scene", "Material")});
    tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree_->setAlternatingRowColors(true);
    tree_->setUniformRowHeights(true);
    tree_->setMinimumHeight(9 * tree_->fontMetrics().height()); // the panel scrolls where that is too much
    connect(tree_, &QTreeWidget::itemChanged, this, &StageTree::take_box);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
        app_.mark(object());
        if (!follows_) Q_EMIT chose();
    });
    connect(&app_, &AppModel::marked_changed, this, &StageTree::follow_mark);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(search_);
    layout->addWidget(tree_, 1);
}

std::optional<std::size_t> StageTree::object() const {
    const QTreeWidgetItem* item = tree_->currentItem();
    // Of a show that was just opened the items come later than its objects.
    if (!item || object_of(item) >= app_.opened().objects.size()) return std::nullopt;
    return object_of(item);
}

bool StageTree::is_shown(std::size_t object) const {
    if (object >= app_.opened().objects.size()) return true;
    const Object& one = app_.opened().objects[object];
    const auto by_hand = app_.look().shown.find(one.instance);
    return by_hand == app_.look().shown.end() ? one.shown : by_hand->second;
}

void StageTree::take_box(QTreeWidgetItem* item) {
    if (follows_) return;
    const bool on = item->checkState(0) != Qt::Unchecked;
    std::set<std::size_t> objects;
    const auto take = [&](QTreeWidgetItem* one) { objects.insert(one->data(0, kObject).toUInt()); };
    for_each_object(item, take);
    if (item->isSelected())
        for (QTreeWidgetItem* other : tree_->selectedItems()) for_each_object(other, take);
    Look look = app_.look();
    for (const std::size_t index : objects) {
        const Object& object = app_.opened().objects[index];
        look.shown.erase(object.instance);
        if (on != object.shown) look.shown[object.instance] = on;
    }
    const std::size_t count = objects.size();
    app_.set_look(std::move(look), on ? translated("Undo", "show %n object(s)", nullptr, count)
                                      : translated("Undo", "hide %n object(s)", nullptr, count));
    refresh();
}

void StageTree::add(QTreeWidgetItem* parent, std::size_t object) {
    const Opened& opened = app_.opened();
    const Object& one = opened.objects[object];
    auto* item = new QTreeWidgetItem(parent);
    item->setText(0, QString::fromStdString(one.name));
    if (one.material < opened.materials.size())
        item->setText(1, QString::fromStdString(opened.materials[one.material].name));
    item->setData(0, kObject, static_cast<unsigned>(object));
    item->setCheckState(0, is_shown(object) ? Qt::Checked : Qt::Unchecked);
}

QTreeWidgetItem* StageTree::add_group(QTreeWidgetItem* parent, const std::string& name, std::size_t count) {
    auto* group = new QTreeWidgetItem(parent);
    group->setText(0, QString("%1 (%2)").arg(QString::fromStdString(name)).arg(count));
    group->setCheckState(0, Qt::Checked);
    group->setExpanded(open_.contains(group->text(0)));
    return group;
}

void StageTree::add_groups(QTreeWidgetItem* parent, const std::vector<std::size_t>& objects) {
    std::map<std::string, std::vector<std::size_t>> groups;
    std::vector<std::string> in_order;
    for (const std::size_t object : objects) {
        const std::string name = without_number(app_.opened().objects[object].name);
        std::vector<std::size_t>& group = groups[name];
        if (group.empty()) in_order.push_back(name);
        group.push_back(object);
    }
    for (const std::string& name : in_order) {
        const std::vector<std::size_t>& members = groups[name];
        QTreeWidgetItem* group = members.size() > 1 ? add_group(parent, name, members.size()) : parent;
        for (const std::size_t object : members) add(group, object);
    }
}

void StageTree::choose(std::size_t object) {
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
        for_each_object(tree_->topLevelItem(i), [&](QTreeWidgetItem* item) {
            if (item->data(0, kObject).toUInt() == object) tree_->setCurrentItem(item);
        });
}

// Chosen in the picture.
void StageTree::follow_mark() {
    if (app_.marked() == object()) return;
    const Following following(follows_);
    if (app_.marked())
        choose(*app_.marked());
    else {
        tree_->setCurrentItem(nullptr);
        tree_->clearSelection(); // its row would look chosen still
    }
}

void StageTree::fill() {
    const Opened& opened = app_.opened();
    std::vector<std::array<std::string, 3>> rows;
    for (const Object& one : opened.objects)
        rows.push_back({one.layer, one.name,
                        one.material < opened.materials.size() ? opened.materials[one.material].name : ""});
    // Of an edit it is told twice: what is selected stays selected.
    const bool stays = rows == std::exchange(rows_, rows) && opened.is_edit;
    if (stays) return refresh();
    const Following following(follows_);
    // What stood in its row may have another number now.
    const std::optional<std::size_t> chosen = app_.opened().is_edit ? app_.marked() : std::nullopt;
    open_.clear();
    const auto note_open = [&](QTreeWidgetItem* item, const auto& again) -> void {
        if (item->isExpanded()) open_.insert(item->text(0));
        for (int i = 0; i < item->childCount(); ++i) again(item->child(i), again);
    };
    if (app_.opened().is_edit) note_open(tree_->invisibleRootItem(), note_open);
    tree_->clear();
    std::map<std::string, std::vector<std::size_t>> layers;
    for (std::size_t i = 0; i < app_.opened().objects.size(); ++i)
        layers[app_.opened().objects[i].layer].push_back(i);
    for (const auto& [layer, objects] : layers)
        add_groups(layer.empty() ? tree_->invisibleRootItem()
                                 : add_group(tree_->invisibleRootItem(), layer, objects.size()),
                   objects);
    if (chosen) choose(*chosen);
    tree_->header()->resizeSection(0, width() * 2 / 3);
    search(search_->text());
    refresh();
}

void StageTree::refresh() {
    const Following following(follows_);
    // Shown objects below an item, and all.
    const auto set_box = [&](QTreeWidgetItem* item, const auto& again) -> std::pair<int, int> {
        std::pair<int, int> sum{0, 0};
        if (item->childCount() == 0) sum = {is_shown(item->data(0, kObject).toUInt()) ? 1 : 0, 1};
        for (int i = 0; i < item->childCount(); ++i) {
            const std::pair<int, int> part = again(item->child(i), again);
            sum = {sum.first + part.first, sum.second + part.second};
        }
        item->setCheckState(0, sum.first == 0            ? Qt::Unchecked
                               : sum.first == sum.second ? Qt::Checked
                                                         : Qt::PartiallyChecked);
        return sum;
    };
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) set_box(tree_->topLevelItem(i), set_box);
}

void StageTree::search(const QString& text) {
    // What fits stays, with all in it and with what it stands in.
    const auto show = [&](QTreeWidgetItem* item, bool whole, const auto& again) -> bool {
        const bool fits = whole || item->text(0).contains(text, Qt::CaseInsensitive) ||
                          item->text(1).contains(text, Qt::CaseInsensitive);
        bool any = fits;
        for (int i = 0; i < item->childCount(); ++i) any |= again(item->child(i), fits, again);
        item->setHidden(!any);
        if (!text.isEmpty() && item->childCount() > 0) item->setExpanded(any && !fits);
        return any;
    };
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) show(tree_->topLevelItem(i), false, show);
}

} // namespace ghost::ui
