#pragma once
// SPDX-License-Identifier: Apache-2.0
// FilmFile: an MP4 that is being written, of encoded pictures and a sound. It appears under its name only
// when finish() succeeds. Errors name the film. One thread.

#include "base/result.h"
#include "video/files/film.h"
#include "video/files/private/film_sound.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

struct AVCodecContext;
struct AVFormatContext;
struct AVPacket;
struct AVStream;

namespace ghost::video {

// Whoever has it frees it. The same bytes every time, on any machine with this encoder.
Result<AVCodecContext*> open_film_encoder(const std::filesystem::path& film, int width, int height, int fps);

class FilmFile {
public:
    // encoder: what the pictures come from. described: its own words for that (extradata), or those of
    // another file whose packets are copied.
    static Result<std::unique_ptr<FilmFile>> create(const std::filesystem::path& path,
                                                    const AVCodecContext& encoder,
                                                    std::span<const std::uint8_t> described, FilmSound sound);
    ~FilmFile(); // without finish(): nothing is left behind
    FilmFile(const FilmFile&) = delete;
    FilmFile& operator=(const FilmFile&) = delete;

    // The next in the order of sending, shown at its pts, in frames. Takes what is in it.
    Result<void> write(AVPacket& packet);
    // The sound of so many frames.
    Result<void> write_sound(long frames);
    Result<void> finish(long frames);
    // What was wrong with the sound so far; empty: nothing.
    std::string sound_problem() const { return sound_ ? sound_->problem() : std::string(); }

private:
    FilmFile() = default;
    Result<void> open(const AVCodecContext& encoder, std::span<const std::uint8_t> described,
                      FilmSound sound);

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    AVFormatContext* file_ = nullptr;
    AVStream* stream_ = nullptr;
    std::unique_ptr<FilmSoundTrack> sound_; // null: none
    int fps_ = 0;
    int delay_ = 0; // pictures that may be sent before one that is shown earlier
    long written_ = 0;
    bool finished_ = false;
};

} // namespace ghost::video
