#pragma once
// SPDX-License-Identifier: Apache-2.0
// PdfWriter: pages of text, lines and pictures as PDF, with embedded fonts of every script that the machine
// has. Points, from the upper left corner. Equal calls give equal bytes. One thread at a time.

#include "base/result.h"
#include "book/html.h"
#include "image/image.h"

#include <memory>
#include <string>

namespace ghost::scene {

struct PdfText {
    double size_pt = 9;
    bool is_bold = false;
    bool is_grey = false;
    bool is_right = false; // aligned
};

class PdfWriter {
public:
    PdfWriter(PaperSize paper, bool is_wide, const std::string& title);
    ~PdfWriter();

    double width_pt() const { return width_pt_; }
    double height_pt() const { return height_pt_; }

    // On the page that is open. What is wider is broken into lines, what is higher ends in "…". The height
    // that it takes.
    double text(double x, double y, double width, double height, const std::string& text,
                const PdfText& look);
    // In one line: what is wider ends in "…".
    void line_of_text(double x, double y, double width, const std::string& text, const PdfText& look);
    // Width that it has in one line, at most 1000 letters of it.
    double width_of(const std::string& text, const PdfText& look);
    void line(double x, double y, double to_x, double to_y);
    void fill(double x, double y, double width, double height, double grey);
    // Packed as JPEG, which no picture of a show suffers from on paper.
    Result<void> picture(double x, double y, double width, double height, const image::Image8& pixels);
    // An entry of the list of contents that leads to the open page.
    void mark(const std::string& name);
    void end_page();
    Result<std::string> finish();

private:
    struct Drawing;
    void set_text(const std::string& text, const PdfText& look);

    double width_pt_, height_pt_;
    int page_ = 1;
    std::unique_ptr<Drawing> drawing_;
};

} // namespace ghost::scene
