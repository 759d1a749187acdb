#pragma once
// SPDX-License-Identifier: Apache-2.0
// Movie: the pictures of a film file in their order, by FFmpeg. Only files are opened: a playlist that names
// an address is refused. Errors name the file and what FFmpeg said. One thread at a time.

#include "base/result.h"
#include "image/image.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace ghost::video {

inline constexpr int kMostMoviePixels = 8192 * 8192;

class Movie {
public:
    // Error: no such file, no film in it, a codec that this FFmpeg has not, nothing to show.
    static Result<std::unique_ptr<Movie>> open(const std::filesystem::path& path);
    ~Movie();
    Movie(const Movie&) = delete;
    Movie& operator=(const Movie&) = delete;

    double duration_s() const; // of the pictures, above 0
    int width() const; // as shown: pixels that are not square are counted, and turned as the file says
    int height() const;

    // Decodes the next picture: seconds from the film's first picture at which it is shown. Nothing: the film
    // is at its end. What cannot be decoded is left out and counted. Error: the file cannot be read further.
    Result<std::optional<double>> next();
    // The picture that next() found last, or the one before it, as sRGB of this size.
    enum class Which { newest, before };
    Result<image::Image8> picture(Which which, int width_px, int height_px) const;
    // The next picture is one at this moment or before.
    Result<void> seek(double at_s);
    double read_to_s() const;  // when the last picture of those read so far ends, as far as the file says so
    int damaged() const;       // packets that could not be decoded
    bool drops_alpha() const;  // it has an alpha channel that this FFmpeg cannot decode
    bool is_cut_short() const; // its index names pictures beyond the end of the file

private:
    struct Decoder;
    explicit Movie(std::unique_ptr<Decoder> decoder);
    std::unique_ptr<Decoder> decoder_;
};

} // namespace ghost::video
