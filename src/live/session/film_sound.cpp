// SPDX-License-Identifier: Apache-2.0
#include "live/session/film_sound.h"

#include "show/show.h"

#include <filesystem>
#include <string>
#include <utility>

namespace ghost::app {

Result<video::FilmSound> film_sound(const scene::Show& show, double from_s) {
    video::FilmSound sound;
    if (std::error_code code; !std::filesystem::is_regular_file(show.sound.file, code)) return sound;
    auto file = video::SoundFile::open(show.sound.file);
    if (!file.ok()) return Error{"[show] sound: " + file.error().text(), show.sound.where};
    sound.file = std::move(*file);
    sound.begin_s = from_s - show.sound.offset_s;
    return sound;
}

void check_sound(const scene::Show& show, Report& report) {
    const Result<video::FilmSound> sound = film_sound(show, 0);
    if (!sound.ok()) report.add(Severity::error, sound.error().where, sound.error().what);
    if (!sound.ok() || !sound->file) return;
    sound->file->skip(video::kLongestSound_s);
    if (const std::string problem = sound->file->problem(); !problem.empty())
        report.add(Severity::error, show.sound.where,
                   "[show] sound: " + show.sound.file.string() + ": " + problem);
}

} // namespace ghost::app
