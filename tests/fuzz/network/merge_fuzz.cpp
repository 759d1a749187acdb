// SPDX-License-Identifier: Apache-2.0
// Packets of many sources with their times, through the merge: whatever order they come in, its tables keep
// their bounds and its levels are those of a source. Input: eight bytes a packet.
#include "dmx/merge/merge.h"

#include <algorithm>
#include <cstdlib>

using namespace ghost;
using namespace ghost::dmx;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

void look(Merge& merge, std::chrono::nanoseconds now) {
    const Universes& universes = merge.universes();
    require(universes.list.size() <= kMaxUniverses);
    for (std::size_t k = 1; k < universes.list.size(); ++k)
        require(universes.list[k - 1].number < universes.list[k].number);
    for (const SourceStatus& source : merge.sources(now)) require(source.slots_held <= source.slot_count);
    require(merge.ignored(now).size() <= kMaxIgnored);
    require(merge.sync().list(now).size() <= kMaxSyncStreams);
    const std::vector<std::uint16_t> groups = merge.sync_universes();
    require(groups.size() <= kMaxSyncGroups && std::is_sorted(groups.begin(), groups.end()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 8) return 0;
    MergeOptions options;
    options.show_preview = data[0] & 1;
    options.artnet_ltp = data[0] & 2;
    options.slot_status = data[0] & 4;
    if (data[0] & 8) options.asked = {1, 2, 700};
    if (data[0] & 16) options.priority_wait = kPriorityWait;
    if (data[0] & 32) options.loss.black_after = std::chrono::milliseconds(40 * data[1]);
    if (data[0] & 64) options.sampling = kSamplingPeriod;
    Merge merge(options);
    std::chrono::nanoseconds now{0};
    merge.listen(now);
    for (std::size_t at = 8; at + 8 <= size; at += 8) {
        const std::uint8_t* const byte = data + at;
        now += std::chrono::milliseconds(byte[0] & 128 ? 100 * (byte[0] & 127) : byte[0]);
        const std::uint8_t what = byte[1] & 15;
        const auto universe = static_cast<std::uint16_t>(1 + byte[2] + 256 * (byte[3] & 15));
        SourceKey source;
        source.protocol = byte[1] & 16 ? Protocol::artnet : Protocol::sacn;
        source.id[0] = byte[4];
        const std::vector<std::uint16_t> some{1, static_cast<std::uint16_t>(universe + 1)};
        if (what == 0) {
            merge.tick(now);
        } else if (what == 1) {
            merge.resume(std::chrono::milliseconds(byte[5]), now);
        } else if (what == 2) {
            merge.ask_for(some);
        } else if (what == 3) {
            merge.keep_only(some);
        } else if (what == 4) {
            look(merge, now);
        } else if (what == 5) {
            SyncPacket packet;
            packet.source = source;
            packet.universe = source.protocol == Protocol::artnet ? std::uint16_t{0} : universe;
            packet.sequence = byte[5];
            merge.feed(packet, now);
        } else {
            Packet packet;
            packet.protocol = source.protocol;
            packet.source = source;
            packet.from = 0x0A000000u | byte[4];
            packet.interface_index = 1u + (byte[3] >> 7);
            packet.universe = universe;
            packet.priority = static_cast<std::uint8_t>(byte[6] % 201);
            packet.sequence = byte[5];
            packet.start_code = what == 6 ? 0xDD : 0;
            packet.terminated = what == 7;
            packet.force_sync = byte[1] & 32;
            packet.sync_universe = byte[1] & 64 ? static_cast<std::uint16_t>(1 + byte[7]) : std::uint16_t{0};
            packet.slot_count = static_cast<std::uint16_t>(std::min(512, 2 * byte[7] + (byte[3] >> 4 & 1)));
            std::fill_n(packet.slots.begin(), packet.slot_count, byte[5]);
            merge.feed(packet, now);
        }
    }
    look(merge, now);
    merge.tick(now + std::chrono::hours(1));
    look(merge, now + std::chrono::hours(1));
    return 0;
}
