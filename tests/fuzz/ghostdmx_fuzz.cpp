// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .ghostdmx recording. Checksums stop nearly all of them, so the input is also unpacked as
// what stands inside of a block.
#include "dmx/record/ghostdmx_reader.h"

#include <cstdlib>

namespace {

using namespace ghost::dmx;

void walk(ghostdmx::BlockCursor& cursor) {
    auto before = std::chrono::microseconds::min();
    while (const auto time = cursor.next_time()) {
        if (*time < before) std::abort();
        before = *time;
        const std::uint16_t universe = cursor.next();
        if (universe == 0 && !cursor.malformed()) std::abort();
    }
    if (cursor.states().size() > kMaxRecordedUniverses) std::abort();
    for (const auto& [universe, state] : cursor.states())
        if (!state.levels || universe < 1 || state.slot_count > kSlots) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<std::uint8_t> bytes(data, data + size);
    const std::size_t first = size > 0 ? data[0] : 0;
    ghostdmx::BlockCursor inside(bytes, {0, std::chrono::microseconds(first * 1000), first});
    walk(inside);
    // The same behind a right header, so that the scan begins.
    std::vector<std::uint8_t> file = ghostdmx::encode(ghostdmx::Header{});
    file.insert(file.end(), bytes.begin(), bytes.end());
    for (const auto& whole : {bytes, file}) {
        auto reader = GhostdmxReader::open(ByteSource(whole), "fuzz");
        if (!reader.ok()) continue;
        for (std::size_t i = 0; i < std::min<std::size_t>(reader->index().blocks.size(), 64); ++i) {
            GhostdmxReader::Block block = reader->block(i);
            walk(block.cursor);
        }
    }
    return 0;
}
