// SPDX-License-Identifier: Apache-2.0
// IES and EULUMDAT files, and the picture that is made of them, on anything. Seeds: any .ies or .ldt file.
#include "light/beam_shape.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const bool ies : {true, false}) {
        const auto loaded = ies ? fixture::parse_ies(text, "fuzz") : fixture::parse_ldt(text, "fuzz");
        if (!loaded.ok()) continue;
        const scene::BeamShape shape = scene::shape_of(loaded->light, "fuzz");
        if (!(shape.flux_lm >= 0) || !std::isfinite(shape.flux_lm) ||
            !std::isfinite(shape.solid_angle(shape.tan_field)) ||
            !std::isfinite(loaded->light.at(-1e6f, 45.0f)))
            std::abort();
    }
    return 0;
}
