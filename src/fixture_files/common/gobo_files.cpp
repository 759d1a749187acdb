// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/gobo_files.h"

#include "base/text.h"
#include "disk/files.h"
#include "fixture_files/common/gobo_drawing.h"
#include "image/ldr.h"

#include <system_error>

namespace ghost::fixture {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 16u << 20;
constexpr std::size_t kMaxName = 512;

bool is_plain(const std::filesystem::path& path) {
    if (path.empty() || path.is_absolute() || path.has_root_path()) return false;
    for (const std::filesystem::path& part : path)
        if (part == "..") return false;
    return true;
}

Result<GoboDrawing> read_picture(Bytes bytes, const std::string& name, std::size_t pixels_left) {
    GoboDrawing gobo;
    TRY(gobo.picture, image::decode_ldr(bytes, name, {kMaxPicture_px, pixels_left}, &gobo.problem));
    return gobo;
}

} // namespace

GoboFiles::Found GoboFiles::decode(Type& type, const std::string& name, std::vector<std::uint8_t> bytes) {
    const bool is_drawing = lower(std::filesystem::path(name).extension().string()) == ".svg";
    Result<GoboDrawing> decoded =
        is_drawing ? draw_gobo(bytes, name) : read_picture(bytes, name, kMaxPicturePixels - pixels_);
    if (!decoded) return {-1, decoded.error().text()};
    image::Image8& pixels = decoded->picture;
    if (pixels.samples.size() / 4 > kMaxPicturePixels - pixels_)
        return {-1, "gobo pictures have more than 96 million pixels in all"};
    pixels_ += pixels.samples.size() / 4;
    Media media;
    media.file = name;
    media.png = std::move(bytes);
    media.width = pixels.width;
    media.height = pixels.height;
    media.rgba = std::move(pixels.samples);
    type.media.push_back(std::move(media));
    return {static_cast<int>(type.media.size()) - 1, decoded->problem};
}

GoboFiles::Found GoboFiles::read(Type& type, const std::string& name) {
    if (name.size() > kMaxName || name.find('\0') != std::string::npos || !is_plain(name))
        return {-1, "gobo pictures must be named by a plain path below the fixture's folder"};
    if (folders_.empty()) return {-1, "gobo pictures are not in the file, the slots stay open"};
    for (const std::filesystem::path& folder : folders_) {
        const std::filesystem::path path = folder / name;
        std::error_code code;
        if (!std::filesystem::is_regular_file(path, code)) continue;
        Result<std::vector<std::uint8_t>> bytes = read_file(path, kMaxFileBytes);
        if (!bytes) return {-1, bytes.error().text()};
        return decode(type, name, std::move(*bytes));
    }
    return {-1, "gobo pictures are neither in nor beside the fixture's folder, the slots stay open"};
}

GoboFiles::Found GoboFiles::find(Type& type, const std::string& name) {
    const auto [entry, is_new] = known_.try_emplace(name);
    if (is_new) entry->second = read(type, name);
    return entry->second;
}

} // namespace ghost::fixture
