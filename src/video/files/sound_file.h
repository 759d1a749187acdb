#pragma once
// SPDX-License-Identifier: Apache-2.0
// SoundFile: the sound of a file (WAV, FLAC, MP3, AAC, or that of a film) as stereo of 48,000 samples a
// second, by FFmpeg. Its second 0 is the file's. Only files are opened: a playlist that names an address is
// refused. What cannot be decoded is silent, and said once at the end. Errors name the file. One thread at a
// time.

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace ghost::video {

inline constexpr int kSoundRate_hz = 48'000;
inline constexpr int kMostSoundChannels = 64;
inline constexpr int kMostSoundRate_hz = 768'000; // of the file
inline constexpr double kLongestSound_s = 86'400;

class SoundFile {
public:
    // Error: no such file, no sound in it, a codec that this FFmpeg has not, more than the limits above.
    static Result<std::unique_ptr<SoundFile>> open(const std::filesystem::path& path);
    ~SoundFile();
    SoundFile(const SoundFile&) = delete;
    SoundFile& operator=(const SoundFile&) = delete;

    // Samples (left, right) from where the last call ended, at most so many; fewer: that is the end.
    std::size_t read(float* pairs, std::size_t count);
    // Leaves out so much of what comes next, to the sample.
    void skip(double seconds);
    // What was wrong with what was read so far; empty: nothing.
    std::string problem() const;

private:
    struct Decoder;
    explicit SoundFile(std::unique_ptr<Decoder> decoder);
    std::unique_ptr<Decoder> decoder_;
};

} // namespace ghost::video
