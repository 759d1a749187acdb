// SPDX-License-Identifier: Apache-2.0
#include "book/pdf.h"

#include "book/private/paper_widths.h"
#include "print/pdf_writer.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ghost::scene {
namespace {

constexpr double kTableMargin_pt = 34, kRow_pt = 11.5, kPad_pt = 3;
constexpr double kTop_pt = kTableMargin_pt + 4, kSentence_pt = 10 * kRow_pt, kSentenceGap_pt = 2;
constexpr double kLeastColumn_pt = 22, kWidestColumn_pt = 190;
constexpr std::size_t kMeasuredCells = 400; // of a column: a text is slow to measure
constexpr double kFreeGrey = 0.92, kHeadGrey = 0.85;

constexpr PdfText kCell{.size_pt = 7.5};
constexpr PdfText kColumnHead{.size_pt = 7.5, .is_bold = true};

class PaperPages {
public:
    PaperPages(const Paper& paper, PaperSize size)
        : paper_(paper), pdf_(size, true, paper.show + ": " + paper.style("paperwork")),
          width_(pdf_.width_pt() - 2 * kTableMargin_pt), end_(pdf_.height_pt() - kTableMargin_pt) {}

    Result<std::string> draw(Report& report) {
        if (const std::string said = look_for_boxes(); !said.empty()) {
            report.add(Severity::warning, "paper.pdf", said);
            boxes_.push_back(said + ".");
        }
        std::vector<TablePages> all;
        for (const PaperTable& table : paper_.tables) {
            all.push_back(pages_of(table));
            pages_ += all.back().pages();
        }
        for (std::size_t k = 0; k < all.size(); ++k) draw_table(paper_.tables[k], all[k]);
        return pdf_.finish();
    }

private:
    // How its rows are spread over pages.
    struct TablePages {
        std::vector<std::string> said; // above the first ones
        std::size_t rows = 0, of_first = 0, of_more = 1;

        std::size_t pages() const {
            return 1 + (rows > of_first ? (rows - of_first + of_more - 1) / of_more : 0);
        }
    };

    std::string look_for_boxes() {
        pdf_.look_for_boxes(paper_.show);
        for (const PaperTable& table : paper_.tables)
            for (const PaperRow& row : table.rows)
                for (const std::string& cell : row.cells) pdf_.look_for_boxes(cell);
        return pdf_.boxes_said(paper_.style);
    }

    // With its heads.
    std::size_t rows_below(double y) const {
        return static_cast<std::size_t>(std::max(0.0, (end_ - y) / kRow_pt - 1));
    }

    double height_of(const std::string& sentence) {
        return pdf_.height_of(width_, kSentence_pt, sentence, kCell) + kSentenceGap_pt;
    }

    TablePages pages_of(const PaperTable& table) {
        TablePages pages;
        pages.rows = table.rows.size();
        std::vector<std::string> all = &table == paper_.tables.data() ? boxes_ : std::vector<std::string>();
        all.insert(all.end(), table.unknown.begin(), table.unknown.end());
        double y = kTop_pt;
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (y + height_of(all[k]) > 0.7 * end_) { // rows are to be seen, too
                pages.said.push_back(
                    paper_.style("and %1 more: see index.html", {std::to_string(all.size() - k)}));
                y += height_of(pages.said.back());
                break;
            }
            pages.said.push_back(all[k]);
            y += height_of(all[k]);
        }
        pages.of_first = rows_below(y);
        pages.of_more = std::max<std::size_t>(1, rows_below(kTop_pt));
        return pages;
    }

    void begin_page(const PaperTable& table, bool is_first) {
        ++page_;
        if (is_first) pdf_.mark(table.title);
        pdf_.line_of_text(kTableMargin_pt, kTableMargin_pt - 14, 0.5 * width_,
                          is_first ? table.title : paper_.style("%1, continued", {table.title}),
                          {.size_pt = 11, .is_bold = true});
        constexpr PdfText kPlace{.size_pt = 8, .is_grey = true, .is_right = true};
        const std::string number =
            paper_.style("page %1 of %2", {std::to_string(page_), std::to_string(pages_)});
        const double of_number = pdf_.width_of(number, kPlace) + 1, end = kTableMargin_pt + width_;
        pdf_.line_of_text(end - of_number, kTableMargin_pt - 14, of_number, number, kPlace);
        pdf_.line_of_text(kTableMargin_pt + 0.5 * width_, kTableMargin_pt - 14,
                          0.5 * width_ - of_number - 2 * kPad_pt, paper_.show, kPlace);
        y_ = kTop_pt;
    }

    std::vector<double> widths_of(const PaperTable& table) {
        std::vector<double> widths;
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            double width = pdf_.width_of(table.columns[k].title, kColumnHead);
            for (const std::string* cell : longest_cells(table, k, kMeasuredCells))
                width = std::max(width, pdf_.width_of(*cell, kCell));
            widths.push_back(std::clamp(width, kLeastColumn_pt, kWidestColumn_pt) + 2 * kPad_pt);
        }
        return shared_widths(table.columns, std::move(widths), width_, kLeastColumn_pt + 2 * kPad_pt);
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

    void draw_table(const PaperTable& table, const TablePages& pages) {
        begin_page(table, true);
        for (const std::string& sentence : pages.said)
            y_ += pdf_.text(kTableMargin_pt, y_, width_, kSentence_pt, sentence, kCell) + kSentenceGap_pt;
        const std::vector<double> widths = widths_of(table);
        if (!table.rows.empty()) draw_column_heads(table, widths);
        for (std::size_t k = 0; k < table.rows.size(); ++k) {
            const PaperRow& row = table.rows[k];
            if (k >= pages.of_first && (k - pages.of_first) % pages.of_more == 0) {
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
    std::vector<std::string> boxes_; // what is said of letters that no font has
    std::size_t page_ = 0, pages_ = 0;
};

} // namespace

Result<std::string> pdf_of(const Paper& paper, PaperSize size, Report& report) {
    return PaperPages(paper, size).draw(report);
}

} // namespace ghost::scene
