#pragma once
// SPDX-License-Identifier: Apache-2.0
// The film of a tour: some seconds of the show's recording from one camera, as browsers play it (MP4).
// Main thread.

#include "base/result.h"
#include "live/session/session.h"

#include <filesystem>

namespace ghost::app {

struct TourFilm {
    double from_s = 0;
    double length_s = 0; // 0: no film
};

// session: its camera, size and exposure. Error: the show has no recording, it ends before, interrupted, a
// full disk.
Result<void> draw_tour_film(const SessionOptions& session, const TourFilm& film,
                            const std::filesystem::path& file);

} // namespace ghost::app
