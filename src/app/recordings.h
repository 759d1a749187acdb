#pragma once
// SPDX-License-Identifier: Apache-2.0
// What commands do with recordings: open one of any format, write a part of one. Long work shows a bar with
// the time left and can be interrupted; what was lost is logged. Main thread.

#include "app/input_options.h"
#include "dmx/part.h"
#include "dmx/player.h"
#include "dmx/recorder.h"

namespace ghost::app {

// How captures are read; options must be valid (receiver_options).
dmx::CaptureOptions capture_options(const InputOptions& options);

Result<dmx::Recording> open_recording(const std::filesystem::path& path, const dmx::CaptureOptions& capture,
                                      bool quiet);

// Error: it is none, or has no frame. Says so soon, before other long work.
Result<void> check_recording(const std::filesystem::path& path, const dmx::CaptureOptions& capture);

// Warns of what a player came across since the last call; returns whether anything was.
bool log_damage(const dmx::Player& player);

struct WrittenPart {
    double seconds = 0.0;
    std::size_t frames = 0;
    std::uintmax_t bytes = 0;
    std::size_t problems = 0;
};
// From a recording of any format to one of the format that the name of `out` asks for, without holding
// either.
// Says where an unfinished recording of that name is now.
void log_kept(const dmx::Recorder& recorder);

Result<WrittenPart> write_part(const std::filesystem::path& path, const dmx::CaptureOptions& capture,
                               const dmx::PartOptions& part, const std::filesystem::path& out, bool quiet);

} // namespace ghost::app
