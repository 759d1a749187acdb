#pragma once
// SPDX-License-Identifier: Apache-2.0
// PlotPage: what a plot or a show has, for somebody who sees it for the first time: what was found, what is
// missing, what was guessed, grouped by kind in plain words, and the fixture files that give no light of
// their own with what could stand in. Made of the findings that `check` prints (doctor_show.h). One thread
// per show; the few fixture files that come near are loaded.

#include "diagnose/doctor_show.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ghost::scene {

inline constexpr std::size_t kMostPageLines = 200; // of one group; what is over is counted

struct StandIn {
    std::string label; // "Robe@Robin Spiider.gdtf (27 ch)"
    std::filesystem::path file;
    std::string mode;        // of that file
    bool seems_same = false; // its name is that of the fixture that is wanted
};

// A fixture file that the plot asks for and whose heads give no light, or one that is assumed.
struct LightlessType {
    std::string wanted; // as [[substitute]] names it
    std::string why;    // "is not in the plot"
    bool is_dark = true;
    std::vector<std::size_t> fixtures; // of the show
    std::vector<StandIn> stand_ins;    // the likest, then general lamps, those of its kind first
};

struct PageLine {
    std::string words;
    std::string advice; // or empty
    std::vector<std::size_t> fixtures;
};

struct PageGroup {
    Severity severity = Severity::note;
    std::string kind;  // as Finding::kind
    std::string title; // "Fixtures that share channels"
    int times = 0;
    std::vector<PageLine> lines;
    std::vector<std::size_t> fixtures; // of all lines
};

struct PlotPage {
    std::string name; // of the file
    std::vector<PageLine> found;
    std::vector<LightlessType> lightless;
    std::vector<PageGroup> groups; // errors first, then warnings, then notes

    int count(Severity severity) const;
    // Whether a designer should see it unasked: something is lost, dark, or guessed about the patch.
    bool matters() const;
};

PlotPage plot_page(const Show& show, const std::vector<Finding>& findings, const FixtureOffers& offers);

// The whole page, for a mail.
std::string text_of(const PlotPage& page);

} // namespace ghost::scene
