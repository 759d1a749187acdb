// SPDX-License-Identifier: Apache-2.0
// By hand: several heads at once, all of their parameters, and what the rest of the light does with them.
#include "support/test_window.h"
#include "ui/actions/fan_actions.h"
#include "ui/actions/programmer_actions.h"
#include "ui/model/gel_book.h"
#include "ui/model/palette_values.h"
#include "ui/panels/programmer_panel.h"
#include "ui/widgets/colour_field.h"
#include "ui/widgets/theme.h"

#include "fixture_files/gdtf/gdtf.h"
#include "show/show.h"

#include <QComboBox>
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
        add_fan_actions(actions, app);
        panel.resize(300, 900);
        panel.show();
        settle();
    }
    // The row of a parameter, by its words.
    ParameterRow* row(const QString& words) {
        for (ParameterRow* const one : panel.findChildren<ParameterRow*>())
            if (one->findChild<QSlider*>()->accessibleName() == words) return one;
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

    ShowDocument document{app};
    PaletteList palettes{app, document};
    QWidget widget;
    Actions actions{widget};
    ProgrammerPanel panel{app, palettes, actions, nullptr};
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

TEST(ProgrammerPanel, a_step_of_what_is_mixed_moves_each_head_by_one) {
    Heads heads;
    const auto set_pan = [&](std::size_t head, float deg) {
        heads.app.select({head});
        change_selected(heads.app, "pan", ProgrammerStep::step,
                        [&](fixture::Programmer& programmer) { programmer.pan_deg = deg; });
    };
    set_pan(0, 270);
    set_pan(1, -30);
    set_pan(2, 10);
    heads.app.select({0, 1, 2});
    auto* const field = heads.value("Pan")->findChild<MixedSpinBox*>();
    ASSERT_TRUE(field->is_mixed());
    const auto step = static_cast<float>(field->singleStep());
    const auto pan = [&](std::size_t head) { return *heads.app.look().fixtures.at(head).pan_deg; };
    field->stepUp();
    settle();
    EXPECT_FLOAT_EQ(pan(0), 270) << "at its end";
    EXPECT_FLOAT_EQ(pan(1), -30 + step);
    EXPECT_FLOAT_EQ(pan(2), 10 + step);
    EXPECT_TRUE(field->is_mixed());
    field->stepBy(-2);
    settle();
    EXPECT_FLOAT_EQ(pan(0), 270 - 2 * step);
    EXPECT_FLOAT_EQ(pan(1), -30 - step);
    heads.app.undo_stack().undo();
    EXPECT_FLOAT_EQ(pan(2), 10) << "steps in a row are one";
}

TEST(ProgrammerPanel, a_slider_of_what_is_mixed_moves_each_head_by_as_much) {
    Heads heads;
    const auto set = [&](std::size_t head, float deg, float share) {
        heads.app.select({head});
        change_selected(heads.app, "pan", ProgrammerStep::step, [&](fixture::Programmer& programmer) {
            programmer.pan_deg = deg;
            programmer.intensity = share;
        });
    };
    set(0, 0, 0.2f);
    set(1, 200, 0.9f);
    heads.app.select({0, 1});
    const auto now = [&](std::size_t head) { return heads.app.look().fixtures.at(head); };
    auto* const pan = heads.value("Pan")->findChild<QSlider*>();
    const int at = pan->value(); // of the first
    pan->setSliderDown(true);
    pan->setSliderPosition(at + 50);
    const float by = *now(0).pan_deg;
    EXPECT_GT(by, 1);
    EXPECT_FLOAT_EQ(*now(1).pan_deg, 200 + by);
    EXPECT_TRUE(heads.value("Pan")->findChild<MixedSpinBox*>()->text().contains("mixed"));
    // Held at its end, and where it was when the hand comes back.
    pan->setSliderPosition(at + 400);
    EXPECT_FLOAT_EQ(*now(1).pan_deg, 270);
    pan->setSliderPosition(at + 50);
    pan->setSliderDown(false);
    EXPECT_FLOAT_EQ(*now(1).pan_deg, 200 + by);
    EXPECT_FLOAT_EQ(*now(0).pan_deg, by);
    heads.app.undo_stack().undo();
    EXPECT_FLOAT_EQ(*now(0).pan_deg, 0) << "one step";
    EXPECT_FLOAT_EQ(*now(1).pan_deg, 200);
    // Keys go on by themselves.
    auto* const intensity = heads.value("Intensity")->findChild<QSlider*>();
    intensity->setValue(intensity->value() + 50);
    intensity->setValue(intensity->value() + 50);
    EXPECT_NEAR(*now(0).intensity, 0.3f, 1e-4f);
    EXPECT_FLOAT_EQ(*now(1).intensity, 1.0f);
}

TEST(ProgrammerPanel, a_slider_of_a_mixed_parameter_keeps_the_differences) {
    Heads heads;
    for (const auto& [head, share] : {std::pair{std::size_t{0}, 0.25f}, {std::size_t{1}, 0.5f}}) {
        heads.app.select({head});
        heads.row("Iris")->on_change(share);
    }
    heads.app.select({0, 1});
    settle();
    auto* const slider = heads.row("Iris")->findChild<QSlider*>();
    slider->setSliderDown(true);
    slider->setSliderPosition(slider->value() + 102); // a tenth
    slider->setSliderDown(false);
    const auto iris = [&](std::size_t head) {
        return heads.app.look().fixtures.at(head).channels.begin()->second;
    };
    EXPECT_NEAR(iris(0), 0.35f, 0.003f); // what is shown is one of 256 values
    EXPECT_NEAR(iris(1), 0.6f, 0.003f);
    EXPECT_EQ(heads.row("Iris")->findChildren<QToolButton*>().first()->toolTip(), "mixed");
    // One of its list is for all.
    heads.row("Iris")->findChild<QMenu*>()->actions().first()->trigger();
    EXPECT_EQ(iris(0), iris(1));
}

TEST(ProgrammerPanel, a_number_that_is_undone_is_shown_though_its_field_has_the_focus) {
    Heads heads;
    heads.app.select({0});
    auto* const field = heads.value("Tilt")->findChild<MixedSpinBox*>();
    heads.panel.activateWindow();
    field->setFocus();
    settle();
    ASSERT_TRUE(field->hasFocus());
    const double before = field->value();
    field->stepUp();
    EXPECT_NE(field->value(), before);
    heads.app.undo_stack().undo();
    settle();
    EXPECT_EQ(field->value(), before);
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
        words << row->findChild<QSlider*>()->accessibleName();
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

// A colour and a gobo by hand stand above the channels, and an intensity opens the shutter: the rows below
// say so, and what is moved of them goes on from there.
TEST(ProgrammerPanel, rows_show_what_a_value_above_them_makes_of_them) {
    Heads heads;
    heads.app.select({0});
    settle();
    const auto meaning = [&](const char* row) {
        return heads.row(row)->findChildren<QToolButton*>().first()->toolTip();
    };
    const auto share = [&](const char* row) {
        return heads.row(row)->findChild<QSlider*>()->value() / 1020.0;
    };
    EXPECT_EQ(meaning("Shutter"), "Open") << "it was 0 %";
    EXPECT_FALSE(Heads::is_warm(heads.row("Shutter")));
    const auto list = heads.panel.findChildren<QComboBox*>();
    const auto gobo = std::find_if(list.begin(), list.end(),
                                   [](const QComboBox* one) { return one->accessibleName() == "Gobo"; });
    ASSERT_NE(gobo, list.end());
    (*gobo)->setCurrentIndex(3);
    Q_EMIT(*gobo)->activated(3);
    change_selected(heads.app, "colour", ProgrammerStep::colour, [](fixture::Programmer& programmer) {
        programmer.colour = glm::vec3(1, 1, 0);
        programmer.intensity = 1.0f;
    });
    settle();
    EXPECT_EQ("2  " + meaning("Gobo wheel 1"), (*gobo)->itemText(3));
    EXPECT_EQ(heads.panel.findChild<QLabel*>("gobo")->palette().color(QPalette::WindowText), accent());
    for (const char* const row : {"Gobo wheel 1", "Cyan", "Magenta", "Yellow", "Shutter"})
        EXPECT_TRUE(Heads::is_warm(heads.row(row))) << row;
    for (const char* const row : {"Iris", "Focus"}) EXPECT_FALSE(Heads::is_warm(heads.row(row))) << row;
    EXPECT_NEAR(share("Yellow"), 1, 1e-3);
    for (const char* const row : {"Cyan", "Magenta"}) EXPECT_NEAR(share(row), 0, 1e-3);
    const QString chosen = meaning("Gobo wheel 1");
    heads.row("Magenta")->on_change(0.5f);
    heads.row("Gobo 2 turn")->on_change(0.25f);
    settle();
    const fixture::Programmer& programmer = heads.app.look().fixtures.at(0);
    EXPECT_FALSE(programmer.colour);
    EXPECT_FALSE(programmer.gobo);
    EXPECT_NEAR(share("Yellow"), 1, 1e-3) << "it stays";
    EXPECT_NEAR(share("Magenta"), 0.5, 1.0 / 255);
    EXPECT_EQ(meaning("Gobo wheel 1"), chosen);
    heads.row("Yellow")->on_release();
    settle();
    EXPECT_FALSE(Heads::is_warm(heads.row("Yellow")));
    EXPECT_TRUE(Heads::is_warm(heads.row("Magenta")));
}

// What a hand wants of a strobe is not what it wants of the intensity.
QImage picture_of(const QIcon& icon) {
    return icon.pixmap(16, 16).toImage();
}

TEST(ProgrammerPanel, slots_of_wheels_have_their_pictures) {
    Heads heads;
    heads.app.select({0});
    settle();
    const QComboBox* gobos = nullptr;
    for (const QComboBox* const one : heads.panel.findChildren<QComboBox*>())
        if (one->accessibleName() == "Gobo") gobos = one;
    ASSERT_TRUE(gobos);
    ASSERT_GT(gobos->count(), 4);
    EXPECT_TRUE(gobos->itemIcon(0).isNull()) << "what the desk says is no slot";
    for (int i = 1; i < gobos->count(); ++i) {
        ASSERT_FALSE(gobos->itemIcon(i).isNull()) << i;
        for (int k = 1; k < i; ++k)
            EXPECT_NE(picture_of(gobos->itemIcon(i)), picture_of(gobos->itemIcon(k))) << i << " " << k;
    }
    const ParameterRow* const colours = heads.row("Colour wheel 1");
    ASSERT_TRUE(colours);
    int with_picture = 0;
    for (const QAction* const one : colours->findChild<QMenu*>()->actions())
        with_picture += one->icon().isNull() ? 0 : 1;
    EXPECT_GE(with_picture, 3);
}

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

// What the desk asks for is the hand's, warm in every row, and goes back row by row.
TEST(ProgrammerPanel, what_is_held_is_warm_and_given_back_one_by_one) {
    Heads heads;
    heads.app.select({0, 1});
    for (QPushButton* const one : heads.panel.findChildren<QPushButton*>())
        if (one->text() == "Hold (H)") one->click();
    settle();
    EXPECT_TRUE(Heads::is_warm(heads.value("Pan")));
    EXPECT_TRUE(Heads::is_warm(heads.value("Intensity")));
    EXPECT_TRUE(Heads::is_warm(heads.row("Iris")));
    heads.value("Pan")->on_release();
    EXPECT_FALSE(Heads::is_warm(heads.value("Pan")));
    EXPECT_TRUE(Heads::is_warm(heads.value("Tilt")));
    EXPECT_TRUE(Heads::is_warm(heads.row("Iris")));
}

struct FanHeads : Heads {
    FanHeads() {
        app.select({0, 1, 2});
        box->findChild<QToolButton*>()->setChecked(true);
        settle();
    }
    QDoubleSpinBox* number(const QString& name) {
        for (QDoubleSpinBox* const one : box->findChildren<QDoubleSpinBox*>())
            if (one->accessibleName() == name) return one;
        return nullptr;
    }
    void choose(const QString& name, const QString& item) {
        for (QComboBox* const one : box->findChildren<QComboBox*>())
            if (one->accessibleName() == name) {
                one->setCurrentText(item);
                Q_EMIT one->activated(one->currentIndex());
            }
    }
    void press(const QString& text) {
        for (QPushButton* const one : box->findChildren<QPushButton*>())
            if (one->text() == text) one->click();
        settle();
    }
    std::vector<float> pans() {
        std::vector<float> all;
        for (const auto& [index, programmer] : app.look().fixtures)
            all.push_back(programmer.pan_deg.value_or(-999));
        return all;
    }
    FanBox* box = panel.findChild<FanBox*>();
};

TEST(FanBox, a_number_that_is_changed_spreads_at_once_and_all_of_it_is_one_step) {
    FanHeads heads;
    ASSERT_TRUE(heads.number("First"));
    EXPECT_TRUE(heads.number("First")->isVisible());
    EXPECT_TRUE(heads.app.look().is_empty()) << "nothing is done by unfolding";
    heads.number("First")->setValue(-40);
    heads.number("Last")->setValue(40);
    EXPECT_EQ(heads.pans(), (std::vector<float>{-40, 0, 40}));
    heads.choose("How it is spread", "Symmetric");
    EXPECT_EQ(heads.number("Ends")->value(), -40) << "it begins with what they have";
    EXPECT_EQ(heads.number("Middle")->value(), 0);
    EXPECT_EQ(heads.pans(), (std::vector<float>{-40, 0, 40})) << "and does nothing by itself";
    heads.number("Middle")->setValue(10);
    EXPECT_EQ(heads.pans(), (std::vector<float>{-40, 10, -40}));
    heads.app.undo_stack().undo();
    EXPECT_TRUE(heads.app.look().is_empty());
}

TEST(FanBox, aligns_to_the_first_and_the_last_and_spreads_between_them) {
    FanHeads heads;
    heads.choose("What is spread", "Iris");
    heads.number("First")->setValue(0); // open, as they are
    const auto iris = [&](std::size_t index) {
        return heads.app.look().fixtures.at(index).channels.begin()->second;
    };
    EXPECT_NEAR(iris(1), 0.5f, 0.01f); // what is shown is one of 256 values
    heads.press("All as last");
    EXPECT_EQ(iris(0), 1.0f);
    heads.app.undo_stack().undo();
    heads.press("All as first");
    EXPECT_EQ(iris(2), 0.0f);
    heads.app.undo_stack().undo();
    heads.app.select({1});
    EXPECT_FALSE(heads.box->isEnabled()) << "one head is no fan";
    heads.app.select({0, 1, 2});
    heads.press("Between them");
    EXPECT_NEAR(iris(1), 0.5f, 0.01f); // what is shown is one of 256 values
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

TEST(ColourField, the_white_is_one_number_for_slider_field_and_colour) {
    Heads heads;
    heads.app.select({0, 1});
    auto* const row = heads.panel.findChild<ColourRow*>();
    row->findChild<QPushButton*>()->click();
    settle();
    auto* const white = row->findChild<ValueRow*>();
    auto* const field = white->findChild<MixedSpinBox*>();
    auto* const slider = white->findChild<QSlider*>();
    slider->setValue(250); // a quarter of 2000 to 10000 K
    settle();
    EXPECT_EQ(field->text(), "4000 K");
    field->setValue(6000);
    settle();
    EXPECT_EQ(slider->value(), 500);
    EXPECT_EQ(field->text(), "6000 K");
    heads.app.undo_stack().undo();
    settle();
    EXPECT_NE(field->text(), "6000 K") << "undone";
    for (QToolButton* const one : row->findChildren<QToolButton*>())
        if (one->accessibleName() == "Red") one->click();
    settle();
    EXPECT_EQ(field->text(), "\u2013") << "red is no white";
    // The number that stood there before, typed.
    field->setFocus();
    field->selectAll();
    for (const auto& [key, text] :
         {std::pair{Qt::Key_6, "6"}, {Qt::Key_0, "0"}, {Qt::Key_0, "0"}, {Qt::Key_0, "0"}}) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
        QCoreApplication::sendEvent(field, &event);
    }
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QCoreApplication::sendEvent(field, &enter);
    settle();
    EXPECT_EQ(field->text(), "6000 K");
    EXPECT_EQ(slider->value(), 500);
    EXPECT_GT(heads.app.look().fixtures.at(1).colour->z, 0.3f) << "and it is white";
}

TEST(ProgrammerPanel, sliders_are_long_enough_for_a_hand_in_every_column) {
    Heads heads;
    heads.app.select({0, 1});
    for (const int width : {235, 261, 275, 330, 400}) {
        heads.panel.resize(width, 900);
        settle();
        for (const QSlider* const one : heads.panel.findChildren<QSlider*>())
            EXPECT_GE(one->width(), 80) << one->accessibleName().toStdString() << " at " << width;
    }
}

TEST(ColourField, the_gel_is_that_of_the_colour_that_is_there_or_none) {
    Heads heads;
    heads.app.select({0, 1});
    auto* const row = heads.panel.findChild<ColourRow*>();
    row->findChild<QPushButton*>()->click();
    settle();
    QComboBox* gels = nullptr;
    QToolButton *red = nullptr, *release = nullptr;
    for (QComboBox* const one : row->findChildren<QComboBox*>())
        if (one->accessibleName() == "Gel") gels = one;
    for (QToolButton* const one : row->findChildren<QToolButton*>()) {
        if (one->accessibleName() == "Red") red = one;
        if (one->accessibleName() == "Give back Colour") release = one;
    }
    ASSERT_TRUE(gels && red && release);
    const auto choose = [&](int index) {
        gels->setCurrentIndex(index);
        Q_EMIT gels->activated(index);
        settle();
    };
    for (int index = 1; index < gels->count(); ++index) {
        choose(index);
        EXPECT_EQ(gels->currentIndex(), index) << gels->itemText(index).toStdString();
    }
    red->click();
    settle();
    EXPECT_EQ(gels->currentIndex(), 0) << "a swatch";
    choose(3);
    heads.app.undo_stack().undo();
    settle();
    EXPECT_EQ(gels->currentIndex(), 0) << "undone";
    choose(3);
    release->click();
    settle();
    EXPECT_EQ(gels->currentIndex(), 0) << "given back";
    choose(3);
    heads.app.select({2});
    settle();
    EXPECT_EQ(gels->currentIndex(), 0) << "of another head";
    heads.app.select({1, 2});
    settle();
    EXPECT_EQ(gels->currentIndex(), 0) << "mixed";
}

TEST(Words, an_attribute_is_called_the_same_everywhere) {
    scene::PaletteValues palette;
    palette.attributes["ColorSub_C"] = 0.5f;
    palette.attributes["Gobo1Pos"] = 0.25f;
    const std::string words = words_of(palette).toStdString();
    EXPECT_EQ(words, "Cyan 50 %, Gobo 1 turn 25 %");
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

TEST(ProgrammerPanel, all_is_given_back_whenever_a_hand_holds_anything_whatever_is_selected) {
    Heads heads;
    add_programmer_actions(heads.actions, heads.app);
    const auto button = [&](const QString& words) {
        for (QPushButton* const one : heads.panel.findChildren<QPushButton*>())
            if (one->text() == words) return one;
        return static_cast<QPushButton*>(nullptr);
    };
    QPushButton* const some = button("Give back (R)");
    QPushButton* const all = button("Give all back (Shift+R)");
    ASSERT_TRUE(some && all);
    EXPECT_FALSE(some->isEnabled());
    EXPECT_FALSE(all->isEnabled());
    heads.app.select({0, 1});
    ASSERT_TRUE(heads.actions.run("intensity 0.5").ok());
    EXPECT_TRUE(some->isEnabled());
    EXPECT_TRUE(all->isEnabled());
    heads.app.select({2});
    EXPECT_FALSE(some->isEnabled()) << "another's hand";
    EXPECT_TRUE(all->isEnabled());
    heads.app.select({0});
    some->click();
    EXPECT_EQ(heads.app.look().fixtures.count(0), 0u);
    EXPECT_EQ(heads.app.look().fixtures.count(1), 1u);
    heads.app.select({});
    EXPECT_FALSE(some->isEnabled());
    ASSERT_TRUE(all->isEnabled());
    all->click();
    EXPECT_TRUE(heads.app.look().is_empty());
    EXPECT_FALSE(all->isEnabled());
}

} // namespace
} // namespace ghost::ui
