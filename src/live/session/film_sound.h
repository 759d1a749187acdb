#pragma once
// SPDX-License-Identifier: Apache-2.0
// The sound of a show ([show] sound) for a film of its recording. Seconds of the recording. Errors name the
// line of the show; a file that is not there was said by the loader, and is none here. Any thread.

#include "base/report.h"
#include "video/files/film.h"

namespace ghost::scene {
struct Show;
} // namespace ghost::scene

namespace ghost::app {

// For a film whose first picture is that of this second; without a file where there is nothing to hear.
Result<video::FilmSound> film_sound(const scene::Show& show, double from_s);

// Reads all of it; what is wrong goes to the report.
void check_sound(const scene::Show& show, Report& report);

} // namespace ghost::app
