// SPDX-License-Identifier: Apache-2.0
#include "passes/passes_foreign.h"

#include "base/memory.h"
#include "image/exr.h"
#include "image/finite.h"
#include "json_xml_toml/toml_reader.h"
#include "passes/passes.h"
#include "passes/passes_file.h"

#include "disk/files.h"
#include "show/show.h"

#include <cmath>
#include <optional>

namespace ghost::scene {
namespace {

constexpr std::uintmax_t kMaxTomlBytes = 4u << 20;
constexpr double kFar_m = 1e6;

// Four rows of four numbers; unit columns at right angles, as a camera's are.
std::optional<glm::mat4> read_matrix(const toml::table& table) {
    const toml::array* rows = table["matrix_world"].as_array();
    if (rows == nullptr || rows->size() != 4) return std::nullopt;
    glm::mat4 matrix(1.0f);
    for (std::size_t row = 0; row < 4; ++row) {
        const toml::array* numbers = rows->get(row)->as_array();
        if (numbers == nullptr || numbers->size() != 4) return std::nullopt;
        for (std::size_t column = 0; column < 4; ++column) {
            const std::optional<double> number = numbers->get(column)->value<double>();
            if (!number || !std::isfinite(*number) || std::abs(*number) > kFar_m) return std::nullopt;
            matrix[static_cast<int>(column)][static_cast<int>(row)] = static_cast<float>(*number);
        }
    }
    const glm::mat3 turn(matrix);
    const glm::mat3 product = glm::transpose(turn) * turn;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            if (std::abs(product[a][b] - (a == b ? 1.0f : 0.0f)) > 1e-2f) return std::nullopt;
    return matrix;
}

ForeignLight read_light(const toml::table& table, bool y_up, const std::string& file, Report& report) {
    TableReader reader(table, "[[light]]", file, report);
    ForeignLight light;
    light.line = reader.line();
    light.name = reader.text("name").value_or("");
    if (light.name.empty()) reader.missing("name", "the name of the fixture in show.toml");
    light.file = reader.text("file").value_or("");
    if (light.file.empty()) reader.missing("file", "the EXR picture lit by this source alone");
    light.stop = reader.integer("stop", 0, 100000).value_or(0);
    if (const auto place = reader.vec3("position_m", kFar_m))
        light.position_m = y_up ? z_up(*place) : *place;
    else
        reader.missing("position_m", "where the point source is, [x, y, z]");
    light.intensity_cd = static_cast<float>(reader.number("intensity_cd", 1e-6, 1e9).value_or(1.0));
    reader.finish();
    return light;
}

// Of all pixels: fragment places from the position picture, coverage -1 where its alpha is 0.
Result<void> read_positions(const std::filesystem::path& path, bool y_up, Passes& passes, Report& report) {
    TRY(const image::ExrFile file, image::read_exr(path));
    int channel[4];
    for (int k = 0; k < 4; ++k) {
        channel[k] = file.find_channel(std::string(1, "RGBA"[k]));
        if (channel[k] < 0 && k < 3) channel[k] = file.find_channel(std::string(1, "XYZ"[k]));
        if (channel[k] < 0 && k < 3)
            return Error{"has no channel " + std::string(1, "RGB"[k]) +
                             ", expected R G B = x y z in metres and A",
                         path.string()};
    }
    passes.width = file.pixels.width;
    passes.height = file.pixels.height;
    const std::size_t pixels = passes.pixel_count();
    const auto stride = static_cast<std::size_t>(file.pixels.channels);
    passes.fragments.assign(pixels, glm::vec4(0, 0, 0, -1));
    std::size_t bad = 0;
    for (std::size_t p = 0; p < pixels; ++p) {
        const float* pixel = file.pixels.samples.data() + p * stride;
        if (channel[3] >= 0 && !(pixel[channel[3]] > 0.5f)) continue;
        const glm::vec3 at(pixel[channel[0]], pixel[channel[1]], pixel[channel[2]]);
        if (!image::is_finite(at)) {
            ++bad;
            continue;
        }
        passes.fragments[p] = glm::vec4(y_up ? z_up(at) : at, 1.0f);
    }
    if (channel[3] < 0)
        report.add(Severity::note, path.string(), "has no channel A; every pixel counts as a surface");
    if (bad > 0)
        report.add(Severity::warning, path.string(),
                   std::to_string(bad) + " positions are not finite numbers; those pixels stay dark");
    return {};
}

Result<std::vector<std::uint16_t>> read_radiance(const std::filesystem::path& path, const ForeignLight& light,
                                                 const image::Chromaticities& primaries, const Passes& passes,
                                                 Report& report) {
    TRY(const std::vector<glm::vec3> values,
        read_picture(path, passes.width, passes.height, light.intensity_cd, "", report, &primaries));
    std::vector<std::uint16_t> halves(values.size() * 4, 0);
    for (std::size_t p = 0; p < values.size(); ++p) {
        if (passes.fragments[p].w < 0.0f) continue;
        // Colours outside Rec.2020 cannot be shown and would take light away from others.
        const glm::vec3 value = glm::max(values[p], glm::vec3(0.0f)) * kRadianceScale;
        for (int c = 0; c < 3; ++c) halves[4 * p + static_cast<std::size_t>(c)] = to_half(value[c]);
    }
    return halves;
}

} // namespace

glm::vec3 z_up(const glm::vec3& y_up) {
    return {y_up.x, -y_up.z, y_up.y};
}

Result<ForeignPasses> parse_foreign_passes(std::string_view text, const std::string& file, Report& report) {
    ForeignPasses passes;
    try {
        const toml::table root = toml::parse(text, file);
        TableReader top(root, "", file, report);
        passes.position = top.text("position").value_or("");
        if (passes.position.empty())
            return Error{"has no 'position', expected the name of the position picture", file};
        const std::string axes = top.text("axes").value_or("z-up");
        if (axes != "z-up" && axes != "y-up")
            top.problem(Severity::error, "axes",
                        "is '" + axes + "', expected \"z-up\" or \"y-up\"; z-up is taken");
        passes.y_up = axes == "y-up";
        const std::string primaries = top.text("primaries").value_or("rec709");
        if (primaries != "rec709" && primaries != "rec2020")
            top.problem(Severity::error, "primaries",
                        "is '" + primaries + "', expected \"rec709\" or \"rec2020\"; rec709 is taken");
        passes.primaries = primaries == "rec2020" ? image::kRec2020 : image::kRec709;

        const toml::table* camera = top.table("camera");
        if (camera == nullptr) return Error{"has no [camera] with matrix_world and fov_y_deg", file};
        TableReader camera_reader(*camera, "[camera]", file, report);
        const std::optional<glm::mat4> matrix = read_matrix(*camera);
        if (!camera_reader.has("matrix_world") || !matrix)
            return Error{
                "[camera] matrix_world must be four rows of four numbers: a rotation and a place in metres",
                camera_reader.where("matrix_world")};
        passes.camera_to_world = *matrix;
        if (passes.y_up)
            for (int column = 0; column < 4; ++column)
                passes.camera_to_world[column] =
                    glm::vec4(z_up(glm::vec3(passes.camera_to_world[column])), column == 3 ? 1.0f : 0.0f);
        if (const auto fov = camera_reader.number("fov_y_deg", 0.01, 179))
            passes.fov_y_deg = static_cast<float>(*fov);
        else
            camera_reader.missing("fov_y_deg", "the vertical field of view in degrees");
        camera_reader.finish();

        for (const toml::table* table : top.tables("light", kMaxLightPasses)) {
            ForeignLight light = read_light(*table, passes.y_up, file, report);
            if (!light.name.empty() && !light.file.empty()) passes.lights.push_back(std::move(light));
        }
        top.finish();
    } catch (const toml::parse_error& problem) {
        return Error{"is not TOML: " + std::string(problem.description()),
                     file_line(file, static_cast<int>(problem.source().begin.line))};
    }
    return passes;
}

Result<Passes> load_foreign_passes(const std::filesystem::path& toml, Report& report) {
    TRY(const std::string text, read_text_file(toml, kMaxTomlBytes));
    TRY(const ForeignPasses foreign, parse_foreign_passes(text, toml.string(), report));
    const std::filesystem::path folder = toml.parent_path();
    Passes passes;
    passes.camera_to_world = foreign.camera_to_world;
    passes.fov_y_deg = foreign.fov_y_deg;
    TRY_VOID(read_positions(folder / foreign.position, foreign.y_up, passes, report));
    TRY_VOID(check_light_memory(passes.pixel_count(), foreign.lights.size(), toml, free_memory_bytes()));
    passes.extra_first.assign(passes.pixel_count() + 1, 0);
    passes.ambient.assign(passes.pixel_count(), glm::vec4(0.0f));
    for (const ForeignLight& entry : foreign.lights) {
        LightPass light;
        light.fixture = entry.name;
        light.stop = entry.stop;
        light.position_m = entry.position_m;
        light.file = folder / entry.file;
        if (auto radiance = read_radiance(light.file, entry, foreign.primaries, passes, report);
            radiance.ok())
            light.radiance = std::move(*radiance);
        else
            report.add(Severity::error, file_line(toml.string(), entry.line),
                       radiance.error().text() + "; light '" + entry.name + "' is dark");
        passes.lights.push_back(std::move(light));
    }
    return passes;
}

} // namespace ghost::scene
