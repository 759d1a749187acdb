// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/ltc_input.h"

#include "base/log.h"
#include "sound/sound_input.h"
#include "video/files/sound_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kLookEvery = 1s;
constexpr auto kNap = 20ms;
constexpr std::size_t kPiece = sound::kInputRate_hz / 100;
static_assert(sound::kInputRate_hz == video::kSoundRate_hz);

std::int16_t loudest(std::span<const std::int16_t> samples) {
    int most = 0;
    for (const std::int16_t sample : samples) most = std::max(most, std::abs(int{sample}));
    return static_cast<std::int16_t>(std::min(most, 32767));
}

} // namespace

LtcInput::LtcInput(std::string name, Take take) : name_(std::move(name)), take_(std::move(take)) {
    status_.name = name_;
    thread_ = std::thread([this] { run(); });
}

LtcInput::~LtcInput() {
    stop_ = true;
    thread_.join();
}

LtcStatus LtcInput::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

void LtcInput::run() {
    std::error_code code;
    const bool is_file = std::filesystem::exists(name_, code);
    while (!stop_) {
        const Result<void> ended = is_file ? play_file() : listen();
        bool is_new = false;
        {
            const std::lock_guard lock(mutex_);
            status_.open = false;
            const std::string problem = ended.ok() ? "" : ended.error().what;
            is_new = problem != std::exchange(status_.problem, problem);
        }
        if (!ended.ok() && is_new) log_warning(ended.error().text() + "; it is looked for once a second");
        if (ended.ok()) return;
        for (const auto until = Clock::now() + kLookEvery; Clock::now() < until && !stop_;)
            std::this_thread::sleep_for(kNap);
    }
}

void LtcInput::opened() {
    const std::lock_guard lock(mutex_);
    status_.open = true;
    status_.problem.clear();
    ++status_.openings;
}

void LtcInput::feed(std::span<const std::int16_t> samples, int channels, std::chrono::nanoseconds end,
                    std::array<sound::LtcDecoder, 2>& decoders) {
    std::vector<std::int16_t> one;
    bool is_found = false; // both may have it
    for (int channel = 0; channel < channels; ++channel) {
        one.clear();
        for (std::size_t k = static_cast<std::size_t>(channel); k < samples.size();
             k += static_cast<std::size_t>(channels))
            one.push_back(samples[k]);
        sound::LtcDecoder& decoder = decoders[static_cast<std::size_t>(channel)];
        std::vector<std::pair<dmx::TimeCode, std::chrono::nanoseconds>> times;
        decoder.feed(one, end, [&](const dmx::TimeCode& time, std::chrono::nanoseconds at) {
            times.emplace_back(time, at);
        });
        if (times.empty() || is_found) continue;
        is_found = true;
        for (const auto& [time, at] : times) take_(time, at);
        const std::lock_guard lock(mutex_);
        status_.channel = channel + 1;
        status_.counters = decoder.counters();
        status_.time = times.back().first;
        status_.arrival = times.back().second;
    }
    const double level_dbfs = 20 * std::log10(std::max<double>(loudest(samples), 0.33) / 32768);
    const std::lock_guard lock(mutex_);
    status_.loudest_dbfs = level_dbfs;
}

// Error: it cannot be opened, or was pulled out.
Result<void> LtcInput::listen() {
    TRY(const auto input, sound::SoundInput::open(name_));
    opened();
    std::array<sound::LtcDecoder, 2> decoders{sound::LtcDecoder(sound::kInputRate_hz),
                                              sound::LtcDecoder(sound::kInputRate_hz)};
    while (!stop_) {
        const auto heard = input->take();
        if (!heard) return Error{"was pulled out", name_};
        if (!heard->samples.empty()) feed(heard->samples, input->channels(), heard->end, decoders);
    }
    return {};
}

Result<void> LtcInput::play_file() {
    TRY(const auto file, video::SoundFile::open(name_));
    opened();
    std::array<sound::LtcDecoder, 2> decoders{sound::LtcDecoder(sound::kInputRate_hz),
                                              sound::LtcDecoder(sound::kInputRate_hz)};
    std::vector<float> pairs(2 * kPiece);
    std::vector<std::int16_t> samples;
    auto heard = Clock::now();
    while (!stop_) {
        const std::size_t count = file->read(pairs.data(), kPiece);
        if (count == 0) break;
        heard += std::chrono::nanoseconds(std::int64_t{1'000'000'000} * static_cast<std::int64_t>(count) /
                                          sound::kInputRate_hz);
        std::this_thread::sleep_until(heard);
        samples.resize(2 * count);
        std::transform(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(2 * count), samples.begin(),
                       [](float value) { return static_cast<std::int16_t>(std::lround(value * 32767)); });
        feed(samples, 2, heard.time_since_epoch(), decoders);
    }
    if (const std::string problem = file->problem(); !problem.empty()) log_warning(name_ + ": " + problem);
    return {};
}

} // namespace ghost::app
