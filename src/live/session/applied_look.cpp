// SPDX-License-Identifier: Apache-2.0
#include "live/session/applied_look.h"

#include "light/bodies.h"
#include "link/carried.h"
#include "stage/box.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace ghost::app {
namespace {

// The box of an instance, as a ball.
ui::Object object_of(const scene::Stage& stage, std::size_t instance) {
    const scene::Instance& placed = stage.instances[instance];
    const scene::Mesh& mesh = stage.meshes[static_cast<std::size_t>(placed.mesh)];
    scene::Box box;
    for (const glm::vec3& position : mesh.positions)
        box.add(glm::vec3(placed.world * glm::vec4(position, 1.0f)));
    ui::Object object{placed.name, instance, static_cast<std::size_t>(std::max(mesh.material, 0)),
                      placed.shown};
    object.layer = placed.layer;
    if (mesh.positions.empty()) return object;
    object.centre_m = box.middle_m();
    object.half_size_m = 0.5f * box.size_m();
    object.radius_m = glm::length(object.half_size_m);
    object.bar = scene::bar_of(mesh.positions, placed.world);
    return object;
}

// Of structures of floats.
template <class T>
bool is_same(const T& a, const T& b) {
    static_assert(sizeof(T) % sizeof(float) == 0);
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

ui::Opened opened_from(const Session& session) {
    ui::Opened opened;
    const scene::Stage& stage = session.live->stage();
    scene::Box box;
    const std::vector<int> movers = scene::movers_of_instances(*session.show, stage);
    for (std::size_t i = 0; i < stage.instances.size(); ++i) {
        const scene::Instance& instance = stage.instances[i];
        if (instance.fixture != scene::kNone || instance.mesh < 0 ||
            instance.mesh >= static_cast<int>(stage.meshes.size()))
            continue;
        opened.objects.push_back(object_of(stage, i));
        opened.objects.back().mover = movers[i];
    }
    for (const scene::PatchedFixture& fixture : session.show->fixtures) box.add(fixture.position_m, 1.0f);
    // A floor of a square kilometre is not what a person wants to see.
    if (session.show->fixtures.empty())
        for (const ui::Object& object : opened.objects) box.add(object.centre_m, object.radius_m);
    if (!box.is_empty()) {
        opened.centre_m = box.middle_m();
        opened.radius_m = std::max(0.5f * glm::length(box.size_m()), 1.0f);
    }
    opened.materials = stage.materials;
    auto show = std::make_shared<scene::Show>(*session.show);
    show->stage = {};
    // One of the window's size was added to those of the show.
    if (session.options.width > 0 && session.camera + 1 == show->cameras.size() && session.camera > 0)
        show->cameras.pop_back();
    opened.show = std::move(show);
    opened.device = session.device->name();
    return opened;
}

ui::Look counted_as(const scene::Show& show, const ui::Look& look, const scene::Show& counted) {
    ui::Look anew = ui::carried(look, counted, show);
    if (look.solo.empty()) return anew;
    const std::vector<std::optional<std::size_t>> same = scene::same_fixtures(counted, show);
    for (std::size_t i = 0; i < same.size(); ++i)
        if (!same[i]) anew.fixtures[i].intensity = 0.0f; // not one of those
    return anew;
}

bool take_air(const scene::Show& edited, Session& session) {
    scene::Show& show = *session.show;
    show.bounce = edited.bounce;
    session.set_bounce(session.options.bounce.value_or(show.bounce));
    if (is_same(edited.haze, show.haze) &&
        std::equal(edited.hazers.begin(), edited.hazers.end(), show.hazers.begin(), show.hazers.end(),
                   is_same<scene::Hazer>))
        return false;
    const bool was_uneven = session.atmosphere().is_uneven();
    show.haze = edited.haze;
    show.hazers = edited.hazers;
    if (session.atmosphere().is_uneven() == was_uneven) return true;
    session.drop_parked();
    session.relighter.reset(); // its programs are for the one or the other
    session.look_from(scene::Camera(session.live->camera()));
    return true;
}

AppliedLook::AppliedLook(const Session& session) : shadows_(session.shadows) {}

bool AppliedLook::apply(const ui::Look& look, Session& session) {
    // Each of them, whatever the others say.
    const bool changed[] = {apply_scene(look.scene, session), apply_objects(look, session),
                            apply_surfaces(look, session)};
    applied_ = look;
    return std::any_of(std::begin(changed), std::end(changed), [](bool one) { return one; });
}

bool AppliedLook::apply_scene(const ui::SceneLook& look, Session& session) {
    if (look == applied_.scene) return false;
    session.scene_look = look;
    session.shadows = look.shadows.value_or(shadows_);
    return true;
}

bool AppliedLook::apply_objects(const ui::Look& look, Session& session) {
    if (look.shown == applied_.shown) return false;
    const std::vector<scene::Instance>& instances = session.live->stage().instances;
    std::set<std::size_t> touched;
    for (const auto& [instance, shown] : look.shown) touched.insert(instance);
    for (const auto& [instance, shown] : applied_.shown) touched.insert(instance);
    for (const std::size_t instance : touched) {
        if (instance >= instances.size()) continue;
        const auto wanted = look.shown.find(instance);
        session.live->show(instance, wanted == look.shown.end() ? instances[instance].shown : wanted->second);
    }
    return true;
}

bool AppliedLook::apply_surfaces(const ui::Look& look, Session& session) {
    if (look.surfaces == applied_.surfaces) return false;
    const std::vector<scene::Material>& materials = session.live->stage().materials;
    std::set<std::size_t> touched;
    for (const auto& [material, values] : look.surfaces) touched.insert(material);
    for (const auto& [material, values] : applied_.surfaces) touched.insert(material);
    for (const std::size_t index : touched) {
        if (index >= materials.size()) continue;
        scene::Material material = materials[index];
        if (const auto wanted = look.surfaces.find(index); wanted != look.surfaces.end()) {
            material.base_colour = wanted->second.colour.value_or(material.base_colour);
            material.specular = wanted->second.specular.value_or(material.specular);
            material.roughness = wanted->second.roughness.value_or(material.roughness);
        }
        session.live->set_material(index, material);
    }
    return true;
}

} // namespace ghost::app
