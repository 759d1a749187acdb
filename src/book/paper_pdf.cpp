// SPDX-License-Identifier: Apache-2.0
#include "book/pdf.h"

#include "print/pdf_writer.h"

#include <algorithm>
#include <numeric>

namespace ghost::scene {
namespace {

constexpr double kTableMargin_pt = 34, kRow_pt = 11.5, kPad_pt = 3;
constexpr double kLeastColumn_pt = 22, kWidestColumn_pt = 190;
constexpr std::size_t kMeasuredRows = 400; // evenly spread over the table: enough to share out a page
constexpr double kFreeGrey = 0.92, kHeadGrey = 0.85;

constexpr PdfText kCell{.size_pt = 7.5};
constexpr PdfText kColumnHead{.size_pt = 7.5, .is_bold = true};

class PaperPages {
public:
    PaperPages(const Paper& paper, PaperSize size)
        : paper_(paper), pdf_(size, true, paper.show + ": " + paper.style("paperwork")),
          width_(pdf_.width_pt() - 2 * kTableMargin_pt), end_(pdf_.height_pt() - kTableMargin_pt) {}

    Result<std::string> draw() {
        for (const PaperTable& table : paper_.tables) draw_table(table);
        return pdf_.finish();
    }

private:
    void begin_page(const PaperTable& table, bool is_first) {
        ++page_;
        if (is_first) pdf_.mark(table.title);
        pdf_.line_of_text(kTableMargin_pt, kTableMargin_pt - 14, 0.7 * width_,
                          is_first ? table.title : paper_.style("%1, continued", {table.title}),
                          {.size_pt = 11, .is_bold = true});
        pdf_.line_of_text(kTableMargin_pt + 0.7 * width_, kTableMargin_pt - 14, 0.3 * width_,
                          paper_.style("%1, page %2", {paper_.show, std::to_string(page_)}),
                          {.size_pt = 8, .is_grey = true, .is_right = true});
        y_ = kTableMargin_pt + 4;
    }

    // What each column wants, shrunk to the page where that is more than it has.
    std::vector<double> widths_of(const PaperTable& table) {
        std::vector<double> widths;
        const std::size_t step = std::max<std::size_t>(1, table.rows.size() / kMeasuredRows);
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            double width = pdf_.width_of(table.columns[k].title, kColumnHead);
            for (std::size_t row = 0; row < table.rows.size(); row += step)
                width = std::max(width, pdf_.width_of(table.rows[row].cells[k], kCell));
            widths.push_back(std::clamp(width, kLeastColumn_pt, kWidestColumn_pt) + 2 * kPad_pt);
        }
        const double all = std::accumulate(widths.begin(), widths.end(), 0.0);
        if (all > width_)
            for (double& width : widths) width *= width_ / all;
        return widths;
    }

    void draw_row(const PaperTable& table, const std::vector<double>& widths,
                  const std::vector<std::string>& cells, PdfText look) {
        double x = kTableMargin_pt;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            look.is_right = table.columns[k].is_number;
            pdf_.line_of_text(x + kPad_pt, y_ + 1, widths[k] - 2 * kPad_pt, cells[k], look);
            x += widths[k];
        }
        y_ += kRow_pt;
        pdf_.line(kTableMargin_pt, y_, x, y_);
    }

    void draw_column_heads(const PaperTable& table, const std::vector<double>& widths) {
        std::vector<std::string> titles;
        for (const PaperColumn& column : table.columns) titles.push_back(column.title);
        pdf_.fill(kTableMargin_pt, y_, std::accumulate(widths.begin(), widths.end(), 0.0), kRow_pt,
                  kHeadGrey);
        draw_row(table, widths, titles, kColumnHead);
    }

    void draw_table(const PaperTable& table) {
        begin_page(table, true);
        for (const std::string& sentence : table.unknown)
            y_ += pdf_.text(kTableMargin_pt, y_, width_, 4 * kRow_pt, sentence, kCell) + 2;
        const std::vector<double> widths = widths_of(table);
        if (!table.rows.empty()) draw_column_heads(table, widths);
        for (const PaperRow& row : table.rows) {
            if (y_ + kRow_pt > end_) {
                pdf_.end_page();
                begin_page(table, false);
                draw_column_heads(table, widths);
            }
            if (row.is_free)
                pdf_.fill(kTableMargin_pt, y_, std::accumulate(widths.begin(), widths.end(), 0.0), kRow_pt,
                          kFreeGrey);
            draw_row(table, widths, row.cells, kCell);
        }
        pdf_.end_page();
    }

    const Paper& paper_;
    PdfWriter pdf_;
    double width_, end_;
    double y_ = 0;
    int page_ = 0;
};

} // namespace

Result<std::string> pdf_of(const Paper& paper, PaperSize size) {
    return PaperPages(paper, size).draw();
}

} // namespace ghost::scene
