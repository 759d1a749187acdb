// SPDX-License-Identifier: Apache-2.0
#include "drawings/drawings.h"

#include "drawings/private/drawing.h"

#include <algorithm>
#include <map>

namespace ghost::scene {
namespace {

std::string type_text(const PatchedFixture& fixture) {
    if (!fixture.type) return "";
    return fixture.type->manufacturer + (fixture.type->manufacturer.empty() ? "" : " ") + fixture.type->name;
}

} // namespace

std::vector<LegendLine> legend_of(const Show& show, const std::vector<RiggedFixture>& rig,
                                  FileSymbols& symbols) {
    struct Kind {
        std::size_t count = 0;
        const PatchedFixture* first = nullptr;
    };
    std::map<std::pair<int, std::string>, Kind> kinds;
    for (const RiggedFixture& fixture : rig) {
        const PatchedFixture& patched = show.fixtures[fixture.fixture];
        Kind& kind = kinds[{static_cast<int>(fixture.kind), type_text(patched)}];
        if (!kind.first) kind.first = &patched;
        ++kind.count;
    }
    std::vector<LegendLine> legend;
    for (const auto& [key, kind] : kinds)
        legend.push_back(
            {static_cast<SymbolKind>(key.first), key.second, kind.count, symbols.from_above(*kind.first)});
    return legend;
}

Result<Drawings> drawings_of(const Show& show, const Stage& stage, const DrawingOptions& options) {
    const PrintStyle& style = options.style;
    const Rigging rigging = rigging_of(show, stage);
    FileSymbols symbols;
    TitleBlock title;
    title.show = show.name.empty() ? show.folder.filename().string() : show.name;
    title.paper = std::string(format_of(options.paper).name);
    title.date = options.date;
    PdfWriter pdf(options.paper, true, title.show + ": " + style("Plan"));
    Drawings made;
    Drawing plan(pdf, show, stage, options, from_above(), true, rigging, symbols);
    Drawing section(pdf, show, stage, options, from_the_side(options.section_x_m), false, rigging, symbols);
    TRY(const std::size_t of_plan, plan.lay_out(made.plan_scale));
    TRY(const std::size_t of_section, section.lay_out(made.section_scale));
    made.sheets = of_plan + of_section;
    for (const std::string& text : {title.show, title.date}) pdf.look_for_boxes(text);
    const std::vector<LegendLine> legend = legend_of(show, plan.rig(), symbols);
    const std::vector<LegendLine> section_legend = legend_of(show, section.rig(), symbols);
    for (const LegendLine& line : legend) pdf.look_for_boxes(line.type);
    made.boxes = pdf.boxes_said(style);
    std::size_t legend_drawn = 0, section_legend_drawn = 0;
    title.title = style("Plan");
    title.remark = style("seen from above, up-stage at the top");
    title.scale = scale_text(made.plan_scale);
    plan.draw(title, 0, made.sheets, legend, legend_drawn);
    title.title = options.section_x_m ? style("Section at x = %1", {style.length_said(*options.section_x_m)})
                                      : style("Section");
    title.remark = style("seen from stage left, the house at the left");
    title.scale = scale_text(made.section_scale);
    section.draw(title, of_plan, made.sheets, section_legend, section_legend_drawn);
    // One for both, unless the cut left something out.
    const std::string of_show = title.show;
    const bool is_cut = section.rig().size() != plan.rig().size();
    if (is_cut) title.show = of_show + ": " + style("Plan");
    const std::size_t rest = is_cut ? legend_drawn : std::min(legend_drawn, section_legend_drawn);
    if (rest < legend.size()) draw_legend_sheet(pdf, style, legend, rest, title);
    title.show = of_show + ": " + title.title;
    if (is_cut && section_legend_drawn < section_legend.size())
        draw_legend_sheet(pdf, style, section_legend, section_legend_drawn, title);
    TRY(made.pdf, pdf.finish());
    return made;
}

} // namespace ghost::scene
