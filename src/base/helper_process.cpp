// SPDX-License-Identifier: Apache-2.0
#include "base/helper_process.h"

#include "base/private/helper_pipe.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ghost {
namespace {

constexpr std::size_t kGathered = 1 << 16;

} // namespace

bool HelperStream::send(Bytes bytes) {
    if (out_.size() + bytes.size() <= kGathered) {
        out_.insert(out_.end(), bytes.begin(), bytes.end());
        return true;
    }
    if (!flush()) return false;
    while (!bytes.empty()) {
        const std::ptrdiff_t sent = write_to_helper(descriptor_, bytes);
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool HelperStream::flush() {
    Bytes left = out_;
    while (!left.empty()) {
        const std::ptrdiff_t sent = write_to_helper(descriptor_, left);
        if (sent <= 0) return false;
        left = left.subspan(static_cast<std::size_t>(sent));
    }
    out_.clear();
    return true;
}

bool HelperStream::receive(std::span<std::uint8_t> bytes) {
    if (!flush()) return false;
    while (!bytes.empty()) {
        if (in_at_ < in_.size()) {
            const std::size_t count = std::min(bytes.size(), in_.size() - in_at_);
            std::memcpy(bytes.data(), in_.data() + in_at_, count);
            in_at_ += count;
            bytes = bytes.subspan(count);
            continue;
        }
        const bool large = bytes.size() >= kGathered;
        if (!large) in_.resize(kGathered);
        const std::ptrdiff_t got = read_of_helper(descriptor_, large ? bytes : std::span<std::uint8_t>(in_));
        in_at_ = 0;
        in_.resize(large || got <= 0 ? 0 : static_cast<std::size_t>(got));
        if (got <= 0) return false;
        if (large) bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

bool HelperStream::wait(int wait_ms) {
    return in_at_ < in_.size() || wait_for_helper(descriptor_, wait_ms);
}

HelperProcess::HelperProcess(HelperProcess&& other) noexcept
    : process_(std::exchange(other.process_, 0)), descriptor_(std::exchange(other.descriptor_, -1)),
      stream_(std::move(other.stream_)) {}

HelperProcess::~HelperProcess() {
    end();
}

} // namespace ghost
