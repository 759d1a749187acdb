// SPDX-License-Identifier: Apache-2.0
#include "dmx/recording.h"

#include "base/files.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace ghost::dmx {

namespace {

constexpr std::string_view kHeader = "OLA Show";
constexpr std::size_t kMaxProblems = 100;
constexpr std::size_t kMaxRecordedUniverses = 4096;
constexpr std::int64_t kMaxDelayMs = 24ll * 3600 * 1000;
constexpr std::int64_t kMaxDurationMs = 7 * kMaxDelayMs;

// Digits only, from 0 to limit.
std::optional<std::int64_t> number(std::string_view text, std::int64_t limit) {
    std::int64_t value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failed != std::errc() || end != text.data() + text.size() || value < 0 || value > limit)
        return std::nullopt;
    return value;
}

class Parser {
public:
    Parser(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    Result<Recording> parse() {
        const std::string_view header = next_line();
        if (header != kHeader || !ended_)
            return Error{"this is no OLA show file, expected the line \"OLA Show\"", place()};
        while (!rest_.empty()) {
            const std::string_view line = next_line();
            if (line.empty()) continue;
            if (!ended_) {
                problem("the last line is cut off and left out");
                break;
            }
            if (line.find(' ') == std::string_view::npos)
                delay(line);
            else
                TRY_VOID(frame(line));
        }
        if (recording_.frames.empty()) return Error{"no frame, expected lines like \"1 255,0,128\"", place()};
        recording_.duration = time_;
        if (problems_ > kMaxProblems)
            recording_.problems.push_back(
                {std::to_string(problems_ - kMaxProblems) + " more lines left out", name_});
        return std::move(recording_);
    }

private:
    std::string place() const { return name_ + ":" + std::to_string(line_); }

    void problem(const std::string& what) {
        if (problems_++ < kMaxProblems) recording_.problems.push_back({what, place()});
    }

    std::string_view next_line() {
        const std::size_t end = rest_.find('\n');
        ended_ = end != std::string_view::npos;
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(ended_ ? end + 1 : rest_.size());
        ++line_;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        return line;
    }

    void delay(std::string_view line) {
        const auto ms = number(line, kMaxDelayMs);
        if (!ms || time_.count() + *ms > kMaxDurationMs)
            problem("expected \"<universe> <levels>\" or a pause in milliseconds of at most a day (a week in "
                    "all)");
        else
            time_ += std::chrono::milliseconds(*ms);
    }

    Result<void> frame(std::string_view line) {
        const std::size_t space = line.find(' ');
        const auto universe = number(line.substr(0, space), kMaxUniverse);
        if (!universe || *universe < 1) {
            problem("universe '" + std::string(line.substr(0, std::min<std::size_t>(space, 20))) +
                    "', expected 1 to " + std::to_string(kMaxUniverse));
            return {};
        }
        Levels levels{};
        std::size_t count = 0;
        for (std::string_view left = line.substr(space + 1);; ++count) {
            const std::size_t comma = left.find(',');
            const std::string_view text = left.substr(0, comma);
            const auto level = text.empty() ? std::optional<std::int64_t>(0) : number(text, 255);
            if (!level) {
                problem("level '" + std::string(text.substr(0, 20)) + "' of slot " +
                        std::to_string(count + 1) + ", expected 0 to 255");
                return {};
            }
            if (count < kSlots) levels[count] = static_cast<std::uint8_t>(*level);
            if (comma == std::string_view::npos) break;
            left.remove_prefix(comma + 1);
        }
        ++count;
        if (count > kSlots) {
            problem(std::to_string(count) + " levels, expected at most 512; the first 512 are used");
            count = kSlots;
        }
        if (recording_.frames.size() == kMaxRecordingFrames)
            return Error{"more than " + std::to_string(kMaxRecordingFrames) + " frames", place()};
        auto& newest = newest_[static_cast<std::uint16_t>(*universe)];
        if (newest_.size() > kMaxRecordedUniverses)
            return Error{"more than " + std::to_string(kMaxRecordedUniverses) + " universes", place()};
        if (!newest || *newest != levels) newest = std::make_shared<const Levels>(levels);
        recording_.frames.push_back(
            {time_, static_cast<std::uint16_t>(*universe), static_cast<std::uint16_t>(count), newest});
        return {};
    }

    std::string_view rest_;
    const std::string& name_;
    std::size_t line_ = 0;
    bool ended_ = true; // the line that was read last had its line end
    std::chrono::milliseconds time_{0};
    std::map<std::uint16_t, std::shared_ptr<const Levels>> newest_;
    std::size_t problems_ = 0;
    Recording recording_;
};

} // namespace

Result<Recording> parse_recording(std::string_view text, const std::string& name) {
    return Parser(text, name).parse();
}

Result<Recording> read_recording(const std::filesystem::path& path) {
    TRY(const std::string text, read_text_file(path, kMaxRecordingBytes));
    return parse_recording(text, path.string());
}

Player::Player(Recording recording) : recording_(std::move(recording)) {
    for (std::size_t i = 0; i < recording_.frames.size(); ++i) {
        const RecordedFrame& frame = recording_.frames[i];
        auto& steps = by_universe_[frame.universe];
        const bool same = !steps.empty() && recording_.frames[steps.back().frame].levels == frame.levels;
        steps.push_back({frame.time, i, same ? steps.back().revision : i + 1});
    }
}

double Player::duration_s() const {
    return std::chrono::duration<double>(recording_.duration).count();
}

Universes Player::at(double t_s) const {
    // Compared in seconds: a frame stamped 40 ms is on at t = 0.04 whatever way that was computed.
    constexpr double kRounding_s = 1e-6;
    Universes result;
    for (const auto& [number, steps] : by_universe_) {
        const auto later = [&](double t, const Step& step) {
            return t < std::chrono::duration<double>(step.time).count() - kRounding_s;
        };
        auto after = std::upper_bound(steps.begin(), steps.end(), std::max(t_s, 0.0), later);
        if (after == steps.begin()) continue;
        const Step& step = *--after;
        Universe universe;
        universe.number = number;
        universe.levels = recording_.frames[step.frame].levels;
        universe.arrival = step.time;
        universe.revision = step.revision;
        result.revision = std::max(result.revision, step.revision);
        result.list.push_back(std::move(universe));
    }
    return result;
}

} // namespace ghost::dmx
