// SPDX-License-Identifier: Apache-2.0
// What video/files offers, in a program without FFmpeg: films and sounds are refused in words.
#include "video/files/film.h"
#include "video/files/movie.h"
#include "video/files/sound_file.h"

namespace ghost::video {
namespace {

Error refusal(const std::filesystem::path& path) {
    return {"this program was made without FFmpeg and has neither films nor sounds", path.string()};
}

} // namespace

struct Movie::Decoder {};
struct FilmWriter::Encoder {};
struct SoundFile::Decoder {};

Result<std::unique_ptr<Movie>> Movie::open(const std::filesystem::path& path) {
    return refusal(path);
}
Movie::~Movie() = default;
double Movie::duration_s() const {
    return 0;
}
int Movie::width() const {
    return 0;
}
int Movie::height() const {
    return 0;
}
Result<std::optional<double>> Movie::next() {
    return std::optional<double>{};
}
Result<image::Image8> Movie::picture(Which, int, int) const {
    return refusal({});
}
Result<void> Movie::seek(double) {
    return refusal({});
}
double Movie::read_to_s() const {
    return 0;
}
int Movie::damaged() const {
    return 0;
}
bool Movie::drops_alpha() const {
    return false;
}
bool Movie::is_cut_short() const {
    return false;
}

Result<std::unique_ptr<FilmWriter>> FilmWriter::create(const std::filesystem::path& path, int, int, int,
                                                       FilmSound, long) {
    return refusal(path);
}
FilmWriter::~FilmWriter() = default;
Result<void> FilmWriter::add(const std::uint8_t*) {
    return refusal({});
}
Result<void> FilmWriter::finish() {
    return refusal({});
}
int FilmWriter::frames() const {
    return 0;
}
std::string FilmWriter::sound_problem() const {
    return {};
}

Result<std::unique_ptr<SoundFile>> SoundFile::open(const std::filesystem::path& path) {
    return refusal(path);
}
SoundFile::~SoundFile() = default;
std::size_t SoundFile::read(float*, std::size_t) {
    return 0;
}
void SoundFile::skip(double) {}
std::string SoundFile::problem() const {
    return {};
}

} // namespace ghost::video
