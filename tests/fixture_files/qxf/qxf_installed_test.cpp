// SPDX-License-Identifier: Apache-2.0
// All definitions that come with QLC+, where they are installed (qlcplus-data): channels as an independent
// count has them, and nothing that is not a number whatever they are sent.
#include "fixture/decode.h"
#include "fixture_files/load_type.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace ghost::fixture {
namespace {

const std::filesystem::path kInstalled = "/usr/share/qlcplus/fixtures";

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

TEST(qxf_installed, all_definitions_open_with_their_channels) {
    if (!std::filesystem::exists(kInstalled))
        GTEST_SKIP() << "QLC+ definitions are not installed (qlcplus-data)";
    int files = 0;
    int modes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kInstalled)) {
        if (entry.path().extension() != ".qxf") continue;
        ++files;
        const Result<LoadedType> type = load_type(entry.path());
        ASSERT_TRUE(type.ok()) << type.error().text();
        std::ifstream file(entry.path());
        std::stringstream stream;
        stream << file.rdbuf();
        const std::string text = stream.str();
        std::size_t mode = 0;
        for (std::size_t at = text.find("<Mode "); at != std::string::npos;
             at = text.find("<Mode ", at + 1)) {
            ASSERT_LT(mode, type->type.modes.size()) << entry.path();
            const Mode& made = type->type.modes[mode++];
            const std::size_t channels =
                count_of(text.substr(at, text.find("</Mode>", at) - at), "<Channel Number=");
            EXPECT_EQ(made.footprint.empty() ? 0u : static_cast<std::size_t>(made.footprint[0]), channels)
                << entry.path() << " " << made.name;
            const Patch patch{
                .name = "t", .type = &type->type, .mode = static_cast<int>(mode) - 1, .addresses = {{1, 1}}};
            State state = make_state(patch);
            for (const int value : {0, 90, 255}) {
                const std::vector<std::uint8_t> bytes(512, static_cast<std::uint8_t>(value));
                Levels levels;
                levels.set(1, bytes);
                step(state, patch, decode(patch, levels), 0.02);
                for (const BeamState& beam : state.beams)
                    ASSERT_TRUE(std::isfinite(beam.optics.dimmer) && std::isfinite(beam.to_fixture[3].x) &&
                                beam.optics.zoom_deg > 0.0f)
                        << entry.path();
            }
            ++modes;
        }
        EXPECT_EQ(mode, type->type.modes.size()) << entry.path();
    }
    EXPECT_GT(files, 1000);
    EXPECT_GT(modes, 3000);
}

} // namespace
} // namespace ghost::fixture
