// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/palette_box.h"

#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/palette_values.h"
#include "ui/widgets/following.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace ghost::ui {
namespace {

constexpr const char* kTitles[] = {
    QT_TRANSLATE_NOOP("Palettes", "Position"), QT_TRANSLATE_NOOP("Palettes", "Colour"),
    QT_TRANSLATE_NOOP("Palettes", "Beam"), QT_TRANSLATE_NOOP("Palettes", "Gobo")};
constexpr int kRows = 2; // of palettes that are seen without scrolling

QString tip_of(const scene::Palette& palette) {
    if (palette.fixtures.empty())
        return translated("Palettes", "All heads: %1").arg(words_of(palette.values));
    return translated("Palettes", "%n head(s), each its own", nullptr, palette.fixtures.size());
}

// Of a colour, or of as many as fit beside each other.
QIcon swatch_of(const scene::Palette& palette) {
    constexpr int kSide_px = 14;
    constexpr int kMost = kSide_px / 2;
    std::vector<QColor> colours;
    if (palette.values.colour) colours.push_back(screen_colour(*palette.values.colour));
    for (const auto& [name, own] : palette.fixtures)
        if (own.colour && static_cast<int>(colours.size()) < kMost)
            colours.push_back(screen_colour(*own.colour));
    if (colours.empty()) return {};
    QImage image(static_cast<int>(colours.size()), 1, QImage::Format_RGB32);
    for (std::size_t i = 0; i < colours.size(); ++i) image.setPixelColor(static_cast<int>(i), 0, colours[i]);
    return QIcon(QPixmap::fromImage(image.scaled(kSide_px, kSide_px)));
}

} // namespace

PaletteBox::PaletteBox(AppModel& app, PaletteList& palettes, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), palettes_(palettes), actions_(actions), kinds_(new QButtonGroup(this)),
      store_(new QToolButton(this)), list_(new QListWidget(this)) {
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (int i = 0; i < 4; ++i) {
        auto* button = new QToolButton(this);
        button->setText(translated("Palettes", kTitles[i]));
        button->setCheckable(true);
        button->setToolTip(translated("Palettes", "Palettes: %1").arg(translated("Palettes", kTitles[i])));
        button->setChecked(i == 0);
        kinds_->addButton(button, i);
        row->addWidget(button);
    }
    row->addStretch(1);
    store_->setText("+");
    store_->setAccessibleName(translated("Palettes", "Store palette"));
    store_->setToolTip(translated(
        "Palettes", "What hands set of it for the selected fixtures, as a new palette of the show"));
    setTabOrder(kinds_->buttons().last(), store_);
    setTabOrder(store_, list_);
    list_->setAccessibleName(translated("Palettes", "Palettes"));
    list_->setFlow(QListView::LeftToRight);
    list_->setWrapping(true);
    list_->setResizeMode(QListView::Adjust);
    list_->setSpacing(2);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFixedHeight(kRows * (fontMetrics().height() + 10) + 6);
    list_->setToolTip(translated("Palettes", "A click gives it to the selected fixtures. F2: another name."));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the panel may be narrow
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(2);
    auto* title = new QLabel(translated("Palettes", "Palettes"), this);
    QFont font = title->font();
    font.setBold(true); // as the groups of parameters below
    title->setFont(font);
    auto* heading = new QHBoxLayout;
    heading->addWidget(title, 1);
    heading->addWidget(store_);
    layout->addLayout(heading);
    layout->addLayout(row);
    layout->addWidget(list_);
    connect(kinds_, &QButtonGroup::idToggled, this, &PaletteBox::fill);
    connect(store_, &QToolButton::clicked, this, [this] {
        const QString name = new_name();
        run("palette-store " + kind_word() + " " + quoted(name));
        for (QListWidgetItem* const item : list_->findItems(name, Qt::MatchExactly)) {
            list_->setCurrentItem(item);
            list_->editItem(item); // what is typed next is its name
        }
    });
    for (const auto signal : {&QListWidget::itemClicked, &QListWidget::itemActivated})
        connect(list_, signal, this,
                [this](QListWidgetItem* item) { run("palette " + quoted(item->text())); });
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (follows_) return;
        const QString before = item->data(Qt::UserRole).toString(), after = item->text();
        if (before != after) run("palette-rename " + quoted(before) + " " + quoted(after));
        // The list is not filled while it tells of a change.
        QMetaObject::invokeMethod(this, &PaletteBox::fill, Qt::QueuedConnection);
    });
    connect(&app_, &AppModel::opened_show, this, &PaletteBox::fill);
    connect(&app_, &AppModel::selection_changed, this,
            [this] { store_->setEnabled(!app_.selection().empty()); });
    store_->setEnabled(false);
}

scene::PaletteKind PaletteBox::kind() const {
    return static_cast<scene::PaletteKind>(kinds_->checkedId());
}

QString PaletteBox::kind_word() const {
    return scene::kPaletteKinds[static_cast<std::size_t>(kind())];
}

QString PaletteBox::chosen() const {
    return list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString() : QString();
}

QString PaletteBox::new_name() const {
    for (int number = list_->count() + 1;; ++number)
        if (const QString name = QString("%1 %2").arg(kTitles[kinds_->checkedId()]).arg(number);
            !scene::find_palette(palettes_.all(), name.toStdString()).ok())
            return name;
}

void PaletteBox::run(const QString& line) {
    actions_.choose(line);
}

void PaletteBox::fill_menu(QMenu& menu) {
    if (chosen().isEmpty()) return;
    const auto add = [&](const QString& text, std::function<void()> done) {
        connect(menu.addAction(text), &QAction::triggered, this, std::move(done));
    };
    const QString name = quoted(chosen());
    add(translated("Palettes", "Give it to the selected fixtures"), [this, name] { run("palette " + name); });
    menu.addSeparator();
    add(translated("Palettes", "Rename"), [this] { list_->editItem(list_->currentItem()); });
    add(translated("Palettes", "Update with what hands set"),
        [this, name] { run("palette-store " + kind_word() + " " + name); });
    menu.addSeparator();
    add(translated("Palettes", "Remove"), [this, name] { run("palette-remove " + name); });
}

// Items whose names stay, stay, so that who types a name goes on: what an item is told closes or empties the
// field over it.
void PaletteBox::fill() {
    const Following following(follows_);
    const QString before = chosen();
    const std::vector<scene::Palette> shown = std::exchange(shown_, {});
    for (const scene::Palette& palette : palettes_.all())
        if (palette.kind == kind()) shown_.push_back(palette);
    const auto name_at = [&](int row) {
        return QString::fromStdString(shown_[static_cast<std::size_t>(row)].name);
    };
    bool stays = shown.size() == shown_.size() && list_->count() == static_cast<int>(shown_.size());
    for (int row = 0; stays && row < list_->count(); ++row) stays = list_->item(row)->text() == name_at(row);
    if (!stays) list_->clear();
    for (int row = 0; row < static_cast<int>(shown_.size()); ++row) {
        const auto at = static_cast<std::size_t>(row);
        auto* const item = stays ? list_->item(row) : new QListWidgetItem(name_at(row), list_);
        item->setData(Qt::UserRole, item->text());
        if (!stays) item->setFlags(item->flags() | Qt::ItemIsEditable);
        if (stays && shown[at].values == shown_[at].values && shown[at].fixtures == shown_[at].fixtures)
            continue;
        item->setIcon(swatch_of(shown_[at]));
        item->setToolTip(tip_of(shown_[at]));
        if (!stays && item->text() == before) list_->setCurrentItem(item);
    }
}

} // namespace ghost::ui
