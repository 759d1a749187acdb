// SPDX-License-Identifier: Apache-2.0
// Text in the code page of Windows becomes UTF-8, text that is UTF-8 or UTF-16 stays.
#include "json_xml_toml/xml_encoding.h"

#include "fixture_files/qxf/qxf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ghost::fixture {
namespace {

std::string repaired(const std::string& text, bool expected = true) {
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    EXPECT_EQ(repair_utf8(bytes), expected) << text;
    return {bytes.begin(), bytes.end()};
}

TEST(xml_encoding, letters_of_windows_become_utf8) {
    EXPECT_EQ(repaired("K\xfc"
                       "che \x96 links, 5 \x80"),
              "K\u00fcche \u2013 links, 5 \u20ac");
    EXPECT_EQ(repaired("\x81"), "\ufffd");
    EXPECT_EQ(repaired("\u00fc and \xfc"), "\u00fc and \u00fc") << "half of it is UTF-8";
    for (const char* broken : {"\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\xf8"})
        EXPECT_NE(repaired(broken), broken);
}

TEST(xml_encoding, what_is_utf8_or_wide_stays) {
    for (const std::string& text :
         {std::string("a"), std::string(""), std::string("\u00fc \u20ac \U0001f4a1"),
          std::string("\xff\xfe<\0\xfc\0", 6), std::string("<\0\xfc\0", 4)})
        EXPECT_EQ(repaired(text, false), text);
}

TEST(xml_encoding, a_definition_keeps_its_umlauts_whatever_it_declares) {
    for (const std::string declared : {"", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>",
                                       "<?xml version=\"1.0\" encoding=\"windows-1252\"?>"}) {
        const std::string text =
            declared +
            "<FixtureDefinition><Manufacturer>J\xfcrgen</Manufacturer><Model>M</Model><Type>Dimmer</Type>"
            "<Channel Name=\"D\" Preset=\"IntensityDimmer\"/><Mode Name=\"m\"><Channel "
            "Number=\"0\">D</Channel>"
            "</Mode></FixtureDefinition>";
        const auto loaded =
            load_qxf(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), "a.qxf");
        ASSERT_TRUE(loaded.ok()) << loaded.error().text();
        EXPECT_EQ(loaded->type.manufacturer, "J\u00fcrgen") << declared;
        EXPECT_TRUE(std::any_of(loaded->messages.begin(), loaded->messages.end(),
                                [](const Message& message) { return message.what == kNotUtf8; }));
    }
}

} // namespace
} // namespace ghost::fixture
