// SPDX-License-Identifier: Apache-2.0
// What the server says; what it is told: protocol_read.cpp.
#include "web/protocol.h"

#include "diagnose/doctor.h"
#include "dmx/merge/merge.h"
#include "dmx/wire/packet.h"
#include "show/show.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace ghost::web {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostSources = 64;
constexpr float kShines_cd = 1.0f; // less is not seen on any stage

std::string json_text(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

class Writer {
public:
    Writer& u8(unsigned value) { return bytes(value, 1); }
    Writer& u16(unsigned value) { return bytes(value, 2); }
    Writer& u32(std::uint32_t value) { return bytes(value, 4); }
    Writer& f32(float value) { return bytes(std::bit_cast<std::uint32_t>(value), 4); }
    Writer& f64(double value) { return bytes(std::bit_cast<std::uint64_t>(value), 8); }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    Writer& bytes(std::uint64_t value, int count) {
        for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        return *this;
    }
    std::vector<std::uint8_t> bytes_;
};

ordered_json json_of(const glm::vec3& vector) {
    return {vector.x, vector.y, vector.z};
}

unsigned byte_of(float share) {
    return std::isfinite(share) ? static_cast<unsigned>(std::lround(255 * std::clamp(share, 0.0f, 1.0f)))
                                : 0u;
}

ordered_json desk_json(const StateNow& now) {
    ordered_json sources = ordered_json::array();
    for (const dmx::SourceStatus& source : now.network->sources) {
        if (sources.size() == kMostSources) break;
        sources.push_back({{"name", source.name},
                           {"from", dmx::place_text(source)},
                           {"protocol", dmx::protocol_name(source.protocol)},
                           {"universe", source.universe},
                           {"priority", source.priority},
                           {"rate_hz", source.rate_hz},
                           {"age_s", std::chrono::duration<double>(source.age).count()}});
    }
    return {{"trouble", now.network->listening.problem},
            {"sources", std::move(sources)},
            {"more", now.network->sources.size() - std::min(now.network->sources.size(), kMostSources)},
            {"problems", now.problems}};
}

// What of it nobody says, so that something stands in its place.
ordered_json unsaid_json(const scene::PatchedFixture& fixture) {
    ordered_json unsaid = ordered_json::array();
    if (fixture.type && !fixture.is_mode_known) unsaid.push_back("mode");
    if (!fixture.is_place_known) unsaid.push_back("place");
    if (fixture.is_place_known && !fixture.is_rotation_known) unsaid.push_back("rotation");
    if (!fixture.is_address_known) unsaid.push_back("address");
    return unsaid;
}

} // namespace

std::vector<std::uint8_t> picture_message(const PictureHead& head, Bytes jpeg) {
    const unsigned flags = (head.coarse ? 1u : 0u) | (head.baked ? 2u : 0u) | (head.at_rest ? 4u : 0u) |
                           (head.false_colours ? 8u : 0u) | (head.still ? 16u : 0u);
    std::vector<std::uint8_t> message = Writer()
                                            .u8(1)
                                            .u8(flags)
                                            .u16(static_cast<unsigned>(head.stream))
                                            .u32(head.number)
                                            .f64(head.drawn_ms)
                                            .f32(head.desk_ms)
                                            .f32(head.ev100)
                                            .u16(static_cast<unsigned>(head.width))
                                            .u16(static_cast<unsigned>(head.height))
                                            .u32(0)
                                            .take();
    message.insert(message.end(), jpeg.begin(), jpeg.end());
    return message;
}

std::vector<std::uint8_t> small_message(SmallKind kind, std::string_view name, Bytes jpeg) {
    std::vector<std::uint8_t> message =
        Writer().u8(3).u8(static_cast<unsigned>(kind)).u16(static_cast<unsigned>(name.size())).take();
    message.insert(message.end(), name.begin(), name.end());
    message.insert(message.end(), jpeg.begin(), jpeg.end());
    return message;
}

std::vector<std::uint8_t> levels_message(std::uint16_t show_version, double at_ms,
                                         std::span<const ui::FixtureNow> fixtures) {
    Writer writer;
    writer.u8(2).u8(0).u16(show_version).u32(static_cast<std::uint32_t>(fixtures.size())).f64(at_ms);
    for (const ui::FixtureNow& fixture : fixtures)
        writer.f32(fixture.candela)
            .u8(byte_of(fixture.colour.r))
            .u8(byte_of(fixture.colour.g))
            .u8(byte_of(fixture.colour.b))
            .u8(byte_of(fixture.dimmer));
    return writer.take();
}

std::string hello_text(Right right) {
    return json_text({{"type", "hello"}, {"protocol", 1}, {"right", name_of(right)}});
}

std::string looks_text(const ui::LooksNow& looks) {
    ordered_json list = ordered_json::array();
    if (looks.looks)
        for (const scene::StoredLook& look : *looks.looks)
            list.push_back(
                {{"name", look.name}, {"fade_s", look.fade_s}, {"fixtures", look.fixtures.size()}});
    return json_text({{"type", "looks"}, {"current", looks.current}, {"looks", std::move(list)}});
}

std::string measure_text(const ui::SideMeasure& measure) {
    ordered_json said{
        {"type", "measure"}, {"place", {measure.place.x, measure.place.y}}, {"cd_m2", measure.cd_m2}};
    if (measure.hit) {
        said["lux"] = measure.lux;
        said["distance_m"] = measure.distance_m;
        said["object"] = measure.object;
    }
    return json_text(said);
}

std::string done_text(std::uint32_t n) {
    return json_text({{"type", "done"}, {"n", n}});
}

std::string refused_text(std::uint32_t n, const std::string& why) {
    return json_text({{"type", "refused"}, {"n", n}, {"why", why}});
}

std::string bye_text(const std::string& why) {
    return json_text({{"type", "bye"}, {"why", why}});
}

std::string show_text(std::uint16_t version, const ui::Opened& opened) {
    ordered_json fixtures = ordered_json::array(), cameras = ordered_json::array(),
                 cues = ordered_json::array();
    if (opened.show) {
        for (const scene::PatchedFixture& fixture : opened.show->fixtures)
            fixtures.push_back({{"name", fixture.name},
                                {"type", fixture.type ? fixture.type->name : ""},
                                {"patch", fixture.address > 0 ? std::to_string(fixture.universe) + "." +
                                                                    std::to_string(fixture.address)
                                                              : ""},
                                {"unsaid", unsaid_json(fixture)}});
        for (const scene::Camera& camera : opened.show->cameras)
            cameras.push_back({{"name", camera.name},
                               {"position_m", json_of(camera.position_m)},
                               {"target_m", json_of(camera.target_m)},
                               {"fov_y_deg", camera.fov_y_deg}});
        for (const scene::Cue& cue : opened.show->cues) cues.push_back(cue.name);
    }
    return json_text({{"type", "show"},
                      {"version", version},
                      {"opens", opened.opens},
                      {"name", opened.show ? opened.show->name : ""},
                      {"device", opened.device},
                      {"cameras", std::move(cameras)},
                      {"cues", std::move(cues)},
                      {"centre_m", json_of(opened.centre_m)},
                      {"radius_m", opened.radius_m},
                      {"fixtures", std::move(fixtures)}});
}

std::string state_text(const StateNow& now) {
    ordered_json state{{"type", "state"}};
    if (now.picture) {
        state["camera"] = now.picture->camera.name;
        state["supply"] = now.picture->supply;
        state["draw_ms"] = now.picture->draw_ms;
        state["work_light"] = now.picture->has_work_light;
    }
    if (now.rig) {
        const auto shines =
            std::count_if(now.rig->fixtures.begin(), now.rig->fixtures.end(),
                          [](const ui::FixtureNow& fixture) { return fixture.candela >= kShines_cd; });
        state["source"] = now.rig->from_desk && now.network                 ? "desk"
                          : now.rig->from_desk || now.rig->recording_s <= 0 ? "none"
                                                                            : "recording";
        state["at_s"] = now.rig->at_s;
        state["recording_s"] = now.rig->recording_s;
        if (!now.rig->timecode.empty()) state["timecode"] = now.rig->timecode;
        state["shining"] = shines;
        state["lamps"] = now.rig->fixtures.size();
        if (!now.cue.empty()) state["cue"] = now.cue;
    }
    if (now.network) state["desk"] = desk_json(now);
    ordered_json lookers = ordered_json::array();
    for (const Looker& looker : now.lookers)
        lookers.push_back({{"from", looker.from},
                           {"seconds", looker.seconds},
                           {"rate_hz", looker.rate_hz},
                           {"width", looker.width},
                           {"controls", looker.controls}});
    state["viewers"] = std::move(lookers);
    return json_text(state);
}

std::string explained_text(const ui::Explained& explained) {
    return json_text({{"type", "explained"},
                      {"fixture", explained.fixture},
                      {"name", explained.explanation.fixture},
                      {"visibility", scene::visibility_name(explained.explanation.visibility)},
                      {"verdict", explained.explanation.verdict},
                      {"words", explained.words}});
}

std::string messages_text(std::span<const Message> messages) {
    const std::size_t shown = std::min(messages.size(), kMostMessagesShown);
    ordered_json list = ordered_json::array();
    for (const Message& message : messages.last(shown))
        list.push_back({{"severity", scene::name_of(message.severity)},
                        {"where", message.where},
                        {"what", message.what}});
    return json_text(
        {{"type", "messages"}, {"more", messages.size() - shown}, {"messages", std::move(list)}});
}

std::string pong_text(double t, double now_ms) {
    return json_text({{"type", "pong"}, {"t", t}, {"now_ms", now_ms}});
}

} // namespace ghost::web
