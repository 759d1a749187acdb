// SPDX-License-Identifier: Apache-2.0
// Edits of show.toml, a few one after the other: each is refused, or gives a text that is a show as before,
// with every comment outside of what was edited. Input: sixteen bytes for four edits, then the text.
#include "json_xml_toml/toml_text.h"
#include "show_file/air_edit.h"
#include "show_file/cue_edit.h"
#include "show_file/object_edit.h"
#include "show_file/palette_edit.h"
#include "show_file/show_edit.h"
#include "show_file/show_toml.h"
#include "show_file/substitute_edit.h"

#include <cstdlib>
#include <map>
#include <set>

using namespace ghost;
using namespace ghost::scene;

namespace {

constexpr int kEdits = 23;
constexpr int kFirstThatTakesAway = 18; // from here on comments go along with what they are in

const char* const kWords[] = {"house",       "Spot 1",       "a.gdtf", "",         "\"", "\\",
                              "[[fixture]]", "# no comment", "a\nb",   "\xc3\xa9", "\t", "x.y"};

Result<std::string> edit(const std::string& text, const ParsedShow& parsed, int what, std::size_t index,
                         const std::string& word, float number) {
    const Show& show = parsed.show;
    const glm::vec3 place(number, -number, 2);
    Cue cue;
    cue.name = cue.notes = word;
    cue.at_s = number;
    Palette palette;
    palette.name = word;
    palette.values.pan_deg = palette.fixtures[word].tilt_deg = number;
    const FixturePlace fixture{index, ""};
    switch (what) {
    case 0:
        return edit_fixtures(
            text, {{fixture,
                    {.name = word, .mode = word, .address = fixture::Address{3, static_cast<int>(index)}}}});
    case 1:
        return edit_fixtures(
            text, {{fixture, {.position_m = place, .rotation_deg = place}}, {{0, word}, {.hidden = true}}});
    case 2:
        return copy_fixture(text, index, {.name = word, .position_m = place});
    case 3:
        return add_fixture(text, {word, {.name = word, .position_m = place}});
    case 4:
        return add_camera(text, {.name = word, .position_m = place});
    case 5:
        return add_model(text, word, place);
    case 6:
        return set_of_show(text, "plot", word);
    case 7:
        return edit_haze(text, {.extinction_per_m = number, .wind_m_s = place});
    case 8:
        return edit_haze(text, {.preset = word, .unevenness = number});
    case 9:
        return edit_hazer(text, show.hazers, index, {.position_m = place, .rate = number});
    case 10:
        return add_hazer(text, {.position_m = place});
    case 11:
        return edit_bounce(text, BounceDetail::normal);
    case 12:
        return edit_cue(text, show.cues, index, cue);
    case 13:
        return add_cue(text, cue);
    case 14:
        return set_object_move(text, word, place);
    case 15:
        return add_palette(text, palette);
    case 16:
        return rename_palette(text, show.palettes, index, word);
    case 17:
        return set_substitute(text, word, "b.gdtf", word);
    case 18:
        return replace_palette(text, show.palettes, index, palette);
    case 19:
        return remove_fixtures(text, {index, 0});
    case 20:
        return remove_hazer(text, show.hazers, index);
    case 21:
        return remove_cue(text, show.cues, index);
    default:
        return remove_palette(text, show.palettes, index);
    }
}

// Lines on which a value goes on that began on an earlier one, and the one on which it begins.
void mark(const toml::node& node, std::set<std::size_t>& lines) {
    if (const toml::table* table = node.as_table(); table && !table->is_inline()) {
        for (const auto& [key, value] : *table) mark(value, lines);
    } else if (const toml::array* array = node.as_array(); array && array->is_array_of_tables()) {
        for (const toml::node& entry : *array) mark(entry, lines);
        if (array->front().as_table()->is_inline())
            for (std::size_t line = array->source().begin.line; line <= array->source().end.line; ++line)
                lines.insert(line);
    } else {
        for (std::size_t line = node.source().begin.line; line <= node.source().end.line; ++line)
            lines.insert(line);
    }
}

// Lines that are comments and nothing else, by their text.
std::map<std::string, int> comments_of(const TomlText& document) {
    std::set<std::size_t> of_values;
    mark(document.root(), of_values);
    std::map<std::string, int> comments;
    const std::string& text = document.text();
    std::size_t number = 1;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t letter = text.find_first_not_of(" \t", begin);
        if (letter < end && text[letter] == '#' && !of_values.contains(number))
            ++comments[text.substr(begin, end - begin)];
        begin = end + 1;
    }
    return comments;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kEditBytes = 4;
    if (size < 4 * kEditBytes) return 0;
    std::string text(reinterpret_cast<const char*>(data) + 4 * kEditBytes, size - 4 * kEditBytes);
    for (const std::uint8_t* byte = data; byte < data + 4 * kEditBytes; byte += kEditBytes) {
        Report report;
        const auto before = parse_show(text, "fuzz/show.toml", report);
        if (!before.ok()) return 0;
        const int what = byte[0] % kEdits;
        const auto edited = edit(text, *before, what, byte[1] % 8, kWords[byte[2] % std::size(kWords)],
                                 0.25f * static_cast<float>(byte[3]));
        if (!edited.ok()) continue;
        const auto document = TomlText::parse(*edited);
        if (!document.ok() || !parse_show(*edited, "fuzz/show.toml", report).ok()) std::abort();
        if (what < kFirstThatTakesAway) {
            std::map<std::string, int> after = comments_of(*document);
            for (const auto& [comment, count] : comments_of(*TomlText::parse(text)))
                if (after[comment] < count) std::abort();
        }
        text = *edited;
    }
    return 0;
}
