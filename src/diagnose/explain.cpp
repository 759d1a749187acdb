// SPDX-License-Identifier: Apache-2.0
// The verdict: findings of the fixture, of the patch and of the network in one order, and what is left of the
// light where it arrives.
#include "diagnose/explain.h"

#include "diagnose/explain_parts.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace ghost::scene {
namespace {

using namespace explained;

constexpr float kFaint = 0.01f; // of the brightest fixture

float quick_lm(const shared::Light& light) {
    return 4.0f * shared::kPi * glm::dot(light.bounce_cd, kLuminance);
}

fixture::Patch patch_of(const PatchedFixture& fixture) {
    return fixture.patch();
}

// What the report of loading says that holds all of these words; "" where nothing does.
std::string said(const Report& report, const std::vector<std::string>& words) {
    for (const Message& message : report.messages) {
        const bool all = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
            return message.what.find(word) != std::string::npos;
        });
        if (all) return message.what;
    }
    return "";
}

Reason no_type(const PatchedFixture& fixture, const Report& report) {
    Reason finding{Cause::no_type, true, "", "their fixture file is missing or cannot be read", {}};
    if (fixture.gdtf.empty()) {
        finding.text = "the show names no fixture file for it (gdtf = ...)";
        return finding;
    }
    finding.text = "its fixture file " + fixture.gdtf.string() + " is missing or cannot be read";
    std::string what = said(report, {fixture.gdtf.filename().string(), "fixtures stay dark"});
    for (const char* end : {" Its fixtures stay dark.", "; its fixtures stay dark"})
        if (const std::size_t at = what.find(end); at != std::string::npos) what.erase(at);
    if (!what.empty()) finding.text += ": " + what;
    return finding;
}

// by_file: the fraction of its light that it gives where the rig leaves nothing dark.
Reason unasked(float by_file) {
    return {
        Cause::unasked,
        true,
        "nobody asks for it, no desk, no recording and no hand: it is left dark while the work light is on "
        "(by its file alone it would give " +
            percent(by_file) + " of its light)",
        "nobody asks for them while the work light is on",
        {}};
}

Reason no_place(const Explanation& explanation) {
    return {Cause::no_place,
            false,
            explanation.is_place_known
                ? "nobody says how it is turned: where its beam goes and what it hits is not known"
                : "nobody says a place that can be used: where its beam comes from and what it hits is not "
                  "known",
            "nobody says where they hang, or how they are turned",
            {}};
}

std::string lit_text(const Explanation& explanation) {
    const BeamFacts& beam = explanation.beams[static_cast<std::size_t>(explanation.main_beam)];
    std::string text = "lit: ";
    if (explanation.beams.size() > 1 && !explanation.asked_beam) {
        const auto shining =
            std::count_if(explanation.beams.begin(), explanation.beams.end(),
                          [](const BeamFacts& b) { return b.output_lm > kDark * b.full_lm; });
        text += std::to_string(shining) + " of " + std::to_string(explanation.beams.size()) +
                " beams, the brightest '" + beam.name + "': ";
    }
    return text + number(static_cast<double>(beam.output_lm)) + " of " +
           number(static_cast<double>(beam.full_lm)) + " lm, " + width_text(beam) + ", " +
           hit_text(explanation, beam);
}

bool covers(const fixture::Overlap& overlap, const fixture::Address& place) {
    const int place_at = place.universe * 512 + place.channel;
    return place_at >= overlap.universe * 512 + overlap.channel_from &&
           place_at <= overlap.universe * 512 + overlap.channel_to;
}

// Another fixture that reads the same channels.
Reason overlap_finding(const fixture::Overlap& overlap, const fixture::Patch& own,
                       const fixture::Patch& other, const Explanation& explanation, const Reason* direct) {
    const bool same_place = own.addresses[0].universe == other.addresses[0].universe &&
                            own.addresses[0].channel == other.addresses[0].channel;
    const bool twin = same_place && own.type == other.type && own.mode == other.mode;
    bool blocks = false;
    if (direct && !twin)
        for (const int index : direct->channels)
            for (const fixture::Address& place : explanation.channels[static_cast<std::size_t>(index)].places)
                blocks = blocks || covers(overlap, place);
    const auto text_of = [](const fixture::Patch& patch) {
        const int bytes = patch.mode_of().footprint.empty() ? 0 : patch.mode_of().footprint[0];
        return std::to_string(bytes) + " channels from " + address_text(patch.addresses[0]);
    };
    Reason finding{same_place ? Cause::same_address : Cause::overlap,
                   blocks,
                   "",
                   same_place ? "another fixture has their address" : "another fixture begins inside of them",
                   {}};
    if (twin)
        finding.text = "'" + other.name + "' has the same address and does the same";
    else if (same_place)
        finding.text = "'" + other.name + "', another kind of fixture, has the same address " +
                       address_text(own.addresses[0]);
    else
        finding.text = "it (" + text_of(own) + ") and '" + other.name + "' (" + text_of(other) +
                       ") read common channels: a mode of the wrong length, or a wrong address";
    if (blocks) finding.text += "; " + direct->text;
    return finding;
}

// What blocks before what is worth knowing; before what leaves a little light what leaves none; then in the
// order in which one would look.
void sort_findings(std::vector<Reason>& findings) {
    const auto place = [](const Reason& finding) {
        return std::tuple(!finding.blocks, finding.fraction >= kDark, finding.cause);
    };
    std::stable_sort(findings.begin(), findings.end(),
                     [&](const Reason& a, const Reason& b) { return place(a) < place(b); });
}

template <class Findings>
auto first_blocking(Findings& findings) -> decltype(findings.data()) {
    for (auto& finding : findings)
        if (finding.blocks) return &finding;
    return nullptr;
}

// Whether a part is as it is because hands have it so.
bool is_by_hand(const Reason& reason, const fixture::Programmer& hand,
                const std::vector<ChannelFacts>& channels) {
    if (reason.cause == Cause::dimmer && hand.intensity) return true;
    return !hand.levels.empty() ||
           std::any_of(reason.channels.begin(), reason.channels.end(), [&](int channel) {
               return hand.channels.contains(channels[static_cast<std::size_t>(channel)].name);
           });
}

// "draws a fan of 12 rays, 60 deg wide", as the rig chooses between show file and desk; "" where it draws
// none.
std::string figure_text(const PatchedFixture& fixture, const std::optional<fixture::LaserCurve>& chosen) {
    std::optional<fixture::LaserCurve> figure = chosen;
    if (fixture.laser && fixture.laser->has_figure && (!chosen || fixture.address == 0))
        figure = fixture.laser->figure;
    if (!figure || figure->kind == fixture::LaserCurveKind::beam) return {};
    const auto deg = [](float value) { return number(static_cast<double>(value), 1); };
    std::string text =
        "draws a " + std::string(fixture::kFigureNames[static_cast<std::size_t>(figure->kind)]);
    if (figure->kind == fixture::LaserCurveKind::wave)
        text += " of " + std::to_string(figure->count) + (figure->count == 1 ? " length" : " lengths");
    else if (!fixture::is_swept(figure->kind))
        text += " of " + std::to_string(figure->count) + " rays";
    const bool is_flat =
        figure->kind == fixture::LaserCurveKind::fan || figure->kind == fixture::LaserCurveKind::line;
    text += ", " + deg(figure->size_deg.x) + (is_flat ? "" : " x " + deg(figure->size_deg.y)) + " deg";
    if (figure->deg_s != 0.0f) text += ", turning at " + deg(figure->deg_s) + " deg/s";
    return text;
}

// The medium that a projector shows: the light knows it where it was drawn with pictures.
std::string shown_by(const Show& show, const shared::Light& light, const Projector& projector) {
    const int media = light.slide.layer > 0 ? static_cast<int>(light.slide.layer) - 1 : projector.media;
    const bool known = media >= 0 && static_cast<std::size_t>(media) < show.media.size();
    return known ? show.media[static_cast<std::size_t>(media)].name : "nothing";
}

// Where no part alone is to blame: all that take much, the one that takes most first.
Reason several(const BeamFacts& beam) {
    std::vector<std::pair<float, const char*>> parts;
    const auto add = [&](const char* name, float fraction) {
        if (fraction < 0.9f) parts.emplace_back(fraction, name);
    };
    add("lamp", beam.lamp);
    add("dimmer", beam.dimmer);
    add("master", beam.master);
    add("shutter", beam.shutter);
    add("strobe", beam.strobe);
    add("mixed colour", beam.mix);
    add("emitters", beam.emitters);
    add("colour correction", beam.correction);
    add("colour", beam.colour);
    add("picture", beam.picture);
    add("animation wheel", beam.animation);
    add("gobo", beam.gobo);
    add("iris", beam.iris);
    add("blades", beam.blades);
    add("other optics", beam.rest);
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string product = parts.empty() ? "what it gives" : "";
    for (const auto& [fraction, name] : parts)
        product += (product.empty() ? "" : " x ") + std::string(name) + " " + percent(fraction);
    return {Cause::several,
            true,
            product + " leaves " + number(static_cast<double>(beam.output_lm), 1) + " of " +
                number(static_cast<double>(beam.full_lm)) + " lm",
            "several things together dim them",
            {}};
}

} // namespace

const char* cause_name(Cause cause) {
    static constexpr const char* kNames[] = {
        "none",    "no_type",        "no_mode", "no_place", "no_address", "not_patched", "no_input",
        "unasked", "never_received", "lost",    "not_sent", "overridden", "two_desks",   "same_address",
        "overlap", "dimmer",         "shutter", "strobe",   "iris",       "blades",      "colour",
        "gobo",    "animation",      "picture", "zoom",     "emitters",   "lamp",        "no_beam",
        "several", "hidden",         "away",    "faint"};
    static_assert(std::size(kNames) == static_cast<std::size_t>(Cause::faint) + 1);
    return kNames[static_cast<std::size_t>(cause)];
}

const char* visibility_name(Visibility visibility) {
    static constexpr const char* kNames[] = {"lit", "unseen", "nearly_dark", "dark"};
    return kNames[static_cast<std::size_t>(visibility)];
}

Explainer::Explainer(const ExplainInput& input) : input_(input) {
    for (const dmx::Universe& universe : input.universes.list) levels_.set(universe.number, *universe.levels);
    faces_ = input.rig.lit(input.gobos, DistanceMaps{}).faces;
    std::vector<fixture::Patch> patched; // those with channels
    std::vector<std::size_t> fixture_of;
    std::size_t next = 0;
    for (std::size_t i = 0; i < input.show.fixtures.size(); ++i) {
        patches_.push_back(patch_of(input.show.fixtures[i]));
        first_face_.push_back(next);
        if (!patches_.back().type) continue;
        next += input.rig.states()[i].beams.size();
        patched.push_back(patches_.back());
        fixture_of.push_back(i);
        float sum_lm = 0;
        for (std::size_t k = first_face_.back(); k < next && k < faces_.size(); ++k) {
            sum_lm += quick_lm(faces_[k].light);
            brightest_cd_ = std::max(brightest_cd_, glm::dot(faces_[k].light.intensity_cd, kLuminance));
        }
        brightest_lm_ = std::max(brightest_lm_, sum_lm);
    }
    first_face_.push_back(next);
    overlaps_ = fixture::find_overlaps(patched);
    for (fixture::Overlap& overlap : overlaps_) {
        overlap.first = fixture_of[overlap.first];
        overlap.second = fixture_of[overlap.second];
    }
}

Explanation Explainer::explain(std::size_t index, int asked_beam) const {
    const PatchedFixture& fixture = input_.show.fixtures[index];
    const fixture::Patch& patch = patches_[index];
    Explanation result;
    result.fixture = fixture.name;
    result.file = fixture.gdtf.string();
    result.addresses = patch.addresses;
    result.is_mode_known = fixture.is_mode_known;
    result.is_place_known = fixture.is_place_known;
    result.is_rotation_known = fixture.is_rotation_known;
    result.is_address_known = fixture.is_address_known;
    const auto conclude = [&](Visibility visibility, const std::string& words) {
        sort_findings(result.findings);
        const Reason* first = first_blocking(result.findings);
        result.visibility = visibility;
        result.cause = first ? first->cause : Cause::none;
        result.verdict = words + (first ? first->text : "");
        return result;
    };
    if (!patch.type) {
        result.findings.push_back(no_type(fixture, input_.report));
        return conclude(Visibility::dark, "dark because ");
    }

    const fixture::State& state = input_.rig.states()[index];
    result.maker = patch.type->manufacturer;
    result.type = patch.type->name;
    result.mode = patch.mode_of().name;
    result.footprint = patch.mode_of().footprint;
    result.channels = channel_facts(patch, fixture::read_channels(patch, levels_));
    const fixture::Programmer* const hand = input_.rig.by_hand(index);
    std::vector<ChannelFacts> of_hand; // what hands have channels at, where they hold any
    if (hand && hand->sets_levels())
        of_hand = channel_facts(patch, fixture::read_levels(patch, levels_by_hand(*hand, patch, levels_)));
    const std::vector<ChannelFacts>& held = of_hand.empty() ? result.channels : of_hand;
    result.universes = universe_facts(input_, result.channels);
    result.looked =
        input_.stage != nullptr && !input_.stage->instances.empty() && input_.first_hit != nullptr;
    const bool is_left_dark = input_.rig.is_left_dark(index);
    const auto by_file = [&](std::size_t beam) {
        return fraction_of(*patch.type, state.beams[beam], input_.gobos);
    };
    float quick_sum_lm = 0, most_cd = 0, most_lm = 0;
    for (std::size_t b = 0; b < state.beams.size(); ++b) {
        const LensFace& face = faces_[first_face_[index] + b];
        const shared::Light& light = face.light;
        quick_sum_lm += quick_lm(light);
        most_cd = std::max(most_cd, glm::dot(light.intensity_cd, kLuminance));
        std::optional<Projector> projector = fixture.projector;
        // A desk may have chosen another medium than the show.
        if (projector && light.slide.layer > 0) projector->media = static_cast<int>(light.slide.layer) - 1;
        BeamFacts facts =
            measure(patch, b, state.beams[b], light, held, input_.gobos, projector ? &*projector : nullptr);
        if (!state.lamp.lit) facts.lamp = 0.0f; // a filament has that in its dimmer
        if (is_left_dark) {
            facts.asked = 0.0f;
            facts.rest = 1.0f;
        }
        facts.findings = causes_in_beam(patch, b, state.beams[b], facts, held, hand);
        sort_findings(facts.findings);
        facts.glows = face.glows;
        if (fixture.projector) {
            facts.medium = shown_by(input_.show, light, *fixture.projector);
            facts.optics.insert(facts.optics.begin(), "projects '" + facts.medium + "'");
        }
        if (const std::string figure = figure_text(fixture, state.beams[b].optics.figure); !figure.empty())
            facts.optics.insert(facts.optics.begin(), figure);
        const BeamGroups& emitters = input_.rig.emitters(index);
        if (const int light_index = beam_group_of(emitters, static_cast<int>(b)); light_index >= 0)
            facts.grouped =
                static_cast<int>(emitters.lights[static_cast<std::size_t>(light_index)].beams.size());
        if (result.looked && result.is_aim_known() && !face.glows) look(input_, light, facts);
        const float shines_lm = is_left_dark ? by_file(b) * facts.full_lm : facts.output_lm;
        result.beams.push_back(std::move(facts));
        if (result.main_beam >= 0 && shines_lm <= most_lm) continue;
        result.main_beam = static_cast<int>(b);
        most_lm = shines_lm;
    }

    if (asked_beam >= 0 && asked_beam < static_cast<int>(result.beams.size())) {
        result.main_beam = asked_beam;
        result.asked_beam = true;
        result.fixture += "/" + result.beams[static_cast<std::size_t>(asked_beam)].name;
    }

    Visibility visibility = Visibility::dark;
    Reason direct_copy;
    const Reason* direct = nullptr;
    if (result.beams.empty()) {
        result.findings.push_back({Cause::no_beam,
                                   true,
                                   "mode '" + result.mode + "' has no Beam geometry: nothing in it can shine",
                                   "their file has no Beam geometry",
                                   {}});
    } else {
        BeamFacts& beam = result.beams[static_cast<std::size_t>(result.main_beam)];
        const float fraction = beam.full_lm > 0.0f ? beam.output_lm / beam.full_lm : 0.0f;
        visibility = fraction < kDark         ? Visibility::dark
                     : fraction < kNearlyDark ? Visibility::nearly_dark
                                              : Visibility::lit;
        if (visibility == Visibility::lit) {
            if (result.looked && result.is_aim_known() && !beam.glows) add_unseen(input_, beam);
        } else if (is_left_dark) { // whatever its channels, network and patch do
            beam.findings.push_back(unasked(by_file(static_cast<std::size_t>(result.main_beam))));
        } else {
            if (!first_blocking(beam.findings)) beam.findings.push_back(several(beam));
            Reason& first = *first_blocking(beam.findings);
            if (hand && is_by_hand(first, *hand, held)) { // whatever network and patch do
                first.text = "hands have it so: " + first.text;
                first.group = "hands have them so: " + first.group;
            } else {
                direct_copy = first;
                direct = &direct_copy;
            }
        }
        if (quick_sum_lm < kFaint * brightest_lm_ && most_cd < kFaint * brightest_cd_ &&
            visibility != Visibility::dark)
            beam.findings.push_back({Cause::faint,
                                     visibility == Visibility::lit,
                                     "it gives " + number(static_cast<double>(quick_sum_lm), 1) +
                                         " lm, less than 1 % of the brightest fixture (" +
                                         number(static_cast<double>(brightest_lm_)) + " lm)",
                                     "they are faint next to the brightest fixture",
                                     {}});
        // A part that dims a lit beam is not why it is dark.
        for (const Reason& finding : beam.findings) {
            const bool hides = finding.cause == Cause::hidden || finding.cause == Cause::away ||
                               finding.cause == Cause::faint || finding.cause == Cause::zoom;
            result.findings.push_back(finding);
            result.findings.back().blocks = finding.blocks && (visibility != Visibility::lit || hides);
        }
    }
    if (const std::string what = said(input_.report, {"[[fixture]] '" + fixture.name + "'", "has no mode"});
        !what.empty()) {
        const std::size_t prefix = std::string("[[fixture]] '" + fixture.name + "' ").size();
        result.findings.push_back(
            {Cause::no_mode,
             direct != nullptr,
             "its mode is not in the file: " + what.substr(std::min(prefix, what.size())) +
                 ", whose channels mean other things" + (direct ? "; " + direct->text : ""),
             "their mode is not in the fixture file",
             {}});
    } else if (!fixture.is_mode_known) {
        result.findings.push_back(
            {Cause::no_mode,
             direct != nullptr,
             "no mode of its type is chosen: give it one (Mode in the list of fixtures, or "
             "mode = in the show file); what follows is of mode '" +
                 result.mode + "'" + (direct ? "; " + direct->text : ""),
             "no mode of their type is chosen",
             {}});
    }
    if (!result.is_aim_known()) result.findings.push_back(no_place(result));
    for (Reason& finding : causes_in_network(input_, patch, result, state, direct))
        result.findings.push_back(std::move(finding));
    for (const fixture::Overlap& overlap : overlaps_)
        if (overlap.first == index || overlap.second == index)
            result.findings.push_back(overlap_finding(
                overlap, patch, patches_[overlap.first == index ? overlap.second : overlap.first], result,
                direct));

    if (visibility == Visibility::dark) return conclude(visibility, "dark because ");
    const BeamFacts& beam = result.beams[static_cast<std::size_t>(result.main_beam)];
    if (visibility == Visibility::nearly_dark)
        return conclude(visibility,
                        "nearly dark (" + percent(beam.output_lm / beam.full_lm) + " of its light) because ");
    if (first_blocking(result.findings)) return conclude(Visibility::unseen, "not seen because ");
    return conclude(Visibility::lit, lit_text(result));
}

std::string summary_of(const std::vector<Explanation>& explanations) {
    const std::string all = std::to_string(explanations.size());
    std::string text;
    for (const auto& [visibility, word] :
         {std::pair(Visibility::dark, "dark"), std::pair(Visibility::nearly_dark, "nearly dark"),
          std::pair(Visibility::unseen, "not seen")}) {
        std::map<std::string, int> groups;
        int count = 0;
        for (const Explanation& explanation : explanations) {
            if (explanation.visibility != visibility) continue;
            ++count;
            if (const Reason* first = first_blocking(explanation.findings)) ++groups[first->group];
        }
        if (count == 0) continue;
        std::vector<std::pair<int, std::string>> sorted;
        for (const auto& [group, times] : groups) sorted.emplace_back(-times, group);
        std::sort(sorted.begin(), sorted.end());
        text += (text.empty() ? "" : "; ") + std::to_string(count) + " of " + all + " " + word;
        for (std::size_t i = 0; i < sorted.size(); ++i)
            text +=
                (i == 0 ? ": " : ", ") + std::to_string(-sorted[i].first) + " because " + sorted[i].second;
    }
    if (explanations.empty()) return "the show has no fixtures";
    return text.empty() ? "all " + all + " lit" : text;
}

} // namespace ghost::scene
