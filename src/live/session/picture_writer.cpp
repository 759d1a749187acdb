// SPDX-License-Identifier: Apache-2.0
#include "live/session/picture_writer.h"

#include "image/exr.h"
#include "image/ldr.h"
#include "live/session/caption.h"
#include "shared/develop.h"

#include "disk/files.h"
#include "image/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <utility>

namespace ghost::app {
namespace {

constexpr std::uintmax_t kMaxPictureBytes = std::uintmax_t{1} << 31; // of 8192x8192 in floats: 0.8 GB

image::Image8 developed(const image::ImageF& picture, float ev100, image::Tone tone) {
    image::Image8 shown(picture.width, picture.height, 4);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float* linear = picture.at(x, y);
            const glm::vec3 value =
                shared::develop({linear[0], linear[1], linear[2]}, shared::exposure_of(ev100),
                                static_cast<std::uint32_t>(tone));
            std::uint8_t* texel = shown.at(x, y);
            for (int c = 0; c < 3; ++c)
                texel[c] = static_cast<std::uint8_t>(std::lround(std::clamp(value[c], 0.0f, 1.0f) * 255.0f));
            texel[3] = 255;
        }
    return shown;
}

// Bilinear.
template <class Picture>
Picture scaled_up(Picture picture, int width, int height) {
    if (picture.width == width && picture.height == height) return picture;
    Picture large(width, height, picture.channels);
    const auto place = [](int at, int to, int from) {
        return std::clamp(
            (static_cast<float>(at) + 0.5f) * static_cast<float>(from) / static_cast<float>(to) - 0.5f, 0.0f,
            static_cast<float>(from - 1));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = place(x, width, picture.width), v = place(y, height, picture.height);
            const int left = static_cast<int>(u), top = static_cast<int>(v);
            const int right = std::min(left + 1, picture.width - 1),
                      below = std::min(top + 1, picture.height - 1);
            const float across = u - static_cast<float>(left), down = v - static_cast<float>(top);
            for (int c = 0; c < picture.channels; ++c) {
                const auto value = [&](int i, int k) { return static_cast<float>(picture.at(i, k)[c]); };
                const float mixed =
                    std::lerp(std::lerp(value(left, top), value(right, top), across),
                              std::lerp(value(left, below), value(right, below), across), down);
                using Sample = std::remove_reference_t<decltype(*large.at(x, y))>;
                large.at(x, y)[c] = std::is_integral_v<Sample> ? static_cast<Sample>(std::lround(mixed))
                                                               : static_cast<Sample>(mixed);
            }
        }
    return large;
}

} // namespace

Result<OutputKind> output_kind(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".png") return OutputKind::png;
    if (ending == ".exr") return OutputKind::exr;
    if (ending == ".mp4") return OutputKind::film;
    return Error{"the output must end in .png, .exr or .mp4", path.string()};
}

Result<void> write_picture(const std::filesystem::path& path, const image::ImageF& picture, float ev100,
                           image::Tone tone) {
    TRY(const OutputKind kind, output_kind(path));
    if (kind == OutputKind::film) return Error{"one picture is no film: .png or .exr", path.string()};
    if (kind == OutputKind::png) return image::write_png(path, developed(picture, ev100, tone));
    image::ExrFile file;
    file.pixels = picture;
    file.channels = {"R", "G", "B"};
    file.chromaticities = image::kRec2020;
    file.text["unit"] = "cd/m^2";
    return image::write_exr(path, file, image::ExrSample::full);
}

Result<std::unique_ptr<PictureWriter>> PictureWriter::create(const std::filesystem::path& path, int width,
                                                             int height, int fps, bool numbered,
                                                             int supersample, video::FilmSound sound,
                                                             long first_frame) {
    std::unique_ptr<PictureWriter> writer(new PictureWriter);
    writer->path_ = path;
    writer->numbered_ = numbered;
    writer->supersample_ = supersample;
    writer->width_ = width;
    writer->height_ = height;
    writer->first_ = writer->count_ = static_cast<int>(first_frame);
    TRY(writer->kind_, output_kind(path));
    if (writer->kind_ == OutputKind::film) {
        TRY(writer->film_,
            video::FilmWriter::create(path, width, height, fps, std::move(sound), first_frame));
    }
    return writer;
}

std::filesystem::path PictureWriter::numbered_path(int number) const {
    if (!numbered_ || kind_ == OutputKind::film) return path_;
    char text[16];
    std::snprintf(text, sizeof text, "-%05d", number);
    std::filesystem::path path = path_;
    path.replace_filename(path_.stem().string() + text + path_.extension().string());
    return path;
}

std::string PictureWriter::written() const {
    const std::string first = first_path().string();
    if (!numbered_ || kind_ == OutputKind::film || count_ - first_ <= 1) return first;
    return first + " to " + numbered_path(count_ - 1).filename().string();
}

Result<void> PictureWriter::add(render::Relighter& relighter, const std::string& caption) {
    image::Image8 picture;
    if (kind_ != OutputKind::exr) {
        picture = supersample_ == 1 ? scaled_up(relighter.picture(), width_, height_)
                                    : developed(image::averaged(relighter.frame(), supersample_),
                                                relighter.ev100_used(), relighter.tone());
        draw_caption(picture, caption);
    }
    if (kind_ == OutputKind::film) {
        last_frame_ = std::move(picture);
        return film_->add(last_frame_.samples.data());
    }
    last_path_ = next_path();
    if (kind_ == OutputKind::png) return image::write_png(last_path_, picture);
    return write_picture(last_path_,
                         scaled_up(image::averaged(relighter.frame(), supersample_), width_, height_),
                         relighter.ev100_used(), relighter.tone());
}

Result<void> PictureWriter::repeat(long times) {
    for (; times > 0; --times) {
        if (kind_ == OutputKind::film) {
            TRY_VOID(film_->add(last_frame_.samples.data()));
            continue;
        }
        TRY(const std::vector<std::uint8_t> bytes, read_file(last_path_, kMaxPictureBytes));
        TRY_VOID(write_file_atomic(next_path(), bytes));
    }
    return {};
}

Result<void> PictureWriter::finish() {
    return film_ ? film_->finish() : Result<void>{};
}

} // namespace ghost::app
