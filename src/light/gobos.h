#pragma once
// SPDX-License-Identifier: Apache-2.0
// The gobo stack of a show: every picture on the wheels of its fixtures, blurred as shaders/shared/gobos.h
// says. Built once when a show is opened; values.

#include "base/report.h"
#include "fixture/type.h"
#include "shared/gobos.h"
#include "show/media.h"

#include <map>
#include <utility>
#include <vector>

namespace ghost::scene {

struct Show;
struct BeamShape; // light/beam_shape.h

struct GoboStack {
    shared::Gobos images;
    std::vector<MediaNow> showing; // what each of Show::media shows; its texels are images.slides
    // (type, index into Type::media) -> layer; what is not in here is open (layer 0).
    std::map<std::pair<const fixture::Type*, int>, std::uint32_t> layers;

    std::map<const BeamShape*, std::uint32_t> shapes; // layer of each

    std::uint32_t layer(const fixture::Type* type, int media) const;
};

// At most 2048 layers; more are left open, with a message.
GoboStack build_gobos(const Show& show, Report& report);

// One picture (RGBA8, sRGB, any size) appended as a new layer. Exposed for tests and measurements.
void append_gobo(shared::Gobos& gobos, const std::uint8_t* rgba, int width, int height);
// The picture of a photometric file as one.
void append_shape(shared::Gobos& gobos, const BeamShape& shape);

} // namespace ghost::scene
