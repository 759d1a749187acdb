#pragma once
// SPDX-License-Identifier: Apache-2.0
// PicturePacker: the newest picture as the bytes that viewers get, encoded once for each width that somebody
// looks at, by a thread apart. After the processor time that encoding a picture took it rests three times as
// long: a quarter of a core at most. The server's thread.

#include "link/link.h"
#include "web/private/connection.h"
#include "web/private/worker.h"
#include "web/protocol.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace ghost::web {

// One of a picture, as the thread apart has made it.
struct Encoded {
    std::uint32_t number = 0; // of the picture
    int width = 0;
    Packed bytes;        // null: it cannot be encoded
    std::string problem; // why
    double cpu_s = 0;
};

class PicturePacker {
public:
    using Taker = std::function<void(const Encoded&)>; // on the server's thread; gives it to the packers

    // numbers: of all pictures of all packers, the last one; stream: of PictureHead.
    PicturePacker(std::uint32_t& numbers, int stream, Worker& worker, Taker taker)
        : numbers_(numbers), stream_(stream), worker_(worker), taker_(std::move(taker)) {}

    // Newer than what there is.
    void put(ui::Picture picture, double drawn_ms, bool is_still = false);
    // The newest picture takes the place of the one that is given out, unless it rests, or is being encoded.
    void go_on(double now_s);

    // Of the picture that is given out; 0: there is none. One that nothing followed for a moment gets a new
    // number, and comes again with all its colours.
    std::uint32_t number() const { return number_; }
    // Null: not yet, or it cannot be encoded, which is logged.
    Packed packed(int width);
    // Of another picture: nothing happens.
    void take(const Encoded& encoded);

private:
    // Without a newer picture; where they come slowly, but come, twice as long as the next one is due.
    static constexpr double kRest_s = 0.3, kMoves_s = 1;
    double rests_after_s() const;

    void begin(bool at_rest, double now_s);

    std::uint32_t& numbers_;
    const int stream_;
    Worker& worker_;
    const Taker taker_;
    bool is_still_ = false;
    std::optional<ui::Picture> next_, shown_;
    double next_ms_ = 0, shown_ms_ = 0;
    double interval_s_ = 1e9; // from the last picture but one to the last
    double shown_s_ = 0;
    bool at_rest_ = false;
    std::uint32_t number_ = 0;
    double spent_s_ = 0;           // on the one that is shown
    double may_go_s_ = 0;          // to the next one
    int encoding_ = 0;             // widths of it that are being encoded
    std::map<int, Packed> packed_; // by width
};

} // namespace ghost::web
