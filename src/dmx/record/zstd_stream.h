#pragma once
// SPDX-License-Identifier: Apache-2.0
// zstd (RFC 8878) as streams whose output can be cut off at any flush. One thread each.

#include "base/byte_reader.h"

#include <memory>
#include <vector>

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace ghost::dmx {

class Packer {
public:
    enum class Then { flush, end }; // end: the next call begins a new stream

    Packer();
    // Appends to out what unpacks to everything given so far.
    void pack(Bytes bytes, Then then, std::vector<std::uint8_t>& out);

private:
    struct Free {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_CCtx_s, Free> context_;
};

// One stream.
class Unpacker {
public:
    Unpacker();
    // Appends to out. False where this is no such stream, or where out would pass limit_bytes; what is in out
    // then is from before the fault.
    bool unpack(Bytes bytes, std::size_t limit_bytes, std::vector<std::uint8_t>& out);

private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

} // namespace ghost::dmx
