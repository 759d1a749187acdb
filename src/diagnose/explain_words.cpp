// SPDX-License-Identifier: Apache-2.0
#include "base/print.h"
#include "diagnose/explain_parts.h"
#include "diagnose/explain_print.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::scene {
namespace {

using namespace explained;

constexpr std::size_t kMostChannels = 64;
constexpr std::size_t kMostBeams = 24;

std::string row(const char* head, const std::string& text) {
    char begin[16];
    std::snprintf(begin, sizeof begin, "%-10s", head);
    return begin + one_line(text) + "\n";
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

std::string metres(float value) {
    return number(static_cast<double>(value), 2);
}

std::string input_text(const Reception& reception) {
    switch (reception.kind) {
    case Reception::Kind::none:
        return "none: " +
               (reception.recording.empty() ? std::string("the show has no recording")
                                            : reception.recording) +
               " and no desk is listened to; every channel has its default";
    case Reception::Kind::recording:
        return "recording " + reception.recording + " at " + number(reception.at_s, 2) + " s of " +
               number(reception.end_s, 2) + " s";
    case Reception::Kind::desk:
        return "listened for " + number(reception.listened_s, 1) +
               " s: " + std::to_string(reception.packets) + " packets";
    }
    return "";
}

std::string sender_text(const UniverseFacts::Sender& sender) {
    std::string text = "'" + sender.name + "' (" + sender.protocol + ", " + sender.from + "), priority " +
                       std::to_string(sender.priority);
    if (sender.per_address_priority) text += ", and one per address";
    return text + ", " + number(sender.rate_hz, 1) + " packets/s, last " + number(sender.age_s, 2) +
           " s ago; has " + std::to_string(sender.channels_held) + " of the fixture's channels";
}

std::string universe_text(const UniverseFacts& facts, const Reception& reception) {
    std::string text = std::to_string(facts.universe) + ": ";
    if (!facts.received) {
        text += "not received";
        if (facts.first_frame_s >= 0)
            text += "; its first frame comes at " + number(facts.first_frame_s, 2) + " s";
        return text;
    }
    if (facts.black) return text + "LOST, black (--on-loss)";
    if (facts.lost) return text + "LOST, last look held for " + number(facts.age_s, 1) + " s";
    text += "received";
    if (reception.kind == Reception::Kind::recording)
        return text + ", newest frame " + number(facts.age_s, 2) + " s old";
    std::vector<std::string> senders;
    for (const UniverseFacts::Sender& sender : facts.senders) senders.push_back(sender_text(sender));
    return text + (senders.empty() ? "" : " from " + joined(senders, "; and from "));
}

// What is wrong with the network of the fixture's universes, but what the verdict says already.
std::string network_lines(const Explanation& explanation, const Reception& reception) {
    std::string text;
    for (const Sentence& sentence : reception.diagnosis) {
        const bool ours = sentence.universes.empty() ||
                          std::any_of(explanation.universes.begin(), explanation.universes.end(),
                                      [&](const UniverseFacts& facts) {
                                          return sentence.universes.contains(facts.universe);
                                      });
        if (sentence.is_problem && ours && explanation.verdict.find(sentence.text) == std::string::npos)
            text += row("network", sentence.text);
    }
    return text;
}

std::string patch_text(const Explanation& explanation) {
    std::string text;
    for (std::size_t b = 0; b < explanation.footprint.size(); ++b) {
        const int bytes = explanation.footprint[b];
        if (bytes == 0) continue;
        if (!text.empty()) text += "; ";
        if (explanation.footprint.size() > 1) text += "break " + std::to_string(b + 1) + ": ";
        if (b >= explanation.addresses.size() || explanation.addresses[b].channel < 1) {
            text +=
                std::string(explanation.is_address_known ? "no address" : "an address that cannot be read") +
                " (" + std::to_string(bytes) + " channels)";
            continue;
        }
        const fixture::Address& first = explanation.addresses[b];
        const int last = first.channel - 1 + bytes - 1;
        text += address_text(first) + " to " + address_text({first.universe + last / 512, last % 512 + 1}) +
                ", " + std::to_string(bytes) + " channels";
    }
    return (text.empty() ? "no channels" : text) + "; " + explanation.maker + " " + explanation.type +
           (explanation.is_mode_known ? ", mode '" : ", mode not known, read as '") + explanation.mode +
           "' (" + explanation.file + ")";
}

std::string channel_lines(const Explanation& explanation) {
    std::size_t number_width = 2, address_width = 4;
    for (const ChannelFacts& channel : explanation.channels) {
        number_width = std::max(number_width, channel.numbers.size());
        address_width = std::max(address_width, channel.addresses.size());
    }
    std::string text;
    for (std::size_t i = 0; i < explanation.channels.size() && i < kMostChannels; ++i) {
        const ChannelFacts& channel = explanation.channels[i];
        std::string line =
            padded(channel.number == 0 ? "-" : channel.numbers, std::min<std::size_t>(number_width, 12)) +
            "  " + padded(channel.addresses, std::min<std::size_t>(address_width, 16)) + "  " +
            padded(channel.reading.received ? channel.value : channel.value + "*", 8) + "  ";
        line += channel.attribute;
        if (!channel.function.empty()) {
            line += ": '" + channel.function + "'";
            if (!channel.set.empty()) line += ", '" + channel.set + "'";
            line += " (DMX " + channel.range + ")";
            if (!channel.meaning.empty() && channel.meaning != channel.set) line += " = " + channel.meaning;
        }
        if (channel.why.find(" and ") != std::string::npos || channel.why.find(';') != std::string::npos ||
            channel.function.empty())
            line += " [" + channel.why + "]";
        text += row(i == 0 ? "channels" : "", line);
    }
    if (explanation.channels.size() > kMostChannels)
        text += row("", "and " + std::to_string(explanation.channels.size() - kMostChannels) +
                            " more (--json has all)");
    const bool any_default =
        std::any_of(explanation.channels.begin(), explanation.channels.end(),
                    [](const ChannelFacts& channel) { return !channel.reading.received; });
    if (any_default) text += row("", "* a default: nothing is received there");
    return text;
}

std::string light_text(const BeamFacts& beam) {
    std::string text = (beam.asked < 1.0f ? "asked 0 % x " : std::string()) +
                       (beam.lamp < 0.995f ? "lamp " + percent(beam.lamp) + " x " : std::string()) +
                       "dimmer " + percent(beam.dimmer) + " x master " + percent(beam.master) +
                       " x shutter " + percent(beam.shutter);
    const auto add = [&](const char* name, float fraction, bool always) {
        if (always || std::abs(fraction - 1.0f) > 0.005f)
            text += std::string(" x ") + name + " " + percent(fraction);
    };
    add("strobe", beam.strobe, beam.strobe_hz > 0.0f);
    add("mixed colour", beam.mix, false);
    add("emitters", beam.emitters, false);
    add("colour correction", beam.correction, false);
    add("colour", beam.colour, true);
    add("picture", beam.picture, beam.projects);
    add("animation wheel", beam.animation, false);
    add("gobo", beam.gobo, false);
    add("iris", beam.iris, false);
    add("blades", beam.blades, false);
    add("other optics", beam.rest, false);
    return text + " = " + number(static_cast<double>(beam.output_lm), beam.output_lm < 10.0f ? 2 : 0) +
           " of " + number(static_cast<double>(beam.full_lm)) + " lm";
}

std::string wheel_text(const WheelFacts& wheel) {
    std::string text = std::string(wheel.colour ? "colour" : "gobo") + " wheel " +
                       std::to_string(wheel.number) + " '" + wheel.name + "': '" + wheel.slot + "'";
    if (!wheel.next.empty()) {
        const float shift = wheel.position - std::floor(wheel.position);
        text += " and '" + wheel.next + "' (" + percent(shift) + " of the way)";
    }
    return text + (wheel.spinning ? ", spinning" : "") + ", lets " + percent(wheel.fraction) + " through";
}

// "37 degrees down, to the house and right (seen from the house)".
std::string direction_text(const glm::vec3& direction) {
    const double up = glm::degrees(std::asin(std::clamp(static_cast<double>(direction.z), -1.0, 1.0)));
    std::string text =
        std::abs(up) < 0.5 ? "level" : number(std::abs(up)) + " degrees " + (up > 0 ? "up" : "down");
    std::vector<std::string> ways;
    if (direction.y < -0.2f) ways.push_back("to the house");
    if (direction.y > 0.2f) ways.push_back("up-stage");
    if (direction.x > 0.2f) ways.push_back("right seen from the house");
    if (direction.x < -0.2f) ways.push_back("left seen from the house");
    return text + (ways.empty() ? "" : ", " + joined(ways));
}

// Where nobody says a place or a turn, what stands there is none of it.
std::string points_text(const Explanation& explanation, const BeamFacts& beam) {
    const std::string from =
        explanation.is_place_known
            ? "from x " + metres(beam.lens_m.x) + ", y " + metres(beam.lens_m.y) + ", z " +
                  metres(beam.lens_m.z) + " m"
            : std::string("from where is not known, nobody says a place that can be used");
    return from + (explanation.is_rotation_known
                       ? (explanation.is_place_known ? ", " : "; ") + direction_text(beam.direction)
                       : std::string("; where to is not known, nobody says how it is turned"));
}

std::string hits_text(const Explanation& explanation, const BeamFacts& beam) {
    if (beam.glows) return "nothing: it glows and throws no beam (BeamType None or Glow of its file)";
    if (!explanation.is_place_known) return "not known, nobody says a place that can be used";
    if (!explanation.is_rotation_known) return "not known, nobody says how it is turned";
    if (!explanation.looked) return "not known, there is no stage";
    if (beam.hit) {
        const auto lux = [](float value) {
            return number(static_cast<double>(value), value < 10.0f ? 2 : 0) + " lx";
        };
        return "'" + beam.hit->object + "' " + metres(beam.hit->distance_m) + " m from the lens, at x " +
               metres(beam.hit->position_m.x) + ", y " + metres(beam.hit->position_m.y) + ", z " +
               metres(beam.hit->position_m.z) + " m: " + lux(beam.hit->illuminance_lx) + " on it, " +
               lux(beam.hit->facing_lx) + " facing the lamp (without haze)" +
               (beam.hit->bounced_lx ? "; " + lux(*beam.hit->bounced_lx) + " more of all lights bounced there"
                                     : "");
    }
    return beam.edge_object.empty() ? "nothing: it leaves the stage"
                                    : "nothing with its middle; its edge meets '" + beam.edge_object + "'";
}

std::string beam_text(const BeamFacts& beam) {
    if (beam.projects) return width_text(beam);
    std::string text = number(static_cast<double>(beam.beam_deg), 1) + " deg at half, field " +
                       number(static_cast<double>(beam.field_deg), 1) + " deg";
    if (beam.is_cut)
        text += ", cut by blades to " + number(static_cast<double>(beam.lit_deg.x), 1) + " x " +
                number(static_cast<double>(beam.lit_deg.y), 1) + " deg";
    return text;
}

std::string beam_lines(const Explanation& explanation) {
    if (explanation.beams.empty()) return "";
    const BeamFacts& beam = explanation.beams[static_cast<std::size_t>(explanation.main_beam)];
    std::string text = row("light", light_text(beam));
    for (std::size_t i = 0; i < beam.wheels.size(); ++i)
        text += row(i == 0 ? "wheels" : "", wheel_text(beam.wheels[i]));
    for (std::size_t i = 0; i < beam.optics.size(); ++i) text += row(i == 0 ? "optics" : "", beam.optics[i]);
    text += row("beam", beam_text(beam) + ", " + number(static_cast<double>(beam.axis_cd)) +
                            " cd in the middle" + (beam.is_cut ? " of that" : ""));
    text += row("points", points_text(explanation, beam));
    text += row("hits", hits_text(explanation, beam));
    if (beam.grouped > 1)
        text += row("drawn", "as a glow of its own; its beam is part of one light for " +
                                 std::to_string(beam.grouped) + " cells (docs/design/multi-cell.md)");
    if (explanation.beams.size() < 2) return text;
    text +=
        row("beams", "this is '" + beam.name + "'; all " + std::to_string(explanation.beams.size()) + ":");
    for (std::size_t b = 0; b < explanation.beams.size() && b < kMostBeams; ++b)
        text += row("", "'" + explanation.beams[b].name + "' " +
                            number(static_cast<double>(explanation.beams[b].output_lm)) + " of " +
                            number(static_cast<double>(explanation.beams[b].full_lm)) + " lm");
    if (explanation.beams.size() > kMostBeams)
        text += row("", "and " + std::to_string(explanation.beams.size() - kMostBeams) + " more (--json)");
    return text;
}

} // namespace

std::string line_of(const Explanation& explanation) {
    return one_line(explanation.fixture + ": " + explanation.verdict);
}

std::string words_of(const Explanation& explanation, const Reception& reception) {
    std::string text = line_of(explanation) + "\n";
    bool said_verdict = false;
    for (const Reason& finding : explanation.findings) {
        if (finding.blocks && !said_verdict) {
            said_verdict = true;
            continue;
        }
        text += row(finding.blocks ? "also" : "note", finding.text);
    }
    text += row("DMX", input_text(reception)) + network_lines(explanation, reception);
    if (!explanation.type.empty()) {
        for (std::size_t i = 0; i < explanation.universes.size(); ++i)
            text += row(i == 0 ? "universe" : "", universe_text(explanation.universes[i], reception));
        text += row("patch", patch_text(explanation)) + channel_lines(explanation) + beam_lines(explanation);
    }
    return text;
}

} // namespace ghost::scene
