// SPDX-License-Identifier: Apache-2.0
#include "print/pdf_writer.h"

#include "base/print.h"
#include "image/jpeg_bytes.h"
#include "print/quantities.h"

#include <cairo-pdf.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <utility>

namespace ghost::scene {
namespace {

constexpr double kGrey = 0.35;
constexpr double kMostHeight_pt = 1e6;
constexpr std::size_t kMeasuredBytes = 1000;
constexpr long kQuotedLetters = 40;
constexpr int kPictureQuality = 85;
// None: cairo would write the time of day, and no two files would be equal.
constexpr const char* kNoDate = "";

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
}

template <class T>
using Freed = std::unique_ptr<T, void (*)(T*)>;

} // namespace

struct PdfWriter::Drawing {
    std::string bytes;
    Freed<cairo_surface_t> surface{nullptr, cairo_surface_destroy};
    Freed<cairo_t> cairo{nullptr, cairo_destroy};
    PangoLayout* layout = nullptr;
    Freed<PangoFontDescription> font{pango_font_description_from_string("Sans"), pango_font_description_free};

    ~Drawing() {
        if (layout) g_object_unref(layout);
    }
};

PdfWriter::PdfWriter(PaperSize paper, bool is_wide, const std::string& title)
    : width_pt_(format_of(paper).width_pt), height_pt_(format_of(paper).height_pt), drawing_(new Drawing) {
    if (is_wide) std::swap(width_pt_, height_pt_);
    Drawing& d = *drawing_;
    d.surface.reset(cairo_pdf_surface_create_for_stream(append, &d.bytes, width_pt_, height_pt_));
    cairo_pdf_surface_set_metadata(d.surface.get(), CAIRO_PDF_METADATA_TITLE, one_line(title).c_str());
    cairo_pdf_surface_set_metadata(d.surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, kNoDate);
    d.cairo.reset(cairo_create(d.surface.get()));
    d.layout = pango_cairo_create_layout(d.cairo.get());
}

PdfWriter::~PdfWriter() = default;

void PdfWriter::set_text(const std::string& text, const PdfText& look) {
    PangoLayout* const layout = drawing_->layout;
    PangoFontDescription* const font = drawing_->font.get();
    pango_font_description_set_absolute_size(font, look.size_pt * PANGO_SCALE);
    pango_font_description_set_weight(font, look.is_bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_layout_set_font_description(layout, font);
    const std::string shown = printable(text); // UTF-8, whatever a name holds
    pango_layout_set_text(layout, shown.data(), static_cast<int>(shown.size()));
    pango_layout_set_alignment(layout, look.is_right    ? PANGO_ALIGN_RIGHT
                                       : look.is_middle ? PANGO_ALIGN_CENTER
                                                        : PANGO_ALIGN_LEFT);
    const double grey = look.is_grey ? kGrey : 0.0;
    cairo_set_source_rgb(drawing_->cairo.get(), grey, grey, grey);
}

double PdfWriter::height_of(double width, double height, const std::string& text, const PdfText& look) {
    if (text.empty() || height < look.size_pt) return 0;
    PangoLayout* const layout = drawing_->layout;
    const auto measured = [&](const std::string& shown, double most) {
        set_text(shown, look);
        pango_layout_set_height(layout, static_cast<int>(most * PANGO_SCALE));
        int taken = 0;
        pango_layout_get_size(layout, nullptr, &taken);
        return static_cast<double>(taken) / PANGO_SCALE;
    };
    pango_layout_set_width(layout, static_cast<int>(width * PANGO_SCALE));
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    std::string shown = with_whole_quantities(text);
    // Of several paragraphs Pango drops those that have no room, without "…": then they are one.
    if (shown.find('\n') != std::string::npos) {
        const double taken = measured(shown, kMostHeight_pt);
        if (taken <= height) return taken;
        std::replace(shown.begin(), shown.end(), '\n', ' ');
    }
    return measured(shown, height);
}

double PdfWriter::text(double x, double y, double width, double height, const std::string& text,
                       const PdfText& look) {
    const double taken = height_of(width, height, text, look);
    if (taken > 0) {
        cairo_move_to(drawing_->cairo.get(), x, y);
        pango_cairo_show_layout(drawing_->cairo.get(), drawing_->layout);
    }
    return taken;
}

void PdfWriter::line_of_text(double x, double y, double width, const std::string& text, const PdfText& look) {
    if (text.empty()) return;
    PangoLayout* const layout = drawing_->layout;
    set_text(text, look);
    pango_layout_set_width(layout, static_cast<int>(width * PANGO_SCALE));
    pango_layout_set_height(layout, -1); // of one line
    pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    cairo_move_to(drawing_->cairo.get(), x, y);
    pango_cairo_show_layout(drawing_->cairo.get(), layout);
}

double PdfWriter::width_of(const std::string& text, const PdfText& look) {
    PangoLayout* const layout = drawing_->layout;
    set_text(text.substr(0, kMeasuredBytes), look);
    pango_layout_set_width(layout, -1);
    pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_NONE);
    int width = 0;
    pango_layout_get_size(layout, &width, nullptr);
    return static_cast<double>(width) / PANGO_SCALE;
}

void PdfWriter::look_for_boxes(const std::string& text) {
    const auto is_ascii = [](char letter) { return static_cast<unsigned char>(letter) < 0x80; };
    if (!boxed_.empty() || std::all_of(text.begin(), text.end(), is_ascii)) return;
    width_of(text, {});
    if (pango_layout_get_unknown_glyphs_count(drawing_->layout) == 0) return;
    boxed_ = one_line(text);
    if (g_utf8_strlen(boxed_.c_str(), -1) <= kQuotedLetters) return;
    boxed_.resize(
        static_cast<std::size_t>(g_utf8_offset_to_pointer(boxed_.c_str(), kQuotedLetters) - boxed_.c_str()));
    boxed_ += "…";
}

std::string PdfWriter::boxes_said(const PrintStyle& style) const {
    return boxed_.empty()
               ? ""
               : style("Letters that no font of this machine has are printed as boxes, as in '%1'", {boxed_});
}

void PdfWriter::line(double x, double y, double to_x, double to_y) {
    cairo_t* const cairo = drawing_->cairo.get();
    cairo_set_source_rgb(cairo, 0.6, 0.6, 0.6);
    cairo_set_line_width(cairo, 0.5);
    cairo_move_to(cairo, x, y);
    cairo_line_to(cairo, to_x, to_y);
    cairo_stroke(cairo);
}

void PdfWriter::fill(double x, double y, double width, double height, double grey) {
    cairo_t* const cairo = drawing_->cairo.get();
    cairo_set_source_rgb(cairo, grey, grey, grey);
    cairo_rectangle(cairo, x, y, width, height);
    cairo_fill(cairo);
}

void PdfWriter::paint(const PdfInk& ink) {
    cairo_t* const cairo = drawing_->cairo.get();
    if (ink.fill_grey >= 0) {
        cairo_set_source_rgb(cairo, ink.fill_grey, ink.fill_grey, ink.fill_grey);
        cairo_fill_preserve(cairo);
    }
    if (ink.line_grey >= 0) {
        const double dashes[] = {ink.dash_pt, 0.3 * ink.dash_pt, 0.15 * ink.dash_pt, 0.3 * ink.dash_pt};
        cairo_set_dash(cairo, dashes, ink.dash_pt > 0 ? 4 : 0, 0);
        cairo_set_source_rgb(cairo, ink.line_grey, ink.line_grey, ink.line_grey);
        cairo_set_line_width(cairo, ink.width_pt);
        cairo_stroke_preserve(cairo);
        cairo_set_dash(cairo, nullptr, 0, 0);
    }
    cairo_new_path(cairo);
}

void PdfWriter::shape(std::span<const glm::dvec2> points, bool is_closed, const PdfInk& ink) {
    if (points.empty()) return;
    cairo_t* const cairo = drawing_->cairo.get();
    cairo_new_path(cairo);
    for (const glm::dvec2& point : points) cairo_line_to(cairo, point.x, point.y);
    if (is_closed) cairo_close_path(cairo);
    paint(ink);
}

void PdfWriter::lines(std::span<const glm::dvec2> ends, const PdfInk& ink) {
    cairo_t* const cairo = drawing_->cairo.get();
    constexpr std::size_t kEndsOfPath = 4000; // printers choke on longer ones
    cairo_new_path(cairo);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        cairo_move_to(cairo, ends[i].x, ends[i].y);
        cairo_line_to(cairo, ends[i + 1].x, ends[i + 1].y);
        if (i % kEndsOfPath == kEndsOfPath - 2) paint(ink);
    }
    paint(ink);
}

void PdfWriter::circle(const glm::dvec2& middle, double radius, const PdfInk& ink) {
    cairo_t* const cairo = drawing_->cairo.get();
    cairo_new_path(cairo);
    cairo_arc(cairo, middle.x, middle.y, radius, 0, 2 * 3.14159265358979);
    cairo_close_path(cairo);
    paint(ink);
}

void PdfWriter::begin_clip(double x, double y, double width, double height) {
    cairo_save(drawing_->cairo.get());
    cairo_rectangle(drawing_->cairo.get(), x, y, width, height);
    cairo_clip(drawing_->cairo.get());
}

void PdfWriter::end_clip() {
    cairo_restore(drawing_->cairo.get());
}

Result<void> PdfWriter::picture(double x, double y, double width, double height,
                                const image::Image8& pixels) {
    TRY(auto jpeg, image::jpeg_bytes(pixels, kPictureQuality));
    const Freed<cairo_surface_t> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height), cairo_surface_destroy);
    // cairo takes the bytes as they are, and keeps them until it has written them.
    auto* const kept = new std::vector<std::uint8_t>(std::move(jpeg));
    const auto drop = [](void* bytes) { delete static_cast<std::vector<std::uint8_t>*>(bytes); };
    if (cairo_surface_set_mime_data(surface.get(), CAIRO_MIME_TYPE_JPEG, kept->data(), kept->size(), drop,
                                    kept) != CAIRO_STATUS_SUCCESS) {
        drop(kept);
        return Error{"a picture cannot be put into the PDF: memory is short", ""};
    }
    cairo_t* const cairo = drawing_->cairo.get();
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_scale(cairo, width / pixels.width, height / pixels.height);
    cairo_set_source_surface(cairo, surface.get(), 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
    return {};
}

void PdfWriter::mark(const std::string& name) {
    // As cairo counts pages, which it does not say.
    cairo_pdf_surface_add_outline(drawing_->surface.get(), CAIRO_PDF_OUTLINE_ROOT, one_line(name).c_str(),
                                  ("page=" + std::to_string(page_)).c_str(), CAIRO_PDF_OUTLINE_FLAG_OPEN);
}

void PdfWriter::end_page() {
    cairo_show_page(drawing_->cairo.get());
    ++page_;
}

Result<std::string> PdfWriter::finish() {
    Drawing& d = *drawing_;
    d.cairo.reset();
    cairo_surface_finish(d.surface.get());
    const cairo_status_t status = cairo_surface_status(d.surface.get());
    if (status != CAIRO_STATUS_SUCCESS)
        return Error{std::string("no PDF can be made: ") + cairo_status_to_string(status), ""};
    return std::move(d.bytes);
}

} // namespace ghost::scene
