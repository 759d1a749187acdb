#pragma once
// SPDX-License-Identifier: Apache-2.0
// Cues: moments of a show that the window's cue list or a remote control calls by name or one after another:
// [[cue]] of show.toml. A cue is a place in the recording, a camera, a look, or several of them. Plain
// values.

#include "base/report.h"

#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

class TableReader; // json_xml_toml/toml_reader.h
struct Show;       // show/show.h

struct Cue {
    std::string name;
    std::string number;            // as the desk and the stage manager call it ("47.5"), or ""
    std::string page;              // of the script, or ""
    std::optional<double> at_s;    // of the recording; none: it goes on where it is
    std::string camera;            // empty: the picture stays where it is
    float flight_s = 0;            // to that camera; 0: a cut
    std::string look;              // of looks.toml; empty: what hands set stays. Only the window recalls it
    std::optional<float> fade_s;   // to that look; none: those of the look
    std::optional<float> follow_s; // after which the next cue goes by itself; none: it waits to be called
    std::string notes;
    std::string where; // file:line
};

std::vector<Cue> read_cues(TableReader& top, const std::string& file, Report& report);

// Names of cameras and looks that the show does not have.
void check_cues(const Show& show, Report& report);

} // namespace ghost::scene
