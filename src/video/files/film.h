#pragma once
// SPDX-License-Identifier: Apache-2.0
// FilmWriter: pictures into an MP4 (H.264, 4:2:0, Rec.709; MPEG-4 where the FFmpeg at hand has no H.264
// encoder), with sound (AAC) where there is some, as long as the pictures. The film appears under its name
// only when finish() succeeds. One thread.

#include "base/result.h"
#include "video/files/sound_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace ghost::video {

struct FilmSound {
    std::unique_ptr<SoundFile> file; // null: the film has none
    double begin_s = 0; // second of the sound at the film's first picture; below 0: it comes later
};

class FilmWriter {
public:
    // Sizes are cut to even numbers, as 4:2:0 asks. Error: no encoder, or the file cannot be created.
    static Result<std::unique_ptr<FilmWriter>> create(const std::filesystem::path& path, int width,
                                                      int height, int fps, FilmSound sound = {});
    ~FilmWriter(); // without finish(): nothing is left behind
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    // rgba: width * height * 4 bytes of the size given to create, sRGB, top row first.
    Result<void> add(const std::uint8_t* rgba);
    Result<void> finish();
    int frames() const;
    // What was wrong with the sound so far; empty: nothing.
    std::string sound_problem() const;

private:
    struct Encoder;
    explicit FilmWriter(std::unique_ptr<Encoder> encoder);
    std::unique_ptr<Encoder> encoder_;
};

} // namespace ghost::video
