// SPDX-License-Identifier: Apache-2.0
// IES files, ANSI/IES LM-63: keywords, TILT, then numbers in a fixed order with any white space or commas
// between them. Files of 1986 have labels of any kind in place of a header and keywords.
#include "fixture_files/ies_ldt/photometric.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace ghost::fixture {
namespace {

constexpr std::array<std::string_view, 5> kHeaders{"IESNA91", "IESNA:LM-63-1995", "IESNA:LM-63-2002",
                                                   "IES:LM-63-2019", "IESNA:LM-63-2019"};
constexpr std::size_t kOfThatTime = 2; // headers whose second factor is a ballast-lamp factor

std::string upper(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return result;
}

std::string shown(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, 40)) result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return result;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::string where() const { return file_ + ":" + std::to_string(line_); }
    bool at_end() const { return at_ >= text_.size(); }

    std::string_view line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view result = text_.substr(at_, end - at_);
        at_ = std::min(end + 1, text_.size());
        ++line_;
        while (!result.empty() && (result.back() == '\r' || result.back() == ' ')) result.remove_suffix(1);
        return result;
    }

    Result<float> number(const std::string& what) {
        while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
        if (at_ >= text_.size()) return Error{"ends before " + what, where()};
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        std::string_view word = text_.substr(begin, at_ - begin);
        const std::string_view written = word;
        if (word.front() == '+') word.remove_prefix(1);
        float value = 0;
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            return Error{what + " is '" + shown(written) + "', expected a number", where()};
        return value;
    }

    Result<float> number(const std::string& what, float low, float high) {
        TRY(const float value, number(what));
        if (value >= low && value <= high) return value;
        return Error{what + " is " + number_text(value) + ", expected " + number_text(low) + " to " +
                         number_text(high),
                     where()};
    }

    Result<std::size_t> count(const std::string& what) {
        TRY(const float value, number(what, 1.0f, static_cast<float>(kMaxPhotometricAngles)));
        if (value != std::floor(value))
            return Error{what + " is " + number_text(value) + ", expected a whole number", where()};
        return static_cast<std::size_t>(value);
    }

    Result<std::vector<float>> list(std::size_t size, const std::string& what, float low, float high) {
        std::vector<float> values;
        for (std::size_t k = 0; k < size; ++k) {
            TRY(const float value, number(what, low, high));
            values.push_back(value);
        }
        return values;
    }

private:
    static bool is_space(char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || c == '\x1a';
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
};

// All round from the planes of a file, whose symmetry the last angle tells.
Result<void> unfold(std::vector<float> planes, std::vector<std::vector<float>> candela, Photometric& light,
                    const std::string& where) {
    const float first = planes.front(), last = planes.back();
    if (planes.size() == 1) {
        light.c_deg = {0.0f};
        light.candela = std::move(candela);
        return {};
    }
    const bool whole = first == 0.0f && last == 360.0f;
    const bool half = first == 0.0f && last == 180.0f;
    const bool quarter = first == 0.0f && last == 90.0f;
    const bool side = first == 90.0f && last == 270.0f; // mirrored in the plane of 90 and 270
    if (!whole && !half && !quarter && !side)
        return Error{"horizontal angles run from " + number_text(first) + " to " + number_text(last) +
                         ", expected 0, or 0 to 90, 180 or 360, or 90 to 270",
                     where};
    std::vector<std::pair<float, std::size_t>> all;
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const float c = planes[k];
        if (whole) {
            if (c < 360.0f) all.emplace_back(c, k);
            continue;
        }
        for (const float turned :
             {c, side ? 180.0f - c : 360.0f - c, quarter ? 180.0f - c : c, quarter ? 180.0f + c : c})
            all.emplace_back(turned < 0.0f ? turned + 360.0f : (turned >= 360.0f ? turned - 360.0f : turned),
                             k);
    }
    std::sort(all.begin(), all.end());
    for (const auto& [c, k] : all) {
        if (!light.c_deg.empty() && light.c_deg.back() == c) continue;
        light.c_deg.push_back(c);
        light.candela.push_back(candela[k]);
    }
    return {};
}

Result<void> read_tilt(Reader& reader, std::string_view tilt, const std::string& file,
                       std::vector<Message>& messages) {
    if (tilt == "NONE") return {};
    if (tilt == "INCLUDE") {
        TRY_VOID([&]() -> Result<void> {
            TRY(const float geometry, reader.number("the lamp to luminaire geometry of TILT", 1, 3));
            (void)geometry;
            TRY(const std::size_t pairs, reader.count("the number of TILT's angles"));
            TRY(const std::vector<float> angles, reader.list(pairs, "an angle of TILT", -180, 180));
            TRY(const std::vector<float> factors, reader.list(pairs, "a factor of TILT", 0, 100));
            return {};
        }());
    }
    messages.push_back(
        {Severity::note, file, "TILT=" + shown(tilt) + ": how the lamp dims when it is tilted is left out"});
    return {};
}

} // namespace

Result<LoadedPhotometric> parse_ies(std::string_view text, const std::string& file) {
    if (text.size() > kMaxPhotometricBytes) return Error{"is larger than 4 MiB", file};
    if (constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    Reader reader(text, file);
    LoadedPhotometric loaded;
    std::string_view line = reader.line();
    const std::string header = upper(line);
    const auto* const known = std::find(kHeaders.begin(), kHeaders.end(), header);
    const Error unknown{"begins with '" + shown(line) +
                            "', expected IESNA:LM-63-1995, IESNA:LM-63-2002 or IES:LM-63-2019",
                        file};
    if (known == kHeaders.end() && (header.empty() || header.starts_with("IES"))) return unknown;
    const bool has_lamp_factor =
        known == kHeaders.end() || static_cast<std::size_t>(known - kHeaders.begin()) < kOfThatTime;
    while (!upper(line).starts_with("TILT=")) {
        if (reader.at_end()) return known == kHeaders.end() ? unknown : Error{"has no line TILT=", file};
        line = reader.line();
        if (upper(line).starts_with("[LUMINAIRE]"))
            loaded.light.name = shown(line.substr(line.size() > 11 ? 12 : 11));
    }
    const std::string tilt = line.size() > 5 ? upper(line.substr(5)) : "NONE";
    TRY_VOID(read_tilt(reader, tilt, file, loaded.messages));
    TRY(const float lamps, reader.number("the number of lamps", 0, 1e6f));
    TRY(const float lumens, reader.number("the lumens of a lamp", -1, 1e9f));
    TRY(float factor, reader.number("the candela multiplier", 0, 1e6f));
    TRY(const std::size_t rows, reader.count("the number of vertical angles"));
    TRY(const std::size_t columns, reader.count("the number of horizontal angles"));
    TRY(const float type, reader.number("the type of photometry", 1, 3));
    if (type != 1.0f)
        return Error{std::string("is photometry of type ") + (type == 2.0f ? "B" : "A") + ", expected type C",
                     reader.where()};
    for (const char* what : {"the unit", "the width", "the length", "the height"}) {
        TRY(const float unused, reader.number(what, -1e6f, 1e6f)); // below 0: it is round
        (void)unused;
    }
    TRY(const float ballast, reader.number("the ballast factor", 0, 1e3f));
    TRY(const float future, reader.number("the ballast-lamp factor", 0, 1e3f));
    TRY(const float watts, reader.number("the input watts", 0, 1e7f));
    (void)lamps, (void)lumens, (void)watts; // candela are as they were measured
    factor *= ballast * (has_lamp_factor ? future : 1.0f);
    if (rows < 2) return Error{"has one vertical angle, expected two or more", reader.where()};
    TRY(loaded.light.gamma_deg, reader.list(rows, "a vertical angle", 0, 180));
    TRY_VOID(check_angles(loaded.light.gamma_deg, 0, 180, "vertical", reader.where()));
    if (loaded.light.gamma_deg.front() >= 90.0f)
        return Error{"shines upwards only: its vertical angles begin at " +
                         number_text(loaded.light.gamma_deg.front()),
                     reader.where()};
    TRY(const std::vector<float> planes, reader.list(columns, "a horizontal angle", 0, 360));
    TRY_VOID(check_angles(planes, 0, 360, "horizontal", reader.where()));
    std::vector<std::vector<float>> candela;
    for (std::size_t c = 0; c < columns; ++c) {
        TRY(std::vector<float> plane, reader.list(rows, "a candela value", 0, kMaxCandela));
        for (float& value : plane) value = std::min(value * factor, kMaxCandela);
        candela.push_back(std::move(plane));
    }
    TRY_VOID(unfold(planes, std::move(candela), loaded.light, reader.where()));
    if (!(loaded.light.flux_lm() > 0)) return Error{"has no light: all its candela are 0", file};
    return loaded;
}

} // namespace ghost::fixture
