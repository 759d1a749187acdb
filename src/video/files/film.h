#pragma once
// SPDX-License-Identifier: Apache-2.0
// FilmWriter: pictures into an MP4 (H.264, 4:2:0, Rec.709; MPEG-4 where the FFmpeg at hand has no H.264
// encoder), with sound (AAC) where there is some, as long as the pictures. It is encoded in blocks that know
// nothing of each other: films of whole blocks make, joined, the bytes of one that was written at once. A
// film appears under its name only when finish() or join_films succeeds. One thread.

#include "base/result.h"
#include "video/files/sound_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ghost::video {

// A block begins at each frame that this divides; frames are numbered in the film that a part is of.
inline constexpr long kFilmBlockFrames = 240;

struct FilmSound {
    std::unique_ptr<SoundFile> file; // null: the film has none
    double begin_s = 0; // second of the sound at the film's first picture; below 0: it comes later
};

// What encodes films here, with its version: another one makes other bytes.
std::string film_encoder();

class FilmWriter {
public:
    // Sizes are cut to even numbers, as 4:2:0 asks. first_frame: the number of the first picture. Error: no
    // encoder, or the file cannot be created.
    static Result<std::unique_ptr<FilmWriter>> create(const std::filesystem::path& path, int width,
                                                      int height, int fps, FilmSound sound = {},
                                                      long first_frame = 0);
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

// A film that FilmWriter made without sound; but for the first, it begins where a block does.
struct FilmPart {
    std::filesystem::path path;
    long frames = 0;
};
// What was wrong with the sound; empty: nothing. Error: names the part that is none, has other frames than
// these, or is not of the same size and encoder as the first.
Result<std::string> join_films(const std::filesystem::path& path, const std::vector<FilmPart>& parts, int fps,
                               FilmSound sound = {});

} // namespace ghost::video
