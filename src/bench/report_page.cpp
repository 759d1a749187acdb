// SPDX-License-Identifier: Apache-2.0
#include "bench/private/report_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::app {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:76rem;padding:0 "
    "1rem;background:#14161a;"
    "color:#d8dbe0}h1{font-size:1.7rem}h2{margin-top:2.5rem;font-size:1.2rem}table{border-collapse:collapse;"
    "font-size:13px;font-variant-numeric:tabular-nums}.wide{overflow-x:auto}th,td{padding:.15rem .6rem;"
    "text-align:right;border-bottom:1px solid #2a2e35;white-space:nowrap}th:first-child,td:first-child{"
    "text-align:left}th{color:#9aa2ad;font-weight:500}td.note{text-align:left;color:#9aa2ad}p.error{color:#"
    "ffb454}"
    "figure{margin:1rem 0}img{max-width:100%;background:#000}figcaption{color:#9aa2ad;font-size:13px}"
    "td.good{color:#7fd88f}td.bad{color:#ffb454}";

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '&')
            safe += "&amp;";
        else if (letter == '<')
            safe += "&lt;";
        else if (letter == '>')
            safe += "&gt;";
        else if (letter == '"')
            safe += "&quot;";
        else
            safe += letter;
    }
    return safe;
}

std::string number_text(double value) {
    if (!std::isfinite(value)) return "-";
    char text[32];
    std::snprintf(text, sizeof text, std::abs(value) >= 1000 ? "%.0f" : "%.4g", value);
    return text;
}

double figure_of(const BenchRow& row, const std::string& name) {
    for (const auto& [key, value] : row.figures)
        if (key == name) return value;
    return std::nan("");
}

// Columns in the order in which rows first have them.
std::vector<std::string> columns_of(const ReportTable& table) {
    std::vector<std::string> columns;
    for (const BenchRow& row : table.rows)
        for (const auto& [name, value] : row.figures)
            if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    return columns;
}

std::string table_html(const ReportTable& table) {
    std::string html = "<h2 id=\"" + table.name + "\">" + escaped(table.title) + "</h2>\n";
    if (!table.error.empty()) html += "<p class=\"error\">" + escaped(table.error) + "</p>\n";
    if (table.rows.empty()) return html;
    const std::vector<std::string> columns = columns_of(table);
    html += "<div class=\"wide\"><table><tr><th>" + escaped(table.name) + "</th>";
    for (std::string column : columns) {
        std::replace(column.begin(), column.end(), '_', ' ');
        html += "<th>" + escaped(column) + "</th>";
    }
    html += "<th></th></tr>\n";
    for (const BenchRow& row : table.rows) {
        html += "<tr><td>" + escaped(row.name) + "</td>";
        for (const std::string& column : columns)
            html += "<td>" + number_text(figure_of(row, column)) + "</td>";
        html += "<td class=\"note\">" + escaped(row.note) + "</td></tr>\n";
    }
    return html + "</table></div>\n";
}

// Of the table scale: pictures a second with every light moving, by beams and by size.
std::string beams_html(const ReportTable& scale) {
    constexpr const char* kSizes[] = {"1920x1080", "3840x2160"};
    constexpr const char* kCounts[] = {"10 lights", "60 lights", "120 lights", "400 lights"};
    constexpr double kGoal_ms[] = {4, 8};
    std::string html = "<h2>Beams</h2>\n<p>ms a picture, and pictures a second, while every light moves; "
                       "with 400 lights 4 ms "
                       "at 1920x1080 and 8 ms at 3840x2160 are the goal.</p>\n<table><tr><th></th>";
    for (const char* count : kCounts) html += std::string("<th>") + count + "</th>";
    html += "</tr>\n";
    for (std::size_t size = 0; size < std::size(kSizes); ++size) {
        html += std::string("<tr><td>") + kSizes[size] + "</td>";
        for (const char* count : kCounts) {
            double ms = std::nan(""), expected_ms = ms;
            for (const BenchRow& row : scale.rows)
                if (row.name == std::string(count) + ", " + kSizes[size]) {
                    ms = figure_of(row, "ms");
                    expected_ms = figure_of(row, "expected_ms");
                }
            const bool measured = std::isfinite(ms);
            const bool has_goal = measured && std::string_view(count) == "400 lights";
            html += has_goal ? (ms <= kGoal_ms[size] ? "<td class=\"good\">" : "<td class=\"bad\">") : "<td>";
            html += measured ? number_text(ms) + " (" + number_text(std::floor(1000 / ms)) + "/s)"
                    : std::isfinite(expected_ms) ? "about " + number_text(expected_ms)
                                                 : "-";
            html += "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

} // namespace

std::string html_of(const ReportPage& page) {
    std::string name = "a device";
    for (const auto& [key, value] : page.facts)
        if (key == "name") name = value;
    std::string html = "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
                       "content=\"width=device-width\">\n<title>Ghostlight on " +
                       escaped(name) + "</title>\n<style>" + kStyle + "</style>\n<h1>Ghostlight on " +
                       escaped(name) + "</h1>\n<p>" + escaped(page.program) + ", " + escaped(page.time) +
                       "</p>\n";
    for (const ReportTable& table : page.tables)
        if (table.name == "scale") html += beams_html(table);
    for (const ReportTable& table : page.tables) {
        html += table_html(table);
        if (table.name != "pictures") continue;
        for (const BenchRow& row : table.rows)
            html += "<figure><img src=\"" + escaped(row.name) + ".png\" alt=\"" + escaped(row.name) +
                    "\" loading=\"lazy\"><figcaption>" + escaped(row.name) + "</figcaption></figure>\n";
    }
    html += "<h2>The device</h2>\n<table>";
    for (const auto& [key, value] : page.facts)
        html += "<tr><td>" + escaped(key) + "</td><td>" + escaped(value) + "</td></tr>\n";
    return html + "</table>\n</html>\n";
}

} // namespace ghost::app
