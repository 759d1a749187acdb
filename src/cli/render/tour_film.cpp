// SPDX-License-Identifier: Apache-2.0
#include "cli/render/tour_film.h"

#include "base/interrupt.h"
#include "cli/render/render_film.h"

#include <memory>

namespace ghost::app {

Result<void> draw_tour_film(const SessionOptions& session_options, const TourFilm& film,
                            const std::filesystem::path& file) {
    RenderArguments arguments;
    arguments.session = session_options;
    arguments.session.live = arguments.session.repeatable = true;
    arguments.session.plays_recording = true;
    arguments.out = file.string();
    arguments.from_s = film.from_s;
    arguments.to_s = film.from_s + film.length_s;
    TRY(const std::unique_ptr<Session> session, open_session(arguments.session));
    TRY(const std::unique_ptr<PictureWriter> writer,
        PictureWriter::create(file, arguments.session.width, arguments.session.height, arguments.fps, true));
    Tally tally;
    TRY_VOID(render_recording(arguments, *session, *writer, tally));
    if (interrupted()) return Error{"interrupted: nothing is written", file.string()};
    return writer->finish();
}

} // namespace ghost::app
