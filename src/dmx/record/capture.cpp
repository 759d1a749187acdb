// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/capture.h"

#include "dmx/merge/merge.h"
#include "dmx/record/changes.h"
#include "dmx/record/private/captured_udp.h"

#include <map>

namespace ghost::dmx {

namespace {

using namespace std::chrono_literals;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

constexpr nanoseconds kTickEvery = 100ms;    // as live
constexpr nanoseconds kAllSourcesGone = 30s; // after so long a silence nothing is left that could leave
constexpr std::size_t kMaxListedLinks = 20;
constexpr std::uint64_t kPacketsPerReport = 4096;

class Reader {
public:
    Reader(ByteSource& source, const std::string& name, const CaptureOptions& options,
           const std::function<void(microseconds)>& began, const FrameSink& sink)
        : file_(source, name), name_(name), options_(options), began_(began), sink_(sink),
          merge_(MergeOptions{.show_preview = options.show_preview}) {}

    Result<CaptureEnd> read(const std::function<bool(double)>& progress) {
        while (const auto frame = file_.next()) {
            if (++packets_ % kPacketsPerReport == 0 && progress && !progress(file_.share()))
                return Error{"interrupted", ""};
            nanoseconds now = frame->time;
            if (now < now_) {
                ++backwards_;
                now = now_;
            }
            TRY_VOID(tick_until(now));
            now_ = now;
            TRY_VOID(take(*frame));
        }
        if (const auto why = file_.source_problem()) problem_ = Error{*why, name_};
        if (!first_) return nothing();
        CaptureEnd end;
        end.unix_time = *first_;
        end.duration = std::chrono::floor<microseconds>(now_) - *first_;
        end.problems = file_.problems();
        if (problem_) end.problems.push_back(*problem_);
        say_losses(end.problems);
        return end;
    }

private:
    Result<void> tick_until(nanoseconds now) {
        if (!first_) return {};
        for (; next_tick_ <= now; next_tick_ += kTickEvery) {
            // A capture may stand still for years: where nobody is left who could leave nothing changes.
            if (now - next_tick_ > kTickEvery &&
                (next_tick_ - now_ > kAllSourcesGone || merge_.sources(next_tick_).empty()))
                next_tick_ += (now - next_tick_) / kTickEvery * kTickEvery;
            merge_.tick(next_tick_);
            if (!merge_.pending()) continue;
            changes_.find(merge_.universes(), next_tick_, frames_);
            TRY_VOID(hand_on());
        }
        return {};
    }

    Result<void> take(const CapturedFrame& frame) {
        const auto found = find_udp(frame);
        if (const NoUdp* none = std::get_if<NoUdp>(&found)) {
            if (*none == NoUdp::unknown_link && unknown_links_.size() < kMaxListedLinks)
                ++unknown_links_[frame.link_type];
            if (*none == NoUdp::fragment) ++fragments_;
            if (*none == NoUdp::cut) ++cut_;
            return {};
        }
        const CapturedUdp& datagram = std::get<CapturedUdp>(found);
        const bool sacn = datagram.to_port == options_.sacn_port;
        if (!sacn && datagram.to_port != options_.artnet_port) {
            ++other_ports_;
            return {};
        }
        const Parsed parsed =
            sacn ? parse_sacn(datagram.payload, datagram.from_ipv4)
                 : parse_artnet(datagram.payload, datagram.from_ipv4, options_.artnet_offset);
        if (const Drop* drop = std::get_if<Drop>(&parsed)) ++drops_[*drop];
        if (const Passing* passing = std::get_if<Passing>(&parsed)) merge_.pass(*passing);
        if (const auto* sync = std::get_if<SyncPacket>(&parsed)) {
            merge_.feed(*sync, now_);
            if (first_ && merge_.pending()) {
                changes_.find(merge_.universes(), now_, frames_);
                return hand_on();
            }
        }
        const Packet* packet = std::get_if<Packet>(&parsed);
        if (!packet) return {};
        wrong_length_ += packet->wrong_length ? 1 : 0;
        merge_.feed(*packet, now_);
        const Universe* universe = merge_.universes().find(packet->universe);
        if (!universe) return {};
        if (!first_) {
            first_ = std::chrono::floor<microseconds>(now_);
            next_tick_ = now_ + kTickEvery;
            began_(*first_);
        }
        changes_.find(*universe, now_, frames_);
        return hand_on();
    }

    Result<void> hand_on() {
        for (RecordedFrame& frame : frames_) {
            frame.time -= *first_;
            TRY_VOID(sink_(frame));
        }
        frames_.clear();
        return {};
    }

    Error nothing() const {
        std::string what = "no levels in " + std::to_string(packets_) +
                           " packets, expected sACN to UDP port " + std::to_string(options_.sacn_port) +
                           " or Art-Net to " + std::to_string(options_.artnet_port) + " (" +
                           std::to_string(other_ports_) + " went to other ports)";
        std::vector<Error> problems = file_.problems();
        if (problem_) problems.push_back(*problem_);
        say_losses(problems);
        for (const Error& problem : problems) what += "; " + problem.what;
        return Error{what, name_};
    }

    void say_losses(std::vector<Error>& problems) const {
        const auto say = [&](std::uint64_t count, const std::string& what) {
            if (count > 0) problems.push_back({std::to_string(count) + " " + what, name_});
        };
        for (const auto& [type, count] : unknown_links_)
            say(count, "packets of link type " + std::to_string(type) +
                           " are left out, expected Ethernet, Linux cooked, loopback or raw IP");
        say(fragments_, "fragments of IP packets are left out");
        say(cut_, "packets were cut by the capture and are left out (capture with a snap length of 0)");
        for (const auto& [drop, count] : drops_)
            say(count, std::string("packets on our ports were not understood: ") + drop_name(drop));
        say(wrong_length_, "packets declare more levels than they hold; those that came are used");
        say(backwards_, "packets are stamped earlier than the one before and count as of that moment");
        say(merge_.counters().missed, "level packets are missing, by their sequence numbers");
        say(merge_.counters().too_many_sources, "packets of more sources on a universe than are merged");
        say(merge_.counters().too_many_universes, "packets of more universes than are merged");
    }

    CaptureFile file_;
    const std::string& name_;
    const CaptureOptions& options_;
    const std::function<void(microseconds)>& began_;
    const FrameSink& sink_;
    Merge merge_;
    Changes changes_;
    std::vector<RecordedFrame> frames_;
    std::optional<Error> problem_;      // of the file below the packets
    std::optional<microseconds> first_; // levels
    nanoseconds now_{0}, next_tick_{0};
    std::uint64_t packets_ = 0, backwards_ = 0, fragments_ = 0, cut_ = 0, other_ports_ = 0, wrong_length_ = 0;
    std::map<std::uint32_t, std::uint64_t> unknown_links_;
    std::map<Drop, std::uint64_t> drops_;
};

} // namespace

bool is_capture(Bytes first_bytes) {
    return CaptureFile::recognises(first_bytes);
}

Result<CaptureEnd> read_capture(ByteSource& source, const std::string& name, const CaptureOptions& options,
                                const std::function<bool(double)>& progress,
                                const std::function<void(microseconds)>& began, const FrameSink& sink) {
    return Reader(source, name, options, began, sink).read(progress);
}

} // namespace ghost::dmx
