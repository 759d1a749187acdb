// SPDX-License-Identifier: Apache-2.0
// 2D symbols of models: whose scale is known, what of them is seen, and what is too much.
#include "fixture_files/common/svg_symbol.h"
#include "support/tiny_gdtf.h"

#include <filesystem>

namespace ghost::fixture {
namespace {

const std::string kSvg = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 200">)";

Result<SvgSymbol> symbol_of(const std::string& text) {
    return read_svg_symbol(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), "a.svg");
}

// A file with models "base" and "head" of those sizes, and their symbols.
LoadedType file_with(const std::vector<std::pair<std::string, std::string>>& svgs,
                     const std::string& more_of_base = "") {
    Description description;
    description.models =
        R"(<Model Name="Base" File="base" PrimitiveType="Cube" Length="0.4" Width="0.2" Height="0.1" )" +
        more_of_base + R"(/><Model Name="Head" File="head" Length="0.1" Width="0.1" Height="0.3"/>)";
    description.geometries =
        R"(<Geometry Name="Base" Model="Base"><Beam Name="Beam" Model="Head"/></Geometry>)";
    auto files = svgs;
    files.insert(files.begin(), {"description.xml", description.xml()});
    Result<LoadedType> result = load_gdtf(make_zip(files), "tiny.gdtf");
    EXPECT_TRUE(result) << result.error().text();
    return result ? std::move(result).value() : LoadedType{};
}

const std::vector<SymbolLine>& top_of(const LoadedType& file, std::size_t model = 0) {
    return file.type.models.at(model).symbols.at(static_cast<std::size_t>(SymbolSide::top));
}

TEST(Symbols, are_in_millimetres_about_the_middle) {
    const LoadedType file =
        file_with({{"models/svg/base.svg", kSvg + R"(<rect x="0" y="0" width="400" height="200"/></svg>)"}});
    ASSERT_EQ(top_of(file).size(), 1u);
    const SymbolLine& line = top_of(file)[0];
    EXPECT_TRUE(line.is_closed);
    EXPECT_TRUE(line.is_filled);
    ASSERT_EQ(line.points_m.size(), 4u);
    EXPECT_NEAR(line.points_m[0].x, -0.2f, 1e-6f);
    EXPECT_NEAR(line.points_m[0].y, 0.1f, 1e-6f) << "y of a drawing goes down";
    EXPECT_NEAR(line.points_m[2].x, 0.2f, 1e-6f);
    EXPECT_TRUE(file.type.models[0].symbols[1].empty());
}

TEST(Symbols, are_put_in_where_the_offset_says) {
    const LoadedType file =
        file_with({{"models/svg/base.svg", kSvg + R"(<rect width="400" height="200"/></svg>)"}},
                  R"(SVGOffsetX="100" SVGOffsetY="50")");
    EXPECT_NEAR(top_of(file).at(0).points_m.at(0).x, -0.1f, 1e-6f);
    EXPECT_NEAR(top_of(file)[0].points_m[0].y, 0.05f, 1e-6f);
}

// As Martin's files: 1024 units a side, whatever the size.
TEST(Symbols, that_fill_a_square_have_the_scale_of_their_model) {
    const std::string square = R"(<svg viewBox="0 0 1024 1024">)";
    const LoadedType file = file_with(
        {{"models/svg/base.svg", square + R"(<rect x="112" y="312" width="800" height="400"/></svg>)"},
         {"models/svg/head.svg", square + R"(<rect x="412" y="212" width="200" height="600"/></svg>)"}});
    EXPECT_NEAR(top_of(file).at(0).points_m.at(0).x, -0.2f, 1e-5f);
    ASSERT_EQ(top_of(file, 1).size(), 1u) << "drawn lying, so it has the unit of the base";
    EXPECT_NEAR(top_of(file, 1)[0].points_m[0].y, 0.15f, 1e-5f);
    const LoadedType alone =
        file_with({{"models/svg/head.svg", square + R"(<rect width="200" height="600"/></svg>)"}});
    EXPECT_TRUE(top_of(alone, 1).empty());
    EXPECT_TRUE(says(alone, {"models/svg", "scale is not known"}));
}

TEST(Symbols, show_what_is_seen) {
    const SvgSymbol symbol =
        std::move(symbol_of(kSvg + R"svg(<style>.a, .b { fill: none; stroke: #000 } .c { opacity: 0 }</style>
<g transform="translate(10 20)"><circle class="a" cx="5" cy="5" r="5"/><rect class="c" width="9" height="9"/>
<path style="fill:#00ff00;fill-opacity:0;stroke:#00ff00;stroke-opacity:0" d="M0 0H9"/>
<g fill="none"><path d="M0 0H9"/></g><line x1="1" y1="1" x2="2" y2="2" stroke="red"/></g>
<image href="http://example.org/a.png" width="9" height="9"/><text>words</text></svg>)svg")
                      .value());
    ASSERT_EQ(symbol.lines.size(), 2u);
    EXPECT_FALSE(symbol.lines[0].is_filled);
    EXPECT_TRUE(symbol.lines[0].is_closed);
    EXPECT_FLOAT_EQ(symbol.low.x, 10.0f);
    EXPECT_NEAR(symbol.high.y, 30.0f, 0.01f);
    EXPECT_FALSE(symbol.lines[1].is_closed);
}

TEST(Symbols, of_bad_files_are_left_out_with_a_word) {
    std::string many = kSvg;
    for (std::size_t i = 0; i <= kMostSymbolLines; ++i) many += R"(<line x2="9" y2="9" stroke="red"/>)";
    std::string deep = kSvg;
    for (int i = 0; i < 40; ++i) deep += "<g>";
    deep += R"(<rect width="9" height="9"/>)";
    for (int i = 0; i < 40; ++i) deep += "</g>";
    std::string long_path = kSvg + "<path d=\"M0 0";
    for (std::size_t i = 0; i <= kMostSymbolPoints; ++i) long_path += " L9 9";
    for (const std::string& bad :
         {std::string(), std::string("<html/>"), kSvg, kSvg + "</svg>", many + "</svg>", deep + "</svg>",
          long_path + "\"/></svg>", std::string(kMostSymbolBytes + 1, ' '),
          kSvg + R"svg(<rect transform="scale(1e6)" width="1e6" height="1e6"/></svg>)svg"})
        EXPECT_FALSE(symbol_of(bad).ok()) << bad.substr(0, 80);
    const LoadedType file = file_with({{"models/svg/base.svg", many + "</svg>"}});
    EXPECT_TRUE(top_of(file).empty());
    EXPECT_TRUE(says(file, {"models/svg/base.svg", "more than 1024 lines", "not used on plans"}));
    const std::string good =
        kSvg + R"(<g class="a"><path d="M0 0C1 1 2 2 3 3z" fill="none" stroke="red"/></g></svg>)";
    for (std::size_t size = 0; size < good.size(); ++size) (void)symbol_of(good.substr(0, size));
}

TEST(Symbols, of_a_type_have_an_end_together) {
    std::vector<std::pair<std::string, std::string>> svgs;
    for (const auto& [side, height] : {std::pair{"svg", "200"}, {"svg_side", "200"}, {"svg_front", "100"}}) {
        std::string fine = std::string(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 )") +
                           height + R"("><path stroke="red" d="M0 0)";
        for (int i = 0; i < 4000; ++i) fine += std::string(" L0 ") + height + " L400 0";
        for (const char* model : {"base", "head"})
            svgs.push_back({std::string("models/") + side + "/" + model + ".svg", fine + R"("/></svg>)"});
    }
    const LoadedType file = file_with(svgs);
    EXPECT_FALSE(top_of(file).empty());
    EXPECT_TRUE(says(file, {"more than 32768 points in all"}));
}

TEST(Symbols, of_a_real_file_are_as_large_as_its_models) {
    const std::string path = "../shared/fixtures/gdtf/bauke_Martin_Professional@MAC_Viper_AirFX.gdtf";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
    const LoadedType file = std::move(load_gdtf(std::filesystem::path(path)).value());
    glm::vec2 low(1e9f), high(-1e9f);
    for (const SymbolLine& line : top_of(file))
        for (const glm::vec2& point : line.points_m) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
    EXPECT_NEAR(high.x - low.x, file.type.models[0].size_m.x, 0.02f);
    EXPECT_NEAR(high.y - low.y, file.type.models[0].size_m.y, 0.02f);
    EXPECT_NEAR(high.x, -low.x, 0.02f);
}

} // namespace
} // namespace ghost::fixture
