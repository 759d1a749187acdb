#pragma once
// SPDX-License-Identifier: Apache-2.0
// Progress: a bar with the time left on a terminal, a line every few seconds elsewhere. The caller supplies
// the time (seconds, any start). Standard error. One thread at a time.

#include <string>

namespace ghost {

// "1:05", "2:03:04".
std::string clock_text(double seconds);

// "baking  42 % [########            ] 0:12 left  foh".
std::string progress_line(const std::string& label, double share, double elapsed_s, const std::string& note);

class Progress {
public:
    enum class Style { bar, lines, silent };
    // bar where standard error is a terminal, else lines.
    static Style style_for_stderr();
    // Of all of them, from now on; 5 s unless said. Before the first one is made.
    static void set_lines_every(double seconds);

    Progress(std::string label, Style style, double now_s);
    void update(double share, double now_s, const std::string& note);
    // Takes the bar away.
    void finish();

private:
    std::string label_;
    Style style_;
    double start_s_;
    double shown_s_;
    std::size_t shown_letters_ = 0;
};

// The last words of a render or bake, with exit code 1, that made all it could.
inline constexpr const char* kMadeButMissing =
    "made, but something that the show asks for is missing (see above)";

} // namespace ghost
