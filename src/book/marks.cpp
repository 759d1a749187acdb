// SPDX-License-Identifier: Apache-2.0
#include "book/marks.h"

#include "base/text.h"
#include "book/book.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace ghost::scene {
namespace {

constexpr double kLatestMark_s = 366.0 * 86400.0;
constexpr std::size_t kMostCells = 64;
constexpr std::size_t kMostLetters = 1000; // of a cell, as of a text of show.toml

struct CsvRow {
    std::size_t line = 1; // of the file
    std::vector<std::string> cells;
};

std::vector<CsvRow> csv_rows(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
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
        else if (!is_quoted && (letter == ',' || letter == ';' || letter == '\t'))
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

// "83.5", "1:23.5", "0:01:23.5", "00:01:23:12".
std::optional<double> seconds_from(std::string_view text, double frames_per_s) {
    const std::vector<std::string_view> parts = split(text, ':');
    if (parts.size() > 4) return std::nullopt;
    double total = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto part = number_from(parts[k]);
        if (!part) return std::nullopt;
        if (k == 3)
            total = *part < frames_per_s ? total + *part / frames_per_s : -1;
        else if (k > 0 && *part >= 60)
            return std::nullopt;
        else
            total = 60 * total + *part;
    }
    return total >= 0 ? std::optional(total) : std::nullopt;
}

} // namespace

std::vector<Mark> read_marks(std::string_view csv, const std::string& file, double frames_per_s,
                             Report& report) {
    std::vector<Mark> marks;
    const std::vector<CsvRow> rows = csv_rows(csv);
    for (const CsvRow& row : rows) {
        const auto cell = [&](std::size_t k) {
            return k < row.cells.size() ? std::string(trimmed(row.cells[k])) : std::string();
        };
        const std::string time = cell(0);
        const bool is_empty = std::all_of(row.cells.begin(), row.cells.end(),
                                          [](const std::string& one) { return trimmed(one).empty(); });
        if (is_empty || time.starts_with('#') || (&row == &rows.front() && lower(time) == "time")) continue;
        const std::string where = file + ":" + std::to_string(row.line);
        const auto at_s = seconds_from(time, frames_per_s);
        if (!at_s) {
            const bool has_frames = std::count(time.begin(), time.end(), ':') == 3 && !(frames_per_s > 0);
            report.add(Severity::error, where,
                       "the time of a mark is '" + time.substr(0, 40) + "', expected seconds or H:MM:SS" +
                           (has_frames ? "; frames need --mark-fps" : "") + "; the mark is left out");
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
