// SPDX-License-Identifier: Apache-2.0
#include "ui/model/head_parameters.h"

#include "fixture_files/gdtf/gdtf.h"
#include "show/show.h"

#include <gtest/gtest.h>

namespace ghost::ui {
namespace {

TEST(HeadParameters, each_range_of_a_wheel_has_a_name_of_its_own) {
    scene::Show show;
    show.fixtures.resize(1);
    auto loaded = fixture::load_gdtf(GHOST_SOURCE_DIR "/assets/fixtures/Vari-Lite@VL2500_Spot.gdtf");
    ASSERT_TRUE(loaded.ok());
    show.fixtures[0].type = std::make_shared<const fixture::Type>(std::move(loaded->type));
    std::size_t spins = 0;
    for (const HeadParameter& parameter : parameters_of(show, {0})) {
        std::set<QString> names;
        for (const ParameterRange& range : parameter.ranges) {
            EXPECT_TRUE(names.insert(range.name).second) << range.name.toStdString();
            spins += range.name.startsWith("Gobo wheel 1 spins: ");
        }
    }
    EXPECT_EQ(spins, 3u) << "one way, stop, the other way";
}

TEST(HeadParameters, an_attribute_without_words_of_its_own_is_read_word_by_word) {
    EXPECT_EQ(attribute_words("Gobo1WheelSpin"), "Gobo wheel 1 spins");
    EXPECT_EQ(attribute_words("Effects2AdjustRate"), "Effects 2 Adjust Rate");
    EXPECT_EQ(attribute_words("Blade3A"), "Blade 3A");
    EXPECT_EQ(attribute_words("NoFeature"), "No function");
}

} // namespace
} // namespace ghost::ui
