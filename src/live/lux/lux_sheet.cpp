// SPDX-License-Identifier: Apache-2.0
#include "live/lux/lux_sheet.h"

#include "image/false_colour.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numeric>

namespace ghost::app {
namespace {

constexpr image::Scale kScale{1, 10000}; // as the window shows lux
constexpr float kLongest_m = 10000;
constexpr double kSheet_px = 1000; // the longer side of what is measured
constexpr double kAround_px = 70;
constexpr double kReadable_px = 30; // of a cell that its value is written into

std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string formatted(const char* format, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<')
            safe += "&lt;";
        else if (c == '&')
            safe += "&amp;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            safe += c;
    }
    return safe;
}

// As many digits as a meter has.
std::string value_text(float lux) {
    return formatted(lux < 10 ? "%.1f" : "%.0f", static_cast<double>(lux));
}

Result<std::size_t> count_along(float length_m, float step_m) {
    if (!(step_m > 0) || !(length_m >= 0) || length_m > kLongest_m)
        return Error{formatted("needs a step above 0 and a length of at most %g m", double{kLongest_m}), ""};
    const double steps = std::ceil(static_cast<double>(length_m) / static_cast<double>(step_m) - 1e-6);
    if (steps >= static_cast<double>(kMostLuxPoints))
        return Error{"more than " + std::to_string(kMostLuxPoints) + " points: take a larger step", ""};
    return static_cast<std::size_t>(std::max(steps, 1.0)) + 1;
}

std::string summary_line(const LuxGrid& grid) {
    const LuxSummary all = summary_of(grid);
    const std::string bounced =
        grid.bounced_lux.empty() ? "" : ", of which " + value_text(all.mean_bounced) + " bounced";
    return formatted(
        "%zu points: mean %s lx%s, least %s lx at (%.2f, %.2f, %.2f), most %s lx at (%.2f, %.2f, "
        "%.2f); least/mean %.2f",
        grid.points_m.size(), value_text(all.mean).c_str(), bounced.c_str(), value_text(all.least).c_str(),
        static_cast<double>(all.least_at_m.x), static_cast<double>(all.least_at_m.y),
        static_cast<double>(all.least_at_m.z), value_text(all.most).c_str(),
        static_cast<double>(all.most_at_m.x), static_cast<double>(all.most_at_m.y),
        static_cast<double>(all.most_at_m.z), static_cast<double>(all.uniformity()));
}

std::string sheet_begin(double width, double height, const LuxGrid& grid, const std::string& title) {
    return formatted("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" "
                     "font-family=\"sans-serif\" font-size=\"13\">\n"
                     "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
                     width, height) +
           "<text x=\"70\" y=\"28\" font-size=\"18\">" + escaped(title) +
           "</text>\n<text x=\"70\" y=\"48\">" + escaped(summary_line(grid)) + "</text>\n";
}

// Cells, the audience below; a white sheet's numbers are black on light and white on dark cells.
std::string area_svg(const LuxGrid& grid, const std::string& title) {
    const glm::vec3 &first = grid.points_m.front(), &last = grid.points_m.back();
    const double cell = kSheet_px / static_cast<double>(std::max(grid.columns, grid.rows));
    const double width = cell * static_cast<double>(grid.columns),
                 height = cell * static_cast<double>(grid.rows);
    std::string svg =
        sheet_begin(std::max(width, 700.0) + 2 * kAround_px, height + 2 * kAround_px + 20, grid, title);
    for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column) {
            const float lux = grid.lux[row * grid.columns + column];
            const image::Rgb8 colour = image::false_colour(kScale, lux);
            const double x = kAround_px + cell * static_cast<double>(column);
            const double y = kAround_px + cell * static_cast<double>(grid.rows - 1 - row);
            svg += formatted(
                "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#%02x%02x%02x\"/>\n", x, y,
                cell, cell, colour[0], colour[1], colour[2]);
            if (cell < kReadable_px) continue;
            const bool is_light = 2 * colour[0] + 5 * colour[1] + colour[2] > 8 * 110;
            svg += formatted(
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"11\" fill=\"%s\">%s</text>\n",
                x + cell / 2, y + cell / 2 + 4, is_light ? "black" : "white", value_text(lux).c_str());
        }
    const double below = kAround_px + height + 20;
    svg += formatted("<text x=\"%.1f\" y=\"%.1f\">x %.2f m</text>\n", kAround_px, below,
                     static_cast<double>(first.x));
    svg += formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">x %.2f m</text>\n", kAround_px + width,
                     below, static_cast<double>(last.x));
    svg += formatted("<text x=\"4\" y=\"%.1f\">y %.2f</text>\n", kAround_px + height - 2,
                     static_cast<double>(first.y));
    svg +=
        formatted("<text x=\"4\" y=\"%.1f\">y %.2f</text>\n", kAround_px + 12, static_cast<double>(last.y));
    svg += formatted("<text x=\"%.1f\" y=\"%.1f\">lux at %.2f m; the audience is below</text>\n", kAround_px,
                     below + 20, static_cast<double>(first.z));
    return svg + "</svg>\n";
}

// A curve over the way.
std::string line_svg(const LuxGrid& grid, const std::string& title) {
    constexpr double kHigh_px = 400;
    const LuxSummary all = summary_of(grid);
    const double top = std::max(static_cast<double>(all.most), 1e-3) * 1.05;
    const double length_m = static_cast<double>(glm::distance(grid.points_m.front(), grid.points_m.back()));
    std::string svg = sheet_begin(kSheet_px + 2 * kAround_px, kHigh_px + 2 * kAround_px, grid, title);
    for (int k = 0; k <= 4; ++k) {
        const double y = kAround_px + kHigh_px * (1 - k / 4.0);
        svg += formatted("<path d=\"M %.1f %.1f h %.1f\" stroke=\"#ccc\"/><text x=\"%.1f\" y=\"%.1f\" "
                         "text-anchor=\"end\">%s</text>\n",
                         kAround_px, y, kSheet_px, kAround_px - 6, y + 4,
                         value_text(static_cast<float>(top * k / 4)).c_str());
        svg += formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%.2f m</text>\n",
                         kAround_px + kSheet_px * k / 4.0, kAround_px + kHigh_px + 20, length_m * k / 4);
    }
    std::string path;
    for (std::size_t i = 0; i < grid.lux.size(); ++i)
        path += formatted("%s%.1f %.1f ", i == 0 ? "M " : "L ",
                          kAround_px +
                              kSheet_px * static_cast<double>(i) / static_cast<double>(grid.lux.size() - 1),
                          kAround_px + kHigh_px * (1 - static_cast<double>(grid.lux[i]) / top));
    return svg + "<path d=\"" + path + "\" fill=\"none\" stroke=\"#b03000\" stroke-width=\"2\"/>\n</svg>\n";
}

} // namespace

Result<LuxGrid> line_grid(const glm::vec3& from_m, const glm::vec3& to_m, float step_m) {
    TRY(const std::size_t count, count_along(glm::distance(from_m, to_m), step_m));
    LuxGrid grid{count, 1, {}, {}, {}};
    for (std::size_t i = 0; i < count; ++i)
        grid.points_m.push_back(
            glm::mix(from_m, to_m, static_cast<float>(i) / static_cast<float>(count - 1)));
    return grid;
}

Result<LuxGrid> area_grid(const glm::vec3& corner_m, const glm::vec3& opposite_m, float step_m) {
    const glm::vec3 low = glm::min(corner_m, opposite_m), high = glm::max(corner_m, opposite_m);
    TRY(const std::size_t columns, count_along(high.x - low.x, step_m));
    TRY(const std::size_t rows, count_along(high.y - low.y, step_m));
    if (columns * rows > kMostLuxPoints)
        return Error{"more than " + std::to_string(kMostLuxPoints) + " points: take a larger step", ""};
    LuxGrid grid{columns, rows, {}, {}, {}};
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            grid.points_m.push_back(
                {glm::mix(low.x, high.x, static_cast<float>(column) / static_cast<float>(columns - 1)),
                 glm::mix(low.y, high.y, static_cast<float>(row) / static_cast<float>(rows - 1)),
                 corner_m.z});
    return grid;
}

LuxSummary summary_of(const LuxGrid& grid) {
    LuxSummary all;
    if (grid.lux.empty()) return all;
    double sum = 0;
    std::size_t least = 0, most = 0;
    for (std::size_t i = 0; i < grid.lux.size(); ++i) {
        sum += static_cast<double>(grid.lux[i]);
        if (grid.lux[i] < grid.lux[least]) least = i;
        if (grid.lux[i] > grid.lux[most]) most = i;
    }
    all.mean = static_cast<float>(sum / static_cast<double>(grid.lux.size()));
    if (!grid.bounced_lux.empty())
        all.mean_bounced =
            static_cast<float>(std::accumulate(grid.bounced_lux.begin(), grid.bounced_lux.end(), 0.0) /
                               static_cast<double>(grid.bounced_lux.size()));
    all.least = grid.lux[least];
    all.most = grid.lux[most];
    all.least_at_m = grid.points_m[least];
    all.most_at_m = grid.points_m[most];
    return all;
}

std::string lux_csv(const LuxGrid& grid) {
    const bool bounces = !grid.bounced_lux.empty();
    std::string csv = bounces ? "x_m,y_m,z_m,lux,bounced_lux\n" : "x_m,y_m,z_m,lux\n";
    for (std::size_t i = 0; i < grid.lux.size(); ++i) {
        csv += formatted("%.3f,%.3f,%.3f,%.6g", static_cast<double>(grid.points_m[i].x),
                         static_cast<double>(grid.points_m[i].y), static_cast<double>(grid.points_m[i].z),
                         static_cast<double>(grid.lux[i]));
        if (bounces) csv += formatted(",%.6g", static_cast<double>(grid.bounced_lux[i]));
        csv += "\n";
    }
    return csv;
}

std::string lux_svg(const LuxGrid& grid, const std::string& title) {
    return grid.rows == 1 ? line_svg(grid, title) : area_svg(grid, title);
}

} // namespace ghost::app
