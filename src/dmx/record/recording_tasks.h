#pragma once
// SPDX-License-Identifier: Apache-2.0
// What commands do with recordings: open one of any format, write a part of one. Long work shows a bar with
// the time left and can be interrupted; what was lost is logged. Main thread.

#include "base/result.h"
#include "dmx/record/part.h"
#include "dmx/record/player.h"
#include "dmx/record/recorder.h"

#include <cstdint>
#include <filesystem>

namespace ghost::dmx {

// Error: one port for two protocols, where what arrives there would be one or the other.
Result<void> check_ports(std::uint16_t sacn_port, std::uint16_t artnet_port);

Result<Recording> open_recording(const std::filesystem::path& path, const CaptureOptions& capture,
                                 bool quiet);

// Error: it is none, or has no frame. Says so soon, before other long work.
Result<void> check_recording(const std::filesystem::path& path, const CaptureOptions& capture);

// Warns of what a player came across since the last call; returns whether anything was.
bool log_damage(Player& player);

struct WrittenPart {
    double seconds = 0.0;
    std::size_t frames = 0;
    std::uintmax_t bytes = 0;
    std::size_t problems = 0;
};
// From a recording of any format to one of the format that the name of `out` asks for, without holding
// either.
// Says where an unfinished recording of that name is now.
void log_kept(const Recorder& recorder);

Result<WrittenPart> write_part(const std::filesystem::path& path, const CaptureOptions& capture,
                               const PartOptions& part, const std::filesystem::path& out, bool quiet);

} // namespace ghost::dmx
