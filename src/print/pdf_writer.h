#pragma once
// SPDX-License-Identifier: Apache-2.0
// PdfWriter: pages of text, lines, shapes and pictures as PDF, with embedded fonts of every script that the
// machine has. Points, from the upper left corner. Equal calls give equal bytes. One thread at a time; other
// writers beside it on others.

#include "base/result.h"
#include "image/image.h"
#include "print/paper_size.h"
#include "print/print_style.h"

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>

namespace ghost::scene {

struct PdfText {
    double size_pt = 9;
    bool is_bold = false;
    bool is_grey = false;
    bool is_right = false;  // aligned
    bool is_middle = false; // aligned
};

// How a shape is drawn. 0 is black, 1 is white; below 0: not at all.
struct PdfInk {
    double line_grey = 0;
    double width_pt = 0.5;
    double fill_grey = -1;
    double dash_pt = 0; // with a dot between two of them; 0: none
};

class PdfWriter {
public:
    PdfWriter(PaperSize paper, bool is_wide, const std::string& title);
    ~PdfWriter();

    double width_pt() const { return width_pt_; }
    double height_pt() const { return height_pt_; }

    // On the page that is open. What is wider is broken into lines, a number and its unit stay together; what
    // is higher ends in "…". The height that it takes.
    double text(double x, double y, double width, double height, const std::string& text,
                const PdfText& look);
    // The height that it would take; 0: no text, or no room for a line.
    double height_of(double width, double height, const std::string& text, const PdfText& look);
    // In one line: what is wider ends in "…".
    void line_of_text(double x, double y, double width, const std::string& text, const PdfText& look);
    // Width that it has in one line, at most 1000 letters of it.
    double width_of(const std::string& text, const PdfText& look);
    // Of a text that is going to be drawn: whether no font of this machine has one of its letters.
    void look_for_boxes(const std::string& text);
    // A sentence about such texts; "": there is none.
    std::string boxes_said(const PrintStyle& style) const;
    void line(double x, double y, double to_x, double to_y);
    void fill(double x, double y, double width, double height, double grey);
    void shape(std::span<const glm::dvec2> points, bool is_closed, const PdfInk& ink);
    // Every two points are a line of its own.
    void lines(std::span<const glm::dvec2> ends, const PdfInk& ink);
    void circle(const glm::dvec2& middle, double radius, const PdfInk& ink);
    // What is drawn until end_clip stays within.
    void begin_clip(double x, double y, double width, double height);
    void end_clip();
    // Packed as JPEG, which no picture of a show suffers from on paper.
    Result<void> picture(double x, double y, double width, double height, const image::Image8& pixels);
    // An entry of the list of contents that leads to the open page.
    void mark(const std::string& name);
    void end_page();
    Result<std::string> finish();

private:
    struct Drawing;
    void paint(const PdfInk& ink);
    void set_text(const std::string& text, const PdfText& look);

    double width_pt_, height_pt_;
    int page_ = 1;
    std::string boxed_; // the first text with such a letter
    std::unique_ptr<Drawing> drawing_;
};

} // namespace ghost::scene
