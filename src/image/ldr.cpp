// SPDX-License-Identifier: Apache-2.0
#include "image/ldr.h"

#include "base/check.h"
#include "disk/files.h"
#include "image/private/jpeg_file.h"
#include "image/private/png_file.h"

#include <vector>

namespace ghost::image {
namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{512} << 20;

Result<PictureSize> size_of(Bytes bytes) {
    if (is_png(bytes)) return png_size(bytes);
    if (is_jpeg(bytes)) return jpeg_size(bytes);
    return Error{"not a readable PNG or JPEG picture: it begins like neither", ""};
}

bool fits(const PictureSize& size, const LdrLimits& limits) {
    return size.width <= limits.side_px && size.height <= limits.side_px && size.pixels() <= limits.pixels;
}

} // namespace

std::size_t decoded_bytes(Bytes bytes, const LdrLimits& limits) {
    if (bytes.size() > kMaxFileBytes) return 0;
    const auto size = size_of(bytes);
    return size.ok() && fits(*size, limits) ? size->pixels() * 4 : 0;
}

Result<Image8> decode_ldr(Bytes bytes, const std::string& name, const LdrLimits& limits,
                          std::string* damage) {
    if (bytes.size() > kMaxFileBytes) return Error{"picture file is larger than the limit of 512 MiB", name};
    const auto size = size_of(bytes);
    if (!size.ok()) return Error{size.error().what, name};
    if (!fits(*size, limits))
        return Error{"the picture has " + std::to_string(size->width) + " x " + std::to_string(size->height) +
                         " pixels, at most " + std::to_string(limits.side_px) + " a side and " +
                         std::to_string(limits.pixels) + " in all are allowed",
                     name};
    std::string found;
    auto image = is_png(bytes) ? decode_png(bytes, found) : decode_jpeg(bytes, found);
    if (!image.ok()) return Error{image.error().what, name};
    if (damage == nullptr && !found.empty()) return Error{"the picture is damaged: " + found, name};
    if (damage != nullptr) *damage = found.empty() ? "" : "the picture is damaged: " + found;
    return image;
}

Result<Image8> read_ldr(const std::filesystem::path& path, std::string* damage) {
    TRY(const auto bytes, read_file(path, kMaxFileBytes));
    return decode_ldr(bytes, path.string(), {}, damage);
}

Result<void> write_png(const std::filesystem::path& path, const Image8& pixels) {
    CHECK(pixels.width > 0 && pixels.height > 0);
    const auto bytes = encode_png(pixels);
    if (!bytes.ok()) return Error{bytes.error().what, path.string()};
    return write_file_atomic(path, *bytes);
}

} // namespace ghost::image
