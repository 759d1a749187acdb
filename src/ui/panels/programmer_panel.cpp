// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/programmer_panel.h"

#include "show/show.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/head_values.h"
#include "ui/widgets/theme.h"

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

// Of fixtures whose channels do not say how far.
constexpr fixture::AxisRange kZoom{1, 80}, kPan{-270, 270}, kTilt{-135, 135};

constexpr double kSame = 0.05; // numbers of a row that are as good as one
constexpr int kParametersEvery_ms = 250;
constexpr int kGobo_px = 24; // its picture in the list

// For head_values.
std::string word_of(fixture::Role role) {
    switch (role) {
    case fixture::Role::zoom:
        return "zoom";
    case fixture::Role::pan:
        return "pan";
    case fixture::Role::tilt:
        return "tilt";
    default:
        return "intensity";
    }
}

ValueRange range_of(const fixture::AxisRange& reach) {
    return {static_cast<double>(reach.low), static_cast<double>(reach.high), 1, "\u00b0"};
}

} // namespace

ProgrammerPanel::ProgrammerPanel(AppModel& app, PaletteList& palettes, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app) {
    title_ = new QLabel(this);
    title_->setWordWrap(true);
    auto* const inside = new QWidget(this);
    column_ = new QVBoxLayout(inside);
    column_->setContentsMargins(0, 0, 0, 0);
    add_row(translated("Programmer", "Intensity"), {0, 100, 0, " %"},
            static_cast<int>(ProgrammerStep::intensity), fixture::Role::dimmer,
            &fixture::Programmer::intensity, &FixtureNow::dimmer, 0.01);
    zoom_ = add_row(translated("Programmer", "Zoom"), range_of(kZoom), static_cast<int>(ProgrammerStep::zoom),
                    fixture::Role::zoom, &fixture::Programmer::zoom_deg, &FixtureNow::zoom_deg, 1);
    pan_ = add_row(translated("Programmer", "Pan"), range_of(kPan), static_cast<int>(ProgrammerStep::pan),
                   fixture::Role::pan, &fixture::Programmer::pan_deg, &FixtureNow::pan_deg, 1);
    tilt_ = add_row(translated("Programmer", "Tilt"), range_of(kTilt), static_cast<int>(ProgrammerStep::tilt),
                    fixture::Role::tilt, &fixture::Programmer::tilt_deg, &FixtureNow::tilt_deg, 1);
    colour_ = new ColourRow(translated("Programmer", "Colour"), this);
    column_->addWidget(colour_);
    colour_->on_change = [this](const QColor& colour) {
        change_selected(app_, translated("Undo", "colour"), ProgrammerStep::colour,
                        [&](fixture::Programmer& programmer) { programmer.colour = filter_from(colour); });
    };
    colour_->on_release = [this] {
        change_selected(app_, translated("Undo", "release %1").arg(translated("Undo", "colour")),
                        ProgrammerStep::step,
                        [](fixture::Programmer& programmer) { programmer.colour.reset(); });
    };
    gobo_ = new QComboBox(this);
    gobo_->setAccessibleName(translated("Programmer", "Gobo"));
    gobo_->setIconSize({kGobo_px, kGobo_px});
    gobo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(gobo_, &QComboBox::activated, this, [this](int index) {
        change_selected(app_, translated("Undo", "gobo"), ProgrammerStep::gobo,
                        [&](fixture::Programmer& programmer) {
                            if (index == 0)
                                programmer.gobo.reset();
                            else
                                programmer.gobo = index - 1;
                        });
    });
    hold_ = new QPushButton(translated("Programmer", "Hold (H)"), this);
    hold_->setToolTip(translated(
        "Programmer", "What the desk asks of the selected fixtures stays, whatever it sends then"));
    connect(hold_, &QPushButton::clicked, this, [&actions] { actions.choose("hold"); });
    release_ = new QPushButton(translated("Programmer", "Give back (R)"), this);
    release_->setToolTip(translated("Programmer", "What is set by hand of the selected fixtures"));
    connect(release_, &QPushButton::clicked, this, [&actions] { actions.choose("release"); });
    release_all_ = new QPushButton(translated("Programmer", "Give all back (Shift+R)"), this);
    release_all_->setToolTip(
        translated("Programmer", "All that is set by hand, whatever is selected: fixtures, scene, objects"));
    connect(release_all_, &QPushButton::clicked, this, [&actions] { actions.choose("release-all"); });
    auto* gobo = new QHBoxLayout;
    gobo->setSpacing(ValueRow::kBetween_px);
    gobo_label_ = new QLabel(translated("Programmer", "Gobo"), this);
    gobo_label_->setObjectName("gobo");
    gobo_label_->setBuddy(gobo_);
    gobo_label_->setFixedWidth(ValueRow::label_width(*this));
    gobo->addWidget(gobo_label_);
    gobo->addWidget(gobo_, 1);
    column_->addLayout(gobo);
    palettes_ = new PaletteBox(app_, palettes, actions, this);
    column_->addWidget(palettes_);
    fan_ = new FanBox(app_, actions, this);
    column_->addWidget(fan_);
    column_->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 4, 6);
    layout->addWidget(title_);
    layout->addWidget(scroll, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(hold_);
    buttons->addWidget(release_, 1);
    layout->addLayout(buttons);
    layout->addWidget(release_all_);
    parameter_timer_.setSingleShot(true);
    parameter_timer_.setInterval(kParametersEvery_ms);
    connect(&parameter_timer_, &QTimer::timeout, this, &ProgrammerPanel::refresh_parameters);
    connect(&app_, &AppModel::selection_changed, this, &ProgrammerPanel::take_kinds);
    for (const auto signal : {&AppModel::selection_changed, &AppModel::look_changed, &AppModel::rig_came})
        connect(&app_, signal, this, &ProgrammerPanel::refresh);
    for (const auto signal : {&AppModel::selection_changed, &AppModel::look_changed})
        connect(&app_, signal, this, &ProgrammerPanel::refresh_parameters);
    connect(&app_, &AppModel::rig_came, this, [this] {
        if (!parameter_timer_.isActive()) parameter_timer_.start();
    });
    refresh();
}

ValueRow* ProgrammerPanel::add_row(const QString& name, const ValueRange& range, int kind, fixture::Role role,
                                   std::optional<float> fixture::Programmer::*value, float FixtureNow::*now,
                                   double per_unit) {
    auto* row = new ValueRow(name, range, this);
    column_->addWidget(row);
    row->on_change = [this, name, kind, value, per_unit](double number) {
        change_selected(app_, name.toLower(), static_cast<ProgrammerStep>(kind),
                        [&](fixture::Programmer& programmer) {
                            programmer.*value = static_cast<float>(number * per_unit);
                        });
    };
    row->on_mixed_step = [this, name, kind, role, value, now, per_unit, range](double by) {
        Look look = app_.look();
        for (const std::size_t index : app_.selection()) {
            if (index >= app_.rig().fixtures.size()) continue;
            const scene::PatchedFixture& fixture = app_.show()->fixtures[index];
            // Whatever a file counts its dimmer in, a hand counts from 0 to 1.
            const std::optional<fixture::AxisRange> reach = fixture.type && role != fixture::Role::dimmer
                                                                ? fixture::reach_of(fixture.patch(), role)
                                                                : std::nullopt;
            const double low = reach ? static_cast<double>(reach->low) : range.low * per_unit,
                         high = reach ? static_cast<double>(reach->high) : range.high * per_unit;
            const float before = (programmer_of(index).*value).value_or(app_.rig().fixtures[index].*now);
            look.fixtures[index].*value =
                static_cast<float>(std::clamp(static_cast<double>(before) + by * per_unit, low, high));
        }
        app_.set_look(std::move(look), name.toLower(), kind);
    };
    row->on_mixed_drag = [this, name, kind, role, per_unit](double from, double to, bool begins) {
        move_each(name.toLower(), word_of(role), kind, static_cast<float>((to - from) * per_unit), begins);
    };
    row->on_refresh = [this] { refresh(); };
    row->on_release = [this, name, role, value] {
        Look look = app_.look();
        for (const std::size_t index : app_.selection()) {
            (look.fixtures[index].*value).reset();
            give_back(app_.show()->fixtures[index], role, look.fixtures[index]);
        }
        app_.set_look(std::move(look), translated("Undo", "release %1").arg(name.toLower()));
    };
    rows_.push_back({row, role, value, now, per_unit});
    return row;
}

void ProgrammerPanel::move_each(const QString& name, const std::string& word, int kind, float by,
                                bool begins) {
    if (!app_.show()) return;
    if (begins) {
        before_.clear();
        const HeadReader reader(*app_.show(), app_.look(), app_.rig());
        for (const std::size_t index : app_.selection())
            if (const std::optional<HeadValue> value = reader.value(index, word))
                before_.insert_or_assign(index, *value);
    }
    Look look = app_.look();
    for (const auto& [index, value] : before_) {
        const float* const number = std::get_if<float>(&value);
        if (number && app_.selection().contains(index))
            set_value(app_.show()->fixtures[index], word, *number + by, look.fixtures[index]);
    }
    app_.set_look(std::move(look), name, kind);
}

fixture::Programmer ProgrammerPanel::programmer_of(std::size_t fixture) const {
    const auto found = app_.look().fixtures.find(fixture);
    return found == app_.look().fixtures.end() ? fixture::Programmer{} : found->second;
}

bool ProgrammerPanel::is_by_hand(const Row& row, std::size_t fixture) const {
    const auto found = app_.look().fixtures.find(fixture);
    return found != app_.look().fixtures.end() &&
           ((found->second.*row.value).has_value() ||
            holds(app_.show()->fixtures[fixture], row.role, found->second));
}

// As far as any of the selected goes.
void ProgrammerPanel::set_reach(ValueRow& row, fixture::Role role, const fixture::AxisRange& otherwise) {
    std::optional<fixture::AxisRange> widest;
    for (const std::size_t index : app_.selection()) {
        const scene::PatchedFixture& fixture = app_.show()->fixtures[index];
        if (!fixture.type) continue;
        const std::optional<fixture::AxisRange> reach = fixture::reach_of(fixture.patch(), role);
        if (!reach) continue;
        widest = widest ? fixture::AxisRange{std::min(widest->low, reach->low),
                                             std::max(widest->high, reach->high)}
                        : *reach;
    }
    const fixture::AxisRange reach = widest.value_or(otherwise);
    row.set_reach(static_cast<double>(reach.low), static_cast<double>(reach.high));
}

void ProgrammerPanel::take_kinds() {
    make_parameters();
    if (app_.show() && app_.current()) {
        set_reach(*zoom_, fixture::Role::zoom, kZoom);
        set_reach(*pan_, fixture::Role::pan, kPan);
        set_reach(*tilt_, fixture::Role::tilt, kTilt);
    }
    gobo_->clear();
    const auto current = app_.current();
    if (!app_.show() || !current) return;
    gobo_->addItem(translated("Programmer", "As the desk says"));
    for (const std::size_t index : app_.selection()) { // the first that has gobos
        const scene::PatchedFixture& fixture = app_.show()->fixtures[index];
        if (!fixture.type) continue;
        int slot = 0;
        const int wheel = gobo_wheel_of(fixture);
        const int side_px = gobo_->iconSize().width();
        for (const std::string& name : fixture::gobo_names(fixture.patch())) {
            gobo_->addItem(pictures_.of(fixture.type, wheel, slot, side_px),
                           QString("%1  %2").arg(slot).arg(QString::fromStdString(name)));
            ++slot;
        }
        if (slot > 0) return;
    }
}

// Rows stay where the heads that are selected now have the same parameters.
void ProgrammerPanel::make_parameters() {
    std::vector<HeadParameter> parameters =
        app_.show() ? parameters_of(*app_.show(), app_.selection()) : std::vector<HeadParameter>{};
    const bool same = std::equal(parameters.begin(), parameters.end(), parameters_.begin(), parameters_.end(),
                                 [](const HeadParameter& a, const HeadParameter& b) {
                                     return a.attribute == b.attribute && a.ranges.size() == b.ranges.size();
                                 });
    if (same && parameter_box_) return;
    parameters_ = std::move(parameters);
    fan_->set_parameters(parameters_);
    parameter_rows_.clear();
    delete parameter_box_;
    parameter_box_ = new QWidget(this);
    auto* layout = new QVBoxLayout(parameter_box_);
    layout->setContentsMargins(0, 0, 0, 0);
    QString group;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        const HeadParameter& parameter = parameters_[i];
        if (parameter.group != group) {
            group = parameter.group;
            auto* heading = new QLabel(translated("Parameter", group.toUtf8().constData()), parameter_box_);
            QFont font = heading->font();
            font.setBold(true);
            heading->setFont(font);
            layout->addWidget(heading);
        }
        auto* row = new ParameterRow(parameter, pictures_, parameter_box_);
        layout->addWidget(row);
        parameter_rows_.push_back(row);
        const auto set = [this, attribute = parameter.attribute](Look& look, std::optional<float> share) {
            for (const std::size_t index : app_.selection())
                set_parameter(app_.show()->fixtures[index], attribute, share, look.fixtures[index]);
        };
        row->on_change = [this, set, i, name = parameter.name](float share) {
            Look look = app_.look();
            set(look, share);
            app_.set_look(std::move(look), name.toLower(),
                          static_cast<int>(ProgrammerStep::first_parameter) + static_cast<int>(i));
        };
        row->on_mixed_drag = [this, i, name = parameter.name,
                              attribute = parameter.attribute](float from, float to, bool begins) {
            move_each(name.toLower(), attribute,
                      static_cast<int>(ProgrammerStep::first_parameter) + static_cast<int>(i), to - from,
                      begins);
        };
        row->on_refresh = [this] { refresh_parameters(); };
        row->on_release = [this, set, name = parameter.name] {
            Look look = app_.look();
            set(look, std::nullopt);
            app_.set_look(std::move(look), translated("Undo", "release %1").arg(name.toLower()));
        };
    }
    column_->insertWidget(column_->count() - 1, parameter_box_);
    parameter_box_->show();
}

void ProgrammerPanel::refresh() {
    const auto current = app_.current();
    const bool any = app_.show() && current && *current < app_.rig().fixtures.size();
    for (const Row& row : rows_) row.row->setEnabled(any);
    for (QWidget* one : std::initializer_list<QWidget*>{colour_, gobo_, hold_}) one->setEnabled(any);
    release_->setEnabled(std::any_of(app_.selection().begin(), app_.selection().end(),
                                     [this](std::size_t one) { return app_.look().fixtures.contains(one); }));
    release_all_->setEnabled(app_.show() && !app_.look().is_empty());
    if (!any) {
        title_->setText(
            translated("Programmer", "Select fixtures to light the scene by hand, with or without a desk."));
        for (const Row& row : rows_) row.row->show_value(0, false);
        colour_->show_colour(Qt::black, false);
        return;
    }
    const std::size_t count = app_.selection().size();
    title_->setText(count == 1 ? QString::fromStdString(app_.show()->fixtures[*current].name)
                               : translated("Fixtures", "%n fixture(s)", nullptr, count));
    const std::vector<FixtureNow>& now = app_.rig().fixtures;
    for (const Row& row : rows_) {
        const auto shown = [&](std::size_t index) {
            return static_cast<double>((programmer_of(index).*row.value).value_or(now[index].*row.now)) /
                   row.per_unit;
        };
        bool by_hand = false, mixed = false;
        for (const std::size_t index : app_.selection()) {
            if (index >= now.size()) continue;
            by_hand = by_hand || is_by_hand(row, index);
            mixed = mixed || std::abs(shown(index) - shown(*current)) > kSame;
        }
        row.row->show_value(shown(*current), by_hand, mixed);
    }
    const fixture::Programmer programmer = programmer_of(*current);
    const auto colour_of = [&](std::size_t index) {
        return screen_colour(programmer_of(index).colour.value_or(now[index].colour));
    };
    bool by_hand = false, mixed = false;
    for (const std::size_t index : app_.selection()) {
        if (index >= now.size()) continue;
        by_hand = by_hand || programmer_of(index).colour.has_value();
        mixed = mixed || colour_of(index) != colour_of(*current);
    }
    colour_->show_colour(colour_of(*current), by_hand, mixed);
    if (!gobo_->view()->isVisible()) gobo_->setCurrentIndex(programmer.gobo ? *programmer.gobo + 1 : 0);
    const bool gobo_by_hand =
        std::any_of(app_.selection().begin(), app_.selection().end(), [&](std::size_t index) {
            return index < now.size() && programmer_of(index).gobo.has_value();
        });
    QPalette colours = palette();
    if (gobo_by_hand) colours.setColor(QPalette::WindowText, accent());
    gobo_label_->setPalette(colours);
}

void ProgrammerPanel::refresh_parameters() {
    if (!app_.show() || parameters_.empty()) return;
    const fixture::Levels levels = levels_of(app_.rig().universes);
    std::vector<std::optional<ParameterValue>> shown(parameters_.size());
    std::vector<bool> mixed(parameters_.size(), false);
    for (const std::size_t index : app_.selection()) {
        if (index >= app_.show()->fixtures.size()) continue;
        const auto values =
            values_of(app_.show()->fixtures[index], programmer_of(index), levels, parameters_);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!values[i]) continue;
            if (!shown[i]) {
                shown[i] = values[i];
            } else {
                mixed[i] = mixed[i] || std::abs(shown[i]->share - values[i]->share) > 1e-4f;
                shown[i]->by_hand = shown[i]->by_hand || values[i]->by_hand;
            }
        }
    }
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (shown[i]) parameter_rows_[i]->show_value(*shown[i], mixed[i]);
}

} // namespace ghost::ui
