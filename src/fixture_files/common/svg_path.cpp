// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/svg_path.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace ghost::fixture {
namespace {

using glm::vec2;

constexpr int kPieces = 16;
constexpr float kPi = 3.14159265f;
constexpr float kArcPiece = kPi / 22.5f;

// Numbers and letters in turn; commas and blanks separate, but need not stand there.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    // The next letter, 0 where a number or the end follows.
    char letter() {
        skip();
        if (text_.empty() || !is_letter(text_.front())) return 0;
        return take();
    }
    bool at_end() {
        skip();
        return text_.empty();
    }
    std::optional<float> number() {
        skip();
        if (!text_.empty() && text_.front() == '+') text_.remove_prefix(1);
        float value = 0.0f;
        const auto read = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        if (read.ec != std::errc() || !(std::abs(value) <= kMostUnits)) return std::nullopt;
        text_.remove_prefix(static_cast<std::size_t>(read.ptr - text_.data()));
        return value;
    }
    // One digit: "a1 1 0 01.5.5" has two flags before its .5.
    std::optional<float> flag() {
        skip();
        if (text_.empty() || (text_.front() != '0' && text_.front() != '1')) return std::nullopt;
        return take() == '1' ? 1.0f : 0.0f;
    }

private:
    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
    void skip() {
        const std::size_t next = text_.find_first_not_of(" ,\t\r\n");
        text_.remove_prefix(next == text_.npos ? text_.size() : next);
    }
    char take() {
        const char first = text_.front();
        text_.remove_prefix(1);
        return first;
    }

    std::string_view text_;
};

int arguments_of(char command) {
    switch (command) {
    case 'M':
    case 'L':
    case 'T':
        return 2;
    case 'H':
    case 'V':
        return 1;
    case 'C':
        return 6;
    case 'S':
    case 'Q':
        return 4;
    case 'A':
        return 7;
    default:
        return 0;
    }
}

class Reader {
public:
    Reader(std::string_view data, std::size_t most_points) : scanner_(data), room_(most_points) {}

    SvgPath read() {
        path_.whole = run();
        return std::move(path_);
    }

private:
    bool run() {
        char command = 0;
        while (!scanner_.at_end()) {
            const char next = scanner_.letter();
            if (next != 0)
                command = next;
            else if (command == 'M' || command == 'm')
                command = command == 'M' ? 'L' : 'l'; // further pairs are lines
            const bool relative = command >= 'a';
            const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
            if (path_.lines.empty() && kind != 'M') return false;
            if (kind == 'Z') {
                if (next == 0) return false;
                path_.lines.back().closed = true;
                at_ = start_;
                ended_ = true;
            } else if (arguments_of(kind) == 0 || !draw(kind, relative)) {
                return false;
            }
            if (room_ == 0) return false;
            before_ = kind;
        }
        return true;
    }

    bool draw(char kind, bool relative) {
        std::array<float, 7> value{};
        for (int i = 0; i < arguments_of(kind); ++i) {
            const bool is_flag = kind == 'A' && (i == 3 || i == 4);
            const std::optional<float> read = is_flag ? scanner_.flag() : scanner_.number();
            if (!read) return false;
            value[static_cast<std::size_t>(i)] = *read;
        }
        const vec2 base = relative ? at_ : vec2(0.0f);
        const auto point = [&](std::size_t i) { return base + vec2(value[i], value[i + 1]); };
        if (kind != 'M' && ended_) begin(at_);
        switch (kind) {
        case 'M':
            start_ = point(0);
            begin(start_);
            break;
        case 'L':
            add(point(0));
            break;
        case 'H':
            add({base.x + value[0], at_.y});
            break;
        case 'V':
            add({at_.x, base.y + value[0]});
            break;
        case 'C':
            cubic(point(0), point(2), point(4));
            break;
        case 'S':
            cubic(before_ == 'C' || before_ == 'S' ? 2.0f * at_ - control_ : at_, point(0), point(2));
            break;
        case 'Q':
            quadratic(point(0), point(2));
            break;
        case 'T':
            quadratic(before_ == 'Q' || before_ == 'T' ? 2.0f * at_ - control_ : at_, point(0));
            break;
        default:
            arc(vec2(value[0], value[1]), value[2], value[3] > 0.5f, value[4] > 0.5f, point(5));
        }
        return true;
    }

    void begin(vec2 point) {
        path_.lines.push_back({});
        ended_ = false;
        add(point);
    }

    void add(vec2 point) {
        at_ = glm::clamp(point, vec2(-kMostUnits), vec2(kMostUnits));
        if (room_ == 0) return;
        path_.lines.back().points.push_back(at_);
        --room_;
    }

    void cubic(vec2 a, vec2 b, vec2 end) {
        const vec2 from = at_;
        for (int i = 1; i <= kPieces; ++i) {
            const float t = static_cast<float>(i) / kPieces;
            const float u = 1.0f - t;
            add(i == kPieces
                    ? end
                    : u * u * u * from + 3.0f * u * u * t * a + 3.0f * u * t * t * b + t * t * t * end);
        }
        control_ = b;
    }

    void quadratic(vec2 middle, vec2 end) {
        cubic(at_ + (middle - at_) * (2.0f / 3.0f), end + (middle - end) * (2.0f / 3.0f), end);
        control_ = middle;
    }

    // SVG 1.1, F.6.5 and F.6.6: from the ends to the centre.
    void arc(vec2 radius, float turn_deg, bool large, bool sweep, vec2 end) {
        radius = glm::abs(radius);
        if (radius.x == 0.0f || radius.y == 0.0f || end == at_) return add(end);
        const float turn = turn_deg * kPi / 180.0f;
        const vec2 axis(std::cos(turn), std::sin(turn));
        const auto into = [&](vec2 v) { return vec2(glm::dot(v, axis), axis.x * v.y - axis.y * v.x); };
        const auto back = [&](vec2 v) {
            return vec2(axis.x * v.x - axis.y * v.y, axis.y * v.x + axis.x * v.y);
        };
        const vec2 half = into(0.5f * (at_ - end));
        const vec2 share = half / radius;
        const float size = glm::dot(share, share);
        if (size > 1.0f) radius *= std::sqrt(size);
        const vec2 unit = half / radius;
        const float away = std::sqrt(std::max(1.0f / std::max(glm::dot(unit, unit), 1e-12f) - 1.0f, 0.0f));
        const vec2 middle = (large == sweep ? -1.0f : 1.0f) * away * vec2(unit.y, -unit.x);
        const vec2 first = unit - middle;
        const vec2 last = -unit - middle;
        float angle = std::atan2(first.x * last.y - first.y * last.x, glm::dot(first, last));
        if (sweep && angle < 0.0f) angle += 2.0f * kPi;
        if (!sweep && angle > 0.0f) angle -= 2.0f * kPi;
        const vec2 centre = 0.5f * (at_ + end) + back(middle * radius);
        const float from = std::atan2(first.y, first.x);
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / kArcPiece)));
        for (int i = 1; i < pieces; ++i) {
            const float a = from + angle * static_cast<float>(i) / static_cast<float>(pieces);
            add(centre + back(radius * vec2(std::cos(a), std::sin(a))));
        }
        add(end);
    }

    Scanner scanner_;
    std::size_t room_;
    SvgPath path_;
    vec2 at_{0.0f};
    vec2 start_{0.0f};
    vec2 control_{0.0f}; // of the curve before
    char before_ = 0;
    bool ended_ = false; // by Z
};

} // namespace

SvgPath read_svg_path(std::string_view data, std::size_t most_points) {
    return Reader(data, most_points).read();
}

SvgLine ellipse_line(vec2 middle, vec2 radius) {
    SvgLine line{{}, true};
    constexpr int kAll = 90;
    for (int i = 0; i < kAll; ++i) {
        const float angle = 2.0f * kPi * static_cast<float>(i) / kAll;
        line.points.push_back(middle + radius * vec2(std::cos(angle), std::sin(angle)));
    }
    return line;
}

} // namespace ghost::fixture
