#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the fixtures of a show are on an RDM line: every patched one a device, with the modes of its file as
// personalities, its channels as slots, and pan and tilt as sensors. Pure.

#include "fixture/state.h"
#include "rdm/device.h"
#include <vector>

namespace ghost::scene {

struct Show;

// A device of the same fixture has the same UID in every run: by its id in the plot, else by its name and,
// where several have that, its place among them.
struct RdmFixture {
    std::size_t fixture = 0; // of the show
    rdm::Device device;
};
// Of fixtures whose type is known and that have an address; states: of the rig, or none.
std::vector<RdmFixture> rdm_devices(const Show& show, const std::vector<fixture::State>& states = {});

// What the sensors of such a device have now, in their order.
std::vector<std::int16_t> rdm_angles(const fixture::Mode& mode, const fixture::State& state);

} // namespace ghost::scene
