#pragma once
// SPDX-License-Identifier: Apache-2.0
// The show-file format of the Open Lighting Architecture (ola_recorder): the line "OLA Show", then in turn
// "<universe> <level>,<level>,..." and the milliseconds until the next frame. Reading keeps what can be read
// and lists each line that cannot, by number. OLA universe n is our universe n. Any thread, one object each.

#include "dmx/record/recorded_frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uintmax_t kMaxOlaShowBytes = 512u << 20;

struct OlaShowEnd {
    std::chrono::microseconds duration{0}; // with the pause after the last frame
    std::vector<Error> problems; // lines that were left out, where = "name:line"; at most 100 and a total
};

// Hands every frame to sink. Error: no "OLA Show" line, no frame at all, a limit passed, or the sink's. name
// is for messages.
Result<OlaShowEnd> read_ola_show(std::string_view text, const std::string& name, const FrameSink& sink);
bool is_ola_show(Bytes first_bytes);

class OlaShowWriter final : public FrameWriter {
public:
    explicit OlaShowWriter(ByteSink sink) : sink_(std::move(sink)) {}

    // A whole line for each frame. Whether a source is lost has no place here.
    Result<void> append(const RecordedFrame& frame) override;
    Result<void> flush(std::chrono::microseconds now) override;
    Result<void> finish(std::chrono::microseconds duration) override;

private:
    Result<void> put(std::string_view text);
    // Lines of pauses; none is longer than a reader takes.
    std::string pause_to(std::chrono::milliseconds time);

    ByteSink sink_;
    std::chrono::milliseconds time_{0};
    bool any_ = false;
};

} // namespace ghost::dmx
