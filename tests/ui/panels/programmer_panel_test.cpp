// SPDX-License-Identifier: Apache-2.0
// By hand: several heads at once, all of their parameters, and what the rest of the light does with them.
#include "support/test_window.h"
#include "ui/actions/programmer_actions.h"
#include "ui/model/gel_book.h"
#include "ui/panels/programmer_panel.h"
#include "ui/widgets/colour_field.h"
#include "ui/widgets/theme.h"

#include "fixture_files/gdtf/gdtf.h"
#include "show/show.h"

#include <QDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

namespace ghost::ui {
namespace {

std::shared_ptr<const fixture::Type> spot() {
    static const auto type = [] {
        auto loaded = fixture::load_gdtf(
            std::filesystem::path(GHOST_SOURCE_DIR "/assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
        return std::make_shared<const fixture::Type>(std::move(loaded->type));
    }();
    return type;
}

struct Heads : Bench {
    Heads() {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        for (scene::PatchedFixture& fixture : show->fixtures) {
            fixture.type = spot();
            fixture.address = 0;
        }
        opened.show = show;
        link.opened.put(std::move(opened));
        link.rig.put(four_lit());
        link.on_news();
        settle();
        panel.resize(300, 900);
        panel.show();
        settle();
    }
    // The row of a parameter, by its words.
    ParameterRow* row(const QString& words) {
        for (ParameterRow* const one : panel.findChildren<ParameterRow*>())
            if (one->findChild<QLabel*>()->text() == words) return one;
        return nullptr;
    }
    ValueRow* value(const QString& words) {
        for (ValueRow* const one : panel.findChildren<ValueRow*>())
            if (one->findChild<QLabel*>()->text() == words) return one;
        return nullptr;
    }
    static bool is_warm(const QWidget* row) {
        return row->findChild<QLabel*>()->palette().color(QPalette::WindowText) == accent();
    }

    ProgrammerPanel panel{app, nullptr};
};

TEST(ProgrammerPanel, values_that_differ_are_mixed_until_one_is_given_to_all) {
    Heads heads;
    heads.app.select({0});
    change_selected(heads.app, "pan", ProgrammerStep::pan,
                    [](fixture::Programmer& programmer) { programmer.pan_deg = 30; });
    heads.app.select({0, 1});
    auto* const field = heads.value("Pan")->findChild<MixedSpinBox*>();
    EXPECT_TRUE(field->text().contains("mixed")) << field->text().toStdString();
    EXPECT_TRUE(Heads::is_warm(heads.value("Pan")));
    EXPECT_FALSE(heads.value("Tilt")->findChild<MixedSpinBox*>()->is_mixed());
    // The number of the first, given to both.
    field->setFocus();
    field->selectAll();
    for (const auto& [key, text] : {std::pair{Qt::Key_3, "3"}, {Qt::Key_0, "0"}}) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
        QCoreApplication::sendEvent(field, &event);
    }
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QCoreApplication::sendEvent(field, &enter);
    settle();
    EXPECT_EQ(heads.app.look().fixtures.at(1).pan_deg, 30.0f);
    EXPECT_FALSE(field->is_mixed());
}

TEST(ProgrammerPanel, nothing_is_warm_when_nothing_is_selected) {
    Heads heads;
    heads.app.select({0});
    change_selected(heads.app, "intensity", ProgrammerStep::intensity,
                    [](fixture::Programmer& programmer) { programmer.intensity = 0.5f; });
    ASSERT_TRUE(Heads::is_warm(heads.value("Intensity")));
    heads.app.select({});
    EXPECT_FALSE(Heads::is_warm(heads.value("Intensity")));
}

TEST(ProgrammerPanel, all_parameters_of_the_head_are_there_in_the_words_of_the_field) {
    Heads heads;
    heads.app.select({0, 2});
    settle();
    QStringList words;
    for (const ParameterRow* const row : heads.panel.findChildren<ParameterRow*>())
        words << row->findChild<QLabel*>()->text();
    for (const char* const wanted : {"Iris", "Focus", "Shutter", "Gobo wheel 1", "Gobo 2 turn"})
        EXPECT_TRUE(words.contains(wanted)) << wanted << " among " << words.join(", ").toStdString();
    ParameterRow* const iris = heads.row("Iris");
    ASSERT_TRUE(iris);
    iris->findChild<QSlider*>()->setValue(255);
    settle();
    for (const std::size_t index : {0u, 2u}) {
        const auto& channels = heads.app.look().fixtures.at(index).channels;
        ASSERT_EQ(channels.size(), 1u);
        EXPECT_FLOAT_EQ(channels.begin()->second, 0.25f);
    }
    EXPECT_FALSE(heads.app.look().fixtures.contains(1));
    EXPECT_TRUE(Heads::is_warm(iris));
    heads.app.undo_stack().undo();
    EXPECT_TRUE(heads.app.look().is_empty());
    EXPECT_FALSE(Heads::is_warm(iris));
    // What it can be is a list.
    ParameterRow* const gobo = heads.row("Gobo wheel 1");
    ASSERT_TRUE(gobo);
    const QList<QAction*> choices = gobo->findChild<QMenu*>()->actions();
    ASSERT_GT(choices.size(), 3);
    choices[2]->trigger();
    settle();
    EXPECT_EQ(gobo->findChildren<QToolButton*>().first()->toolTip(), choices[2]->text());
}

// What a hand wants of a strobe is not what it wants of the intensity.
TEST(ProgrammerPanel, a_strobe_by_hand_goes_on_under_an_intensity_by_hand) {
    const fixture::Patch patch{.type = spot().get(), .addresses = {{1, 0}}};
    fixture::Programmer programmer;
    programmer.intensity = 1.0f;
    const auto targets = [&] {
        auto made = fixture::decode_levels(patch, fixture::levels_by_hand(programmer, patch, {}));
        fixture::apply(programmer, patch, made);
        return made;
    };
    ASSERT_FALSE(targets().beams.empty());
    EXPECT_EQ(targets().beams.front().strobe, fixture::Strobe::none);
    for (const fixture::Channel& channel : patch.mode_of().channels)
        for (const fixture::ChannelFunction& function : channel.functions)
            if (function.meaning.role == fixture::Role::strobe)
                programmer.channels[channel.name] = static_cast<float>(function.dmx_from + function.dmx_to) /
                                                    2 / static_cast<float>(channel.max);
    ASSERT_FALSE(programmer.channels.empty());
    EXPECT_NE(targets().beams.front().strobe, fixture::Strobe::none);
    EXPECT_EQ(targets().beams.front().dimmer, 1.0f);
}

TEST(ColourField, a_colour_is_chosen_in_the_panel_itself) {
    Heads heads;
    heads.app.select({0, 1});
    auto* const row = heads.panel.findChild<ColourRow*>();
    row->findChild<QPushButton*>()->click();
    settle();
    for (const QWidget* const one : QApplication::topLevelWidgets())
        EXPECT_FALSE(qobject_cast<const QDialog*>(one)) << "over the picture";
    auto* const hues = row->findChild<HueField*>();
    ASSERT_TRUE(hues && hues->isVisible());
    const QPointF corner(0, hues->height() - 1); // red, saturated
    QMouseEvent press(QEvent::MouseButtonPress, corner, hues->mapToGlobal(corner), Qt::LeftButton,
                      Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(hues, &press);
    settle();
    const glm::vec3 red = *heads.app.look().fixtures.at(1).colour;
    EXPECT_EQ(red.x, 1.0f);
    EXPECT_LT(red.z, 0.1f);
    QKeyEvent right(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
    for (int i = 0; i < 30; ++i) QCoreApplication::sendEvent(hues, &right);
    EXPECT_GT(heads.app.look().fixtures.at(1).colour->y, heads.app.look().fixtures.at(1).colour->x);
}

TEST(GelBook, conversions_are_what_their_mired_say) {
    for (const Gel& gel : gel_book()) {
        const glm::vec3 colour = colour_of(gel, 3200);
        EXPECT_FLOAT_EQ(std::max({colour.x, colour.y, colour.z}), 1.0f) << gel.name;
        if (gel.number != "L201") continue;
        const glm::vec3 daylight = colour_of({"", "", 0, 0}, 5700); // 1e6 / 3200 - 137 = 1e6 / 5698
        EXPECT_NEAR(colour.z, daylight.z, 0.01f);
    }
}

} // namespace
} // namespace ghost::ui
