// SPDX-License-Identifier: Apache-2.0
// Keys are listed in docs/guide/user-guide.md and stay.
#include "diagnose/explain_parts.h"
#include "diagnose/explain_print.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace ghost::scene {
namespace {

using Json = nlohmann::ordered_json;

// Six digits are more than any of these is known to.
Json rounded(double value) {
    if (!std::isfinite(value)) return nullptr;
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::strtod(text, nullptr);
}
Json rounded(float value) {
    return rounded(static_cast<double>(value));
}

Json vector_json(const glm::vec3& v) {
    return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)});
}

Json finding_json(const Reason& finding, const std::vector<ChannelFacts>& channels) {
    Json list = Json::array();
    for (const int index : finding.channels) list.push_back(channels[static_cast<std::size_t>(index)].name);
    return {{"cause", cause_name(finding.cause)},
            {"blocks", finding.blocks},
            {"text", finding.text},
            {"channels", std::move(list)}};
}

Json input_json(const Reception& reception) {
    switch (reception.kind) {
    case Reception::Kind::none:
        return {{"kind", "none"}};
    case Reception::Kind::recording:
        return {{"kind", "recording"},
                {"file", reception.recording},
                {"at_s", rounded(reception.at_s)},
                {"end_s", rounded(reception.end_s)}};
    case Reception::Kind::desk:
        break;
    }
    Json diagnosis = Json::array();
    for (const Sentence& sentence : reception.diagnosis)
        diagnosis.push_back({{"trouble", trouble_name(sentence.trouble)},
                             {"problem", sentence.is_problem},
                             {"text", sentence.text}});
    return {{"kind", "desk"},
            {"listened_s", rounded(reception.listened_s)},
            {"packets", reception.packets},
            {"preview", reception.preview},
            {"unlisted", reception.unlisted},
            {"not_understood", reception.not_understood},
            {"diagnosis", diagnosis}};
}

Json universe_json(const UniverseFacts& facts) {
    Json senders = Json::array();
    for (const UniverseFacts::Sender& sender : facts.senders)
        senders.push_back({{"protocol", sender.protocol},
                           {"name", sender.name},
                           {"from", sender.from},
                           {"priority", sender.priority},
                           {"per_address_priority", sender.per_address_priority},
                           {"rate_hz", rounded(sender.rate_hz)},
                           {"age_s", rounded(sender.age_s)},
                           {"channels_sent", sender.channels},
                           {"channels_held", sender.channels_held}});
    return {{"universe", facts.universe},
            {"received", facts.received},
            {"lost", facts.lost},
            {"black", facts.black},
            {"age_s", facts.received ? rounded(facts.age_s) : Json(nullptr)},
            {"first_frame_s", facts.first_frame_s >= 0 ? rounded(facts.first_frame_s) : Json(nullptr)},
            {"senders", std::move(senders)}};
}

// Without the zeros that words have: programs compare it.
Json address_json(const fixture::Address& address) {
    return std::to_string(address.universe) + "." + std::to_string(address.channel);
}

Json channel_json(const ChannelFacts& channel) {
    Json places = Json::array();
    for (const fixture::Address& place : channel.places) places.push_back(address_json(place));
    const auto text_or_null = [](const std::string& text) {
        return text.empty() ? Json(nullptr) : Json(text);
    };
    return {{"name", channel.name},
            {"break", channel.dmx_break},
            {"channel", channel.number > 0 ? Json(channel.numbers) : Json(nullptr)},
            {"addresses", std::move(places)},
            {"received", channel.reading.received},
            {"raw", channel.reading.raw},
            {"value", channel.value},
            {"attribute", channel.attribute},
            {"function", text_or_null(channel.function)},
            {"set", text_or_null(channel.set)},
            {"dmx", text_or_null(channel.range)},
            {"why", channel.why},
            {"physical", channel.function.empty() ? Json(nullptr) : rounded(channel.reading.physical)},
            {"unit", text_or_null(channel.unit)},
            {"meaning", channel.meaning},
            {"slot", channel.slot > 0 ? Json(channel.slot) : Json(nullptr)}};
}

Json beam_json(const BeamFacts& beam, const Explanation& explanation) {
    const std::vector<ChannelFacts>& channels = explanation.channels;
    Json wheels = Json::array();
    for (const WheelFacts& wheel : beam.wheels)
        wheels.push_back({{"kind", wheel.colour ? "colour" : "gobo"},
                          {"number", wheel.number},
                          {"wheel", wheel.name},
                          {"position", rounded(wheel.position)},
                          {"slot", wheel.slot},
                          {"next_slot", wheel.next.empty() ? Json(nullptr) : Json(wheel.next)},
                          {"spinning", wheel.spinning},
                          {"share", rounded(wheel.fraction)}});
    Json hit = nullptr;
    if (beam.hit)
        hit = {{"object", beam.hit->object},
               {"distance_m", rounded(beam.hit->distance_m)},
               {"position_m", vector_json(beam.hit->position_m)},
               {"illuminance_lx", rounded(beam.hit->illuminance_lx)},
               {"facing_lx", rounded(beam.hit->facing_lx)},
               {"bounced_lx", beam.hit->bounced_lx ? Json(rounded(*beam.hit->bounced_lx)) : Json(nullptr)},
               {"lens_inside", beam.hit->lens_inside}};
    Json findings = Json::array();
    for (const Reason& finding : beam.findings) findings.push_back(finding_json(finding, channels));
    return {{"name", beam.name},
            {"glows", beam.glows},
            {"grouped", beam.grouped},
            {"output_lm", rounded(beam.output_lm)},
            {"full_lm", rounded(beam.full_lm)},
            {"shares",
             {{"asked", rounded(beam.asked)},
              {"lamp", rounded(beam.lamp)},
              {"dimmer", rounded(beam.dimmer)},
              {"master", rounded(beam.master)},
              {"shutter", rounded(beam.shutter)},
              {"strobe", rounded(beam.strobe)},
              {"mix", rounded(beam.mix)},
              {"emitters", rounded(beam.emitters)},
              {"correction", rounded(beam.correction)},
              {"colour", rounded(beam.colour)},
              {"picture", rounded(beam.picture)},
              {"animation", rounded(beam.animation)},
              {"gobo", rounded(beam.gobo)},
              {"iris", rounded(beam.iris)},
              {"blades", rounded(beam.blades)},
              {"rest", rounded(beam.rest)}}},
            {"strobe_hz", rounded(beam.strobe_hz)},
            {"axis_cd", rounded(beam.axis_cd)},
            {"beam_deg", rounded(beam.beam_deg)},
            {"field_deg", rounded(beam.field_deg)},
            {"lit_deg", Json::array({rounded(beam.lit_deg.x), rounded(beam.lit_deg.y)})},
            {"projects", beam.projects ? Json(beam.medium) : Json(nullptr)},
            {"wheels", std::move(wheels)},
            {"optics", beam.optics},
            {"lens_m", explanation.is_place_known ? vector_json(beam.lens_m) : Json(nullptr)},
            {"direction", explanation.is_rotation_known ? vector_json(beam.direction) : Json(nullptr)},
            {"hit", std::move(hit)},
            {"edge_object", beam.edge_object.empty() ? Json(nullptr) : Json(beam.edge_object)},
            {"findings", std::move(findings)}};
}

Json fixture_json(const Explanation& explanation) {
    Json findings = Json::array();
    for (const Reason& finding : explanation.findings)
        findings.push_back(finding_json(finding, explanation.channels));
    Json patch = Json::array();
    for (std::size_t b = 0; b < explanation.footprint.size(); ++b) {
        const bool patched = b < explanation.addresses.size() && explanation.addresses[b].channel > 0;
        patch.push_back({{"break", b + 1},
                         {"address", patched ? address_json(explanation.addresses[b]) : Json(nullptr)},
                         {"channels", explanation.footprint[b]}});
    }
    Json universes = Json::array();
    for (const UniverseFacts& facts : explanation.universes) universes.push_back(universe_json(facts));
    Json channels = Json::array();
    for (const ChannelFacts& channel : explanation.channels) channels.push_back(channel_json(channel));
    Json beams = Json::array();
    for (const BeamFacts& beam : explanation.beams) beams.push_back(beam_json(beam, explanation));
    return {{"fixture", explanation.fixture},
            {"state", visibility_name(explanation.visibility)},
            {"cause", cause_name(explanation.cause)},
            {"verdict", explanation.verdict},
            {"findings", std::move(findings)},
            {"file", explanation.file},
            {"manufacturer", explanation.maker},
            {"type", explanation.type},
            {"mode", explanation.mode},
            {"mode_known", explanation.is_mode_known},
            {"place_known", explanation.is_place_known},
            {"rotation_known", explanation.is_rotation_known},
            {"address_known", explanation.is_address_known},
            {"patch", std::move(patch)},
            {"universes", std::move(universes)},
            {"channels", std::move(channels)},
            {"main_beam", explanation.main_beam >= 0 ? Json(explanation.main_beam) : Json(nullptr)},
            {"stage_known", explanation.looked},
            {"beams", std::move(beams)}};
}

std::string dumped(const Json& json) {
    // A file or a source may say anything in its names; what is no UTF-8 is replaced, not thrown.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

std::string json_of(const Explanation& explanation, const Reception& reception) {
    Json json = {{"input", input_json(reception)}};
    json.update(fixture_json(explanation));
    return dumped(json);
}

std::string json_of(const std::vector<Explanation>& explanations, const Reception& reception) {
    Json json = {{"input", input_json(reception)},
                 {"summary", summary_of(explanations)},
                 {"counts", {{"lit", 0}, {"unseen", 0}, {"nearly_dark", 0}, {"dark", 0}}},
                 {"fixtures", Json::array()}};
    for (const Explanation& explanation : explanations) {
        Json& count = json["counts"][visibility_name(explanation.visibility)];
        count = count.get<int>() + 1;
        json["fixtures"].push_back(fixture_json(explanation));
    }
    return dumped(json);
}

} // namespace ghost::scene
