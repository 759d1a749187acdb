#pragma once
// SPDX-License-Identifier: Apache-2.0
// The parts of Explainer (explain.h), inside of this folder only: channels in words, one beam measured, what
// keeps light away. Pure.

#include "diagnose/explain.h"

#include <string>
#include <vector>

namespace ghost::scene::explained {

// Below this fraction a part of the chain is why there is no light.
inline constexpr float kBlocks = 0.05f;
inline constexpr float kDark = 1e-3f; // of all light: none
inline constexpr float kNearlyDark = 0.025f;

inline const glm::vec3 kLuminance{0.2627f, 0.6780f, 0.0593f}; // Rec.2020

template <class T>
const T& item(const std::vector<T>& list, int index) {
    return list[static_cast<std::size_t>(index)];
}

std::string number(double value, int digits = 0); // without zeros at the end: "12.5", "12"
std::string percent(float fraction);              // "45 %", "1.7 %", "0.03 %"
std::string dmx_text(std::uint32_t raw, std::size_t bytes);
// "0-7"; of 16 bit channels coarse.fine, the fine byte only where a range does not end with a coarse one.
std::string range_text(std::uint32_t from, std::uint32_t to, std::size_t bytes);
std::string address_text(const fixture::Address& address); // "1.055", as lists have it
// "channel 11 (1.055)", "channel 2-3 of break 2", "the virtual channel 'Head_Dimmer'".
std::string place_text(const ChannelFacts& channel);
// "is at 4", "is at its default 0".
std::string value_text(const ChannelFacts& channel);
std::string joined(const std::vector<std::string>& parts, const std::string& last = " and ");

// In the order of Mode::channels, as the readings.
std::vector<ChannelFacts> channel_facts(const fixture::Patch& patch,
                                        const std::vector<fixture::ChannelReading>& readings);

// Light that leaves, in lumens: beam_candela over all directions.
float output_lm(const shared::Light& light, const GoboStack& gobos);
// A projector's panel all white, without its picture.
void show_white(shared::Light& light);
// The beam without what is a picture: gobos, animation wheel, film, two colours. Iris and blades stay.
shared::Light outline_of(const shared::Light& light);

// The part of its gate by which a beam leaves.
struct LitGate {
    glm::vec2 middle{0}; // gate units: 0 where the middle of the beam is lit
    glm::vec2 half{1};   // of its extent
    float beam_deg = 0;  // full angles of the round field, iris and frost included; of a picture its width
    float field_deg = 0;
    glm::vec2 lit_deg{0}; // across and up
    bool is_cut = false;  // by blades
};
LitGate lit_gate(const shared::Light& light, const GoboStack& gobos);

// One beam, without hit and findings. light: what is drawn of it; projector: what it projects, null: nothing.
BeamFacts measure(const fixture::Patch& patch, std::size_t beam, const fixture::BeamState& state,
                  const shared::Light& light, const std::vector<ChannelFacts>& channels,
                  const GoboStack& gobos, const Projector* projector);
// Fraction of the light of an open beam that these optics let out, wherever the head points.
float fraction_of(const fixture::Type& type, const fixture::BeamState& state, const GoboStack& gobos);

// What in the fixture itself keeps this beam dark, in order; the channels that change it only. hand: what is
// set by hand, null: nothing; channels are those of its levels then.
std::vector<Reason> causes_in_beam(const fixture::Patch& patch, std::size_t beam,
                                   const fixture::BeamState& state, const BeamFacts& facts,
                                   const std::vector<ChannelFacts>& channels,
                                   const fixture::Programmer* hand);

// The ray along the middle of what is lit, and where that meets nothing some beside it. Needs a stage.
void look(const ExplainInput& input, const shared::Light& light, BeamFacts& facts);
// Light leaves, but it is not seen: findings for a beam that was looked along.
void add_unseen(const ExplainInput& input, BeamFacts& facts);
// "beam 20 deg", "beam 20 deg, cut to 18 x 7 deg", "picture 37 x 21 deg".
std::string width_text(const BeamFacts& facts);
// "hits 'floor' at 6 m with 850 lx".
std::string hit_text(const Explanation& explanation, const BeamFacts& facts);

// The universes that these channels are patched in, by number.
std::vector<UniverseFacts> universe_facts(const ExplainInput& input,
                                          const std::vector<ChannelFacts>& channels);

// What lies before the fixture: universes and their senders. direct: the finding of causes_in_beam that there
// is something to say about, or null.
std::vector<Reason> causes_in_network(const ExplainInput& input, const fixture::Patch& patch,
                                      const Explanation& explanation, const fixture::State& state,
                                      const Reason* direct);

// Of several sources of a universe: what a higher priority keeps out, and what equal ones make of each other.
void add_overrides(const ExplainInput& input, const fixture::Patch& patch, const Explanation& explanation,
                   const fixture::State& state, const Reason* direct, std::vector<Reason>& findings);
void add_two_desks(const ExplainInput& input, const fixture::Patch& patch, const Explanation& explanation,
                   const fixture::State& state, const Reason* direct, std::vector<Reason>& findings);

} // namespace ghost::scene::explained
