// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/scene_panel.h"

#include "show/show.h"
#include "stage/overrides.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/panel_parts/mover_box.h"

#include <QVBoxLayout>

namespace ghost::ui {
namespace {

constexpr float kMostShininess = 4000;

// The other way round than scene::roughness_from_shininess.
float shininess_from_roughness(float roughness) {
    const float alpha = std::max(roughness * roughness, 1e-3f);
    return std::clamp(2.0f / (alpha * alpha) - 2.0f, 0.0f, kMostShininess);
}

template <class T>
ValueRow* scene_row(AppModel& app, const QString& name, const ValueRange& range, QWidget* parent,
                    std::optional<T> SceneLook::*value) {
    auto* row = new ValueRow(name, range, parent);
    row->on_change = [&app, name, value](double number) {
        change_scene(app, name.toLower(), ProgrammerStep::scene,
                     [&](SceneLook& scene) { scene.*value = static_cast<T>(number); });
    };
    row->on_release = [&app, name, value] {
        change_scene(app, translated("Undo", "release %1").arg(name.toLower()), ProgrammerStep::step,
                     [&](SceneLook& scene) { (scene.*value).reset(); });
    };
    return row;
}

} // namespace

ScenePanel::ScenePanel(AppModel& app, QWidget* parent) : QWidget(parent), app_(app) {
    auto* layout = new QVBoxLayout(this);
    add_air(layout);
    auto* movers = new MoverBox(app_, this);
    connect(movers, &MoverBox::asks_for, this, &ScenePanel::asks_for);
    layout->addWidget(movers);
    add_stage(layout);
    connect(&app_, &AppModel::opened_show, this, &ScenePanel::fill);
    for (const auto signal : {&AppModel::look_changed, &AppModel::request_changed,
                              &AppModel::selection_changed, &AppModel::marked_changed})
        connect(&app_, signal, this, &ScenePanel::refresh);
    setEnabled(false);
}

void ScenePanel::add_air(QLayout* layout) {
    smoke_ = scene_row(app_, translated("Scene", "Smoke"), {0, 5, 2, " x"}, this, &SceneLook::smoke);
    ambient_ =
        scene_row(app_, translated("Scene", "Even light"), {0, 200, 1, " lx"}, this, &SceneLook::ambient_lux);
    layout->addWidget(smoke_);
    layout->addWidget(ambient_);
    colour_ = new ColourRow(translated("Scene", "Its colour"), this);
    colour_->setToolTip(translated("Scene", "Of the even light"));
    colour_->on_change = [this](const QColor& colour) {
        change_scene(app_, translated("Undo", "colour of the even light"), ProgrammerStep::scene,
                     [&](SceneLook& scene) { scene.ambient_colour = filter_from(colour); });
    };
    colour_->on_release = [this] {
        change_scene(app_, translated("Undo", "release the colour of the even light"), ProgrammerStep::step,
                     [](SceneLook& scene) { scene.ambient_colour.reset(); });
    };
    layout->addWidget(colour_);
    static const char* const kFactors[] = {QT_TRANSLATE_NOOP("Scene", "Constant"),
                                           QT_TRANSLATE_NOOP("Scene", "Linear"),
                                           QT_TRANSLATE_NOOP("Scene", "Quadratic")};
    for (int k = 0; k < 3; ++k) {
        attenuation_[k] = new ValueRow(translated("Scene", kFactors[k]), {0, 2, 2, ""}, this);
        attenuation_[k]->setToolTip(translated(
            "Scene", "Light falls with 1 / (constant + linear d + quadratic d²); 0, 0, 1 is physics."));
        attenuation_[k]->on_change = [this, k](double value) { change_attenuation(k, value); };
        attenuation_[k]->on_release = [this] {
            change_scene(app_, translated("Undo", "release attenuation"), ProgrammerStep::step,
                         [](SceneLook& scene) { scene.attenuation.reset(); });
        };
        layout->addWidget(attenuation_[k]);
    }
    samples_ = new ValueRow(translated("Scene", "Samples"), {1, 64, 0, ""}, this);
    samples_->setToolTip(translated("Scene", "Of the haze, along a ray through one beam. Fewer are faster."));
    samples_->on_change = [this](double value) { change_samples(app_, static_cast<int>(value)); };
    samples_->on_release = [this] { change_samples(app_, std::nullopt); };
    layout->addWidget(samples_);
    shadows_ = new QCheckBox(translated("Scene", "Shadows"), this);
    connect(shadows_, &QCheckBox::clicked, this, [this](bool on) {
        change_scene(app_, translated("Undo", "shadows"), ProgrammerStep::step, [&](SceneLook& scene) {
            scene.shadows = on == app_.show()->shadows ? std::nullopt : std::optional(on);
        });
    });
    layout->addWidget(shadows_);
    auto* air = new QPushButton(translated("Scene", "Haze, wind and hazers of the show..."), this);
    connect(air, &QPushButton::clicked, this, &ScenePanel::asks_for_air);
    layout->addWidget(air);
}

void ScenePanel::add_stage(QLayout* layout) {
    stage_ = new StageTree(app_, this);
    connect(stage_, &StageTree::chose, this, &ScenePanel::refresh);
    layout->addWidget(stage_);
    hang_ = new QPushButton(translated("Scene", "Hang the selected fixtures under it"), this);
    hang_->setToolTip(translated(
        "Scene",
        "Evenly along the truss or pipe that is chosen, with all its pieces; one alone where it is nearest"));
    connect(hang_, &QPushButton::clicked, this, [this] {
        if (const auto object = stage_->object()) Q_EMIT asks_to_hang(*object);
    });
    layout->addWidget(hang_);
    fly_ = new QPushButton(translated("Scene", "Fly it on two hoists"), this);
    fly_->setToolTip(translated(
        "Scene", "The truss with all its pieces and the fixtures under it; Movers above then drive it"));
    connect(fly_, &QPushButton::clicked, this, [this] {
        if (stage_->object()) Q_EMIT asks_for("fly-on-hoists");
    });
    layout->addWidget(fly_);
    const auto surface_row = [&](const QString& name, const ValueRange& range,
                                 std::optional<float> SurfaceLook::*value, auto convert) {
        auto* row = new ValueRow(name, range, this);
        row->on_change = [this, name, value, convert](double number) {
            if (!material()) return;
            Look look = app_.look();
            look.surfaces[*material()].*value = convert(static_cast<float>(number));
            app_.set_look(std::move(look), name.toLower(), static_cast<int>(ProgrammerStep::surface));
        };
        row->on_release = [this, name, value] {
            if (!material()) return;
            Look look = app_.look();
            (look.surfaces[*material()].*value).reset();
            app_.set_look(std::move(look), translated("Undo", "release %1").arg(name.toLower()));
        };
        layout->addWidget(row);
        return row;
    };
    specular_ = surface_row(translated("Scene", "Specular"), {0, 1, 2, ""}, &SurfaceLook::specular,
                            [](float value) { return value; });
    shininess_ = surface_row(translated("Scene", "Shininess"), {1, kMostShininess, 0, "", true},
                             &SurfaceLook::roughness,
                             [](float value) { return scene::roughness_from_shininess(value); });
}

std::optional<std::size_t> ScenePanel::material() const {
    const auto object = stage_->object();
    if (!object) return std::nullopt;
    const std::size_t index = app_.opened().objects[*object].material;
    return index < app_.opened().materials.size() ? std::optional(index) : std::nullopt;
}

void ScenePanel::change_attenuation(int factor, double value) {
    const scene::Attenuation& own = app_.show()->attenuation;
    glm::vec3 factors =
        app_.look().scene.attenuation.value_or(glm::vec3(own.constant, own.linear, own.quadratic));
    factors[factor] = static_cast<float>(value);
    if (factors == glm::vec3(0)) factors[factor] = 0.01f; // light that never falls is none
    change_scene(app_, translated("Undo", "attenuation"), ProgrammerStep::scene,
                 [&](SceneLook& scene) { scene.attenuation = factors; });
}

void ScenePanel::fill() {
    setEnabled(true);
    stage_->fill();
    refresh();
}

void ScenePanel::refresh() {
    if (!app_.show()) return;
    const scene::Show& show = *app_.show();
    const SceneLook& look = app_.look().scene;
    smoke_->show_value(static_cast<double>(look.smoke.value_or(1)), look.smoke.has_value());
    ambient_->show_value(static_cast<double>(look.ambient_lux.value_or(show.ambient_lux)),
                         look.ambient_lux.has_value());
    colour_->show_colour(screen_colour(look.ambient_colour.value_or(show.ambient_colour)),
                         look.ambient_colour.has_value());
    const glm::vec3 factors = look.attenuation.value_or(
        glm::vec3(show.attenuation.constant, show.attenuation.linear, show.attenuation.quadratic));
    for (int k = 0; k < 3; ++k)
        attenuation_[k]->show_value(static_cast<double>(factors[k]), look.attenuation.has_value());
    const std::optional<int> samples = app_.look().haze_samples;
    samples_->show_value(samples.value_or(kHazeSamples), samples.has_value());
    shadows_->setChecked(look.shadows.value_or(show.shadows));
    stage_->refresh();
    const auto object = stage_->object();
    fly_->setEnabled(object && app_.opened().objects[*object].bar &&
                     app_.opened().objects[*object].mover == scene::kNoMover);
    hang_->setEnabled(object && app_.opened().objects[*object].bar && !app_.selection().empty());
    specular_->setEnabled(material().has_value());
    shininess_->setEnabled(material().has_value());
    if (material()) {
        const scene::Material& own = app_.opened().materials[*material()];
        const auto found = app_.look().surfaces.find(*material());
        const SurfaceLook surface = found == app_.look().surfaces.end() ? SurfaceLook{} : found->second;
        specular_->show_value(static_cast<double>(surface.specular.value_or(own.specular)),
                              surface.specular.has_value());
        shininess_->show_value(
            static_cast<double>(shininess_from_roughness(surface.roughness.value_or(own.roughness))),
            surface.roughness.has_value());
    }
}

} // namespace ghost::ui
