// SPDX-License-Identifier: Apache-2.0
// Any bytes as a connection of MVR-xchange: the first says how they are cut into pieces. Messages that come
// out are answered.
#include "xchange/protocol.h"

#include <algorithm>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost;
    if (size == 0) return 0;
    const std::size_t piece = 1u + data[0];
    scene::XchangeReader reader;
    std::uint64_t bytes = 0;
    const scene::XchangeReader::Sink sink{
        [&](std::string_view json) -> Result<void> {
            if (json.size() > scene::kMaxXchangeMessageBytes) std::abort();
            const auto message = scene::parse_xchange_message(json);
            if (!message.ok()) return {};
            if (message->commits.size() > scene::kMostXchangeCommits ||
                message->station_name.size() > scene::kMaxXchangeText)
                std::abort();
            if (!scene::parse_xchange_message(scene::xchange_message_text(*message)).ok()) std::abort();
            for (const scene::XchangeCommit& commit : message->commits)
                if (scene::plot_file_name(commit.file_name).find('/') != std::string::npos) std::abort();
            return {};
        },
        [&](Bytes more, bool) -> Result<void> {
            bytes += more.size();
            return {};
        }};
    for (std::size_t i = 1; i < size; i += piece)
        if (!reader.take({data + i, std::min(piece, size - i)}, sink).ok()) break;
    if (bytes > size) std::abort();
    return 0;
}
