#pragma once
// SPDX-License-Identifier: Apache-2.0
// A contact sheet of a fixture file: what each of its channels does, tried one after the other
// (fixture/sweep.h) before a wall 8 m away. Main thread.

#include "base/result.h"
#include "image/tone.h"

#include <cstdint>
#include <string>

namespace ghost::app {

// Of every contact sheet.
inline constexpr int kSheetGap_px = 4;
inline constexpr std::uint8_t kSheetGround = 24;                        // grey
inline constexpr std::int64_t kMostSheetPixels = std::int64_t{1} << 28; // a gigabyte

struct ChannelSheetOptions {
    std::string file; // GDTF, QXF, OFL
    std::string mode; // empty: the first
    std::string out;
    std::string view;              // "side", "wall", "face"; empty: face for bars and panels, else side
    int width = 160, height = 120; // of one picture
    std::string device;
    bool quiet = false;
    image::Tone tone = image::Tone::agx;
};

// Error: unreadable file, no such mode, nothing that shines, too large.
Result<void> draw_channel_sheet(const ChannelSheetOptions& options);

} // namespace ghost::app
