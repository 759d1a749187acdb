// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/poll_answers.h"

#include "dmx/wire/build.h"

#include <algorithm>
#include <utility>

namespace ghost::dmx {

namespace {

constexpr std::size_t kMaxBindIndex = 255;

} // namespace

bool is_local(std::uint32_t ipv4, std::span<const NetInterface> interfaces) {
    struct Block {
        std::uint32_t address, mask;
    };
    static constexpr Block kBlocks[] = {{0x0A000000, 0xFF000000}, {0xAC100000, 0xFFF00000},
                                        {0xC0A80000, 0xFFFF0000}, {0xA9FE0000, 0xFFFF0000},
                                        {0x7F000000, 0xFF000000}, {0x02000000, 0xFF000000}};
    return std::any_of(std::begin(kBlocks), std::end(kBlocks),
                       [&](const Block& block) { return (ipv4 & block.mask) == block.address; }) ||
           std::any_of(interfaces.begin(), interfaces.end(), [&](const NetInterface& interface) {
               return interface.address != 0 && ((ipv4 ^ interface.address) & interface.netmask) == 0;
           });
}

void PollAnswers::announce(const std::vector<std::uint16_t>& port_addresses) {
    std::vector<bool> waited;
    for (const Run& run : runs_) waited.push_back(waits(run));
    const std::size_t most = port_addresses.size() > kMaxBindIndex ? kMaxPortsPerReply : 1;
    replies_.clear();
    for (const std::uint16_t port : port_addresses) {
        const bool joins =
            !replies_.empty() && replies_.back().size() < most && replies_.back().front() >> 4 == port >> 4;
        if (!joins) replies_.emplace_back();
        replies_.back().push_back(port);
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) runs_[i].next = waited[i] ? 0 : replies_.size();
}

std::optional<PollAnswers::Place> PollAnswers::place_of(std::uint16_t port_address) const {
    for (std::size_t i = 0; i < replies_.size(); ++i)
        for (std::size_t port = 0; port < replies_[i].size(); ++port)
            if (replies_[i][port] == port_address)
                return Place{static_cast<std::uint8_t>(std::min(i + 1, kMaxBindIndex)),
                             static_cast<std::uint8_t>(port + 1)};
    return std::nullopt;
}

void PollAnswers::hello(std::uint32_t broadcast, std::uint32_t our_ipv4, std::chrono::nanoseconds now) {
    if (runs_.size() < kMaxPollers) runs_.push_back({broadcast, our_ipv4, {}, 0, now, now, false});
}

bool PollAnswers::asked(const PollPacket& poll, std::uint32_t from_ipv4, std::uint32_t our_ipv4,
                        std::chrono::nanoseconds now) {
    wake(now);
    std::erase_if(runs_, [&](const Run& run) { return !waits(run) && run.rests <= now; });
    const auto same = [&](const Run& run) { return run.to_ipv4 == from_ipv4; };
    if (const auto known = std::find_if(runs_.begin(), runs_.end(), same); known != runs_.end()) {
        // What either of them means.
        known->range.first = std::min(known->range.first, poll.first);
        known->range.last = std::max(known->range.last, poll.last);
        return !std::exchange(known->once_more, true);
    }
    if (runs_.size() >= kMaxPollers) return false;
    // Nodes spread their answers over time; ours depends on our address, so that it is the same every time.
    const auto delay = std::chrono::milliseconds(our_ipv4 & 0xFF);
    runs_.push_back({from_ipv4, our_ipv4, poll, 0, now + delay, now + kPollerRest, true});
    return true;
}

void PollAnswers::wake(std::chrono::nanoseconds now) {
    for (Run& run : runs_) {
        if (!run.once_more || waits(run) || run.rests > now) continue;
        run.once_more = false;
        run.next = 0;
        run.start = now;
        run.rests = now + kPollerRest;
    }
}

std::optional<PollAnswers::Reply> PollAnswers::next(std::chrono::nanoseconds now) {
    wake(now);
    if (now >= slice_ + kReplyEvery) {
        slice_ = now;
        sent_in_slice_ = 0;
    }
    if (sent_in_slice_ >= kRepliesAtOnce) return std::nullopt;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        Run run = runs_.front(); // in turn
        runs_.pop_front();
        std::optional<Reply> reply;
        while (!reply && waits(run) && run.start <= now) {
            const std::vector<std::uint16_t>& ports = replies_[run.next++];
            if (ports.back() < run.range.first || ports.front() > run.range.last) continue;
            reply = {run.to_ipv4, run.our_ipv4, ports,
                     static_cast<std::uint8_t>(std::min(run.next, kMaxBindIndex)), run.asked};
        }
        if (waits(run) || run.once_more || run.rests > now) runs_.push_back(run);
        if (!reply) continue;
        ++sent_in_slice_;
        return reply;
    }
    return std::nullopt;
}

std::optional<std::chrono::nanoseconds> PollAnswers::wait(std::chrono::nanoseconds now) const {
    std::optional<std::chrono::nanoseconds> first;
    for (const Run& run : runs_)
        if (waits(run) || run.once_more) {
            const auto then = waits(run) ? run.start : run.rests;
            first = std::min(first.value_or(then), then);
        }
    if (!first) return std::nullopt;
    if (sent_in_slice_ >= kRepliesAtOnce) first = std::max(*first, slice_ + kReplyEvery);
    return std::max(*first - now, std::chrono::nanoseconds(0));
}

} // namespace ghost::dmx
