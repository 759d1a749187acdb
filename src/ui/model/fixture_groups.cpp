// SPDX-License-Identifier: Apache-2.0
#include "ui/model/fixture_groups.h"

#include "mvr/mvr_load.h"
#include "show/show.h"
#include "ui/language/language.h"

#include <algorithm>
#include <map>

namespace ghost::ui {
namespace {

constexpr float kHangsWithin_m = 1.0f; // of the underside of its truss

using Groups = std::map<QString, std::set<std::size_t>>;

void append(const Groups& groups, std::vector<FixtureGroup>& all) {
    for (const auto& [title, fixtures] : groups) all.push_back({title, fixtures});
}

float distance_m(const scene::Bar& bar, const glm::vec3& at_m) {
    const glm::vec3 along = bar.to_m - bar.from_m;
    const float share =
        std::clamp(glm::dot(at_m - bar.from_m, along) / std::max(glm::dot(along, along), 1e-6f), 0.0f, 1.0f);
    return glm::distance(at_m, bar.from_m + share * along);
}

// Of plots that have layers.
std::map<std::string, QString> layers_of(const scene::Show& show) {
    std::map<std::string, QString> layers;
    if (!show.plot) return layers;
    for (const scene::PlotObject& object : show.plot->plot.objects)
        if (object.layer >= 0)
            layers[object.uuid] =
                QString::fromStdString(show.plot->plot.layers[static_cast<std::size_t>(object.layer)].name);
    return layers;
}

bool has_own_optics(const scene::PatchedFixture& fixture) {
    if (!fixture.type) return false;
    const fixture::Patch patch = fixture.patch();
    const fixture::Mode& mode = patch.mode_of();
    return std::any_of(mode.beams.begin(), mode.beams.end(), [&](int node) {
        const int geometry = mode.nodes[static_cast<std::size_t>(node)].geometry;
        const auto& beam = fixture.type->geometries[static_cast<std::size_t>(geometry)].beam;
        return beam && !beam->is_assumed;
    });
}

} // namespace

std::vector<FixtureGroup> groups_of(const scene::Show& show, const std::vector<Object>& objects) {
    Groups types, layers, trusses;
    const std::map<std::string, QString> layer_of = layers_of(show);
    std::vector<const Object*> bars;
    for (const Object& object : objects)
        if (object.bar && scene::is_slender(*object.bar)) bars.push_back(&object);
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const scene::PatchedFixture& fixture = show.fixtures[i];
        types[translated("Fixtures", "Type: %1")
                  .arg(QString::fromStdString(fixture.type ? fixture.type->name : fixture.gdtf.string()))]
            .insert(i);
        if (const auto layer = layer_of.find(fixture.uuid); !fixture.uuid.empty() && layer != layer_of.end())
            layers[translated("Fixtures", "Layer: %1").arg(layer->second)].insert(i);
        const Object* nearest = nullptr;
        float nearest_m = kHangsWithin_m;
        for (const Object* const bar : bars)
            if (const float away_m = distance_m(*bar->bar, fixture.position_m); away_m < nearest_m) {
                nearest = bar;
                nearest_m = away_m;
            }
        if (nearest)
            trusses[translated("Fixtures", "Under: %1").arg(QString::fromStdString(nearest->name))].insert(i);
    }
    std::vector<FixtureGroup> all;
    for (const Groups* const groups : {&types, &layers, &trusses}) append(*groups, all);
    return all;
}

std::vector<FixtureGroup> dark_groups_of(const std::vector<Verdict>& verdicts) {
    Groups reasons;
    for (std::size_t i = 0; i < verdicts.size(); ++i)
        if (verdicts[i].visibility != scene::Visibility::lit) reasons[said(verdicts[i].group)].insert(i);
    std::vector<FixtureGroup> all;
    append(reasons, all);
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.fixtures.size() > b.fixtures.size(); });
    return all;
}

QString held_back(const ViewRequest& request, const RemoteNow& remote) {
    if (request.black_out) return translated("Dark", "BLACK-OUT: nothing shines until it ends (B)");
    if (remote.black_out) return translated("Dark", "BLACK-OUT of a remote control: nothing shines");
    if (request.master <= 0) return translated("Dark", "The master is at 0 %: nothing shines");
    if (remote.master <= 0)
        return translated("Dark", "The master of a remote control is at 0 %: nothing shines");
    return {};
}

QString held_back(const ViewRequest& request, const RemoteNow& remote, const Look& look,
                  std::size_t fixture) {
    if (const QString all = held_back(request, remote); !all.isEmpty()) return all;
    if (look.solo.empty() || look.solo.contains(fixture)) return {};
    return translated("Dark", "Others are solo: this one is dark until they are not");
}

bool can_shine(const scene::PatchedFixture& fixture) {
    return fixture.type && !fixture.patch().mode_of().beams.empty();
}

std::vector<FixtureGroup> without_optics(const scene::Show& show) {
    Groups files;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i)
        if (const scene::PatchedFixture& fixture = show.fixtures[i];
            !fixture.uuid.empty() && !fixture.gdtf.empty() && !has_own_optics(fixture))
            files[QString::fromStdString(fixture.gdtf.string())].insert(i);
    std::vector<FixtureGroup> all;
    append(files, all);
    return all;
}

} // namespace ghost::ui
