// SPDX-License-Identifier: Apache-2.0
// load_ofl, decode and step on anything. Seeds: the fixtures of tests/fixture_files/ofl/ofl_test.cpp, or any
// of the library's.
#include "fixture/decode.h"
#include "fixture_files/ofl/ofl.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

using namespace ghost;
using namespace ghost::fixture;

void drive(const Type& type, int mode, Bytes data) {
    const Patch patch{.name = "fuzz", .type = &type, .mode = mode, .addresses = {{1, 1}}};
    State state = make_state(patch);
    Levels levels;
    for (int universe = 1; universe <= 4; ++universe)
        levels.set(universe, data.subspan(0, std::min<std::size_t>(data.size(), 512)));
    for (const double dt_s : {0.0, 0.02, 1e6}) {
        step(state, patch, decode(patch, levels), dt_s);
        for (const BeamState& beam : state.beams)
            if (!(beam.optics.dimmer >= 0.0f && beam.optics.dimmer <= 1.0f && beam.optics.shutter >= 0.0f &&
                  beam.optics.shutter <= 1.0f && std::isfinite(beam.optics.zoom_deg) &&
                  std::isfinite(beam.to_fixture[3].z)))
                std::abort();
    }
    (void)check_patch(patch);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, size);
    const auto loaded = load_ofl(bytes, "fuzz.json");
    if (!loaded) return 0;
    const int modes = std::min(3, static_cast<int>(loaded->type.modes.size()));
    for (int mode = 0; mode < modes; ++mode) drive(loaded->type, mode, bytes);
    return 0;
}
