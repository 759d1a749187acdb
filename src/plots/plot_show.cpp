// SPDX-License-Identifier: Apache-2.0
#include "plots/plot_show.h"

#include "base/name_index.h"
#include "base/text.h"
#include "fixture/patch.h"
#include "fixture_files/common/wall_type.h"
#include "light/led_wall_light.h"
#include "plots/plot_types.h"
#include "plots/private/plot_media.h"
#include "show/limits.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNameBytes = 90; // leaves room for a number
constexpr double kScaled = 0.01;
constexpr double kAimed_deg = 0.5;
constexpr float kFlat = 0.2f;       // depth of a wall, as a share of its shorter side
constexpr double kFlattened = 1e-6; // volume of a matrix, as a share of that of a box of its lengths

glm::mat4 node_to_fixture(const fixture::Mode& mode, int node) {
    glm::mat4 matrix(1.0f);
    for (; node >= 0; node = mode.nodes[static_cast<std::size_t>(node)].parent)
        matrix = mode.nodes[static_cast<std::size_t>(node)].local * matrix;
    return matrix;
}

// Text for people and for file names: no control characters, not too long, whole UTF-8 letters.
std::string clean(const std::string& name) {
    std::string result;
    for (const char c : name) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    if (result.size() > kMaxNameBytes) {
        std::size_t end = kMaxNameBytes;
        while (end > 0 && (static_cast<unsigned char>(result[end]) & 0xc0) == 0x80) --end;
        result.resize(end);
    }
    const std::size_t first = result.find_first_not_of(' ');
    if (first == std::string::npos) return "";
    return result.substr(first, result.find_last_not_of(' ') - first + 1);
}

// "Spot", "Spot #2", "Spot #3".
class Names {
public:
    explicit Names(const std::vector<PatchedFixture>& taken) {
        for (const PatchedFixture& fixture : taken) used_.insert(fixture.name);
    }
    std::string take(const std::string& wanted) {
        int& count = count_[wanted];
        std::string name;
        do {
            name = ++count == 1 ? wanted : wanted + " #" + std::to_string(count);
        } while (!used_.insert(name).second);
        return name;
    }

private:
    std::set<std::string> used_;
    std::map<std::string, int> count_;
};

bool is_device(const PlotObject& object) {
    if (object.kind == ObjectKind::fixture) return true;
    return object.kind != ObjectKind::focus_point && object.device.gdtf >= 0 && object.geometries.empty();
}

bool is_wall(const PlotObject& object) {
    return object.kind == ObjectKind::video_screen && !object.geometries.empty();
}

bool is_fixture(const PlotObject& object) {
    return is_device(object) || is_wall(object);
}

// The fixtures that a plot had, when it is made into fixtures once more.
class KnownFixtures {
public:
    KnownFixtures() = default;
    explicit KnownFixtures(const std::vector<PatchedFixture>& fixtures) {
        for (const PatchedFixture& fixture : fixtures) {
            if (fixture.uuid.empty()) continue;
            by_key_.try_emplace(uuid_key(fixture.uuid), &fixture);
            if (fixture.shape) shapes_.try_emplace(fixture.gdtf.string(), fixture.shape);
        }
    }
    const PatchedFixture* find(const std::string& uuid) const {
        const auto found = by_key_.find(uuid_key(uuid));
        return found == by_key_.end() ? nullptr : found->second;
    }
    // Measured light goes by the fixture's file.
    std::shared_ptr<const BeamShape> shape_of(const fs::path& gdtf) const {
        const auto found = shapes_.find(gdtf.string());
        return found == shapes_.end() ? nullptr : found->second;
    }

private:
    std::unordered_map<std::string, const PatchedFixture*> by_key_;
    std::unordered_map<std::string, std::shared_ptr<const BeamShape>> shapes_;
};

class FixtureMaker {
public:
    // plot: show.plot's, or what an edit makes of it; before: the fixtures that it had, where no file must be
    // read.
    FixtureMaker(Show& show, const Plot& plot, const std::vector<SubstituteEntry>& substitutes,
                 const std::vector<WallSettings>& walls, const std::vector<PatchedFixture>* before,
                 Report& report)
        : show_(show), loaded_(*show.plot), plot_(plot), reads_(before == nullptr),
          types_(*show.plot, show.folder, substitutes, report), walls_(walls), was_used_(walls.size(), false),
          report_(report), names_(show.fixtures) {
        if (!before) return;
        known_ = KnownFixtures(*before);
        types_.know(*before);
    }

    // index: of the object; called for every object in order, parents first.
    void visit(int index, bool adds) {
        const PlotObject& object = plot_.objects[static_cast<std::size_t>(index)];
        worlds_.push_back(object.world);
        fixture_of_.push_back(-1);
        bool is_known = true, is_turn_known = true;
        if (object.parent >= 0) {
            const auto parent = static_cast<std::size_t>(object.parent);
            const auto hung = child_position(object, fixture_of_[parent]);
            worlds_.back() = worlds_[parent] * hung.value_or(glm::dmat4(1.0)) * object.local;
            is_known = hung && are_known_[parent];
            is_turn_known = hung && are_turns_known_[parent];
        } else if (object.layer >= 0) {
            const PlotLayer& layer = plot_.layers[static_cast<std::size_t>(object.layer)];
            is_known = is_turn_known = layer.placed_by != PlacedBy::nobody;
        }
        are_known_.push_back(object.placed_by == PlacedBy::change ||
                             (is_known && object.placed_by == PlacedBy::plot));
        are_turns_known_.push_back(object.turned_by == PlacedBy::change ||
                                   (is_turn_known && object.turned_by == PlacedBy::plot));
        if (adds && is_wall(object))
            add_wall(index, object);
        else if (adds)
            add(object);
        else if (const std::string name = clean(object.name); is_fixture(object) && !name.empty())
            names_.take(name); // those behind it that are called the same keep their numbers
    }

    void finish(Report& report) {
        types_.finish();
        unpack_media(show_, report);
        if (steps_ == 0)
            report.add(Severity::error, walls_.front().where, std::string("[[wall]] ") + kMatchStepsSpent);
        for (std::size_t k = 0; k < walls_.size() && steps_ > 0; ++k)
            if (!was_used_[k])
                report.add(Severity::warning, walls_[k].where,
                           "[[wall]] name: the plot has no screen '" + walls_[k].name.substr(0, 60) + "'");
        say(report, bent_, Severity::warning,
            "a LED wall that is not flat: its picture is thrown straight onto it");
        say(report, unhung_, Severity::warning,
            "hangs by its ChildPosition on a geometry that the fixture above does not have; it hangs on its "
            "base");
        say(report, mirrored_, Severity::warning,
            "mirrored by the plot, which no fixture can be; drawn as made");
        say(report, scaled_, Severity::note, "scaled or skewed by the plot; drawn in the size of their GDTF");
        say(report, aimed_, Severity::note, "without pan and tilt and turned to their focus points");
        say(report, far_, Severity::error,
            "left out, more than 10 km from most of the plot: no picture holds both");
        if (left_out_ > 0)
            report.add(Severity::error, loaded_.name,
                       std::to_string(left_out_) + " fixtures are left out: a show has at most " +
                           std::to_string(kMaxFixtures));
    }

private:
    void add(const PlotObject& object) {
        if (show_.fixtures.size() >= kMaxFixtures) {
            ++left_out_;
            return;
        }
        PatchedFixture fixture;
        const PlotDevice& device = object.device;
        fixture.gdtf = types_.file_of(device);
        const PlotTypes::Found found = types_.find(device, place_of(loaded_, object));
        fixture.type = found.type;
        fixture.mode = found.mode;
        fixture.is_mode_known = found.is_mode_known;
        std::string name = clean(object.name);
        if (name.empty() && fixture.type) name = clean(fixture.type->name);
        fixture.name = names_.take(name.empty() ? "Fixture" : name);
        fixture.fixture_id = device.fixture_id;
        fixture.uuid = object.uuid;
        fixture.invert_pan = device.invert_pan;
        fixture.invert_tilt = device.invert_tilt;
        set_addresses(patch_addresses(plot_, object), fixture);
        fixture.is_address_known = are_addresses_known(plot_, object);
        place(object, fixture);
        if (is_far(fixture.position_m)) {
            far_.push_back(fixture.name);
            return;
        }
        if (object.kind == ObjectKind::projector && fixture.type && reads_)
            fixture.projector =
                plot_projector(show_, object, *fixture.type, place_of(loaded_, object), report_);
        if (!reads_) take_pictures(fixture);
        fixture_of_.back() = static_cast<int>(show_.fixtures.size());
        show_.fixtures.push_back(std::move(fixture));
    }

    // What files other than that of its type said.
    void take_pictures(PatchedFixture& fixture) const {
        if (const PatchedFixture* was = known_.find(fixture.uuid)) fixture.projector = was->projector;
        if (!fixture.projector) fixture.shape = known_.shape_of(fixture.gdtf);
    }

    // It stands where its object does, so that a hand that moves it moves the object; the panel is beside
    // that.
    PatchedFixture hung_wall(const PlotObject& object) {
        PatchedFixture fixture;
        const std::string name = clean(object.name);
        fixture.name = names_.take(name.empty() ? "LED wall" : name);
        fixture.fixture_id = object.device.fixture_id;
        fixture.uuid = object.uuid;
        fixture.address = 0;
        place(object, fixture);
        return fixture;
    }

    // Its size is that of a mesh, which is not read again; one that was hidden has none yet.
    void add_known_wall(const PlotObject& object) {
        const PatchedFixture* was = known_.find(object.uuid);
        if (!was || !was->wall) return;
        PatchedFixture fixture = hung_wall(object);
        fixture.type = was->type;
        fixture.wall = was->wall;
        fixture_of_.back() = static_cast<int>(show_.fixtures.size());
        show_.fixtures.push_back(std::move(fixture));
    }

    // As large as it is drawn, and there; patched nowhere.
    void add_wall(int index, const PlotObject& object) {
        if (show_.fixtures.size() >= kMaxFixtures) {
            ++left_out_;
            return;
        }
        if (!reads_) return add_known_wall(object);
        const auto plane = screen_plane(loaded_, index, show_.plot_origin_m);
        if (!plane) return;
        const std::string name = clean(object.name);
        LedWall wall;
        bool says_media = false;
        for (std::size_t k = 0; k < walls_.size(); ++k) {
            if (!matches(walls_[k].name, name, steps_)) continue;
            wall = walls_[k].wall;
            was_used_[k] = says_media = true;
        }
        PatchedFixture fixture = hung_wall(object);
        if (!says_media)
            wall.media =
                media_of_source(show_, object.sources.empty() ? PlotSource{} : object.sources.front(),
                                fixture.name, place_of(loaded_, object), report_);
        wall.size_m = plane->size_m;
        wall.has_body = false;
        const bool bent = plane->depth_m > kFlat * std::min(wall.size_m.x, wall.size_m.y);
        if (bent) {
            wall.reach_m = plane->depth_m + wall.reach_m;
            bent_.push_back(fixture.name);
        }
        const glm::dmat4 to_world(fixture_to_world(fixture, 0));
        fixture.type = fixture::led_wall_type(wall.size_m, cells_of(wall), wall.nits,
                                              glm::mat4(glm::inverse(to_world) * plane->to_world));
        fixture.wall = wall;
        fixture_of_.back() = static_cast<int>(show_.fixtures.size());
        show_.fixtures.push_back(std::move(fixture));
    }

    void say(Report& report, const std::vector<std::string>& names, Severity severity,
             const std::string& what) const {
        if (names.empty()) return;
        report.add(severity, loaded_.name,
                   std::to_string(names.size()) + (names.size() == 1 ? " fixture is " : " fixtures are ") +
                       what + ": " + name_list(names));
    }

    static void set_addresses(const std::vector<fixture::Address>& addresses, PatchedFixture& fixture) {
        fixture.address = 0;
        if (addresses.empty()) return;
        fixture.address = addresses.front().channel;
        fixture.universe = addresses.front().channel > 0 ? addresses.front().universe : 1;
        fixture.more_addresses.assign(addresses.begin() + 1, addresses.end());
    }

    // What hangs on a geometry of a fixture counts its matrix from there ("Base.Yoke.Head"; MVR 1.6,
    // ChildPosition). The fixture is taken as it hangs at home. Nothing: there is no such geometry.
    std::optional<glm::dmat4> child_position(const PlotObject& object, int parent_fixture) {
        const std::string& path = object.device.child_position;
        if (path.empty() || parent_fixture < 0) return glm::dmat4(1.0);
        const PatchedFixture& parent = show_.fixtures[static_cast<std::size_t>(parent_fixture)];
        if (!parent.type) return glm::dmat4(1.0);
        const fixture::Mode& mode = parent.type->modes[static_cast<std::size_t>(parent.mode)];
        const std::string last = path.substr(path.rfind('.') + 1);
        for (std::size_t k = 0; k < mode.nodes.size(); ++k)
            if (mode.nodes[k].name == path || mode.nodes[k].name == last)
                return glm::dmat4(node_to_fixture(mode, static_cast<int>(k)));
        unhung_.push_back(object.name);
        return std::nullopt;
    }

    void place(const PlotObject& object, PatchedFixture& fixture) {
        glm::dmat4 world = worlds_.back();
        world[3] -= glm::dvec4(show_.plot_origin_m, 0.0);
        if (aim(object, fixture, world)) aimed_.push_back(fixture.name);
        const Placement placement = placement_of(world);
        fixture.position_m = placement.position_m;
        fixture.is_place_known = are_known_.back();
        fixture.rotation_deg = placement.rotation_deg;
        fixture.is_rotation_known = are_turns_known_.back() && !placement.flattened;
        if (placement.mirrored) mirrored_.push_back(fixture.name);
        if (placement.scaled) scaled_.push_back(fixture.name);
    }

    // A lantern that nothing turns is pointed by hand: its focus point says where.
    bool aim(const PlotObject& object, const PatchedFixture& fixture, glm::dmat4& world) const {
        if (object.device.focus < 0 || !fixture.type) return false;
        const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
        if (mode.beams.empty() || !mode.axes.empty()) return false;
        const PlotObject& focus = plot_.objects[static_cast<std::size_t>(object.device.focus)];
        const glm::dmat4 to_world = world * glm::dmat4(node_to_fixture(mode, mode.beams.front()));
        const glm::dvec3 way = glm::dvec3(focus.world[3]) - show_.plot_origin_m - glm::dvec3(to_world[3]);
        const glm::dvec3 beam = -glm::dvec3(to_world[2]);
        if (!(glm::length(way) > 0.1) || !(glm::length(beam) > 1e-9)) return false;
        const glm::dvec3 from = glm::normalize(beam);
        const glm::dvec3 to = glm::normalize(way);
        const double cosine = std::clamp(glm::dot(from, to), -1.0, 1.0);
        if (cosine > std::cos(glm::radians(kAimed_deg))) return false;
        glm::dvec3 about = glm::cross(from, to);
        // Straight back: about any line across the beam.
        if (glm::length(about) < 1e-9)
            about = glm::cross(from, std::abs(from.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        const glm::dvec3 position_m(world[3]);
        world[3] = {0, 0, 0, 1};
        world = glm::rotate(glm::dmat4(1.0), std::acos(cosine), about) * world;
        world[3] = glm::dvec4(position_m, 1.0);
        return true;
    }

    Show& show_;
    LoadedPlot& loaded_;
    const Plot& plot_;
    bool reads_; // files
    KnownFixtures known_;
    PlotTypes types_;
    const std::vector<WallSettings>& walls_;
    std::vector<bool> was_used_;            // of walls_
    std::uint64_t steps_ = kMostMatchSteps; // that are left to compare their names
    Report& report_;
    Names names_;
    std::vector<glm::dmat4> worlds_; // per object, with child positions
    std::vector<bool> are_known_;    // per object: whether somebody says its place
    std::vector<bool> are_turns_known_;
    std::vector<int> fixture_of_; // per object: Show::fixtures, or -1
    std::vector<std::string> mirrored_;
    std::vector<std::string> scaled_;
    std::vector<std::string> aimed_;
    std::vector<std::string> far_; // left out
    std::vector<std::string> bent_;
    std::vector<std::string> unhung_;
    std::size_t left_out_ = 0;
};

} // namespace

std::string place_of(const LoadedPlot& loaded, const PlotObject& object) {
    return loaded.name + ": " + loaded.description +
           (object.line > 0 ? ":" + std::to_string(object.line) : "");
}

Placement placement_of(const glm::dmat4& world) {
    Placement placement;
    placement.position_m = glm::vec3(world[3]);
    const glm::dmat3 axes(world);
    placement.mirrored = glm::determinant(axes) < 0.0;
    placement.flattened = !(std::abs(glm::determinant(axes)) >
                            kFlattened * glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]));
    // The beam's line counts most, then the tilt's plane; X follows, and takes the mirror with it.
    const auto unit = [](const glm::dvec3& v, const glm::dvec3& fallback) {
        const double length = glm::length(v);
        return length > 1e-9 && std::isfinite(length) ? v / length : fallback;
    };
    const glm::dvec3 w = unit(axes[2], {0, 0, 1});
    const glm::dvec3 side = std::abs(w.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 v = unit(axes[1] - w * glm::dot(w, axes[1]), unit(side - w * glm::dot(w, side), side));
    const glm::dvec3 u = glm::cross(v, w);
    for (int k = 0; k < 3; ++k)
        placement.scaled = placement.scaled || std::abs(glm::length(axes[k]) - 1.0) > kScaled;
    placement.scaled = placement.scaled ||
                       std::abs(std::abs(glm::dot(unit(axes[0], u), u)) - 1.0) > kScaled ||
                       std::abs(glm::dot(unit(axes[1], v), w)) > kScaled;
    // Rz * Ry * Rx, as fixture_to_world turns.
    const double level = std::hypot(u.x, u.y);
    glm::dvec3 turn_rad;
    turn_rad.y = std::atan2(-u.z, level);
    if (level > 1e-9) {
        turn_rad.x = std::atan2(v.z, w.z);
        turn_rad.z = std::atan2(u.y, u.x);
    } else { // X points up or down: a turn about Z is one about X
        turn_rad.x = 0.0;
        turn_rad.z = std::atan2(-v.x, v.y);
    }
    placement.rotation_deg = glm::vec3(glm::degrees(turn_rad));
    return placement;
}

Result<std::shared_ptr<LoadedPlot>> load_plot(const std::filesystem::path& file, Report& report,
                                              const ShowLoading& loading) {
    std::atomic<bool> cancel{false};
    MvrLoading reading;
    reading.cancel = &cancel;
    reading.progress = [&](double share, std::string_view what) {
        if (loading.progress) loading.progress(share, std::string(what));
        if (loading.stop && loading.stop()) cancel = true;
    };
    TRY(LoadedPlot loaded, load_mvr(file, reading));
    for (const Message& message : loaded.report.messages) report.messages.push_back(message);
    return std::make_shared<LoadedPlot>(std::move(loaded));
}

Result<void> add_plot_fixtures(Show& show, const std::vector<bool>& shown,
                               const std::vector<SubstituteEntry>& substitutes,
                               const std::vector<WallSettings>& walls, Report& report,
                               const ShowLoading& loading) {
    const std::vector<PlotObject>& objects = show.plot->plot.objects;
    FixtureMaker maker(show, show.plot->plot, substitutes, walls, nullptr, report);
    const std::size_t step = std::max<std::size_t>(1, objects.size() / 100);
    for (std::size_t k = 0; k < objects.size(); ++k) {
        const bool adds = shown[k] && is_fixture(objects[k]);
        if (adds || k % step == 0) {
            if (loading.stop && loading.stop())
                return Error{"stopped while its fixtures were read", show.plot->name};
            if (loading.progress)
                loading.progress(static_cast<double>(k) / static_cast<double>(objects.size()), "fixtures");
        }
        maker.visit(static_cast<int>(k), adds);
    }
    maker.finish(report);
    return {};
}

void add_known_fixtures(Show& show, const Plot& plot, const std::vector<bool>& shown,
                        const std::vector<SubstituteEntry>& substitutes,
                        const std::vector<WallSettings>& walls, const std::vector<PatchedFixture>& before) {
    Report unsaid;
    FixtureMaker maker(show, plot, substitutes, walls, &before, unsaid);
    for (std::size_t k = 0; k < plot.objects.size(); ++k)
        maker.visit(static_cast<int>(k), shown[k] && is_fixture(plot.objects[k]));
}

} // namespace ghost::scene
