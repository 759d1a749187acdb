// SPDX-License-Identifier: Apache-2.0
#include "show_file/private/laser_toml.h"

#include "base/suggest.h"
#include "json_xml_toml/toml_reader.h"

#include <algorithm>
#include <vector>

namespace ghost::scene {
namespace {

void read_kind(TableReader& reader, fixture::LaserCurve& figure) {
    const auto name = reader.text("figure");
    if (!name) return;
    const auto* const found = std::find(fixture::kFigureNames.begin(), fixture::kFigureNames.end(), *name);
    if (found != fixture::kFigureNames.end()) {
        figure.kind = static_cast<fixture::LaserCurveKind>(found - fixture::kFigureNames.begin());
        return;
    }
    const std::vector<std::string> names(fixture::kFigureNames.begin(), fixture::kFigureNames.end());
    reader.problem(Severity::error, "figure",
                   "is '" + name->substr(0, 40) + "', expected beam, fan, grid, ring, line, circle or wave" +
                       reader.did_you_mean(*name, names) + "; it is beam");
}

} // namespace

Laser read_laser(const toml::table& table, const std::string& section, const std::string& file,
                 Report& report) {
    TableReader reader(table, section + " laser", file, report);
    Laser laser;
    fixture::LaserCurve& figure = laser.figure;
    const auto put = [](float& target, const std::optional<double>& value) {
        if (value) target = static_cast<float>(*value);
    };
    laser.has_figure = reader.has("figure");
    read_kind(reader, figure);
    if (const auto rays = reader.integer("rays", 1, fixture::kMostRays)) figure.count = *rays;
    const auto widest = static_cast<double>(fixture::kWidestFigure_deg);
    if (const auto size = reader.numbers("size_deg", 2, 0, widest))
        figure.size_deg = {static_cast<float>((*size)[0]), static_cast<float>((*size)[1])};
    put(figure.deg, reader.number("turn_deg", -360, 360));
    put(figure.deg_s, reader.number("turning_deg_s", -3600, 3600));
    const auto fastest = static_cast<double>(fixture::kMostFigure_hz);
    put(figure.move_hz, reader.number("running_hz", -fastest, fastest));
    put(laser.watts, reader.number("watts", 1e-3, 1000));
    laser.colour = reader.colour("colour");
    for (const char* key : {"rays", "size_deg", "turn_deg", "turning_deg_s", "running_hz"})
        if (!laser.has_figure && reader.has(key))
            reader.problem(Severity::warning, key, "is not used: it says nothing of a figure");
    reader.finish();
    return laser;
}

} // namespace ghost::scene
