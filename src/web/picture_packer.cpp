// SPDX-License-Identifier: Apache-2.0
#include "web/private/picture_packer.h"

#include "base/log.h"
#include "image/jpeg.h"
#include "net/socket.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace ghost::web {
namespace {

constexpr image::JpegQuality kMoving{75, false};
constexpr image::JpegQuality kAtRest{92, true}; // saturated beams smear where colour has fewer pixels

// Any thread.
Encoded encode(const image::Image8& whole, int width, PictureHead head) {
    const auto begin = dmx::thread_cpu_time();
    const bool narrows = width < whole.width;
    const image::Image8 small = narrows ? image::narrowed(whole, width) : image::Image8();
    const image::Image8& sent = narrows ? small : whole;
    const auto jpeg = image::encode_jpeg(sent, head.at_rest ? kAtRest : kMoving);
    Encoded encoded{.number = head.number, .width = width, .bytes = nullptr, .problem = {}, .cpu_s = 0};
    head.width = sent.width;
    head.height = sent.height;
    if (jpeg.ok())
        encoded.bytes = std::make_shared<const std::vector<std::uint8_t>>(
            build_frame(Opcode::binary, picture_message(head, *jpeg)));
    else
        encoded.problem = jpeg.error().text();
    encoded.cpu_s = std::chrono::duration<double>(dmx::thread_cpu_time() - begin).count();
    return encoded;
}

} // namespace

void PicturePacker::put(ui::Picture picture, double drawn_ms, bool is_still) {
    if (!picture.image || picture.image->empty()) return;
    next_ = std::move(picture);
    interval_s_ = 1e-3 * (drawn_ms - next_ms_);
    next_ms_ = drawn_ms;
    is_still_ = is_still;
}

void PicturePacker::go_on(double now_s) {
    if (encoding_ > 0) return;
    if (spent_s_ > 0) may_go_s_ = now_s + 3 * std::exchange(spent_s_, 0.0);
    if (now_s < may_go_s_) return;
    if (next_) {
        shown_ = std::exchange(next_, std::nullopt);
        shown_ms_ = next_ms_;
        begin(false, now_s);
    } else if (shown_ && !at_rest_ && !shown_->is_coarse && now_s - shown_s_ >= rests_after_s()) {
        begin(true, now_s);
    }
}

double PicturePacker::rests_after_s() const {
    return interval_s_ < kMoves_s ? std::max(kRest_s, 2 * interval_s_) : kRest_s;
}

void PicturePacker::begin(bool at_rest, double now_s) {
    number_ = ++numbers_;
    at_rest_ = at_rest;
    shown_s_ = now_s;
    packed_.clear();
}

Packed PicturePacker::packed(int width) {
    if (!shown_) return nullptr;
    const auto [place, is_new] = packed_.try_emplace(std::min(width, shown_->image->width));
    if (!is_new) return place->second;
    ++encoding_;
    const double arrival_ms = std::chrono::duration<double, std::milli>(shown_->arrival).count();
    const PictureHead head{.stream = stream_,
                           .number = number_,
                           .drawn_ms = shown_ms_,
                           .desk_ms = arrival_ms > 0 ? static_cast<float>(shown_ms_ - arrival_ms)
                                                     : std::numeric_limits<float>::quiet_NaN(),
                           .ev100 = shown_->ev100,
                           .coarse = shown_->is_coarse,
                           .baked = shown_->is_baked,
                           .at_rest = at_rest_,
                           .false_colours = shown_->false_colour.measure != ui::Measure::none,
                           .still = is_still_};
    worker_.put([whole = shown_->image, width = place->first, head, taker = taker_]() -> Worker::Done {
        return [encoded = encode(*whole, width, head), taker] { taker(encoded); };
    });
    return nullptr;
}

void PicturePacker::take(const Encoded& encoded) {
    if (encoded.number != number_) return;
    --encoding_;
    spent_s_ += encoded.cpu_s;
    packed_[encoded.width] = encoded.bytes;
    if (!encoded.bytes) log_warning("browsers: " + encoded.problem);
}

} // namespace ghost::web
