// SPDX-License-Identifier: Apache-2.0
#include "image/exr.h"

#include "base/check.h"
#include "disk/files.h"
#include "image/private/exr_header.h"

#include <ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <utility>

namespace ghost::image {
namespace {

constexpr float kHalfMax = 65504.0f;
constexpr std::size_t kMaxChannels = 64;
constexpr std::uint64_t kMaxSamples = std::uint64_t{512} << 20;

// What a channel is called in the file, and by us.
struct Named {
    std::string in_file;
    std::string name;
};

std::string after_last_dot(const std::string& text) {
    return text.substr(text.rfind('.') + 1);
}

bool is_combined(const std::string& in_file) {
    const std::size_t dot = in_file.rfind('.');
    return dot != std::string::npos && after_last_dot(in_file.substr(0, dot)) == "Combined";
}

int place_of(const std::string& name) {
    static const std::string kFirst = "RGBA";
    const std::size_t place = name.size() == 1 ? kFirst.find(name[0]) : std::string::npos;
    return place == std::string::npos ? 4 : static_cast<int>(place);
}

std::vector<Named> short_names(const Imf::ChannelList& list) {
    std::vector<Named> channels;
    std::map<std::string, std::vector<std::string>> rivals; // for one short name
    for (auto channel = list.begin(); channel != list.end(); ++channel) {
        channels.push_back({channel.name(), after_last_dot(channel.name())});
        rivals[channels.back().name].push_back(channel.name());
    }
    for (Named& channel : channels) {
        const std::vector<std::string>& others = rivals[channel.name];
        const bool plain_one = std::find(others.begin(), others.end(), channel.name) != others.end();
        const bool alone =
            others.size() == 1 || (!plain_one && is_combined(channel.in_file) &&
                                   std::count_if(others.begin(), others.end(), is_combined) == 1);
        if (!alone) channel.name = channel.in_file;
    }
    std::stable_sort(channels.begin(), channels.end(),
                     [](const Named& a, const Named& b) { return place_of(a.name) < place_of(b.name); });
    return channels;
}

std::string size_text(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

ImageF placed_in(const Imath::Box2i& display, const Imath::Box2i& data, const ImageF& pixels) {
    ImageF result(display.max.x - display.min.x + 1, display.max.y - display.min.y + 1, pixels.channels);
    const int first_x = std::max(display.min.x, data.min.x);
    const int last_x = std::min(display.max.x, data.max.x);
    if (first_x > last_x) return result;
    const std::size_t row =
        static_cast<std::size_t>(last_x - first_x + 1) * static_cast<std::size_t>(pixels.channels);
    for (int y = std::max(display.min.y, data.min.y); y <= std::min(display.max.y, data.max.y); ++y)
        std::copy_n(pixels.at(first_x - data.min.x, y - data.min.y), row,
                    result.at(first_x - display.min.x, y - display.min.y));
    return result;
}

Result<void> check_window(const Imath::Box2i& window, std::size_t channels) {
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
        return Error{"is " + size_text(width, height) + " pixels, expected 1 to " + std::to_string(kMaxSide) +
                         " a side",
                     ""};
    if (static_cast<std::uint64_t>(width * height) * channels > kMaxSamples)
        return Error{"has " + size_text(width, height) + " pixels of " + std::to_string(channels) +
                         " channels, more than the limit of 512 Mi samples",
                     ""};
    return {};
}

constexpr std::uint64_t kUnasked = std::uint64_t{256} << 20; // bytes that are not asked about

std::uint64_t area_of(const Imath::Box2i& window) {
    return static_cast<std::uint64_t>(window.max.x - window.min.x + 1) *
           static_cast<std::uint64_t>(window.max.y - window.min.y + 1);
}

// A few bytes can say that they are gigabytes, or that their pixels lie in a picture of that many. Nothing
// that pictures are packed with gets below a thousandth but for one colour all over.
Result<void> check_packing(const Imf::Header& header, std::uintmax_t file_bytes) {
    constexpr std::uint64_t kMostPacked = 2000;
    std::uint64_t pixel_bytes = 0;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
        pixel_bytes += channel.channel().type == Imf::HALF ? 2 : 4;
    const std::uint64_t bytes =
        pixel_bytes * std::max(area_of(header.dataWindow()), area_of(header.displayWindow()));
    if (bytes > kUnasked && bytes / kMostPacked > file_bytes)
        return Error{"says that it holds " + std::to_string(bytes >> 20) +
                         " MiB of pixels, but the file has " + std::to_string(file_bytes) + " bytes",
                     ""};
    return {};
}

// Nor a small piece, that it lies in a huge picture of nothing.
Result<void> check_empty(const Imath::Box2i& display, const Imath::Box2i& data, std::size_t channels) {
    constexpr std::uint64_t kMostEmpty = 16;
    if (area_of(display) * channels * sizeof(float) <= kUnasked ||
        area_of(display) <= kMostEmpty * area_of(data))
        return {};
    return Error{"says that its picture has " + std::to_string(area_of(display)) + " pixels, but holds " +
                     std::to_string(area_of(data)) + " of them",
                 ""};
}

Result<void> check_shape(const Imath::Box2i& display, const Imath::Box2i& data, std::size_t channels,
                         const ExrShape& expected) {
    constexpr std::uint64_t kMostAround = 16; // of a picture, that is cut off
    const int width = display.max.x - display.min.x + 1, height = display.max.y - display.min.y + 1;
    if ((expected.width > 0 && width != expected.width) || (expected.height > 0 && height != expected.height))
        return Error{"is " + size_text(width, height) + " pixels, expected " +
                         size_text(expected.width, expected.height),
                     ""};
    if (expected.channels > 0 && channels != static_cast<std::size_t>(expected.channels))
        return Error{"has " + std::to_string(channels) + " channels, expected " +
                         std::to_string(expected.channels),
                     ""};
    if (expected.width > 0 && area_of(data) * channels * sizeof(float) > kUnasked &&
        area_of(data) > kMostAround * area_of(display))
        return Error{"holds " + std::to_string(area_of(data)) + " pixels, but its picture has " +
                         std::to_string(area_of(display)) + " of them",
                     ""};
    return {};
}

// Throws what OpenEXR throws.
Result<ExrFile> read_unguarded(const std::filesystem::path& path, const ExrShape& expected) {
    TRY_VOID(check_exr_attributes(path));
    Imf::InputFile input(path.string().c_str());
    const Imf::Header& header = input.header();
    const Imath::Box2i data = header.dataWindow();
    const Imath::Box2i display = header.displayWindow();
    const std::vector<Named> channels = short_names(header.channels());
    if (channels.empty() || channels.size() > kMaxChannels)
        return Error{"has " + std::to_string(channels.size()) + " channels, expected 1 to " +
                         std::to_string(kMaxChannels),
                     ""};
    TRY_VOID(check_window(data, channels.size()));
    TRY_VOID(check_window(display, channels.size()));
    TRY_VOID(check_shape(display, data, channels.size(), expected));
    TRY_VOID(check_empty(display, data, channels.size()));
    std::error_code code;
    TRY_VOID(check_packing(header, std::filesystem::file_size(path, code)));

    ExrFile file;
    file.pixels =
        ImageF(data.max.x - data.min.x + 1, data.max.y - data.min.y + 1, static_cast<int>(channels.size()));
    const std::size_t step = channels.size() * sizeof(float);
    const std::size_t row = step * static_cast<std::size_t>(file.pixels.width);
    Imf::FrameBuffer frame;
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const Imf::Channel& channel = header.channels()[channels[k].in_file.c_str()];
        if (channel.xSampling != 1 || channel.ySampling != 1)
            return Error{"channel " + channels[k].in_file + " is subsampled, expected one sample a pixel",
                         ""};
        file.channels.push_back(channels[k].name);
        frame.insert(channels[k].in_file,
                     Imf::Slice::Make(Imf::FLOAT, file.pixels.samples.data() + k, data.min, file.pixels.width,
                                      file.pixels.height, step, row));
    }
    input.setFrameBuffer(frame);
    input.readPixels(data.min.y, data.max.y);
    if (display != data) file.pixels = placed_in(display, data, file.pixels);

    if (Imf::hasChromaticities(header)) {
        const Imf::Chromaticities c = Imf::chromaticities(header);
        file.chromaticities = {c.red.x,  c.red.y,  c.green.x, c.green.y,
                               c.blue.x, c.blue.y, c.white.x, c.white.y};
    }
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            file.text[attribute.name()] = text->value();
    return file;
}

// A whole EXR file in memory: OpenEXR's own file writer swallows a full disk when it closes.
std::string encode(const ExrFile& file, ExrSample sample) {
    const ImageF& pixels = file.pixels;
    const bool is_half = sample == ExrSample::half;
    Imf::Header header(pixels.width, pixels.height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y,
                       Imf::ZIP_COMPRESSION);
    if (file.chromaticities) {
        const Chromaticities& c = *file.chromaticities;
        Imf::addChromaticities(header,
                               Imf::Chromaticities({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}));
    }
    for (const auto& [name, value] : file.text) header.insert(name, Imf::StringAttribute(value));

    std::vector<half> halves;
    if (is_half) {
        halves.reserve(pixels.samples.size());
        for (const float value : pixels.samples)
            halves.emplace_back(std::isfinite(value) ? std::clamp(value, -kHalfMax, kHalfMax) : value);
    }
    const Imf::PixelType type = is_half ? Imf::HALF : Imf::FLOAT;
    const std::size_t size = is_half ? sizeof(half) : sizeof(float);
    const std::size_t step = size * file.channels.size();
    const char* base = is_half ? reinterpret_cast<const char*>(halves.data())
                               : reinterpret_cast<const char*>(pixels.samples.data());
    Imf::FrameBuffer frame;
    for (std::size_t k = 0; k < file.channels.size(); ++k) {
        header.channels().insert(file.channels[k], Imf::Channel(type));
        frame.insert(file.channels[k], Imf::Slice(type, const_cast<char*>(base + k * size), step,
                                                  step * static_cast<std::size_t>(pixels.width)));
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(frame);
        output.writePixels(pixels.height);
    }
    return stream.str();
}

} // namespace

int ExrFile::find_channel(const std::string& name) const {
    const auto found = std::find(channels.begin(), channels.end(), name);
    return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
}

Result<ExrFile> read_exr(const std::filesystem::path& path, const ExrShape& expected) {
    std::error_code code;
    if (!std::filesystem::exists(path, code)) return Error{"no such file", path.string()};
    if (!std::filesystem::is_regular_file(path, code)) return Error{"not a plain file", path.string()};
    try {
        Result<ExrFile> file = read_unguarded(path, expected);
        if (!file.ok()) return Error{file.error().what, path.string()};
        return file;
    } catch (const std::exception& problem) {
        return Error{std::string("not a readable OpenEXR image: ") + problem.what(), path.string()};
    }
}

Result<void> write_exr(const std::filesystem::path& path, const ExrFile& file, ExrSample sample) {
    CHECK(file.pixels.width > 0 && file.pixels.height > 0);
    CHECK_EQ(static_cast<std::size_t>(file.pixels.channels), file.channels.size());
    std::string bytes;
    try {
        bytes = encode(file, sample);
    } catch (const std::exception& problem) {
        return Error{std::string("cannot encode as OpenEXR: ") + problem.what(), path.string()};
    }
    return write_file_atomic(path, bytes);
}

} // namespace ghost::image
