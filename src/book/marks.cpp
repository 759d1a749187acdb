// SPDX-License-Identifier: Apache-2.0
#include "book/marks.h"

#include "base/text.h"
#include "book/book.h"
#include "dmx/wire/timecode.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace ghost::scene {
namespace {

constexpr double kLatestMark_s = 366.0 * 86400.0;
constexpr std::size_t kMostCells = 64;
constexpr std::size_t kMostColumns = 4; // that are read
constexpr double kDropFramesPer_s = 30;
constexpr std::size_t kMostLetters = 1000; // of a cell, as of a text of show.toml

struct CsvRow {
    std::size_t line = 1; // of the file
    std::vector<std::string> cells;
};

// "00:01:23;12", with what follows it.
bool begins_with_drop_frame(std::string_view line) {
    const std::size_t end = line.find_first_not_of("0123456789:");
    const std::string_view time = line.substr(0, end);
    return end != std::string_view::npos && line[end] == ';' &&
           std::count(time.begin(), time.end(), ':') == 2;
}

bool looks_like_time(std::string_view cell) {
    cell = trimmed(cell);
    return !cell.empty() && cell.front() >= '0' && cell.front() <= '9' &&
           cell.find_first_not_of("0123456789:.,") == std::string_view::npos;
}

// Of the first line that has a time before it; where none has, of the first that has one at all, outside of
// quotes and of time code: a spreadsheet whose decimals have commas writes ';'.
char separator_of(std::string_view text) {
    for (const std::string_view whole : split(text, '\n')) {
        std::string_view line = trimmed(whole);
        if (begins_with_drop_frame(line)) line.remove_prefix(line.find(';') + 1);
        for (const char separator : {';', '\t', ','})
            if (const std::size_t end = line.find(separator);
                end != std::string_view::npos && looks_like_time(line.substr(0, end)))
                return separator;
    }
    for (const std::string_view whole : split(text, '\n')) {
        std::string_view line = trimmed(whole);
        if (line.starts_with('#')) continue;
        if (begins_with_drop_frame(line)) line.remove_prefix(line.find(';') + 1);
        std::string bare;
        bool is_quoted = false;
        for (const char letter : line) {
            is_quoted = is_quoted != (letter == '"');
            if (!is_quoted) bare += letter;
        }
        for (const char separator : {';', '\t', ','})
            if (bare.find(separator) != std::string::npos) return separator;
    }
    return ',';
}

std::vector<CsvRow> csv_rows(std::string_view text, char separator) {
    std::vector<CsvRow> rows;
    CsvRow row;
    std::string cell;
    bool is_quoted = false;
    std::size_t line = 1;
    const auto end_cell = [&] {
        if (row.cells.size() < kMostCells) row.cells.push_back(std::move(cell));
        cell.clear();
    };
    const auto end_row = [&] {
        end_cell();
        rows.push_back(std::move(row));
        row = {line + 1, {}};
    };
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char letter = text[k];
        if (letter == '"' && is_quoted && k + 1 < text.size() && text[k + 1] == '"')
            cell += text[++k];
        else if (letter == '"')
            is_quoted = !is_quoted;
        else if (!is_quoted && letter == separator)
            end_cell();
        else if (!is_quoted && letter == '\n')
            end_row();
        else if (letter != '\r' && cell.size() < kMostLetters)
            cell += letter;
        if (letter == '\n') ++line;
    }
    if (!cell.empty() || !row.cells.empty()) end_row();
    return rows;
}

std::optional<double> number_from(std::string_view text) {
    double value = 0;
    const auto read =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    const bool is_whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
    return is_whole && value >= 0 && value <= kLatestMark_s ? std::optional(value) : std::nullopt;
}

// "00:01:23;12", which keeps to the clock at 29.97 frames, as live time code counts (dmx/wire/timecode.h);
// numbers that drop frame leaves out are no time.
std::optional<double> drop_frame_seconds(std::string text) {
    text[text.find(';')] = ':';
    const std::vector<std::string_view> parts = split(text, ':');
    dmx::TimeCode time;
    time.rate = dmx::TimeCode::Rate::drop_29_97;
    std::uint8_t* const fields[] = {&time.hours, &time.minutes, &time.seconds, &time.frames};
    if (parts.size() != std::size(fields)) return std::nullopt;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto part = number_from(parts[k]);
        if (!part || !(*part >= 0 && *part < 60) || *part != std::floor(*part)) return std::nullopt;
        *fields[k] = static_cast<std::uint8_t>(*part);
    }
    const bool is_left_out = time.frames < 2 && time.seconds == 0 && time.minutes % 10 != 0;
    if (!dmx::is_timecode(time) || is_left_out) return std::nullopt;
    return dmx::timecode_seconds(time);
}

// "83.5", "1:23.5", "0:01:23.5", "00:01:23:12".
std::optional<double> seconds_from(const std::string& text, double frames_per_s) {
    if (begins_with_drop_frame(text))
        return frames_per_s == kDropFramesPer_s ? drop_frame_seconds(text) : std::nullopt;
    const std::vector<std::string_view> parts = split(text, ':');
    if (parts.size() > 4) return std::nullopt;
    double total = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto part = number_from(parts[k]);
        const bool may_have_fraction = k + 1 == parts.size() && k < 3;
        if (!part || (!may_have_fraction && parts[k].find('.') != std::string_view::npos))
            return std::nullopt;
        if (k == 3)
            total = *part < frames_per_s ? total + *part / frames_per_s : -1;
        else if (k > 0 && *part >= 60)
            return std::nullopt;
        else
            total = 60 * total + *part;
    }
    return total >= 0 ? std::optional(total) : std::nullopt;
}

bool are_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// "83,5" in each line, and what would be the numbers of cues does not count on: somebody's decimals, perhaps.
bool may_be_decimals(const std::vector<CsvRow>& rows) {
    std::string before;
    bool counts_on = true;
    std::size_t count = 0;
    for (const CsvRow& row : rows) {
        const bool is_empty = row.cells.size() == 1 && trimmed(row.cells[0]).empty();
        if (is_empty || row.cells[0].starts_with('#')) continue;
        if (row.cells.size() == 1 && are_digits(row.cells[0])) continue; // 30 stands for 30,0
        if (row.cells.size() != 2 || !are_digits(row.cells[0]) || !are_digits(row.cells[1])) {
            if (row.line == 1) continue; // a heading
            return false;
        }
        const std::string& number = row.cells[1];
        if (count++ > 0 && std::pair(number.size(), number) <= std::pair(before.size(), before))
            counts_on = false;
        before = number;
    }
    return count == 1 || (count > 1 && !counts_on);
}

} // namespace

std::vector<Mark> read_marks(std::string_view csv, const std::string& file, double frames_per_s,
                             Report& report) {
    if (csv.starts_with("\xef\xbb\xbf")) csv.remove_prefix(3);
    if (csv.find('\0') != std::string_view::npos) {
        report.add(
            Severity::error, file,
            "is no text of UTF-8 (of UTF-16, as spreadsheets write it, perhaps): save it as CSV in UTF-8");
        return {};
    }
    // "sep=;", as spreadsheets write it.
    const bool is_told = csv.starts_with("sep=") && csv.size() > 4 &&
                         std::string_view(";\t,").find(csv[4]) != std::string_view::npos;
    const char separator = is_told ? csv[4] : separator_of(csv);
    const std::string parts_at = separator == '\t' ? "a tab" : std::string("a '") + separator + "'";
    std::vector<Mark> marks;
    std::size_t most_cells = kMostColumns;
    bool is_first = true;
    const std::vector<CsvRow> rows = csv_rows(csv, separator);
    if (separator == ',' && may_be_decimals(rows))
        report.add(
            Severity::warning, file,
            "each line is read as a time in whole seconds and a number; if it is one time with a decimal "
            "comma, write a point or put ';' behind it");
    for (const CsvRow& row : rows) {
        const auto cell = [&](std::size_t k) {
            return k < row.cells.size() ? std::string(trimmed(row.cells[k])) : std::string();
        };
        std::size_t cells = row.cells.size();
        while (cells > 0 && cell(cells - 1).empty()) --cells;
        std::string time = cell(0);
        if (cells == 0 || time.starts_with('#') || (is_told && row.line == 1)) continue;
        // A heading, whatever its language; columns that it has beyond ours are somebody's own.
        if (std::exchange(is_first, false) && time.find_first_of("0123456789") == std::string::npos) {
            most_cells = std::max(most_cells, cells);
            continue;
        }
        const std::string where = file + ":" + std::to_string(row.line);
        const auto refuse = [&](const std::string& what) {
            report.add(Severity::error, where, what + "; the mark is left out");
        };
        if (cells > most_cells) {
            refuse("a mark has " + std::to_string(cells) + " parts, expected at most " +
                   std::to_string(most_cells) + " (time, number, name, note); one with " + parts_at +
                   " of its own stands in quotes");
            continue;
        }
        if (separator == ';' && frames_per_s == kDropFramesPer_s &&
            std::count(time.begin(), time.end(), ':') == 2 && cell(1).size() == 2 && number_from(cell(1))) {
            refuse("drop-frame time code in a file that parts by ';' stands in quotes");
            continue;
        }
        if (const std::size_t comma = time.find(','); separator != ',' && comma != std::string::npos)
            time[comma] = '.';
        const auto at_s = seconds_from(time, frames_per_s);
        if (!at_s) {
            const bool has_frames = std::count(time.begin(), time.end(), ':') == 3 && !(frames_per_s > 0);
            const bool is_drop_frame = begins_with_drop_frame(time) && frames_per_s != kDropFramesPer_s;
            refuse("the time of a mark is '" + cell(0).substr(0, 40) +
                   "', expected seconds or H:MM:SS before " + parts_at + ", as in the first line" +
                   (is_drop_frame ? "; drop-frame time code needs --mark-fps 30"
                    : begins_with_drop_frame(time)
                        ? "; drop frame has no frames 0 and 1 in a minute's first second but each tenth's"
                    : has_frames ? "; frames need --mark-fps"
                    : separator == ',' && time.find(',') != std::string::npos
                        ? "; where decimals have commas ';' parts the cells"
                        : ""));
            continue;
        }
        if (marks.size() == kMostEntries) {
            report.add(Severity::error, where,
                       "more than " + std::to_string(kMostEntries) + " marks, the rest is left out");
            break;
        }
        marks.push_back({*at_s, cell(1), cell(2), cell(3)});
    }
    std::stable_sort(marks.begin(), marks.end(),
                     [](const Mark& a, const Mark& b) { return a.at_s < b.at_s; });
    return marks;
}

} // namespace ghost::scene
