// SPDX-License-Identifier: Apache-2.0
// Photometric files: known fluxes of literal files, every symmetry, and what broken ones are told.
#include "fixture_files/ies_ldt/photometric.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace ghost::fixture {
namespace {

constexpr double kPi = std::numbers::pi;

// 1000 cd from 0 to 90 degrees: a half sphere of 2 pi sr.
std::string ies(const std::string& header = "IESNA:LM-63-2002", const std::string& tilt = "TILT=NONE\n",
                const std::string& numbers = "1 -1 1 3 1 1 2 0 0 0\n1 1 100\n0 45 90\n0\n1000 1000 1000\n") {
    return header + "\r\n[TEST] none\r\n[LUMINAIRE] Half sphere\r\n" + tilt + numbers;
}

std::string ldt(const std::string& symmetry, const std::string& planes, const std::string& c_angles,
                const std::string& candela, const std::string& flux = "2000") {
    std::string text =
        "Maker\n1\n" + symmetry + "\n" + planes + "\n90\n3\n45\nreport\nLantern\n7\nfile\ndate\n";
    for (int k = 0; k < 9; ++k) text += "100\n";
    text += "100\n100\n1,0\n0\n1\n1\nlamp\n" + flux + "\n3200\n1A\n1000\n"; // a comma as Germans write it
    for (int k = 0; k < 10; ++k) text += "0.5\n";
    return text + c_angles + "0\n45\n90\n" + candela;
}

double error_percent(double value, double expected) {
    return 100.0 * std::abs(value / expected - 1.0);
}

TEST(photometric, integrates_a_half_sphere_and_a_cosine) {
    const auto half = parse_ies(ies(), "a.ies");
    ASSERT_TRUE(half.ok()) << half.error().text();
    EXPECT_EQ(half->light.name, "Half sphere");
    EXPECT_LT(error_percent(half->light.flux_lm(), 2.0 * kPi * 1000.0), 1e-3);
    EXPECT_LT(error_percent(half->light.flux_lm(60.0), kPi * 1000.0), 1e-3);
    std::string angles, candela;
    for (int k = 0; k <= 90; ++k) {
        angles += std::to_string(k) + " ";
        candela +=
            std::to_string(1000.0 * std::cos(k * kPi / 180.0)) + "\n"; // every value on a line of its own
    }
    const auto lambert = parse_ies(ies("IES:LM-63-2019", "TILT=NONE\n",
                                       "1 -1 1 91 1 1 2 0 0 0 1 1.10001 100 " + angles + "\n0\n" + candela),
                                   "b.ies");
    ASSERT_TRUE(lambert.ok()) << lambert.error().text();
    EXPECT_LT(error_percent(lambert->light.flux_lm(), kPi * 1000.0), 0.02)
        << "2019's last but one number is no factor";
}

TEST(photometric, multiplies_by_the_factors_of_its_time) {
    const auto of_1995 = parse_ies(
        ies("IESNA:LM-63-1995", "TILT=NONE\n", "1,1000,2,3,1,1,2,0,0,0\n0.5 0.8 100\n0 45 90\n0\n10 10 10"),
        "a.ies");
    ASSERT_TRUE(of_1995.ok()) << of_1995.error().text();
    EXPECT_NEAR(of_1995->light.at(0, 30), 8.0f, 1e-4f);
    const auto of_2002 = parse_ies(
        ies("IESNA:LM-63-2002", "TILT=NONE\n", "1 1000 2 3 1 1 2 0 0 0\n0.5 0.8 100\n0 45 90\n0\n10 10 10"),
        "a.ies");
    ASSERT_TRUE(of_2002.ok());
    EXPECT_NEAR(of_2002->light.at(0, 30), 10.0f, 1e-4f);
}

// A byte order mark, small letters, and the labels of 1986, when the second factor was one of the lamp.
TEST(photometric, reads_what_programs_and_years_write) {
    const std::string numbers = "1 1000 2 3 1 1 2 0 0 0\n0.5 0.8 100\n0 45 90\n0\n10 10 10";
    for (const auto& [text, candela] :
         {std::pair{"\xEF\xBB\xBF" + ies("IESNA:LM-63-2002", "TILT=NONE\n", numbers), 10.0f},
          {ies("iesna:lm-63-1995", "tilt=none\n", numbers), 8.0f},
          {"A spotlight\nof a laboratory\nTILT=NONE\n" + numbers, 8.0f},
          {"TILT=NONE\n" + numbers, 8.0f}}) {
        const auto loaded = parse_ies(text, "a.ies");
        ASSERT_TRUE(loaded.ok()) << loaded.error().text();
        EXPECT_NEAR(loaded->light.at(0, 30), candela, 1e-4f) << text;
        EXPECT_TRUE(loaded->messages.empty());
    }
}

TEST(photometric, unfolds_every_symmetry_of_ies) {
    const auto of = [](const std::string& planes, const std::string& candela) {
        auto loaded =
            parse_ies(ies("IESNA:LM-63-2002", "TILT=NONE\n", "1 -1 1 3 " + planes + candela), "a.ies");
        EXPECT_TRUE(loaded.ok()) << loaded.error().text();
        return loaded.ok() ? loaded->light
                           : Photometric{.gamma_deg = {0, 90}, .c_deg = {0}, .candela = {{0, 0}}};
    };
    const std::string head = " 1 2 0 0 0 1 1 9 0 45 90 ";
    const Photometric quarter = of("3" + head, "0 45 90 1 1 1 2 2 2 3 3 3");
    for (const auto& [c, candela] : {std::pair{0.0f, 1.0f},
                                     {45.0f, 2.0f},
                                     {90.0f, 3.0f},
                                     {135.0f, 2.0f},
                                     {180.0f, 1.0f},
                                     {225.0f, 2.0f},
                                     {270.0f, 3.0f},
                                     {315.0f, 2.0f},
                                     {337.5f, 1.5f},
                                     {-45.0f, 2.0f}})
        EXPECT_NEAR(quarter.at(c, 20), candela, 1e-5f) << c;
    const Photometric half = of("3" + head, "0 90 180 1 1 1 2 2 2 3 3 3");
    for (const auto& [c, candela] :
         {std::pair{0.0f, 1.0f}, {90.0f, 2.0f}, {180.0f, 3.0f}, {270.0f, 2.0f}, {315.0f, 1.5f}})
        EXPECT_NEAR(half.at(c, 20), candela, 1e-5f) << c;
    const Photometric side = of("3" + head, "90 180 270 1 1 1 2 2 2 3 3 3");
    for (const auto& [c, candela] :
         {std::pair{90.0f, 1.0f}, {180.0f, 2.0f}, {270.0f, 3.0f}, {0.0f, 2.0f}, {45.0f, 1.5f}})
        EXPECT_NEAR(side.at(c, 20), candela, 1e-5f) << c;
    const Photometric whole = of("4" + head, "0 90 180 360 1 1 1 2 2 2 3 3 3 1 1 1");
    for (const auto& [c, candela] : {std::pair{0.0f, 1.0f}, {90.0f, 2.0f}, {180.0f, 3.0f}, {270.0f, 2.0f}})
        EXPECT_NEAR(whole.at(c, 20), candela, 1e-5f) << c;
    // Half a turn at 1..3 and back: the mean of the flux is that of 2 cd.
    for (const Photometric* light : {&quarter, &half, &side, &whole})
        EXPECT_LT(error_percent(light->flux_lm(), 2.0 * 2.0 * kPi), 1e-3);
}

TEST(photometric, reads_eulumdat_per_thousand_lumens) {
    const auto round = parse_ldt(ldt(
                                     "1", "24",
                                     [] {
                                         std::string angles;
                                         for (int k = 0; k < 24; ++k) angles += std::to_string(15 * k) + "\n";
                                         return angles;
                                     }(),
                                     "100\n100\n100\n"),
                                 "a.ldt");
    ASSERT_TRUE(round.ok()) << round.error().text();
    EXPECT_EQ(round->light.name, "Lantern");
    EXPECT_NEAR(round->light.at(77, 30), 200.0f, 1e-4f) << "2000 lm of lamps";
    EXPECT_LT(error_percent(round->light.flux_lm(), 2.0 * kPi * 200.0), 1e-3);
}

TEST(photometric, unfolds_every_symmetry_of_eulumdat) {
    const std::string c_angles = "0\n90\n180\n270\n";
    const auto plane = [](int candela) {
        const std::string one = std::to_string(candela) + "\n";
        return one + one + one;
    };
    struct Case {
        std::string isym, candela;
        float expected[4]; // at C 0, 90, 180, 270, for 1000 lm
    };
    for (const Case& one : {Case{"0", plane(1) + plane(2) + plane(3) + plane(4), {1, 2, 3, 4}},
                            Case{"2", plane(1) + plane(2) + plane(3), {1, 2, 3, 2}},
                            Case{"3", plane(1) + plane(2) + plane(3), {2, 3, 2, 1}},
                            Case{"4", plane(1) + plane(2), {1, 2, 1, 2}}}) {
        const auto loaded = parse_ldt(ldt(one.isym, "4", c_angles, one.candela, "1000"), "a.ldt");
        ASSERT_TRUE(loaded.ok()) << one.isym << " " << loaded.error().text();
        for (int k = 0; k < 4; ++k)
            EXPECT_NEAR(loaded->light.at(90.0f * static_cast<float>(k), 10), one.expected[k], 1e-5f)
                << one.isym << " " << k;
    }
}

TEST(photometric, broken_files_are_refused_with_place_and_reason) {
    const auto numbers = [](const std::string& text) { return ies("IESNA:LM-63-2002", "TILT=NONE\n", text); };
    const std::pair<std::string, const char*> ies_cases[] = {
        {"", "begins with"},
        {"IESNA:LM-63-2002\nno more", "TILT"},
        {"a letter\nto somebody\n", "begins with 'a letter'"},
        {ies("IESNA:LM-63-1958"), "expected IESNA:LM-63-1995"},
        {numbers("1 -1 1 3 1 2 2 0 0 0 1 1 1 0 45 90 0 1 1 1"), "type B"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 0 90 45 0 1 1 1"), "do not rise"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 0 45 190 0 1 1 1"), "190"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 0 45 90 0 1 nan 1"), "nan"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 0 45 90 0 1 -5 1"), "candela"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 0 45 90 0 0 0 0"), "no light"},
        {numbers("1 -1 1 1e9 1 1 2 0 0 0 1 1 1 0"), "vertical angles"},
        {numbers("1 -1 1 2.5 1 1 2 0 0 0 1 1 1 0"), "whole number"},
        {numbers("1 -1 1 3 2 1 2 0 0 0 1 1 1 0 45 90 0 120 1 1 1 1 1 1"), "horizontal"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 90 135 180 0 1 1 1"), "upwards"},
        {numbers("1 -1 1 3 1 1 2 0 0 0 1 1 1 0 45 90 0 1 1"), "ends before"},
    };
    for (const auto& [text, said] : ies_cases) {
        const auto loaded = parse_ies(text, "lamp.ies");
        ASSERT_FALSE(loaded.ok()) << said;
        EXPECT_NE(loaded.error().text().find(said), std::string::npos) << loaded.error().text();
        EXPECT_NE(loaded.error().text().find("lamp.ies"), std::string::npos);
    }
    const std::string good = ldt("2", "4", "0\n90\n180\n270\n", "1\n1\n1\n1\n1\n1\n1\n1\n1\n");
    ASSERT_TRUE(parse_ldt(good, "a.ldt").ok());
    const std::pair<std::string, const char*> ldt_cases[] = {
        {ldt("5", "4", "0\n90\n180\n270\n", ""), "symmetry"},
        {ldt("4", "6", "0\n60\n120\n180\n240\n300\n", "1\n1\n1\n1\n1\n1\n"), "multiple of 4"},
        {ldt("0", "4", "0\n180\n90\n270\n", ""), "do not rise"},
        {ldt("0", "4", "0\n90\n180\n270\n", "1\n1\nx\n"), "'x'"},
        {ldt("2", "4", "0\n90\n180\n270\n", "1\n1\n1\n1\n1\n1\n1\n1\n1\n", "0"), "flux of its lamps"},
        {good.substr(0, good.size() - 3), "ends before"},
    };
    for (const auto& [text, said] : ldt_cases) {
        const auto loaded = parse_ldt(text, "lamp.ldt");
        ASSERT_FALSE(loaded.ok()) << said;
        EXPECT_NE(loaded.error().text().find(said), std::string::npos) << loaded.error().text();
    }
}

// Cut anywhere: an error, or a file whose last number lost a digit; never a crash.
TEST(photometric, survives_truncation) {
    const std::string whole = ies();
    for (std::size_t size = 0; size < whole.size(); ++size) (void)parse_ies(whole.substr(0, size), "a.ies");
    const std::string other = ldt("2", "4", "0\n90\n180\n270\n", "1\n1\n1\n1\n1\n1\n1\n1\n1\n");
    for (std::size_t size = 0; size + 20 < other.size(); ++size)
        EXPECT_FALSE(parse_ldt(other.substr(0, size), "a.ldt").ok()) << size;
}

TEST(photometric, says_that_tilt_is_left_out) {
    const auto loaded =
        parse_ies(ies("IESNA:LM-63-2002", "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8\n"), "a.ies");
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    ASSERT_EQ(loaded->messages.size(), 1u);
    EXPECT_NE(loaded->messages[0].what.find("TILT=INCLUDE"), std::string::npos);
}

} // namespace
} // namespace ghost::fixture
