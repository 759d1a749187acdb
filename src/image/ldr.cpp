// SPDX-License-Identifier: Apache-2.0
#include "image/ldr.h"

#include "base/check.h"
#include "files/files.h"
#include "image/private/jpeg_check.h"

#include <cstddef>
#include <cstdlib>

namespace {

// stb unpacks a PNG to its end, however small the picture: 4 MB can become 4 GB.
thread_local std::size_t largest_block = 0;

void* block(std::size_t size) {
    return size <= largest_block ? std::malloc(size) : nullptr;
}
void* larger_block(void* old, std::size_t size) {
    return size <= largest_block ? std::realloc(old, size) : nullptr;
}

} // namespace

#define STBI_MALLOC(size) block(size)
#define STBI_REALLOC(old, size) larger_block(old, size)
#define STBI_FREE(old) std::free(old)
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace ghost::image {
namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{512} << 20;

struct Size {
    int width = 0, height = 0; // 0: not known
    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    bool fits(const LdrLimits& limits) const {
        return width <= limits.side_px && height <= limits.side_px && pixels() <= limits.pixels;
    }
};

// Sets how much the decoder may take at once: 16 bits of 4 channels, twice, as it doubles what is too small;
// what it keeps of the file; blocks at the edges of a small JPEG.
void allow_blocks(const Size& size, std::size_t file_bytes) {
    largest_block = 2 * (size.pixels() * 8 + static_cast<std::size_t>(size.height)) + 2 * file_bytes +
                    (std::size_t{4} << 20);
}

Size size_of(Bytes bytes) {
    Size size;
    int channels = 0;
    allow_blocks({}, bytes.size());
    if (!stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &size.width, &size.height,
                               &channels))
        return {};
    return size;
}

// stb shows what it has of a JPEG that ends early; the end marker tells.
bool jpeg_cut_short(Bytes bytes) {
    constexpr std::array<std::uint8_t, 2> kStart{0xff, 0xd8};
    constexpr std::array<std::uint8_t, 2> kEnd{0xff, 0xd9};
    return bytes.size() > 2 && std::equal(kStart.begin(), kStart.end(), bytes.begin()) &&
           std::find_end(bytes.begin(), bytes.end(), kEnd.begin(), kEnd.end()) == bytes.end();
}

void append(void* target, void* data, int size) {
    auto* bytes = static_cast<std::vector<std::uint8_t>*>(target);
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes->insert(bytes->end(), begin, begin + size);
}

} // namespace

std::size_t decoded_bytes(Bytes bytes, const LdrLimits& limits) {
    const Size size = bytes.size() <= kMaxFileBytes ? size_of(bytes) : Size{};
    return size.fits(limits) ? size.pixels() * 4 : 0;
}

Result<Image8> decode_ldr(Bytes bytes, const std::string& name, const LdrLimits& limits) {
    if (bytes.size() > kMaxFileBytes) return Error{"picture file is larger than the limit of 512 MiB", name};
    if (jpeg_cut_short(bytes)) return Error{"the JPEG picture is cut short (no end marker)", name};
    if (const std::string fault = fault_of_jpeg(bytes); !fault.empty())
        return Error{"the JPEG picture has " + fault, name};
    const Size size = size_of(bytes);
    if (!size.fits(limits))
        return Error{"the picture has " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                         " pixels, at most " + std::to_string(limits.side_px) + " a side and " +
                         std::to_string(limits.pixels) + " in all are allowed",
                     name};
    allow_blocks(size, bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &channels, 4),
        stbi_image_free);
    if (!pixels) {
        const std::string why = stbi_failure_reason();
        if (why == "too large")
            return Error{"the picture is too large, at most 16384 pixels a side are allowed", name};
        return Error{
            "not a readable PNG or JPEG picture: " +
                (why == "outofmem" ? "it unpacks to more than its size says, or memory is short" : why),
            name};
    }
    Image8 image;
    image.width = width;
    image.height = height;
    image.channels = 4;
    image.samples.assign(pixels.get(), pixels.get() + static_cast<std::size_t>(width) *
                                                          static_cast<std::size_t>(height) * 4);
    return image;
}

Result<Image8> read_ldr(const std::filesystem::path& path) {
    TRY(const auto bytes, read_file(path, kMaxFileBytes));
    return decode_ldr(bytes, path.string());
}

Result<void> write_png(const std::filesystem::path& path, const Image8& pixels) {
    CHECK(pixels.width > 0 && pixels.height > 0);
    CHECK(pixels.channels == 3 || pixels.channels == 4);
    std::vector<std::uint8_t> bytes;
    if (!stbi_write_png_to_func(append, &bytes, pixels.width, pixels.height, pixels.channels,
                                pixels.samples.data(), pixels.width * pixels.channels))
        return Error{"cannot encode as PNG", path.string()};
    return write_file_atomic(path, bytes);
}

} // namespace ghost::image
