#pragma once
// SPDX-License-Identifier: Apache-2.0
// FilmSoundTrack: the sound of a film that is being written, as AAC, as far as its pictures go; where the
// file has none it is silent. Seconds of the film. Errors name the film. One thread.

#include "base/result.h"
#include "video/files/film.h"

#include <cstdint>
#include <filesystem>
#include <memory>

struct AVFormatContext;

namespace ghost::video {

class FilmSoundTrack {
public:
    // Adds its stream to the file, whose header is not written yet; film is for errors.
    static Result<std::unique_ptr<FilmSoundTrack>> create(FilmSound sound, AVFormatContext* file,
                                                          const std::filesystem::path& film);
    ~FilmSoundTrack();
    FilmSoundTrack(const FilmSoundTrack&) = delete;
    FilmSoundTrack& operator=(const FilmSoundTrack&) = delete;

    // Writes what sounds before this moment, but for less than a packet.
    Result<void> write_to(double film_s);
    // And the rest: the film is so long.
    Result<void> finish(double film_s);
    std::string problem() const;

private:
    struct Encoder;
    explicit FilmSoundTrack(std::unique_ptr<Encoder> encoder);
    std::unique_ptr<Encoder> encoder_;
};

} // namespace ghost::video
