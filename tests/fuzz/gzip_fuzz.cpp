// SPDX-License-Identifier: Apache-2.0
// Any bytes as a gzip file, and as what is in one of two members: read on and on, and again from any place,
// it is the same; and as a capture.
#include "fuzz_folder.h"

#include "archives/byte_source.h"
#include "dmx/record/capture.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <zlib.h>

using namespace ghost;
using namespace ghost::dmx;

namespace {

constexpr std::size_t kMostUnpacked = 4u << 20; // looked at: a zip bomb takes its time

std::vector<std::uint8_t> packed(Bytes content) {
    constexpr int kGzip = 16 + MAX_WBITS;
    z_stream stream{};
    if (deflateInit2(&stream, 1, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK) std::abort();
    std::vector<std::uint8_t> out(deflateBound(&stream, static_cast<uLong>(content.size())) + 32);
    stream.next_in = const_cast<Bytef*>(content.data());
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    if (deflate(&stream, Z_FINISH) != Z_STREAM_END) std::abort();
    out.resize(out.size() - stream.avail_out);
    deflateEnd(&stream);
    return out;
}

std::vector<std::uint8_t> all_of(ByteSource& source) {
    std::vector<std::uint8_t> all(kMostUnpacked);
    std::size_t size = 0;
    while (size < all.size()) {
        const std::size_t more =
            source.read(size, std::span(all).subspan(size, std::min<std::size_t>(all.size() - size, 70'001)));
        if (more == 0) break;
        size += more;
    }
    all.resize(size);
    return all;
}

std::vector<std::uint8_t> look(const std::filesystem::path& path) {
    auto source = ByteSource::open(path);
    if (!source.ok()) std::abort();
    const std::vector<std::uint8_t> all = all_of(*source);
    for (const std::size_t at :
         {all.size() / 2, std::size_t{0}, all.size() - all.size() / 7}) { // back, to the front, on
        std::vector<std::uint8_t> piece(std::min<std::size_t>(all.size() - at, 999));
        if (source->read(at, piece) != piece.size() ||
            !std::equal(piece.begin(), piece.end(), all.begin() + static_cast<std::ptrdiff_t>(at)))
            std::abort();
    }
    if (all.size() < kMostUnpacked)
        (void)read_capture(
            *source, "fuzz", {}, {}, [](std::chrono::microseconds) {},
            [](const RecordedFrame&) -> Result<void> { return {}; });
    return all;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes input(data, size);
    (void)look(fuzz_file("a.pcap.gz", input));
    std::vector<std::uint8_t> file = packed(input.first(size / 3));
    const std::vector<std::uint8_t> second = packed(input.subspan(size / 3));
    file.insert(file.end(), second.begin(), second.end());
    const std::vector<std::uint8_t> unpacked = look(fuzz_file("b.pcap.gz", file));
    if (!std::equal(unpacked.begin(), unpacked.end(), input.begin(), input.end())) std::abort();
    return 0;
}
