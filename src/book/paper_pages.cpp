// SPDX-License-Identifier: Apache-2.0
#include "book/paper_pages.h"

#include "base/print.h"

#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::size_t kWholeBytes = 24; // addresses of many breaks have lines

std::string csv_cell(const std::string& text, bool is_number) {
    std::string cell = one_line(text);
    if (!is_number && !cell.empty() && std::string_view("=+-@").find(cell[0]) != std::string_view::npos)
        cell.insert(0, 1, '\'');
    if (cell.find_first_of("\",") == std::string::npos) return cell;
    std::string quoted = "\"";
    for (const char letter : cell) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

std::string cell_begin(const PaperColumn& column, const std::string& cell) {
    if (column.is_number) return "<td class=\"n\">";
    return column.is_whole && cell.size() <= kWholeBytes ? "<td class=\"w\">" : "<td>";
}

std::string html_table(const PaperTable& table, const PrintStyle& style) {
    std::string text = "<section id=\"" + table.file + "\">\n<h2>" + html_text(table.title) + "</h2>\n";
    if (!table.unknown.empty()) {
        text += "<ul class=\"unknown\">\n";
        for (const std::string& sentence : table.unknown) text += "<li>" + html_name(sentence) + "</li>\n";
        text += "</ul>\n";
    }
    if (table.rows.empty()) return text + "<p class=\"of\">" + style("nothing") + "</p>\n</section>\n";
    text += "<div class=\"table\">\n<table>\n<thead><tr>";
    for (const PaperColumn& column : table.columns)
        text += std::string("<th") + (column.is_number ? " class=\"n\"" : "") + ">" +
                html_text(column.title) + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (const PaperRow& row : table.rows) {
        text += row.is_free ? "<tr class=\"free\">" : "<tr>";
        for (std::size_t k = 0; k < row.cells.size(); ++k)
            text += cell_begin(table.columns[k], row.cells[k]) +
                    (row.cells[k].empty() ? "" : html_name(row.cells[k])) + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody></table>\n</div>\n</section>\n";
}

} // namespace

std::string csv_of(const PaperTable& table) {
    std::string text = "\xef\xbb\xbf";
    for (std::size_t k = 0; k < table.columns.size(); ++k)
        text += (k > 0 ? "," : "") + csv_cell(table.columns[k].title, false);
    return text + "\r\n" + csv_rows_of(table);
}

std::string csv_rows_of(const PaperTable& table) {
    std::string text;
    for (const PaperRow& row : table.rows) {
        for (std::size_t k = 0; k < row.cells.size(); ++k)
            text += (k > 0 ? "," : "") + csv_cell(row.cells[k], table.columns[k].is_number);
        text += "\r\n";
    }
    return text;
}

std::string html_of(const Paper& paper, PaperSize size, const std::vector<PaperDrawing>& drawings) {
    const PrintStyle& style = paper.style;
    std::string page = html_begin(paper.show + ": " + style("paperwork"), size, style.language, true);
    const std::string units =
        style.units == Units::metric
            ? style("Metres, kilograms, watts; x to the right seen from the house, y up-stage, z up.")
            : style("Feet and inches, pounds, watts; x to the right seen from the house, y up-stage, z up.");
    page += "<h1>" + html_name(paper.show) + "</h1>\n<p class=\"of\">" + style("Paperwork") + ". " + units +
            " " +
            style("Each table lies beside this page as .csv. What a cell leaves empty, the show does not "
                  "say.") +
            "</p>\n";
    if (!drawings.empty()) page += "<nav aria-label=\"" + style("drawings") + "\">\n";
    for (const PaperDrawing& drawing : drawings)
        page += "<a href=\"" + drawing.file + "\">" + html_text(drawing.title) + " (PDF)</a>\n";
    if (!drawings.empty()) page += "</nav>\n";
    page += "<nav aria-label=\"" + style("tables") + "\">\n";
    for (const PaperTable& table : paper.tables)
        page += "<a href=\"#" + table.file + "\">" + html_text(table.title) + "</a>\n";
    page += "</nav>\n";
    for (const PaperTable& table : paper.tables) page += html_table(table, style);
    return page + html_end();
}

} // namespace ghost::scene
