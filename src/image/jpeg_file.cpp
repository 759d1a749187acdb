// SPDX-License-Identifier: Apache-2.0
#include "image/private/jpeg_file.h"

#include "base/check.h"
#include "image/jpeg_bytes.h"

#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>

namespace ghost::image {
namespace {

constexpr std::ptrdiff_t kMostScans = 32; // of a picture; a progressive one has some ten

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

struct Header {
    PictureSize size;
    int colours = -1; // TJCS
};

Error unreadable(const Decoder& decoder) {
    return Error{std::string("not a readable JPEG picture: ") +
                     (decoder ? tjGetErrorStr2(decoder.get()) : "memory is short"),
                 ""};
}

Result<Header> read_header(const Decoder& decoder, Bytes bytes) {
    Header header;
    int subsampling = 0;
    if (!decoder) return unreadable(decoder);
    const int status =
        tjDecompressHeader3(decoder.get(), bytes.data(), static_cast<unsigned long>(bytes.size()),
                            &header.size.width, &header.size.height, &subsampling, &header.colours);
    // It also complains of subsampling that has no name there, and of nothing worse; decoding copes with it.
    if (status != 0 && (header.size.width < 1 || header.size.height < 1 || header.colours < 0))
        return unreadable(decoder);
    return header;
}

// Adobe, the only one to write such files, stores what is left of the light.
void rgb_from_cmyk(Image8& image) {
    for (std::size_t k = 0; k < image.samples.size(); k += 4) {
        const unsigned black = image.samples[k + 3];
        for (std::size_t c = 0; c < 3; ++c)
            image.samples[k + c] = static_cast<std::uint8_t>((image.samples[k + c] * black + 127) / 255);
        image.samples[k + 3] = 255;
    }
}

// The decoder fills up what a file that ends early lacks; the end marker tells.
bool is_cut_short(Bytes bytes) {
    constexpr std::array<std::uint8_t, 2> kEnd{0xff, 0xd9};
    return std::find_end(bytes.begin(), bytes.end(), kEnd.begin(), kEnd.end()) == bytes.end();
}

// Each goes over the whole picture, however few bytes it has. In what is packed no marker stands.
bool has_too_many_scans(Bytes bytes) {
    std::ptrdiff_t scans = 0;
    for (std::size_t k = 0; k + 1 < bytes.size(); ++k) scans += bytes[k] == 0xff && bytes[k + 1] == 0xda;
    return scans > kMostScans;
}

} // namespace

bool is_jpeg(Bytes bytes) {
    constexpr std::array<std::uint8_t, 3> kStart{0xff, 0xd8, 0xff};
    return bytes.size() >= kStart.size() && std::equal(kStart.begin(), kStart.end(), bytes.begin());
}

Result<PictureSize> jpeg_size(Bytes bytes) {
    const Decoder decoder(tjInitDecompress(), tjDestroy);
    TRY(const Header header, read_header(decoder, bytes));
    return header.size;
}

Result<Image8> decode_jpeg(Bytes bytes, std::string& damage) {
    if (is_cut_short(bytes)) return Error{"the JPEG picture is cut short (no end marker)", ""};
    if (has_too_many_scans(bytes))
        return Error{"the JPEG picture has more than " + std::to_string(kMostScans) + " scans", ""};
    const Decoder decoder(tjInitDecompress(), tjDestroy);
    TRY(const Header header, read_header(decoder, bytes));
    const bool is_cmyk = header.colours == TJCS_CMYK || header.colours == TJCS_YCCK;
    Image8 image(header.size.width, header.size.height, 4);
    const int status = tjDecompress2(decoder.get(), bytes.data(), static_cast<unsigned long>(bytes.size()),
                                     image.samples.data(), image.width, 0, image.height,
                                     is_cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_LIMITSCANS);
    if (status != 0 && tjGetErrorCode(decoder.get()) != TJERR_WARNING) return unreadable(decoder);
    if (status != 0) damage = tjGetErrorStr2(decoder.get());
    if (is_cmyk) rgb_from_cmyk(image);
    return image;
}

Result<std::vector<std::uint8_t>> jpeg_bytes(const Image8& pixels, int quality) {
    CHECK(pixels.channels == 4 && !pixels.empty());
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
    unsigned char* packed = nullptr;
    unsigned long size = 0;
    const int status = encoder ? tjCompress2(encoder.get(), pixels.samples.data(), pixels.width, 0,
                                             pixels.height, TJPF_RGBA, &packed, &size, TJSAMP_444, quality, 0)
                               : -1;
    std::vector<std::uint8_t> bytes;
    if (status == 0) bytes.assign(packed, packed + size);
    tjFree(packed);
    if (status != 0) return Error{"cannot be packed as JPEG: memory is short, or it is too large", ""};
    return bytes;
}

} // namespace ghost::image
