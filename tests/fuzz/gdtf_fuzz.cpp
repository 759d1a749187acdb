// SPDX-License-Identifier: Apache-2.0
// load_gdtf, decode and step on anything. Input that starts with "PK" is taken as the zip itself, other input
// as the description.xml of one. Seeds: assets/fixtures/src/*/description.xml, assets/fixtures/*.gdtf.
#include "stored_zip.h"

#include "fixture/curves.h"
#include "fixture/decode.h"
#include "fixture_files/common/mesh_check.h"
#include "fixture_files/gdtf/gdtf.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using namespace ghost;
using namespace ghost::fixture;

std::vector<std::uint8_t> zip_of(Bytes xml) {
    return stored_zip({{"description.xml", xml}});
}

void drive(const Type& type, int mode, Bytes data) {
    const Patch patch{.name = "fuzz", .type = &type, .mode = mode, .addresses = {{1, 1}, {2, 500}, {3, 512}}};
    State state = make_state(patch);
    Levels levels;
    for (int universe = 1; universe <= 4; ++universe)
        levels.set(universe, data.subspan(0, std::min<std::size_t>(data.size(), 512)));
    for (const double dt_s : {0.0, 0.02, 1e6}) {
        step(state, patch, decode(patch, levels), dt_s);
        for (const BeamState& beam : state.beams) {
            const Optics& optics = beam.optics;
            if (!(optics.dimmer >= 0.0f && optics.dimmer <= 1.0f && optics.shutter >= 0.0f &&
                  optics.shutter <= 1.0f && std::isfinite(optics.zoom_deg)))
                std::abort();
            for (const WheelState& wheel : optics.gobo_wheels)
                if (!(wheel.position >= 0.0f &&
                      wheel.position < static_cast<float>(
                                           type.wheels[static_cast<std::size_t>(wheel.wheel)].slots.size())))
                    std::abort();
        }
    }
    (void)check_patch(patch);
}

void must_be_finite(float value) {
    if (!std::isfinite(value)) std::abort();
}

// Every index of a Type leads somewhere, and no curve leaves the numbers.
void read_curves(const Type& type) {
    for (const float percent : {0.0f, 33.0f, 100.0f}) {
        for (const DmxProfile& profile : type.dmx_profiles) must_be_finite(evaluate(profile, percent));
        for (const Emitter& emitter : type.emitters)
            must_be_finite(measured_at(emitter, percent).luminous_intensity_cd);
        for (const Filter& filter : type.filters) must_be_finite(measured_at(filter, percent).transmission);
    }
    for (const Mode& mode : type.modes) {
        for (const Channel& channel : mode.channels)
            for (const ChannelFunction& function : channel.functions) {
                must_be_finite(physical_at(type, function, function.dmx_from));
                must_be_finite(physical_at(type, function, channel.max));
                if (function.definition >= 0)
                    (void)type.definitions.at(static_cast<std::size_t>(function.definition));
                if (function.gamut >= 0) (void)type.gamuts.at(static_cast<std::size_t>(function.gamut));
                if (function.color_space >= 0)
                    (void)type.color_spaces.at(static_cast<std::size_t>(function.color_space));
            }
        for (const Macro& macro : mode.macros)
            for (const Macro::Step& step : macro.steps)
                for (const Macro::Value& value : step.values)
                    (void)mode.channels.at(static_cast<std::size_t>(value.channel));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, size);
    (void)fault_of_mesh(bytes, "3ds");
    (void)fault_of_mesh(bytes, "glb");
    const bool is_zip = size >= 2 && data[0] == 'P' && data[1] == 'K';
    const auto loaded = is_zip ? load_gdtf(bytes, "fuzz.gdtf") : load_gdtf(zip_of(bytes), "fuzz.gdtf");
    if (!loaded) return 0;
    read_curves(loaded->type);
    const int modes = std::min(3, static_cast<int>(loaded->type.modes.size()));
    for (int mode = 0; mode < modes; ++mode) drive(loaded->type, mode, bytes);
    return 0;
}
