// SPDX-License-Identifier: Apache-2.0
#include "diagnose/diagnosis.h"

#include "diagnose/diagnosis_parts.h"

#include <algorithm>

namespace ghost::scene {
namespace {

using namespace diagnosed;
using namespace std::chrono_literals;

constexpr auto kPatience = 5s; // unchanged levels come every second (sACN) or every four (Art-Net)

// What is wrong on universes that nothing of the show reads keeps no light of it away.
bool concerns(const Sentence& sentence, const PatchMap& patch) {
    return patch.universes().empty() || sentence.universes.empty() ||
           std::any_of(sentence.universes.begin(), sentence.universes.end(),
                       [&](int universe) { return patch.has(universe); });
}

} // namespace

const char* trouble_name(Trouble trouble) {
    switch (trouble) {
    case Trouble::not_listening:
        return "not_listening";
    case Trouble::no_interface:
        return "no_interface";
    case Trouble::cable:
        return "cable";
    case Trouble::nothing_arrives:
        return "nothing_arrives";
    case Trouble::port_shared:
        return "port_shared";
    case Trouble::same_host:
        return "same_host";
    case Trouble::wrong_interface:
        return "wrong_interface";
    case Trouble::held_back:
        return "held_back";
    case Trouble::off_by_one:
        return "off_by_one";
    case Trouble::not_received:
        return "not_received";
    case Trouble::not_patched:
        return "not_patched";
    case Trouble::short_universe:
        return "short_universe";
    case Trouble::lost:
        return "lost";
    case Trouble::preview:
        return "preview";
    case Trouble::low_priority:
        return "low_priority";
    case Trouble::bad_priorities:
        return "bad_priorities";
    case Trouble::two_desks:
        return "two_desks";
    case Trouble::same_identity:
        return "same_identity";
    case Trouble::numbering:
        return "numbering";
    case Trouble::too_many:
        return "too_many";
    case Trouble::too_many_universes:
        return "too_many_universes";
    case Trouble::waits_for_sync:
        return "waits_for_sync";
    case Trouble::other_network:
        return "other_network";
    case Trouble::wrong_group:
        return "wrong_group";
    case Trouble::wrong_length:
        return "wrong_length";
    case Trouble::packets_lost:
        return "packets_lost";
    case Trouble::two_timecodes:
        return "two_timecodes";
    }
    return "?";
}

std::vector<Sentence> diagnose(const dmx::Statistics& statistics, const PatchMap& patch) {
    std::vector<Sentence> out;
    if (!statistics.listening.problem.empty())
        return {problem(Trouble::not_listening, statistics.listening.problem)};
    const Arriving arriving(statistics);
    const bool patient = statistics.time - statistics.listening.since >= kPatience;
    add_links(statistics, !arriving.nothing(), out);
    // Without a patch whatever arrives will do.
    const bool all_fed =
        patch.universes().empty()
            ? !arriving.nothing()
            : std::all_of(patch.universes().begin(), patch.universes().end(),
                          [&](const PatchedUniverse& one) { return arriving.has(one.universe); });
    if (patient && out.empty()) add_silence(statistics, arriving, patch, all_fed, out);
    if (patient) add_patch(statistics, arriving, patch, out);
    add_lost(statistics, patch, out);
    const std::size_t before = out.size();
    add_ignored(statistics, out);
    add_ranks(statistics, patch, out);
    add_numbering(statistics, out);
    add_sources(statistics, out);
    // Who hears only what is patched knows nothing of the others, and all say the same.
    out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(before), out.end(),
                             [&](const Sentence& one) { return !concerns(one, patch); }),
              out.end());
    return out;
}

} // namespace ghost::scene
