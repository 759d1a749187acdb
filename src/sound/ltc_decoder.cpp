// SPDX-License-Identifier: Apache-2.0
#include "sound/ltc_decoder.h"

#include "dmx/wire/timecode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ltc.h>
#include <numeric>
#include <optional>

namespace ghost::sound {

struct HeardFrame {
    dmx::TimeCode time;
    double end = 0;    // sample
    double length = 0; // samples
    bool is_backwards = false;
};

namespace {

using dmx::TimeCode;

constexpr int kQueue = 32;              // frames
constexpr std::size_t kLtcPiece = 1024; // samples: less than that queue of frames at any speed
constexpr int kBits = LTC_FRAME_BIT_COUNT;
constexpr int kLoud = 100;       // of 32767: -50 dBFS
constexpr int kDeaf_s = 2;       // a tenth of the speed has three frames in that time
constexpr double kTorn = 1.25;   // times the length of its bits
constexpr int kMostMissing = 30; // frames between two that still follow each other

// By how long a frame takes; at another speed it may be wrong.
TimeCode::Rate rate_by_length(double frames_per_s) {
    return frames_per_s < 24.5   ? TimeCode::Rate::film_24
           : frames_per_s < 27.5 ? TimeCode::Rate::ebu_25
                                 : TimeCode::Rate::smpte_30;
}

// By the number of the last frame of a second.
std::optional<TimeCode::Rate> rate_by_last(int frame) {
    if (frame == 23) return TimeCode::Rate::film_24;
    if (frame == 24) return TimeCode::Rate::ebu_25;
    if (frame == 29) return TimeCode::Rate::smpte_30;
    return std::nullopt;
}

double frames_between(const HeardFrame& before, const HeardFrame& after) {
    return (after.end - before.end) / after.length;
}

// The numbers differ by as many frames as lie between them, at most so many.
bool follows(const HeardFrame& next, const std::optional<HeardFrame>& before, int most) {
    if (!before || before->is_backwards != next.is_backwards || before->time.rate != next.time.rate)
        return false;
    const auto frames = static_cast<int>(std::lround(std::min(frames_between(*before, next), 1e6)));
    return frames >= 1 && frames <= most &&
           plus_frames(before->time, next.is_backwards ? -frames : frames) == next.time;
}

TimeCode fields_of(const LTCFrame& bits) {
    const auto number = [](unsigned tens, unsigned units) {
        return static_cast<std::uint8_t>(units < 10 ? 10 * tens + units : 0xFF);
    };
    TimeCode time;
    time.hours = number(bits.hours_tens, bits.hours_units);
    time.minutes = number(bits.mins_tens, bits.mins_units);
    time.seconds = number(bits.secs_tens, bits.secs_units);
    time.frames = number(bits.frame_tens, bits.frame_units);
    return time;
}

} // namespace

struct LtcDecoder::Decoder {
    LTCDecoder* ltc = nullptr;
    LTCFrameExt frame{};
    std::optional<HeardFrame> before; // the last one, taken or not
    std::optional<HeardFrame> taken;
    std::optional<TimeCode::Rate> rate; // where a second was seen to end

    ~Decoder() { ltc_decoder_free(ltc); }

    void find_rate(HeardFrame& next, int rate_hz);
};

void LtcDecoder::Decoder::find_rate(HeardFrame& next, int rate_hz) {
    const TimeCode& time = next.time;
    if (before && before->time.seconds != time.seconds && std::lround(frames_between(*before, next)) == 1)
        if (const auto seen = rate_by_last(std::max(time.frames, before->time.frames))) rate = seen;
    next.time.rate = rate.value_or(rate_by_length(rate_hz / next.length));
    if (!dmx::is_timecode(time)) { // a number that this rate has not
        rate.reset();
        next.time.rate = TimeCode::Rate::smpte_30;
    }
    if (next.time.rate == TimeCode::Rate::smpte_30 && frame.ltc.dfbit)
        next.time.rate = TimeCode::Rate::drop_29_97;
}

LtcDecoder::LtcDecoder(int rate_hz) : rate_hz_(rate_hz), decoder_(std::make_unique<Decoder>()) {
    begin();
}

void LtcDecoder::begin() {
    if (decoder_->ltc) ltc_decoder_free(decoder_->ltc);
    decoder_->ltc = ltc_decoder_create(rate_hz_ / 25, kQueue);
    deaf_ = 0;
}

LtcDecoder::~LtcDecoder() = default;

void LtcDecoder::feed(std::span<const std::int16_t> samples, std::chrono::nanoseconds end, const Take& take) {
    const std::int64_t last = fed_ + static_cast<std::int64_t>(samples.size());
    for (std::size_t from = 0; from < samples.size(); from += kLtcPiece) {
        std::array<short, kLtcPiece> piece{};
        const std::size_t count = std::min(kLtcPiece, samples.size() - from);
        std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(from), count, piece.begin());
        ltc_decoder_write_s16(decoder_->ltc, piece.data(), count, fed_);
        fed_ += static_cast<std::int64_t>(count);
        const auto ahead = std::chrono::duration<double>(static_cast<double>(last) / rate_hz_);
        // The moment of sample 0.
        while (ltc_decoder_read(decoder_->ltc, &decoder_->frame) == 1)
            take_frame(end - std::chrono::duration_cast<std::chrono::nanoseconds>(ahead), take);
        const bool is_loud =
            std::any_of(piece.begin(), piece.end(), [](short one) { return std::abs(one) > kLoud; });
        if (is_loud) deaf_ += static_cast<std::int64_t>(count);
        if (deaf_ > std::int64_t{kDeaf_s} * rate_hz_) begin();
    }
}

void LtcDecoder::take_frame(std::chrono::nanoseconds begin, const Take& take) {
    Decoder& d = *decoder_;
    ++counters_.frames;
    counters_.level_dbfs = d.frame.volume;
    counters_.is_backwards = d.frame.reverse != 0;
    HeardFrame frame;
    frame.time = fields_of(d.frame.ltc);
    frame.end = static_cast<double>(d.frame.off_end);
    frame.length = static_cast<double>(d.frame.off_end - d.frame.off_start + 1);
    frame.is_backwards = d.frame.reverse != 0;
    // The last edge of a frame before a pause comes when the sound goes on.
    const double by_bits =
        std::accumulate(std::begin(d.frame.biphase_tics), std::end(d.frame.biphase_tics), 0.0);
    const bool is_whole = frame.length >= kBits && frame.length <= kTorn * by_bits;
    if (is_whole) d.find_rate(frame, rate_hz_);
    if (!is_whole || !dmx::is_timecode(frame.time)) {
        ++counters_.left_out;
        return;
    }
    const bool stands = d.before && d.before->time == frame.time;
    const bool is_good = stands || follows(frame, d.taken, kMostMissing) || follows(frame, d.before, 1);
    d.before = frame;
    if (!is_good) {
        ++counters_.left_out;
        return;
    }
    d.taken = frame;
    deaf_ = 0;
    // A frame tells the time of its first bit; forwards its end, at which it is known, is a frame later.
    const TimeCode now = frame.is_backwards || stands ? frame.time : plus_frames(frame.time, 1);
    const std::chrono::duration<double> at(frame.end / rate_hz_);
    take(now, begin + std::chrono::duration_cast<std::chrono::nanoseconds>(at));
}

} // namespace ghost::sound
