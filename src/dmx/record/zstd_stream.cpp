// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/zstd_stream.h"

#include "base/check.h"

#include <zstd.h>

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr int kLevel = 3;               // of 1 to 19; the default of zstd
constexpr int kMaxWindowLog = 24;       // 16 MiB: no stream makes us take more memory
constexpr std::size_t kRoom = 64 << 10; // taken at a time

} // namespace

void Packer::Free::operator()(ZSTD_CCtx_s* context) const {
    ZSTD_freeCCtx(context);
}

Packer::Packer() : context_(ZSTD_createCCtx()) {
    CHECK(context_ != nullptr);
    CHECK(!ZSTD_isError(ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, kLevel)));
}

void Packer::pack(Bytes bytes, Then then, std::vector<std::uint8_t>& out) {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (std::size_t left = 1; left > 0;) {
        const std::size_t done = out.size();
        out.resize(done + std::max(kRoom, bytes.size() / 4));
        ZSTD_outBuffer target{out.data(), out.size(), done};
        left = ZSTD_compressStream2(context_.get(), &target, &in,
                                    then == Then::flush ? ZSTD_e_flush : ZSTD_e_end);
        CHECK(!ZSTD_isError(left)); // nothing but a lack of memory or a bug can stop it
        out.resize(target.pos);
    }
}

void Unpacker::Free::operator()(ZSTD_DCtx_s* context) const {
    ZSTD_freeDCtx(context);
}

Unpacker::Unpacker() : context_(ZSTD_createDCtx()) {
    CHECK(context_ != nullptr);
    CHECK(!ZSTD_isError(ZSTD_DCtx_setParameter(context_.get(), ZSTD_d_windowLogMax, kMaxWindowLog)));
}

bool Unpacker::unpack(Bytes bytes, std::size_t limit_bytes, std::vector<std::uint8_t>& out) {
    const std::size_t before = out.size();
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (;;) {
        const std::size_t done = out.size();
        const std::size_t room = std::min(kRoom * 4, limit_bytes - done);
        out.resize(done + room);
        ZSTD_outBuffer target{out.data(), out.size(), done};
        const std::size_t code = ZSTD_decompressStream(context_.get(), &target, &in);
        const bool full = target.pos == target.size;
        out.resize(target.pos);
        const bool stuck = in.pos < in.size && (code == 0 || room == 0);
        if (ZSTD_isError(code) || stuck || (full && out.size() == limit_bytes)) {
            out.resize(before);
            return false;
        }
        if (in.pos == in.size && !full) return true;
    }
}

} // namespace ghost::dmx
