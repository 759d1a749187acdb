// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/ola_show.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

namespace ghost::dmx {

namespace {

constexpr std::string_view kHeader = "OLA Show";
constexpr std::size_t kMaxProblems = 100;
constexpr std::int64_t kMaxDelayMs = 24ll * 3600 * 1000;
constexpr std::int64_t kMaxDurationMs =
    std::chrono::floor<std::chrono::milliseconds>(kLongestRecording).count();

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
    Parser(std::string_view text, const std::string& name, const FrameSink& sink)
        : rest_(text), name_(name), sink_(sink) {}

    Result<OlaShowEnd> parse() {
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
        if (newest_.empty()) return Error{"no frame, expected lines like \"1 255,0,128\"", place()};
        end_.duration = time_;
        if (problems_ > kMaxProblems)
            end_.problems.push_back(
                {std::to_string(problems_ - kMaxProblems) + " more lines left out", name_});
        return std::move(end_);
    }

private:
    std::string place() const { return name_ + ":" + std::to_string(line_); }

    void problem(const std::string& what) {
        if (problems_++ < kMaxProblems) end_.problems.push_back({what, place()});
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
            problem("expected \"<universe> <levels>\" or a pause in milliseconds of at most a day (a year in "
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
        auto& newest = newest_[static_cast<std::uint16_t>(*universe)];
        if (newest_.size() > kMaxRecordedUniverses)
            return Error{"more than " + std::to_string(kMaxRecordedUniverses) + " universes", place()};
        if (!newest || *newest != levels) newest = std::make_shared<const Levels>(levels);
        return sink_(
            {time_, static_cast<std::uint16_t>(*universe), static_cast<std::uint16_t>(count), false, newest});
    }

    std::string_view rest_;
    const std::string& name_;
    const FrameSink& sink_;
    std::size_t line_ = 0;
    bool ended_ = true; // the line that was read last had its line end
    std::chrono::milliseconds time_{0};
    std::map<std::uint16_t, std::shared_ptr<const Levels>> newest_;
    std::size_t problems_ = 0;
    OlaShowEnd end_;
};

} // namespace

Result<OlaShowEnd> read_ola_show(std::string_view text, const std::string& name, const FrameSink& sink) {
    return Parser(text, name, sink).parse();
}

bool is_ola_show(Bytes first_bytes) {
    return first_bytes.size() >= kHeader.size() &&
           std::equal(kHeader.begin(), kHeader.end(), first_bytes.begin());
}

Result<void> OlaShowWriter::put(std::string_view text) {
    return sink_(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string OlaShowWriter::pause_to(std::chrono::milliseconds time) {
    std::string lines;
    for (; (time - time_).count() > kMaxDelayMs; time_ += std::chrono::milliseconds(kMaxDelayMs))
        lines += std::to_string(kMaxDelayMs) + "\n";
    lines += std::to_string((time - time_).count()) + "\n";
    time_ = time;
    return lines;
}

Result<void> OlaShowWriter::append(const RecordedFrame& frame) {
    const auto time = std::chrono::floor<std::chrono::milliseconds>(frame.time);
    std::string line = any_ ? "" : std::string(kHeader) + "\n";
    if (any_ || time.count() > 0) line += pause_to(time);
    any_ = true;
    line += std::to_string(frame.universe);
    for (std::size_t i = 0; i < std::max<std::size_t>(frame.slot_count, 1); ++i)
        line += (i == 0 ? " " : ",") + std::to_string(static_cast<int>((*frame.levels)[i]));
    return put(line + "\n");
}

Result<void> OlaShowWriter::flush(std::chrono::microseconds) {
    return {}; // every line was handed on whole
}

Result<void> OlaShowWriter::finish(std::chrono::microseconds duration) {
    const auto time = std::chrono::floor<std::chrono::milliseconds>(duration);
    return put(any_ ? pause_to(time) : std::string(kHeader) + "\n");
}

} // namespace ghost::dmx
