// SPDX-License-Identifier: Apache-2.0
#include "web/private/connection.h"

namespace ghost::web {

bool Connection::read(double now_s) {
    const std::optional<Bytes> came = stream_->read();
    if (!came) return false;
    if (came->empty() || is_ending()) return true;
    heard_s_ = now_s;
    unread_.insert(unread_.end(), came->begin(), came->end());
    return true;
}

void Connection::put(Piece piece) {
    if (is_ending() || piece.bytes.empty()) return;
    unsent_ += piece.bytes.size();
    out_.push_back(std::move(piece));
}

void Connection::put(Packed bytes) {
    const Bytes all = *bytes;
    put(Piece{std::move(bytes), all});
}

void Connection::put(SharedText text) {
    const Bytes all(reinterpret_cast<const std::uint8_t*>(text->data()), text->size());
    put(Piece{std::move(text), all});
}

void Connection::put(std::string_view text) {
    put(std::vector<std::uint8_t>(text.begin(), text.end()));
}

bool Connection::send(double now_s) {
    while (!out_.empty()) {
        const Bytes rest = out_.front().bytes.subspan(sent_of_first_);
        const std::optional<std::size_t> sent = stream_->send(rest);
        if (!sent) return false;
        if (*sent > 0) moved_s_ = now_s;
        unsent_ -= *sent;
        sent_of_first_ += *sent;
        if (*sent < rest.size()) return true;
        out_.pop_front();
        sent_of_first_ = 0;
    }
    if (is_ending() && !finished_) {
        stream_->finish();
        finished_ = true;
    }
    return true;
}

void Connection::end(double now_s) {
    if (!is_ending()) ends_s_ = now_s;
    unread_.clear();
}

bool Connection::is_over(double now_s) {
    if (!is_ending()) return false;
    if (unsent_ > 0) return now_s - ends_s_ > kSend_s;
    if (sent_s_ < 0) sent_s_ = now_s;
    return now_s - sent_s_ > kEnd_s;
}

} // namespace ghost::web
