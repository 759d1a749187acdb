// SPDX-License-Identifier: Apache-2.0
// Senders that cannot be told apart, and such as do not count their packets up (E1.31-2018 6.7.2, Art-Net 4's
// Sequence).
#include "diagnose/diagnosis_parts.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene::diagnosed {
namespace {

constexpr double kStill_hz = 6.0;   // more looks than get through where a number stands still
constexpr double kMostlyLate = 4.0; // late ones for each in time; a network that brings all twice has one
constexpr double kManyLate_hz = 10.0;

bool is_mostly_late(const dmx::SourceStatus& source) {
    return source.late_hz >= kManyLate_hz && source.late_hz > kMostlyLate * source.rate_hz &&
           source.rate_hz < kStill_hz;
}

// "6454 and 40021"; "" of numbered packets.
std::string ports_text(const dmx::SourceStatus& source) {
    return source.other_port == 0 ? ""
                                  : std::to_string(source.port) + " and " + std::to_string(source.other_port);
}

std::string rate_text(double rate_hz) {
    return std::to_string(std::lround(rate_hz));
}

} // namespace

void add_numbering(const dmx::Statistics& statistics, Sentences& out) {
    std::map<std::pair<std::string, std::string>, std::set<int>> doubles; // who, and where else
    std::map<std::pair<std::string, std::string>, std::set<int>> shared;  // who, and by which ports
    std::map<std::string, std::set<int>> late, gaps, disordered;
    std::map<std::string, std::pair<double, double>>
        rates_hz; // of the late ones and the disordered: late, all
    for (const dmx::SourceStatus& source : statistics.sources) {
        const std::string who = source_text(source);
        if (source.double_from)
            doubles[{who, dmx::address_text(*source.double_from)}].insert(source.universe);
        else if (source.is_shared)
            shared[{who, ports_text(source)}].insert(source.universe);
        else if (is_mostly_late(source) || source.is_reordered) {
            (is_mostly_late(source) ? late : disordered)[who].insert(source.universe);
            auto& [of_late, of_all] = rates_hz[who];
            of_late = std::max(of_late, source.late_hz);
            of_all = std::max(of_all, source.late_hz + source.rate_hz);
        } else if (source.has_gaps)
            gaps[who].insert(source.universe);
    }
    for (const auto& [who, universes] : doubles)
        out.push_back(problem(Trouble::same_identity,
                              "two senders have one identity (CID) on " + universes_text(universes) + ": " +
                                  who.first + " and one at " + who.second +
                                  " that sends other packets. The first is shown, the second is dropped. One "
                                  "is a copy of the other (a cloned disk, a copied set-up): give it a CID of "
                                  "its own",
                              universes));
    for (const auto& [who, universes] : shared)
        out.push_back(problem(
            Trouble::same_identity,
            (who.second.empty()
                 ? "packets of " + who.first + " on " + universes_text(universes) +
                       " come in two rows of numbers, or one of them without any, with "
                       "different levels: two programs send there as one, or one that gives two packets "
                       "one number (a base and an effect)"
                 : "the packets of " + who.first + " on " + universes_text(universes) +
                       " come by turns from the ports " + who.second +
                       " with different levels: two programs send there as one, or "
                       "one by two sockets") +
                ". Now the look of this shows, now of that. Of two, close one, or give it an "
                "identity of its own (sACN: a CID, Art-Net: an address)",
            universes));
    for (const auto& [who, universes] : gaps)
        out.push_back(note(Trouble::numbering,
                           "most packets of " + who + " on " + universes_text(universes) +
                               " come after a gap in their numbers: it counts several universes in one row, "
                               "or as many get lost on the way",
                           universes));
    for (const auto& [who, universes] : disordered)
        out.push_back(note(Trouble::numbering,
                           "packets of " + who + " on " + universes_text(universes) +
                               " come in another order than they were sent (two paths, Wi-Fi): " +
                               rate_text(rates_hz[who].first) + " of " + rate_text(rates_hz[who].second) +
                               " a second are late and dropped",
                           universes));
    for (const auto& [who, universes] : late)
        out.push_back(
            problem(Trouble::numbering,
                    who + " does not count its packets up on " + universes_text(universes) + ": " +
                        rate_text(rates_hz[who].first) + " of " + rate_text(rates_hz[who].second) +
                        " a second are dropped as late or twice, for their sequence number stands "
                        "still or counts down. The look follows in jumps until this sender is mended",
                    universes));
}

} // namespace ghost::scene::diagnosed
