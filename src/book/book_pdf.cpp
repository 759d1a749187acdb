// SPDX-License-Identifier: Apache-2.0
#include "book/pdf.h"

#include "book/private/difference_lines.h"
#include "book/private/entry_text.h"
#include "image/ldr.h"
#include "print/pdf_writer.h"

#include <algorithm>

namespace ghost::scene {
namespace {

constexpr double kMargin_pt = 40, kHead_pt = 26, kGap_pt = 10;
constexpr std::size_t kRowsOfPage = 4;
constexpr std::size_t kMostPictures = 2; // of an entry; the page of the browser has all
constexpr double kPictures_pt = 215;     // width of what stands left of the words
constexpr double kPencil_pt = 16, kTimes_pt = 22, kUnknown_pt = 20;
constexpr double kAll_pt = 1e6;

constexpr PdfText kTitle{.size_pt = 11, .is_bold = true};
constexpr PdfText kSmall{.size_pt = 8, .is_grey = true};
constexpr PdfText kWords{.size_pt = 8.5};
constexpr PdfText kHeading{.size_pt = 9.5, .is_bold = true};
constexpr double kHeadingGap_pt = 8, kLineGap_pt = 2;

class BookPages {
public:
    BookPages(const Book& book, const BookDifference* difference, const std::filesystem::path& folder,
              PaperSize size, const PrintStyle& style, BookLayout layout)
        : book_(book), folder_(folder), style_(style), columns_(layout == BookLayout::grid ? 3 : 1),
          pdf_(size, false, book.show + ": " + style("cue book")) {
        if (!difference) return;
        since_ = style("Since %1", {difference->old_name});
        for (const DifferenceLine& line : lines_of(*difference, style)) lines_.push_back(sized(line));
    }

    Result<std::string> draw(Report& report) {
        unknown_ = book_.unknown;
        if (const std::string said = look_for_boxes(); !said.empty()) {
            report.add(Severity::warning, "book.pdf", said);
            unknown_.insert(unknown_.begin(), said);
        }
        const std::size_t of_page = kRowsOfPage * columns_;
        const std::size_t of_entries =
            std::max<std::size_t>(1, (book_.entries.size() + of_page - 1) / of_page);
        pages_ = pages_of_lines() + of_entries;
        if (!lines_.empty()) draw_lines();
        for (std::size_t page = 0; page < of_entries; ++page) {
            draw_head();
            const double top = kMargin_pt + kHead_pt;
            const double height = (pdf_.height_pt() - top - kMargin_pt) / kRowsOfPage;
            for (std::size_t k = 0; k < of_page && page * of_page + k < book_.entries.size(); ++k) {
                const double y = top + static_cast<double>(k / columns_) * height;
                TRY_VOID(columns_ == 1 ? draw_entry(page * of_page + k, y, height - kGap_pt)
                                       : draw_cell(page * of_page + k, k % columns_, y, height - kGap_pt));
            }
            pdf_.end_page();
        }
        return pdf_.finish();
    }

private:
    struct SizedLine {
        DifferenceLine line;
        double gap_pt = 0, height_pt = 0; // above it, its own
    };

    static const PdfText& look_of(DifferenceLine::Rank rank) {
        switch (rank) {
        case DifferenceLine::Rank::heading:
            return kHeading;
        case DifferenceLine::Rank::unknown:
            return kSmall;
        case DifferenceLine::Rank::sentence:
            break;
        }
        return kWords;
    }

    double room_of_lines_pt() const { return pdf_.height_pt() - 2 * kMargin_pt - kHead_pt; }

    SizedLine sized(const DifferenceLine& line) {
        const double room = room_of_lines_pt() - kHeadingGap_pt - kHead_pt;
        return {line, line.rank == DifferenceLine::Rank::heading ? kHeadingGap_pt : kLineGap_pt,
                pdf_.height_of(pdf_.width_pt() - 2 * kMargin_pt, room, line.text, look_of(line.rank))};
    }

    // begin(k): the k-th line is the first of its page.
    template <class Begin, class Line>
    void each_line(const Begin& begin, const Line& line) {
        double at = 0;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            // A heading does not stand alone at the foot of a page.
            const bool leads = lines_[k].line.rank == DifferenceLine::Rank::heading && k + 1 < lines_.size();
            const double needed = lines_[k].gap_pt + lines_[k].height_pt +
                                  (leads ? lines_[k + 1].gap_pt + lines_[k + 1].height_pt : 0);
            if (k == 0 || at + needed > room_of_lines_pt()) {
                begin(k);
                at = k == 0 ? kHead_pt : 0; // the title
            }
            line(lines_[k], at + lines_[k].gap_pt);
            at += lines_[k].gap_pt + lines_[k].height_pt;
        }
    }

    std::size_t pages_of_lines() {
        std::size_t pages = 0;
        each_line([&](std::size_t) { ++pages; }, [](const SizedLine&, double) {});
        return pages;
    }

    void draw_lines() {
        const double top = kMargin_pt + kHead_pt, width = pdf_.width_pt() - 2 * kMargin_pt;
        each_line(
            [&](std::size_t k) {
                if (k > 0) pdf_.end_page();
                draw_head();
                if (k > 0) return;
                pdf_.mark(since_);
                pdf_.line_of_text(kMargin_pt, top, width, since_, kTitle);
            },
            [&](const SizedLine& line, double y) {
                pdf_.text(kMargin_pt, top + y, width, line.height_pt + 1, line.line.text,
                          look_of(line.line.rank));
            });
        pdf_.end_page();
    }

    void draw_head() {
        const std::size_t page = page_++;
        const double width = pdf_.width_pt() - 2 * kMargin_pt;
        pdf_.line_of_text(kMargin_pt, kMargin_pt - 12, 0.75 * width, book_.show, kTitle);
        pdf_.line_of_text(
            kMargin_pt + 0.75 * width, kMargin_pt - 12, 0.25 * width,
            style_("cue book, page %1 of %2", {std::to_string(page + 1), std::to_string(pages_)}),
            {.size_pt = 8, .is_grey = true, .is_right = true});
        if (page == 0)
            draw_list(kMargin_pt, kMargin_pt + 2, width, kMargin_pt + 2 + kUnknown_pt, unknown_, kSmall);
    }

    std::string look_for_boxes() {
        pdf_.look_for_boxes(book_.show);
        pdf_.look_for_boxes(since_);
        for (const SizedLine& line : lines_) pdf_.look_for_boxes(line.line.text);
        for (std::size_t i = 0; i < book_.entries.size(); ++i) {
            const BookEntry& entry = book_.entries[i];
            for (const std::string& text :
                 {entry_number(book_, i) + entry.name, times_text(entry, style_), entry.notes})
                pdf_.look_for_boxes(text);
            for (const BookPicture& picture : entry.pictures) pdf_.look_for_boxes(picture.camera);
            for (const BookChange& change : entry.changes) pdf_.look_for_boxes(change.line(style_));
        }
        return pdf_.boxes_said(style_);
    }

    // Its title, which the list of contents has.
    std::string begin_entry(std::size_t index) {
        std::string title = entry_number(book_, index) + book_.entries[index].name;
        pdf_.mark(title);
        return title;
    }

    Result<void> draw_cell(std::size_t index, std::size_t column, double y, double height) {
        const BookEntry& entry = book_.entries[index];
        const double each = (pdf_.width_pt() - 2 * kMargin_pt + kGap_pt) / static_cast<double>(columns_);
        const double x = kMargin_pt + static_cast<double>(column) * each, width = each - kGap_pt;
        pdf_.line_of_text(x, y, width, begin_entry(index), kTitle);
        std::string said = times_text(entry, style_);
        for (const std::string& sentence : entry.unknown) said += (said.empty() ? "" : "; ") + sentence;
        const double top = y + 18 + pdf_.text(x, y + 15, width, kTimes_pt, said, kSmall);
        if (entry.pictures.empty()) return {};
        return draw_picture(entry.pictures.front(), x, top, width, y + height - top - 10);
    }

    // With the name of its camera below.
    Result<void> draw_picture(const BookPicture& picture, double x, double y, double width, double height) {
        TRY(const image::Image8 pixels, image::read_ldr(folder_ / picture.file));
        const double scale = std::min(width / pixels.width, height / pixels.height);
        TRY_VOID(pdf_.picture(x, y, scale * pixels.width, scale * pixels.height, pixels));
        pdf_.line_of_text(x, y + scale * pixels.height, width, picture.camera, kSmall);
        return {};
    }

    Result<void> draw_entry(std::size_t index, double y, double height) {
        const BookEntry& entry = book_.entries[index];
        const std::string title = begin_entry(index);
        pdf_.line(kMargin_pt, y, pdf_.width_pt() - kMargin_pt, y);
        TRY_VOID(draw_pictures(entry, y + 6, height - 6));
        const double x = kMargin_pt + kPictures_pt + kGap_pt, width = pdf_.width_pt() - kMargin_pt - x;
        const double end = y + height - 2 * kPencil_pt;
        std::vector<std::string> changes;
        for (const BookChange& change : entry.changes) changes.push_back(change.line(style_));
        if (changes.empty()) changes.push_back(style_("nothing that is seen"));
        // What follows has a line each, at least: that says how much more there is.
        const double line = pdf_.height_of(width, kTimes_pt, "x", kWords);
        const double of_changes = line + 2, of_unknown = entry.unknown.empty() ? 0 : line;
        double at = y + 5;
        at += pdf_.text(x, at, width, 0.3 * (end - at), title, kTitle) + 1;
        at += pdf_.text(x, at, width, kTimes_pt, times_text(entry, style_), kSmall);
        at += pdf_.text(x, at, width, end - of_changes - of_unknown - at, entry.notes, kWords);
        at += draw_list(x, at, width, end - of_changes, entry.unknown, kSmall);
        draw_list(x, at + 2, width, end, changes, kWords);
        for (const double up : {kPencil_pt, 0.0}) pdf_.line(x, y + height - up, x + width, y + height - up);
        return {};
    }

    // One below the other as far as there is room, and how many more there are. The height that it takes.
    double draw_list(double x, double y, double width, double end, const std::vector<std::string>& lines,
                     const PdfText& look) {
        const double least = pdf_.height_of(width, kTimes_pt, "x", look);
        double at = y;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const bool is_last = k + 1 == lines.size();
            const double room = end - at - (is_last ? 0 : least);
            if (pdf_.height_of(width, kAll_pt, lines[k], look) > room) {
                const std::string more = std::to_string(lines.size() - k);
                return at - y +
                       pdf_.text(x, at, width, std::max(least, end - at),
                                 style_("and %1 more: see index.html", {more}), look);
            }
            at += pdf_.text(x, at, width, room, lines[k], look);
        }
        return at - y;
    }

    Result<void> draw_pictures(const BookEntry& entry, double y, double height) {
        const std::size_t count = std::min(entry.pictures.size(), kMostPictures);
        const double each = (height - kGap_pt * static_cast<double>(count)) /
                            static_cast<double>(std::max<std::size_t>(count, 1));
        for (std::size_t k = 0; k < count; ++k)
            TRY_VOID(draw_picture(entry.pictures[k], kMargin_pt,
                                  y + static_cast<double>(k) * (each + kGap_pt), kPictures_pt, each));
        return {};
    }

    const Book& book_;
    const std::filesystem::path& folder_;
    const PrintStyle& style_;
    const std::size_t columns_;
    PdfWriter pdf_;
    std::vector<std::string> unknown_; // of the book, and of its letters
    std::string since_;                // title of the difference
    std::vector<SizedLine> lines_;     // of the difference; empty: there is none
    std::size_t page_ = 0, pages_ = 0;
};

} // namespace

Result<std::string> pdf_of(const Book& book, const BookDifference* difference,
                           const std::filesystem::path& folder, PaperSize size, Report& report,
                           const PrintStyle& style, BookLayout layout) {
    return BookPages(book, difference, folder, size, style, layout).draw(report);
}

} // namespace ghost::scene
