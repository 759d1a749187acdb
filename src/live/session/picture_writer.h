#pragma once
// SPDX-License-Identifier: Apache-2.0
// PictureWriter: what the relighter drew into a PNG, EXR (linear, Rec.2020, cd/m^2) or MP4, chosen by the
// file's ending. Atomic. Main thread.

#include "base/result.h"
#include "render/relight/relighter.h"
#include "video/files/film.h"

#include <filesystem>
#include <memory>
#include <string>

namespace ghost::app {

enum class OutputKind { png, exr, film };
Result<OutputKind> output_kind(const std::filesystem::path& path);

// A linear picture as .exr, or developed at this exposure, by this curve, as .png.
Result<void> write_picture(const std::filesystem::path& path, const image::ImageF& picture, float ev100,
                           image::Tone tone);

class PictureWriter {
public:
    // width, height: of the file. numbered: PNG and EXR become NAME-00000.png, NAME-00001.png, ...
    // supersample: the relighter's picture is that many times as large. One that is smaller is scaled
    // smoothly. sound: of a film; pictures have none. first_frame: the number of the first picture.
    static Result<std::unique_ptr<PictureWriter>> create(const std::filesystem::path& path, int width,
                                                         int height, int fps, bool numbered,
                                                         int supersample = 1, video::FilmSound sound = {},
                                                         long first_frame = 0);
    // caption: burnt into the picture, but not into EXR.
    Result<void> add(render::Relighter& relighter, const std::string& caption = {});
    // The last picture again, so often.
    Result<void> repeat(long times);
    Result<void> finish();
    // What was wrong with the sound of a film; empty: nothing.
    std::string sound_problem() const { return film_ ? film_->sound_problem() : std::string(); }
    // The files that were written: "a.png", "a-00000.png to a-00019.png".
    std::string written() const;
    // The first of them.
    std::filesystem::path first_path() const { return numbered_path(first_); }

private:
    PictureWriter() = default;
    std::filesystem::path next_path() { return numbered_path(count_++); }
    std::filesystem::path numbered_path(int number) const;

    std::filesystem::path path_;
    OutputKind kind_ = OutputKind::png;
    bool numbered_ = false;
    int supersample_ = 1;
    int width_ = 0, height_ = 0;
    int first_ = 0, count_ = 0; // numbers
    std::unique_ptr<video::FilmWriter> film_;
    image::Image8 last_frame_;        // of a film
    std::filesystem::path last_path_; // of a picture
};

} // namespace ghost::app
