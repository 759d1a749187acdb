#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sounds that tests make: WAV files, byte by byte.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace ghost::video {

inline std::string little(std::uint32_t value, int bytes) {
    std::string text;
    for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xFF);
    return text;
}

// samples: of all channels in turn. As 32-bit floats.
inline std::string wav(const std::vector<float>& samples, int rate_hz, int channels) {
    std::string data(samples.size() * 4, '\0');
    std::copy_n(reinterpret_cast<const char*>(samples.data()), data.size(), data.begin());
    const auto size = static_cast<std::uint32_t>(data.size());
    const auto rate = static_cast<std::uint32_t>(rate_hz), wide = static_cast<std::uint32_t>(channels);
    return "RIFF" + little(36 + size, 4) + "WAVEfmt " + little(16, 4) + little(3, 2) + little(wide, 2) +
           little(rate, 4) + little(rate * wide * 4, 4) + little(wide * 4, 2) + little(32, 2) + "data" +
           little(size, 4) + data;
}

inline std::filesystem::path write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

// Silence, but for 20 ms of a loud tone from clap_s on.
inline std::vector<float> clap(double clap_s, double length_s, int rate_hz, int channels) {
    std::vector<float> samples(static_cast<std::size_t>(std::lround(length_s * rate_hz)) *
                               static_cast<std::size_t>(channels));
    const auto from = static_cast<std::size_t>(std::lround(clap_s * rate_hz));
    for (std::size_t k = 0; k < static_cast<std::size_t>(rate_hz / 50); ++k)
        for (int channel = 0; channel < channels; ++channel)
            samples.at((from + k) * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel)) =
                static_cast<float>(0.8 * std::cos(2 * M_PI * 1000 * static_cast<double>(k) / rate_hz));
    return samples;
}

// Pair from which on it is loud; -1: nowhere.
inline std::ptrdiff_t loud_from(const std::vector<float>& pairs) {
    const auto at =
        std::find_if(pairs.begin(), pairs.end(), [](float value) { return std::abs(value) > 0.25f; });
    return at == pairs.end() ? -1 : (at - pairs.begin()) / 2;
}

} // namespace ghost::video
