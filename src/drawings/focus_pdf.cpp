// SPDX-License-Identifier: Apache-2.0
#include "drawings/focus.h"
#include "drawings/private/view.h"
#include "print/pdf_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::scene {
namespace {

constexpr double kEdge_pt = 12 * kPointsOfMm, kTop_pt = 30, kGutter_pt = 10;
constexpr std::size_t kAcross = 2, kDown = 5;
constexpr double kLeastPicture_m = 4; // across
constexpr double kWidestGrid = 14;    // squares of a metre
constexpr double kLeastMeasure_m = 0.005;
constexpr double kFactLine_pt = 9.2;
constexpr double kCaption_pt = 8; // below a picture
constexpr double kFigure_pt = 7.5, kBesideArrow_pt = 2.5;
constexpr double kMostSaid_pt = 80; // at the head of the first page

constexpr PdfInk kSquare{.line_grey = 0.85, .width_pt = 0.25};
constexpr PdfInk kAxisLine{.line_grey = 0.35, .width_pt = 0.6, .dash_pt = 6};
constexpr PdfInk kBeamLine{.line_grey = 0.55, .width_pt = 0.35};
constexpr PdfInk kPool{.line_grey = 0, .width_pt = 0.9, .fill_grey = 0.93};
constexpr PdfInk kMeasure{.line_grey = 0.2, .width_pt = 0.35};
constexpr PdfInk kBorder{.line_grey = 0.4, .width_pt = 0.5};
constexpr PdfText kName{.size_pt = 9.5, .is_bold = true};
constexpr PdfText kFact{.size_pt = 7.2};
constexpr PdfText kTiny{.size_pt = 5.8, .is_middle = true};
constexpr PdfText kCaption{.size_pt = 5.8};
constexpr PdfText kSaid{.size_pt = 7, .is_grey = true};

struct CardFact {
    std::string text;
    bool gives_way = false; // a name, which may be as long as somebody likes
};

class FocusPages {
public:
    FocusPages(const FocusChart& chart, PaperSize paper)
        : chart_(chart), style_(chart.style), pdf_(paper, false, chart.show + ": " + style_("Focus charts")) {
    }

    Result<std::string> draw(Report& report) {
        look_for_boxes(report);
        lay_out();
        const std::size_t of_page = kAcross * kDown;
        const std::size_t pages = std::max<std::size_t>(1, (chart_.lamps.size() + of_page - 1) / of_page);
        for (std::size_t page = 0; page < pages; ++page) {
            double top = draw_head(page, pages);
            for (std::size_t k = 0; k < of_page; ++k) {
                const std::size_t lamp = page * of_page + k;
                if (lamp >= chart_.lamps.size()) break;
                draw_card(chart_.lamps[lamp],
                          {kEdge_pt + static_cast<double>(k % kAcross) * (card_.x + kGutter_pt),
                           top + static_cast<double>(k / kAcross) * card_.y});
            }
            pdf_.end_page();
        }
        return pdf_.finish();
    }

private:
    void look_for_boxes(Report& report) {
        pdf_.look_for_boxes(chart_.show);
        for (const FocusLamp& lamp : chart_.lamps)
            for (const std::string* text : {&lamp.name, &lamp.number, &lamp.position, &lamp.focus_point})
                pdf_.look_for_boxes(*text);
        if (const std::string said = pdf_.boxes_said(style_); !said.empty())
            report.add(Severity::warning, "focus.pdf", said);
    }

    // What is said of all of them stands at the head of the first page, and cards have what is left.
    void lay_out() {
        said_ = chart_.moment;
        if (const std::string boxes = pdf_.boxes_said(style_); !boxes.empty()) said_ += " " + boxes + ".";
        for (const std::string& sentence : chart_.unknown) said_ += " " + sentence;
        const double width = pdf_.width_pt() - 2 * kEdge_pt;
        head_pt_ = std::max(11.0, pdf_.height_of(width, kMostSaid_pt, said_, kSaid) + 3);
        card_ = {(width - kGutter_pt) / kAcross,
                 (pdf_.height_pt() - kEdge_pt - kTop_pt - 3 - head_pt_) / kDown};
    }

    double draw_head(std::size_t page, std::size_t pages) {
        const double width = pdf_.width_pt() - 2 * kEdge_pt;
        pdf_.line_of_text(kEdge_pt, kTop_pt - 12, 0.75 * width, chart_.show + ": " + style_("Focus charts"),
                          {.size_pt = 11, .is_bold = true});
        pdf_.line_of_text(kEdge_pt + 0.75 * width, kTop_pt - 10, 0.25 * width,
                          style_("%1 of %2", {std::to_string(page + 1), std::to_string(pages)}),
                          {.size_pt = 8, .is_grey = true, .is_right = true});
        // What is not known is said once.
        pdf_.text(kEdge_pt, kTop_pt + 3, width, head_pt_, page == 0 ? said_ : chart_.moment, kSaid);
        if (page == 0) pdf_.mark(style_("Focus charts"));
        pdf_.line_of_text(kEdge_pt, pdf_.height_pt() - kEdge_pt + 6, width,
                          style_("Left and right as the house sees them. The ellipse is the field (10 %) on "
                                 "the floor that the middle of the beam hits."),
                          {.size_pt = 6, .is_grey = true});
        return kTop_pt + 3 + head_pt_;
    }

    void draw_card(const FocusLamp& lamp, const glm::dvec2& at) {
        const double side = card_.y - 4 - kCaption_pt;
        draw_picture(lamp, at, side);
        const double x = at.x + side + 6, width = card_.x - side - 6;
        double y = at.y;
        const std::string number = lamp.number.empty() ? "" : "(" + lamp.number + ") ";
        y += pdf_.text(x, y, width, 24, number + lamp.name, kName) + 1;
        std::vector<CardFact> facts;
        const auto fact = [&](const std::string& text, bool gives_way = false) {
            if (!text.empty()) facts.push_back({text, gives_way});
        };
        const auto at_place = [&](const glm::vec3& point) {
            return across_text(style_, static_cast<double>(point.x)) + "\n   " +
                   along_text(style_, static_cast<double>(point.y)) + "\n   z " +
                   style_.length_said(static_cast<double>(point.z));
        };
        if (!lamp.position.empty())
            fact((lamp.unit.empty() ? "" : "[" + lamp.unit + "] ") + lamp.position, true);
        fact(style_("place") + ": " + at_place(lamp.place_m));
        if (!lamp.focus_point.empty()) fact(style_("focus point") + ": " + lamp.focus_point, true);
        if (lamp.hit) {
            fact(style_("aims at") + ": " + at_place(lamp.aim_m()));
            if (!lamp.hit->what.empty()) fact(style_("hits") + ": " + lamp.hit->what, true);
        } else if (!lamp.is_aim_known()) {
            fact(style_("aims at") + ": " + style_("not known"));
        } else if (chart_.has_stage) {
            fact(style_("hits nothing"));
        }
        const std::string angle =
            lamp.is_angle_known
                ? style_("angle") + " " + style_.number(static_cast<double>(lamp.angle_deg), 1) + "\xc2\xb0"
                : style_("angle") + ": " + style_("not known");
        fact(lamp.hit ? style_("throw") + " " +
                            style_.length_said(static_cast<double>(lamp.hit->distance_m)) + ", " + angle
                      : angle);
        if (lamp.has_axes)
            fact(axis_text("pan", lamp.is_pan_known, lamp.pan_deg) + ", " +
                 axis_text("tilt", lamp.is_tilt_known, lamp.tilt_deg));
        fact(style_("light") + ": " +
             (lamp.light_percent < 1 ? style_("dark")
                                     : style_.number(static_cast<double>(lamp.light_percent), 0) + " %"));
        draw_facts(facts, {x, y}, width, at.y + side);
    }

    // Figures are whole; names have the lines that these leave, one at least.
    void draw_facts(const std::vector<CardFact>& facts, glm::dvec2 at, double width, double end) {
        constexpr double kGap_pt = 0.6;
        double spare = end - at.y;
        for (const CardFact& fact : facts)
            spare -= kGap_pt +
                     (fact.gives_way ? kFactLine_pt : pdf_.height_of(width, end - at.y, fact.text, kFact));
        for (const CardFact& fact : facts) {
            if (at.y + kFactLine_pt > end) return;
            const double most = fact.gives_way ? kFactLine_pt + std::max(spare, 0.0) : end - at.y;
            const double height = pdf_.text(at.x, at.y, width, most, fact.text, kFact);
            if (fact.gives_way) spare -= height - kFactLine_pt;
            at.y += height + kGap_pt;
        }
    }

    std::string axis_text(Word axis, bool is_known, float angle_deg) const {
        return is_known ? style_(axis) + " " + style_.number(static_cast<double>(angle_deg), 1) + "\xc2\xb0"
                        : style_(axis) + ": " + style_("not known");
    }

    std::string without_floor(const FocusLamp& lamp) const {
        if (!lamp.is_aim_known()) return style_("aims at") + ": " + style_("not known");
        return lamp.hit || !chart_.has_stage ? style_("hits no floor") : style_("hits nothing");
    }

    // The floor from above, up-stage at the top, the aim in the middle of what is shown.
    void draw_picture(const FocusLamp& lamp, const glm::dvec2& at, double side) {
        const std::array frame{at, at + glm::dvec2(side, 0), at + glm::dvec2(side), at + glm::dvec2(0, side)};
        pdf_.shape(frame, true, kBorder);
        if (!lamp.is_on_floor) {
            pdf_.line_of_text(at.x + 2, at.y + 0.5 * side - 4, side - 4, without_floor(lamp),
                              {.size_pt = 7, .is_grey = true, .is_middle = true});
            return;
        }
        const glm::dvec2 aim(glm::vec2(lamp.aim_m()));
        Extent2 shown;
        shown.include(aim);
        for (const glm::dvec2& point : lamp.pool_m) shown.include(point);
        const double across =
            std::clamp(1.3 * std::max(shown.size().x, shown.size().y), kLeastPicture_m, 60.0);
        const glm::dvec2 middle = shown.size().x > 60 || shown.size().y > 60 ? aim : shown.middle();
        const double metre = side / across;
        const auto paper = [&](const glm::dvec2& point) {
            return at + glm::dvec2(0.5 * side + (point.x - middle.x) * metre,
                                   0.5 * side - (point.y - middle.y) * metre);
        };
        pdf_.begin_clip(at.x, at.y, side, side);
        draw_squares(middle, across, paper);
        std::vector<glm::dvec2> pool;
        for (const glm::dvec2& point : lamp.pool_m) pool.push_back(paper(point));
        if (lamp.is_pool_whole && !pool.empty())
            pdf_.shape(pool, true, kPool);
        else if (!pool.empty())
            pdf_.shape(pool, false, {.line_grey = 0, .width_pt = 0.9});
        pdf_.lines(std::array{paper(glm::dvec2(glm::vec2(lamp.lens_m))), paper(aim)}, kBeamLine);
        pdf_.circle(paper(glm::dvec2(glm::vec2(lamp.lens_m))), 2,
                    {.line_grey = 0, .width_pt = 0.4, .fill_grey = 0});
        draw_measures(aim, at, side, paper);
        pdf_.circle(paper(aim), 1.4, {.line_grey = 0, .width_pt = 0.6, .fill_grey = 1});
        pdf_.end_clip();
        pdf_.shape(frame, true, kBorder);
        std::string caption = style_("a square: %1", {style_.length_said(step_of(across))});
        if (!lamp.is_pool_whole) caption += "; " + style_("its edge reaches no floor");
        if (!lamp.is_angle_known) caption += "; " + style_("angle") + ": " + style_("not known");
        pdf_.line_of_text(at.x, at.y + side + 0.5, card_.x, caption, kCaption);
    }

    double step_of(double across) const {
        const double unit_m = style_.units == Units::metric ? 1.0 : 0.3048;
        return across / unit_m > kWidestGrid ? 5 * unit_m : unit_m;
    }

    void draw_squares(const glm::dvec2& middle, double across, const auto& paper) {
        const double step = step_of(across);
        const glm::dvec2 low = middle - 0.5 * across, high = middle + 0.5 * across;
        std::vector<glm::dvec2> ends;
        for (double x = std::ceil(low.x / step) * step; x <= high.x; x += step)
            ends.insert(ends.end(), {paper({x, low.y}), paper({x, high.y})});
        for (double y = std::ceil(low.y / step) * step; y <= high.y; y += step)
            ends.insert(ends.end(), {paper({low.x, y}), paper({high.x, y})});
        pdf_.lines(ends, kSquare);
        pdf_.lines(std::array{paper({0, low.y}), paper({0, high.y}), paper({low.x, 0}), paper({high.x, 0})},
                   kAxisLine);
    }

    // To the centre line and to the set line; where they are outside of the picture, up to its edge.
    void draw_measures(const glm::dvec2& aim, const glm::dvec2& at, double side, const auto& paper) {
        const glm::dvec2 from = paper(aim);
        const glm::dvec2 low = at + 3.0, high = at + side - 3.0;
        const glm::dvec2 to_centre = glm::clamp(paper({0, aim.y}), low, high);
        const glm::dvec2 to_set = glm::clamp(paper({aim.x, 0}), low, high);
        pdf_.lines(std::array{from, to_centre, from, to_set}, kMeasure);
        for (const glm::dvec2& end : {to_centre, to_set}) {
            if (glm::distance(from, end) < 4) continue;
            const glm::dvec2 back = 3.0 * glm::normalize(from - end), aside(-0.4 * back.y, 0.4 * back.x);
            pdf_.shape(std::array{end, end + back + aside, end + back - aside}, true,
                       {.line_grey = -1, .fill_grey = 0.2});
        }
        // Each figure on the side of its arrow where the other arrow is not.
        const bool is_set_below = to_set.y >= from.y, is_centre_right = to_centre.x > from.x;
        figure(aim.x, low, high, [&](double width) {
            return glm::dvec2(0.5 * (from.x + to_centre.x - width),
                              is_set_below ? from.y - kBesideArrow_pt - kFigure_pt
                                           : from.y + kBesideArrow_pt);
        });
        figure(aim.y, low, high, [&](double width) {
            const double left = from.x - kBesideArrow_pt - width, right = from.x + kBesideArrow_pt;
            const double middle = 0.5 * (from.y + to_set.y - kFigure_pt);
            const bool has_room = is_centre_right ? left >= low.x : right + width <= high.x;
            if (has_room)
                return glm::dvec2(is_centre_right ? left : right,
                                  is_set_below ? std::max(middle, from.y - 1)
                                               : std::min(middle, from.y + 1 - kFigure_pt));
            return glm::dvec2(is_centre_right ? right : left,
                              is_set_below ? std::max(middle, from.y + kBesideArrow_pt)
                                           : std::min(middle, from.y - kBesideArrow_pt - kFigure_pt));
        });
    }

    // place: of its upper left corner, for its width.
    void figure(double distance_m, const glm::dvec2& low, const glm::dvec2& high, const auto& place) {
        if (std::abs(distance_m) < kLeastMeasure_m) return; // on the line
        const std::string text = style_.length_said(std::abs(distance_m));
        const double width = pdf_.width_of(text, kTiny) + 1.5;
        const glm::dvec2 at = glm::clamp(place(width), low, high - glm::dvec2(width, kFigure_pt));
        pdf_.fill(at.x, at.y, width, kFigure_pt, 1);
        pdf_.line_of_text(at.x, at.y, width, text, kTiny);
    }

    const FocusChart& chart_;
    const PrintStyle& style_;
    PdfWriter pdf_;
    std::string said_;
    double head_pt_ = 0; // of what the first page says
    glm::dvec2 card_{0};
};

} // namespace

Result<std::string> pdf_of(const FocusChart& chart, PaperSize paper, Report& report) {
    return FocusPages(chart, paper).draw(report);
}

} // namespace ghost::scene
