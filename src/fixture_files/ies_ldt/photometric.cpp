// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/ies_ldt/photometric.h"

#include "base/text.h"
#include "disk/files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace ghost::fixture {
namespace {

constexpr double kRad = std::numbers::pi / 180.0;

// Index of the last one that is not above, and how far it is from there to the next.
struct Place {
    std::size_t index = 0;
    float part = 0.0f;
};
Place place_in(const std::vector<float>& angles, float angle) {
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - angles.begin() - 1, 0));
    if (index + 1 >= angles.size()) return {index, 0.0f};
    return {index, std::clamp((angle - angles[index]) / (angles[index + 1] - angles[index]), 0.0f, 1.0f)};
}

// Integral of a straight line from i0 at g0 to i1 at g1, times the sine; radians.
double ring(double g0, double g1, double i0, double i1) {
    const double slope = (i1 - i0) / (g1 - g0);
    const auto whole = [&](double g) { return -(i0 + slope * (g - g0)) * std::cos(g) + slope * std::sin(g); };
    return whole(g1) - whole(g0);
}

} // namespace

float Photometric::at(float c, float gamma) const {
    if (gamma < gamma_deg.front() || gamma > gamma_deg.back()) return 0.0f;
    const Place place = place_in(gamma_deg, gamma);
    const std::size_t row = place.index;
    const std::size_t next_row = std::min(row + 1, gamma_deg.size() - 1);
    const auto along = [&](std::size_t plane) {
        return candela[plane][row] + (candela[plane][next_row] - candela[plane][row]) * place.part;
    };
    if (c_deg.size() == 1) return along(0);
    const float turned = c - 360.0f * std::floor(c / 360.0f);
    const auto above = std::upper_bound(c_deg.begin(), c_deg.end(), turned);
    const auto plane = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - c_deg.begin() - 1, 0));
    const std::size_t next = (plane + 1) % c_deg.size();
    const float width = (next == 0 ? 360.0f : c_deg[next]) - c_deg[plane];
    const float share = std::clamp((turned - c_deg[plane]) / width, 0.0f, 1.0f);
    return along(plane) + (along(next) - along(plane)) * share;
}

double Photometric::flux_lm(double to_gamma_deg) const {
    double sum = 0;
    for (std::size_t plane = 0; plane < c_deg.size(); ++plane) {
        // Half of the way to the planes beside it.
        const double before =
            plane == 0 ? static_cast<double>(c_deg.back()) - 360.0 : static_cast<double>(c_deg[plane - 1]);
        const double after = plane + 1 == c_deg.size() ? 360.0 + static_cast<double>(c_deg.front())
                                                       : static_cast<double>(c_deg[plane + 1]);
        const double width = c_deg.size() == 1 ? 360.0 : 0.5 * (after - before);
        for (std::size_t k = 0; k + 1 < gamma_deg.size(); ++k) {
            const auto low = static_cast<double>(gamma_deg[k]);
            const auto high = static_cast<double>(gamma_deg[k + 1]);
            if (low >= to_gamma_deg) break;
            const double end = std::min(high, to_gamma_deg);
            const auto first = static_cast<double>(candela[plane][k]);
            const double last =
                first + (static_cast<double>(candela[plane][k + 1]) - first) * (end - low) / (high - low);
            sum += width * kRad * ring(low * kRad, end * kRad, first, last);
        }
    }
    return sum;
}

std::string number_text(float value) {
    std::array<char, 64> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
    return {digits.data(), end};
}

Result<void> check_angles(const std::vector<float>& angles, float low, float high, const std::string& what,
                          const std::string& where) {
    for (std::size_t k = 0; k < angles.size(); ++k) {
        if (!(angles[k] >= low && angles[k] <= high))
            return Error{what + " angle " + number_text(angles[k]) + ", expected " + number_text(low) +
                             " to " + number_text(high) + " degrees",
                         where};
        if (k > 0 && !(angles[k] > angles[k - 1]))
            return Error{what + " angles do not rise: " + number_text(angles[k]) + " after " +
                             number_text(angles[k - 1]),
                         where};
    }
    return {};
}

Result<LoadedPhotometric> load_photometric(const std::filesystem::path& path) {
    TRY(const std::string text, read_text_file(path, kMaxPhotometricBytes));
    const std::string ending = lower(path.extension().string());
    if (ending == ".ies") return parse_ies(text, path.string());
    if (ending == ".ldt" || ending == ".eulumdat") return parse_ldt(text, path.string());
    return Error{"is no photometric file, expected .ies or .ldt", path.string()};
}

} // namespace ghost::fixture
