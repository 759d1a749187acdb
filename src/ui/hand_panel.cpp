// SPDX-License-Identifier: Apache-2.0
#include "ui/hand_panel.h"

#include "ui/hand.h"

#include <QAbstractItemView>
#include <QFormLayout>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

// Of fixtures whose channels do not say how far.
constexpr fixture::Reach kZoom{1, 80}, kPan{-270, 270}, kTilt{-135, 135};

ValueRange range_of(const fixture::Reach& reach) {
    return {static_cast<double>(reach.low), static_cast<double>(reach.high), 1, " deg"};
}

} // namespace

HandPanel::HandPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    title_ = new QLabel(this);
    title_->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(title_);
    intensity_ = add_row("Intensity", {0, 100, 0, " %"}, static_cast<int>(Hand::intensity),
                         &fixture::Manual::intensity, 0.01);
    zoom_ = add_row("Zoom", range_of(kZoom), static_cast<int>(Hand::zoom), &fixture::Manual::zoom_deg, 1);
    pan_ = add_row("Pan", range_of(kPan), static_cast<int>(Hand::pan), &fixture::Manual::pan_deg, 1);
    tilt_ = add_row("Tilt", range_of(kTilt), static_cast<int>(Hand::tilt), &fixture::Manual::tilt_deg, 1);
    colour_ = new ColourRow("Colour", this);
    layout->addWidget(colour_);
    colour_->on_change = [this](const QColor& colour) {
        change_selected(studio_, "colour", Hand::colour,
                        [&](fixture::Manual& manual) { manual.colour = filter_from(colour); });
    };
    colour_->on_release = [this] {
        change_selected(studio_, "release colour", Hand::step,
                        [](fixture::Manual& manual) { manual.colour.reset(); });
    };
    gobo_ = new QComboBox(this);
    gobo_->setAccessibleName("Gobo");
    connect(gobo_, &QComboBox::activated, this, [this](int index) {
        change_selected(studio_, "gobo", Hand::gobo, [&](fixture::Manual& manual) {
            if (index == 0)
                manual.gobo.reset();
            else
                manual.gobo = index - 1;
        });
    });
    release_ = new QPushButton("Give all back (R)", this);
    connect(release_, &QPushButton::clicked, this, [this] {
        change_selected(studio_, "release", Hand::step, [](fixture::Manual& manual) { manual = {}; });
    });
    auto* form = new QFormLayout;
    form->addRow("Gobo", gobo_);
    layout->addLayout(form);
    layout->addWidget(release_);
    layout->addStretch(1);
    connect(&studio_, &Studio::selection_changed, this, &HandPanel::take_kinds);
    for (const auto signal : {&Studio::selection_changed, &Studio::look_changed, &Studio::rig_came})
        connect(&studio_, signal, this, &HandPanel::refresh);
    refresh();
}

ValueRow* HandPanel::add_row(const QString& name, const ValueRange& range, int kind,
                             std::optional<float> fixture::Manual::*value, double per_unit) {
    auto* row = new ValueRow(name, range, this);
    layout()->addWidget(row);
    row->on_change = [this, name, kind, value, per_unit](double number) {
        change_selected(studio_, name.toLower(), static_cast<Hand>(kind), [&](fixture::Manual& manual) {
            manual.*value = static_cast<float>(number * per_unit);
        });
    };
    row->on_release = [this, name, value] {
        change_selected(studio_, "release " + name.toLower(), Hand::step,
                        [&](fixture::Manual& manual) { (manual.*value).reset(); });
    };
    return row;
}

// As far as any of the selected goes.
void HandPanel::set_reach(ValueRow& row, fixture::Role role, const fixture::Reach& otherwise) {
    std::optional<fixture::Reach> widest;
    for (const std::size_t index : studio_.selection()) {
        const scene::PatchedFixture& fixture = studio_.show()->fixtures[index];
        if (!fixture.type) continue;
        const std::optional<fixture::Reach> reach = fixture::reach_of(fixture.patch(), role);
        if (!reach) continue;
        widest = widest
                     ? fixture::Reach{std::min(widest->low, reach->low), std::max(widest->high, reach->high)}
                     : *reach;
    }
    const fixture::Reach reach = widest.value_or(otherwise);
    row.set_reach(static_cast<double>(reach.low), static_cast<double>(reach.high));
}

void HandPanel::take_kinds() {
    if (studio_.show() && studio_.current()) {
        set_reach(*zoom_, fixture::Role::zoom, kZoom);
        set_reach(*pan_, fixture::Role::pan, kPan);
        set_reach(*tilt_, fixture::Role::tilt, kTilt);
    }
    gobo_->clear();
    const auto current = studio_.current();
    if (!studio_.show() || !current) return;
    gobo_->addItem("As the desk says");
    for (const std::size_t index : studio_.selection()) { // the first that has gobos
        const scene::PatchedFixture& fixture = studio_.show()->fixtures[index];
        if (!fixture.type) continue;
        int slot = 0;
        for (const std::string& name : fixture::gobo_names(fixture.patch()))
            gobo_->addItem(QString("%1  %2").arg(slot++).arg(QString::fromStdString(name)));
        if (slot > 0) return;
    }
}

void HandPanel::refresh() {
    const auto current = studio_.current();
    const bool any = studio_.show() && current && *current < studio_.rig().fixtures.size();
    for (QWidget* one :
         std::initializer_list<QWidget*>{intensity_, zoom_, pan_, tilt_, colour_, gobo_, release_})
        one->setEnabled(any);
    if (!any) {
        title_->setText("Select fixtures to light the scene by hand, with or without a desk.");
        return;
    }
    const QString name = QString::fromStdString(studio_.show()->fixtures[*current].name);
    title_->setText(studio_.selection().size() == 1
                        ? name
                        : QString("%1 and %2 more").arg(name).arg(studio_.selection().size() - 1));
    const FixtureNow& now = studio_.rig().fixtures[*current];
    const auto found = studio_.look().fixtures.find(*current);
    const fixture::Manual manual = found == studio_.look().fixtures.end() ? fixture::Manual{} : found->second;
    const auto show = [](ValueRow* row, const std::optional<float>& by_hand, float is, double per_unit) {
        row->show_value(static_cast<double>(by_hand.value_or(is)) * per_unit, by_hand.has_value());
    };
    show(intensity_, manual.intensity, now.dimmer, 100);
    show(zoom_, manual.zoom_deg, now.zoom_deg, 1);
    show(pan_, manual.pan_deg, now.pan_deg, 1);
    show(tilt_, manual.tilt_deg, now.tilt_deg, 1);
    colour_->show_colour(screen_colour(manual.colour.value_or(now.colour)), manual.colour.has_value());
    if (!gobo_->view()->isVisible()) gobo_->setCurrentIndex(manual.gobo ? *manual.gobo + 1 : 0);
}

} // namespace ghost::ui
