// SPDX-License-Identifier: Apache-2.0
// EULUMDAT files (.ldt): one value a line, in a fixed order; candela are per 1000 lumens of the lamps.
#include "fixture_files/ies_ldt/photometric.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace ghost::fixture {
namespace {

constexpr int kMostLampSets = 20; // as the format has it

class Lines {
public:
    Lines(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::string where() const { return file_ + ":" + std::to_string(line_); }

    Result<std::string> text(const std::string& what) {
        if (at_ >= text_.size()) return Error{"ends before " + what, where()};
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        ++line_;
        while (!line.empty() && (static_cast<unsigned char>(line.back()) <= 0x20)) line.remove_suffix(1);
        while (!line.empty() && (static_cast<unsigned char>(line.front()) <= 0x20)) line.remove_prefix(1);
        return std::string(line.substr(0, 200));
    }

    Result<void> skip(int lines, const std::string& what) {
        for (int k = 0; k < lines; ++k) {
            TRY(const std::string unused, text(what));
            (void)unused;
        }
        return {};
    }

    Result<float> number(const std::string& what, float low, float high) {
        TRY(std::string word, text(what));
        std::replace(word.begin(), word.end(), ',', '.'); // of German programs
        const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
        float value = 0;
        const auto [end, code] = std::from_chars(begin, word.data() + word.size(), value);
        if (word.empty() || code != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            return Error{what + " is '" + word.substr(0, 40) + "', expected a number", where()};
        if (value >= low && value <= high) return value;
        return Error{what + " is " + number_text(value) + ", expected " + number_text(low) + " to " +
                         number_text(high),
                     where()};
    }

    Result<int> whole(const std::string& what, int low, int high) {
        TRY(const float value, number(what, static_cast<float>(low), static_cast<float>(high)));
        if (value != std::floor(value))
            return Error{what + " is " + number_text(value) + ", expected a whole number", where()};
        return static_cast<int>(value);
    }

    Result<std::vector<float>> list(int size, const std::string& what, float low, float high) {
        std::vector<float> values;
        for (int k = 0; k < size; ++k) {
            TRY(const float value, number(what, low, high));
            values.push_back(value);
        }
        return values;
    }

private:
    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 0;
};

// Planes that the file has, of those that it names, and where each of the others is taken from.
struct Symmetry {
    int first = 0;
    int count = 0;
};

Symmetry symmetry_of(int isym, int planes) {
    switch (isym) {
    case 1:
        return {0, 1};
    case 2:
        return {0, planes / 2 + 1};
    case 3:
        return {3 * planes / 4, planes / 2 + 1};
    case 4:
        return {0, planes / 4 + 1};
    default:
        return {0, planes};
    }
}

// The plane of the file that is as bright as plane k of all.
int source_of(int isym, int k, int planes) {
    const int mirrored = (planes - k) % planes; // in C0 - C180
    switch (isym) {
    case 1:
        return 0;
    case 2:
        return std::min(k, mirrored);
    case 3: { // mirrored in C90 - C270: from C270 on
        const int other = (planes / 2 - k + planes) % planes;
        const int from = (k + planes / 4) % planes, from_other = (other + planes / 4) % planes;
        return std::min(from, from_other);
    }
    case 4: {
        const int half = std::min(k, mirrored);
        return std::min(half, planes / 2 - half);
    }
    default:
        return k;
    }
}

} // namespace

Result<LoadedPhotometric> parse_ldt(std::string_view text, const std::string& file) {
    if (text.size() > kMaxPhotometricBytes) return Error{"is larger than 4 MiB", file};
    Lines lines(text, file);
    LoadedPhotometric loaded;
    constexpr int kMost = static_cast<int>(kMaxPhotometricAngles);
    TRY_VOID(lines.skip(1, "the company"));
    TRY(const int type, lines.whole("the type of light source", 0, 3));
    (void)type;
    TRY(const int isym, lines.whole("the symmetry", 0, 4));
    TRY(const int planes, lines.whole("the number of C planes", 1, kMost));
    TRY(const float step_c, lines.number("the distance of C planes", 0, 360));
    TRY(const int rows, lines.whole("the number of angles in a plane", 2, kMost));
    TRY(const float step_g, lines.number("the distance of angles in a plane", 0, 180));
    (void)step_c, (void)step_g; // the angles themselves follow
    TRY_VOID(lines.skip(1, "the report's number"));
    TRY(loaded.light.name, lines.text("the luminaire's name"));
    TRY_VOID(lines.skip(3, "number, file and date"));
    TRY_VOID(lines.skip(9, "the luminaire's size"));
    TRY(const float downward, lines.number("the downward flux fraction", 0, 100));
    TRY(const float output, lines.number("the light output ratio", 0, 1000));
    (void)downward, (void)output;
    TRY(const float factor, lines.number("the conversion factor of candela", 0, 1e6f));
    TRY_VOID(lines.skip(1, "the tilt of the luminaire"));
    TRY(const int sets, lines.whole("the number of lamp sets", 1, kMostLampSets));
    float lamp_lm = 0;
    for (int k = 0; k < sets; ++k) {
        TRY_VOID(lines.skip(2, "number and type of lamps"));
        TRY(const float flux_lm, lines.number("the flux of the lamps", 0, 1e9f));
        if (k == 0) lamp_lm = flux_lm; // the other sets are other lamps for it
        TRY_VOID(lines.skip(3, "colour, colour rendering and watts of the lamps"));
    }
    TRY_VOID(lines.skip(10, "the direct ratios"));
    TRY(const std::vector<float> c_deg, lines.list(planes, "a C angle", 0, 360));
    TRY_VOID(check_angles(c_deg, 0, 359.999f, "C", lines.where()));
    TRY(loaded.light.gamma_deg, lines.list(rows, "an angle in a plane", 0, 180));
    TRY_VOID(check_angles(loaded.light.gamma_deg, 0, 180, "gamma", lines.where()));
    if (c_deg.front() != 0.0f)
        return Error{"C angles begin at " + number_text(c_deg.front()) + ", expected 0", lines.where()};
    if (loaded.light.gamma_deg.front() >= 90.0f) return Error{"shines upwards only", lines.where()};
    const int needs = isym == 4 || isym == 3 ? 4 : (isym == 2 ? 2 : 1);
    if (planes % needs != 0)
        return Error{std::to_string(planes) + " C planes with a symmetry of " + std::to_string(isym) +
                         ", expected a multiple of " + std::to_string(needs),
                     lines.where()};
    const Symmetry held = symmetry_of(isym, planes);
    std::vector<std::vector<float>> candela;
    for (int plane = 0; plane < held.count; ++plane) {
        TRY(std::vector<float> values, lines.list(rows, "a candela value", 0, kMaxCandela));
        for (float& value : values) value = std::min(value * factor * lamp_lm / 1000.0f, kMaxCandela);
        candela.push_back(std::move(values));
    }
    if (sets > 1)
        loaded.messages.push_back(
            {Severity::note, file, std::to_string(sets) + " sets of lamps: it burns the first one"});
    if (isym == 1) {
        loaded.light.c_deg = {0.0f};
        loaded.light.candela = std::move(candela);
    } else {
        loaded.light.c_deg = c_deg;
        for (int k = 0; k < planes; ++k)
            loaded.light.candela.push_back(candela[static_cast<std::size_t>(source_of(isym, k, planes))]);
    }
    if (!(loaded.light.flux_lm() > 0))
        return Error{"has no light: all its candela, or the flux of its lamps, are 0", file};
    return loaded;
}

} // namespace ghost::fixture
