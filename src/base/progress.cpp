// SPDX-License-Identifier: Apache-2.0
#include "base/progress.h"

#include "base/print.h"
#include "base/private/terminal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ghost {
namespace {

constexpr double kBarEvery_s = 0.1;
double line_every_s = 5.0;
constexpr int kBarWidth = 24;

} // namespace

std::string clock_text(double seconds) {
    const long whole = std::lround(std::clamp(seconds, 0.0, 359999.0));
    char text[32];
    if (whole >= 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    return text;
}

std::string progress_line(const std::string& label, double share, double elapsed_s, const std::string& note) {
    share = std::clamp(share, 0.0, 1.0);
    const int filled = static_cast<int>(share * kBarWidth);
    std::string bar(kBarWidth, ' ');
    std::fill_n(bar.begin(), filled, '#');
    char percent[8];
    std::snprintf(percent, sizeof percent, "%3.0f %%", std::floor(share * 100));
    std::string line = label + " " + percent + " [" + bar + "]";
    // The first moments say nothing about the rest.
    if (share > 0.01 && elapsed_s > 0.5) line += " " + clock_text(elapsed_s * (1 - share) / share) + " left";
    return note.empty() ? line : line + "  " + note;
}

Progress::Style Progress::style_for_stderr() {
    return stderr_is_terminal() ? Style::bar : Style::lines;
}

void Progress::set_lines_every(double seconds) {
    line_every_s = seconds;
}

Progress::Progress(std::string label, Style style, double now_s)
    : label_(std::move(label)), style_(style), start_s_(now_s), shown_s_(now_s) {}

void Progress::update(double share, double now_s, const std::string& note) {
    if (style_ == Style::silent) return;
    if (now_s - shown_s_ < (style_ == Style::bar ? kBarEvery_s : line_every_s)) return;
    shown_s_ = now_s;
    std::string line = one_line(progress_line(label_, share, now_s - start_s_, note));
    if (style_ == Style::lines) {
        std::fprintf(stderr, "%s\n", line.c_str());
        return;
    }
    const std::size_t letters = line.size();
    if (letters < shown_letters_) line.append(shown_letters_ - letters, ' ');
    shown_letters_ = letters;
    std::fprintf(stderr, "\r%s", line.c_str());
    std::fflush(stderr);
}

void Progress::finish() {
    if (style_ == Style::bar && shown_letters_ > 0) {
        std::fprintf(stderr, "\r%s\r", std::string(shown_letters_, ' ').c_str());
        std::fflush(stderr);
    }
    shown_letters_ = 0;
}

} // namespace ghost
