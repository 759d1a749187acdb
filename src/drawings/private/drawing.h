#pragma once
// SPDX-License-Identifier: Apache-2.0
// Drawing: a plan or a section: laid out once at its scale, then drawn on as many sheets as it takes. Points
// of the whole drawing, from its upper left corner, are those of the page after an offset. One thread.

#include "base/result.h"
#include "drawings/drawings.h"
#include "drawings/private/file_symbols.h"
#include "drawings/private/labels.h"
#include "drawings/private/outlines.h"
#include "drawings/private/rigging.h"
#include "drawings/private/sheet.h"
#include "show/show.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

inline constexpr double kSheetOverlap_pt = 10 * kPointsOfMm;
inline constexpr double kLineOfText = 6.8 / 5.5; // of the height of its letters
inline constexpr double kLeastLetters_pt = 5.5;
inline constexpr PdfText kBarText{.size_pt = 7, .is_bold = true};

// Words beside what they name, in points of the whole drawing.
struct DrawnLabel {
    Extent2 box, around;
    std::vector<std::string> lines;
    PdfText look;
    bool is_led = false;
    double line_pt() const { return kLineOfText * look.size_pt; }
};

// Words at the edge of a sheet, on white; "": room for those of match marks. Points of the page.
struct EdgeWords {
    Extent2 box;
    std::string text;
    PdfText look;
};

// One of the sheets that a drawing is spread over. Points of the page.
struct SheetPart {
    Extent2 window;               // of the drawing
    glm::dvec2 offset{0};         // of the drawing's upper left corner
    Extent2 scale_bar;            // with the white about it; empty: the window is too narrow
    std::vector<EdgeWords> words; // HOUSE, UP-STAGE, names of lines
};

struct DrawnSymbol {
    SymbolKind kind = SymbolKind::other;
    SymbolPlace place;
    std::vector<std::vector<glm::dvec2>> bodies; // in a section
    std::vector<FlatLine> lines;                 // in a plan, where the fixture's file has them
    Extent2 box;
    bool is_hidden = false; // in a section: behind an equal one, which is drawn later
};

// Kinds of what a drawing shows.
std::vector<LegendLine> legend_of(const Show& show, const std::vector<RiggedFixture>& rig,
                                  FileSymbols& symbols);

class Drawing {
public:
    Drawing(PdfWriter& pdf, const Show& show, const Stage& stage, const DrawingOptions& options,
            const View& view, bool is_plan, const Rigging& rigging, FileSymbols& file_symbols);

    // How many sheets it takes. scale: gets what is asked for, or fits. Error: too many.
    Result<std::size_t> lay_out(int& scale);
    void draw(TitleBlock title, std::size_t first_sheet, std::size_t sheets,
              const std::vector<LegendLine>& legend, std::size_t& legend_drawn);
    const std::vector<RiggedFixture>& rig() const { return rig_; } // what is not cut away
    // After lay_out.
    const std::vector<DrawnLabel>& labels() const { return labels_; }
    const std::vector<std::string>& remarks() const { return notes_; }
    const std::vector<SheetPart>& sheets() const { return parts_; }
    const std::vector<DrawnSymbol>& symbols() const { return symbols_; }

private:
    void choose_frame(const Outlines& rough);
    // Scale, sheets, symbols. Error: too many.
    Result<void> spread(int& scale);
    glm::dvec2 paper_of(const glm::dvec2& point_m) const {
        const glm::dvec2 from = (point_m - frame_.low) * metre_pt_;
        return {from.x, (frame_.size().y * metre_pt_) - from.y};
    }
    void place_symbols();
    void take_lines(const RiggedFixture& fixture, DrawnSymbol& symbol);
    void hide_what_is_behind();
    Extent2 end_of(const Bar& bar, const glm::vec3& end_m) const;
    void place_bars(Labels& labels);
    void place_labels(Labels& labels);
    std::vector<std::string> words_of(const HungBar& bar);
    std::vector<std::string> words_of(const std::vector<std::size_t>& group) const;
    // False: there is no room.
    bool put(Labels& labels, DrawnLabel label, double widest_pt, std::vector<DrawnLabel>& placed);
    std::vector<std::string> notes(std::size_t unlabelled) const;
    SheetPart part_at(std::size_t column, std::size_t row) const;
    // Puts scale bars and edge words where they cover no symbol, and keeps labels away from them. False: a
    // sheet has no such place for its bar.
    bool furnish(Labels& labels);
    // The first that holds nothing.
    std::optional<Extent2> free_of_symbols(std::span<const Extent2> places, const SheetPart& part) const;
    std::vector<Extent2> match_words(const Extent2& window, std::size_t column, std::size_t row) const;
    double scale_step_m() const;
    void draw_furniture(const SheetPart& part);
    double letters_pt() const; // of what stands beside symbols and of the grid
    void draw_grid(const glm::dvec2& offset, const Extent2& window);
    void draw_lines(const glm::dvec2& offset, const Extent2& window);
    void draw_rig(const glm::dvec2& offset, const Extent2& window);
    void draw_scale_bar(const Extent2& box);
    void draw_match_marks(const Extent2& window, std::size_t column, std::size_t row, std::size_t first);
    double grid_step_m() const;

    PdfWriter& pdf_;
    const Show& show_;
    const Stage& stage_;
    const DrawingOptions& options_;
    const PrintStyle& style_;
    View view_;
    bool is_plan_;
    const Rigging& rigging_;
    FileSymbols& file_symbols_;
    SheetRoom room_;
    std::vector<RiggedFixture> rig_;
    std::vector<std::vector<std::vector<glm::dvec2>>> bodies_; // of the show's fixtures, in a section
    Extent2 frame_;                                            // metres
    double metre_pt_ = 1;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<SheetPart> parts_; // row by row
    Outlines outlines_;
    std::vector<DrawnSymbol> symbols_;
    std::vector<DrawnLabel> labels_;
    std::vector<std::string> notes_;
    std::size_t unnamed_bars_ = 0; // and hanging positions
    std::size_t wordless_ = 0;     // HOUSE, UP-STAGE and names of lines without a place
    bool is_bar_below_ = false;    // the scale bar stands below the drawing, which leaves room for it
    bool is_any_enlarged_ = false; // a symbol would be a dot
};

} // namespace ghost::scene
