// SPDX-License-Identifier: Apache-2.0
#include "live/engine/show_sound.h"

#include "sound/sound_output.h"
#include "video/files/sound_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kPiece = sound::kOutputRate_hz / 100;
constexpr auto kLookEvery = 1s;
constexpr auto kNap = 10ms;
constexpr auto kStale = 500ms; // no frame for so long: the window stands still
constexpr double kLeastSpeed = 0.8, kMostSpeed = 1.25;
constexpr double kJump_s = 0.04;   // further from where it should be it begins anew there
constexpr double kClose_s = 0.001; // nearer is near enough
constexpr double kSmooth = 0.05;   // of what is measured in each piece
constexpr std::size_t kFade = 240; // pairs, so that nothing clicks
static_assert(sound::kOutputRate_hz == video::kSoundRate_hz);

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

void fade(std::vector<float>& pairs, bool in) {
    for (std::size_t k = 0; k < std::min(kFade, pairs.size() / 2); ++k) {
        const float share = static_cast<float>(in ? k : kFade - k) / static_cast<float>(kFade);
        pairs[2 * k] *= share;
        pairs[2 * k + 1] *= share;
    }
    if (!in)
        std::fill(pairs.begin() + static_cast<std::ptrdiff_t>(std::min(2 * kFade, pairs.size())), pairs.end(),
                  0.0f);
}

// A sound that is read from any place of it. Back it is read anew from its beginning.
class Reader {
public:
    explicit Reader(std::filesystem::path path) : path_(std::move(path)) {}

    Result<void> go_to(double at_s) {
        const auto pair = static_cast<std::int64_t>(std::llround(at_s * sound::kOutputRate_hz));
        if (!file_ || pair < next_) {
            TRY(file_, video::SoundFile::open(path_));
            next_ = std::min<std::int64_t>(pair, 0); // before it begins it is silent
        }
        if (pair > next_) {
            const std::int64_t silent = std::clamp<std::int64_t>(-next_, 0, pair - next_);
            file_->skip(static_cast<double>(pair - next_ - silent) / sound::kOutputRate_hz);
        }
        next_ = pair;
        return {};
    }
    void read(std::vector<float>& pairs) {
        const auto count = static_cast<std::int64_t>(pairs.size() / 2);
        const auto silent = std::clamp<std::int64_t>(-next_, 0, count);
        std::fill(pairs.begin(), pairs.end(), 0.0f);
        file_->read(pairs.data() + 2 * silent, static_cast<std::size_t>(count - silent));
        next_ += count;
    }
    double at_s() const { return static_cast<double>(next_) / sound::kOutputRate_hz; }

private:
    std::filesystem::path path_;
    std::unique_ptr<video::SoundFile> file_;
    std::int64_t next_ = 0; // pair
};

} // namespace

ShowSound::~ShowSound() {
    end();
}

void ShowSound::end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    stop_ = false;
}

void ShowSound::use(const scene::Sound& sound) {
    if (sound.file == sound_.file && sound.offset_s == sound_.offset_s) return;
    end();
    sound_ = sound;
    if (output_.empty() || sound_.file.empty()) return;
    thread_ = std::thread([this] { run(); });
}

void ShowSound::follow(double recording_s, std::chrono::nanoseconds now) {
    const std::lock_guard lock(mutex_);
    const double passed_s = seconds(now - place_.at);
    const double speed = passed_s > 0 ? (recording_s - place_.recording_s) / passed_s : 0;
    const bool runs = now - place_.at < kStale && speed > kLeastSpeed && speed < kMostSpeed;
    place_ = {recording_s, now, runs};
}

std::vector<std::string> ShowSound::take_messages() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

void ShowSound::say(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(sentence);
}

// Second of the sound that is to be heard then; nothing: silence.
std::optional<double> ShowSound::wanted_s(std::chrono::nanoseconds moment) const {
    const std::lock_guard lock(mutex_);
    if (!place_.runs || Clock::now().time_since_epoch() - place_.at > kStale) return std::nullopt;
    return place_.recording_s + seconds(moment - place_.at) - sound_.offset_s;
}

void ShowSound::run() {
    std::string said;
    while (!stop_) {
        auto output = sound::SoundOutput::open(output_);
        if (output.ok()) said.clear();
        const Result<void> ended = output.ok() ? play(**output) : Result<void>(output.error());
        if (ended.ok()) return;
        if (std::exchange(said, ended.error().text()) != ended.error().text())
            say(ended.error().text() + "; the show's sound is not heard");
        for (const auto until = Clock::now() + kLookEvery; Clock::now() < until && !stop_;)
            std::this_thread::sleep_for(kNap);
    }
}

// Error: the sound cannot be read, or the output is gone.
Result<void> ShowSound::play(sound::SoundOutput& output) {
    Reader reader(sound_.file);
    TRY_VOID(reader.go_to(0));
    std::vector<float> pairs(2 * kPiece);
    bool sounds = false;
    double late_s = 0; // smoothed: how far it is behind
    while (!stop_) {
        const auto delay = output.delay();
        if (!delay) return Error{"is gone", output_};
        const auto wanted = wanted_s(Clock::now().time_since_epoch() + *delay);
        const double off_s = wanted ? *wanted - reader.at_s() : 0;
        const bool jumps = wanted && (!sounds || std::abs(off_s) > kJump_s);
        pairs.assign(2 * kPiece, 0.0f);
        if (sounds && (jumps || !wanted)) {
            reader.read(pairs);
            fade(pairs, false);
            sounds = false;
        } else if (jumps) {
            TRY_VOID(reader.go_to(*wanted));
            // Reading up to there took its time.
            const auto then = wanted_s(Clock::now().time_since_epoch() + output.delay().value_or(0ns));
            if (then && *then - reader.at_s() < kJump_s) {
                TRY_VOID(reader.go_to(std::max(*then, reader.at_s())));
                reader.read(pairs);
                fade(pairs, true);
                sounds = true;
                late_s = 0;
            }
        } else if (wanted) {
            late_s += kSmooth * (off_s - late_s);
            // One pair more or less in each piece is not heard.
            const bool is_ahead = late_s < -kClose_s;
            if (is_ahead) pairs.resize(pairs.size() - 2);
            reader.read(pairs);
            if (is_ahead) {
                const float left = pairs[pairs.size() - 2], right = pairs.back();
                pairs.insert(pairs.end(), {left, right});
            }
            if (late_s > kClose_s) TRY_VOID(reader.go_to(reader.at_s() + 1.0 / sound::kOutputRate_hz));
        }
        if (!output.put(pairs.data(), pairs.size() / 2)) return Error{"is gone", output_};
    }
    return {};
}

} // namespace ghost::app
