#pragma once
// SPDX-License-Identifier: Apache-2.0
// A capture of the network as a recording: its sACN and Art-Net go through the same parsers and the same
// merge as live, with the capture's own time, so the levels are what a receiver would have seen. Memory: what
// the merge needs. One thread.

#include "archives/byte_source.h"
#include "dmx/record/recorded_frame.h"
#include "dmx/wire/packet.h"

#include <string>
#include <vector>

namespace ghost::dmx {

struct CaptureOptions {
    std::uint16_t sacn_port = 5568; // UDP, where packets went to
    std::uint16_t artnet_port = 6454;
    int artnet_offset = 1; // Ghostlight universe = Port-Address + this
    bool show_preview = false;
};

struct CaptureEnd {
    std::chrono::microseconds duration{0};  // from the first levels to the last packet of any kind
    std::chrono::microseconds unix_time{0}; // of the first levels
    std::vector<Error> problems;            // what was left out and why, with counts
};

bool is_capture(Bytes first_bytes);
// progress: see ReadOptions. began: called before the first frame. Error: no levels in it, or the sink's.
// name is for messages.
Result<CaptureEnd> read_capture(ByteSource& source, const std::string& name, const CaptureOptions& options,
                                const std::function<bool(double share)>& progress,
                                const std::function<void(std::chrono::microseconds unix_time)>& began,
                                const FrameSink& sink);

} // namespace ghost::dmx
