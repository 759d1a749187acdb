// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/look_panel.h"

#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/typed_delegate.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace ghost::ui {

LookPanel::LookPanel(AppModel& app, Looks& looks, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), looks_(looks), actions_(actions) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 6, 4, 6); // the narrowest column has room for it
    list_ = new QListWidget(this);
    list_->setAccessibleName(translated("Looks", "Looks"));
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setAlternatingRowColors(true);
    list_->setItemDelegate(new TypedDelegate(list_));
    list_->setToolTip(translated("Looks", "Double click or Enter: recall. F2: another name."));
    layout->addWidget(list_, 1);
    connect(list_, &QListWidget::itemDoubleClicked, this, [this] { run("look-recall " + quoted(chosen())); });
    connect(list_, &QListWidget::currentItemChanged, this, &LookPanel::refresh);
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (follows_) return;
        const QString before = item->data(Qt::UserRole).toString(), after = item->text();
        if (before != after) run("look-rename " + quoted(before) + " " + quoted(after));
        fill();
    });

    auto* buttons = new QGridLayout;
    buttons->setHorizontalSpacing(4);
    const auto name = [this] { return quoted(chosen()); };
    recall_ = add_button(translated("Looks", "Recall"), translated("Looks", "Fades to it"),
                         [=] { return "look-recall " + name(); });
    store_ = new QPushButton(translated("Looks", "Store programmer"), this);
    connect(store_, &QPushButton::clicked, this, [this] { store_new("look-store"); });
    auto* capture = new QPushButton(translated("Looks", "Store what is seen"), this);
    capture->setToolTip(translated("Looks", "Of the selected fixtures, or of all: whoever asked for it"));
    connect(capture, &QPushButton::clicked, this, [this] { store_new("look-capture"); });
    update_ =
        add_button(translated("Looks", "Update"), translated("Looks", "Puts what hands set in its place"),
                   [=] { return "look-store " + name(); });
    remove_ = add_button(translated("Looks", "Remove"), translated("Looks", "Can be undone"),
                         [=] { return "look-remove " + name(); });
    fade_ = new QDoubleSpinBox(this);
    fade_->setRange(0, scene::kLongestFade_s);
    fade_->setDecimals(1);
    fade_->setSuffix(translated("Looks", " s fade"));
    fade_->setAccessibleName(translated("Looks", "Seconds of the crossfade"));
    fade_->setKeyboardTracking(false);
    connect(fade_, &QDoubleSpinBox::valueChanged, this, [this](double seconds) {
        if (!follows_ && !chosen().isEmpty())
            run("look-fade " + quoted(chosen()) + " " + QString::number(seconds));
    });
    buttons->addWidget(recall_, 0, 0);
    buttons->addWidget(fade_, 0, 1);
    buttons->addWidget(store_, 1, 0);
    buttons->addWidget(capture, 1, 1);
    buttons->addWidget(update_, 2, 0);
    buttons->addWidget(remove_, 2, 1);
    layout->addLayout(buttons);
    add_what_if(layout);

    connect(&looks_, &Looks::changed, this, &LookPanel::fill);
    for (const auto signal : {&AppModel::selection_changed, &AppModel::look_changed})
        connect(&app_, signal, this, &LookPanel::refresh);
    setEnabled(false);
}

QPushButton* LookPanel::add_button(const QString& text, const QString& tip, std::function<QString()> line) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, line] { run(line()); });
    return button;
}

void LookPanel::add_what_if(QLayout* layout) {
    solo_ = add_button(translated("Looks", "Solo"), translated("Looks", "The selected fixtures alone shine"),
                       [] { return QString("solo"); });
    solo_->setCheckable(true);
    what_if_ = new QLabel(this);
    what_if_->setWordWrap(true);
    // Always room for two lines, so that what stands above it stays where it is.
    what_if_->setFixedHeight(2 * what_if_->fontMetrics().lineSpacing());
    what_if_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    gel_ = new ColourRow(translated("Looks", "Gel"), this);
    gel_->setToolTip(translated("Looks", "A filter in front of the selected fixtures, on top of all else"));
    gel_->on_change = [this](const QColor& colour) { run("gel " + colour.name()); };
    gel_->on_release = [this] {
        change_selected(app_, translated("Undo", "release %1").arg(translated("Undo", "gel")),
                        ProgrammerStep::step,
                        [](fixture::Programmer& programmer) { programmer.gel.reset(); });
    };
    lamp_ = new ValueRow(translated("Looks", "Lamp"), {0, 4, 2, " x"}, this);
    lamp_->setToolTip(translated("Looks", "Another lamp: how many times as much light"));
    lamp_k_ = new ValueRow(translated("Looks", "Its white"), {2000, 10000, 0, " K"}, this);
    const auto connect_row = [this](ValueRow* row, const QString& what,
                                    std::optional<float> fixture::Programmer::*value) {
        row->on_change = [this, what, value](double number) {
            change_selected(app_, what, ProgrammerStep::lamp, [&](fixture::Programmer& programmer) {
                programmer.*value = static_cast<float>(number);
            });
        };
        row->on_release = [this, what, value] {
            change_selected(app_, translated("Undo", "release %1").arg(what), ProgrammerStep::step,
                            [&](fixture::Programmer& programmer) { (programmer.*value).reset(); });
        };
    };
    connect_row(lamp_, translated("Undo", "lamp"), &fixture::Programmer::lamp);
    connect_row(lamp_k_, translated("Undo", "white of the lamp"), &fixture::Programmer::lamp_k);
    for (QWidget* widget : std::initializer_list<QWidget*>{solo_, what_if_, gel_, lamp_, lamp_k_})
        layout->addWidget(widget);
}

void LookPanel::fill_menu(QMenu& menu) {
    if (chosen().isEmpty()) return;
    const auto add = [&](const QString& text, std::function<void()> done) {
        connect(menu.addAction(text), &QAction::triggered, this, std::move(done));
    };
    const QString name = quoted(chosen());
    add(translated("Looks", "Recall"), [this, name] { run("look-recall " + name); });
    add(translated("Looks", "Add as a cue"), [this, name] { run("cue-add \"\" " + name); });
    menu.addSeparator();
    add(translated("Looks", "Rename"), [this] { list_->editItem(list_->currentItem()); });
    add(translated("Looks", "Update with what hands set"), [this, name] { run("look-store " + name); });
    menu.actions().back()->setEnabled(looks_.can_store());
    menu.addSeparator();
    add(translated("Looks", "Remove"), [this, name] { run("look-remove " + name); });
}

// What is typed next is its name.
void LookPanel::store_new(const QString& action) {
    const QString name = new_name();
    run(action + " " + quoted(name));
    for (QListWidgetItem* const item : list_->findItems(name, Qt::MatchExactly)) {
        list_->setCurrentItem(item);
        list_->editItem(item);
    }
}

void LookPanel::run(const QString& line) {
    actions_.choose(line);
    refresh();
}

QString LookPanel::chosen() const {
    return list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString() : QString();
}

QString LookPanel::new_name() const {
    for (std::size_t number = looks_.all().size() + 1;; ++number)
        if (const QString name = QString("Look %1").arg(number);
            !scene::find_look(looks_.all(), name.toStdString()).ok())
            return name;
}

void LookPanel::fill() {
    setEnabled(app_.show() != nullptr);
    {
        const Following following(follows_);
        list_names();
    }
    refresh();
}

void LookPanel::list_names() {
    const std::vector<scene::StoredLook>& looks = looks_.all();
    const QString before = chosen();
    const int row = list_->currentRow();
    bool are_same = static_cast<std::size_t>(list_->count()) == looks.size();
    for (int i = 0; are_same && i < list_->count(); ++i) {
        const QString name = QString::fromStdString(looks[static_cast<std::size_t>(i)].name);
        const QListWidgetItem* const item = list_->item(i);
        are_same = item->text() == name && item->data(Qt::UserRole).toString() == name;
    }
    if (!are_same) list_->clear(); // a recall leaves a name that is being typed alone
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const scene::StoredLook& look = looks[i];
        auto* const item = are_same ? list_->item(static_cast<int>(i))
                                    : new QListWidgetItem(QString::fromStdString(look.name), list_);
        item->setToolTip(translated("Looks", "%n fixture(s), %1 s", nullptr, look.fixtures.size())
                             .arg(static_cast<double>(look.fade_s), 0, 'f', 1));
        if (are_same) continue;
        item->setData(Qt::UserRole, item->text());
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        if (item->text() == before) list_->setCurrentItem(item);
    }
    if (!list_->currentItem() && list_->count() > 0)
        list_->setCurrentRow(std::clamp(row, 0, list_->count() - 1));
}

void LookPanel::refresh() {
    if (!app_.show() || follows_) return;
    const Following following(follows_);
    const QString current = QString::fromStdString(looks_.current());
    for (int i = 0; i < list_->count(); ++i) {
        QListWidgetItem* item = list_->item(i);
        item->setForeground(item->text() == current ? accent() : palette().color(QPalette::Text));
    }
    const Result<std::size_t> index = scene::find_look(looks_.all(), chosen().toStdString());
    for (QWidget* widget : std::initializer_list<QWidget*>{recall_, remove_, fade_})
        widget->setEnabled(index.ok());
    const bool any_by_hand = looks_.can_store();
    const QString why =
        translated("Looks", "Nothing is set by hand: set something in Programmer or Scene, or "
                            "take Store what is seen");
    store_->setEnabled(any_by_hand);
    store_->setToolTip(any_by_hand ? translated("Looks", "As a new look") : why);
    update_->setEnabled(index.ok() && any_by_hand);
    update_->setToolTip(any_by_hand ? translated("Looks", "Puts what hands set in its place") : why);
    if (index.ok()) fade_->setValue(static_cast<double>(looks_.all()[*index].fade_s));
    solo_->setChecked(!app_.look().solo.empty());
    const std::size_t count = app_.selection().size();
    solo_->setText(app_.look().solo.empty()
                       ? translated("Looks", "Solo")
                       : translated("Looks", "Solo: %n shine(s)", nullptr, app_.look().solo.size()));
    solo_->setEnabled(count > 0 || !app_.look().solo.empty());
    what_if_->setText(count == 0 ? translated("Looks", "What if: select fixtures to try another gel or lamp")
                                 : translated("Looks", "What if %n fixture(s) had", nullptr, count));
    for (QWidget* widget : std::initializer_list<QWidget*>{gel_, lamp_, lamp_k_})
        widget->setEnabled(count > 0);
    fixture::Programmer programmer;
    if (app_.current())
        if (const auto found = app_.look().fixtures.find(*app_.current());
            found != app_.look().fixtures.end())
            programmer = found->second;
    gel_->show_colour(screen_colour(programmer.gel.value_or(glm::vec3(1))), programmer.gel.has_value());
    lamp_->show_value(static_cast<double>(programmer.lamp.value_or(1)), programmer.lamp.has_value());
    lamp_k_->show_value(static_cast<double>(programmer.lamp_k.value_or(6000)), programmer.lamp_k.has_value());
}

} // namespace ghost::ui
