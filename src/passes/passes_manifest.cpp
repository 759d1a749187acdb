// SPDX-License-Identifier: Apache-2.0
#include "passes/passes_file.h"

#include "disk/files.h"
#include "image/exr.h"
#include "json_xml_toml/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace ghost::scene {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxManifestBytes = 16u << 20;

json numbers(const glm::vec3& v) {
    return json::array({v.x, v.y, v.z});
}

// Reads one JSON object; the first thing that is missing or wrong is kept in problem.
struct Fields {
    const json& object;
    std::string place;
    std::string& problem;

    const json* find(const char* key) const {
        if (!object.is_object() || !object.contains(key)) {
            fail(key, "is missing");
            return nullptr;
        }
        return &object.at(key);
    }
    void fail(const char* key, const char* what) const {
        if (problem.empty()) problem = place + key + " " + what;
    }
    std::string text(const char* key) const {
        const json* value = find(key);
        if (value == nullptr) return {};
        if (value->is_string() && value->get_ref<const std::string&>().size() <= 1000)
            return value->get<std::string>();
        fail(key, "must be text of at most 1000 characters");
        return {};
    }
    // A name in this folder, never a way out of it.
    std::string file(const char* key) const {
        const std::string name = text(key);
        if (name.empty() || name[0] == '.' || name.find_first_of("/\\") != std::string::npos ||
            name.find('\0') != std::string::npos) {
            fail(key, "must be a plain file name");
            return {};
        }
        return name;
    }
    std::int64_t whole(const char* key, std::int64_t low, std::int64_t high) const {
        const json* value = find(key);
        if (value == nullptr) return low;
        if (value->is_number_integer()) {
            const auto number = value->is_number_unsigned() && value->get<std::uint64_t>() > INT64_MAX
                                    ? INT64_MAX
                                    : value->get<std::int64_t>();
            if (number >= low && number <= high) return number;
        }
        fail(key,
             ("must be a whole number from " + std::to_string(low) + " to " + std::to_string(high)).c_str());
        return low;
    }
    bool flag(const char* key) const {
        const json* value = find(key);
        if (value != nullptr && value->is_boolean()) return value->get<bool>();
        fail(key, "must be true or false");
        return false;
    }
    void floats(const char* key, float* to, std::size_t count) const {
        const json* value = find(key);
        if (value == nullptr) return;
        bool good = value->is_array() && value->size() == count;
        for (std::size_t k = 0; good && k < count; ++k) {
            good = (*value)[k].is_number() && std::isfinite((*value)[k].get<float>());
            if (good) to[k] = (*value)[k].get<float>();
        }
        if (!good) fail(key, ("must be " + std::to_string(count) + " numbers").c_str());
    }
    const json& list(const char* key) const {
        static const json empty = json::array();
        const json* value = find(key);
        if (value != nullptr && value->is_array() && value->size() <= kMaxLightPasses) return *value;
        fail(key, ("must be a list of at most " + std::to_string(kMaxLightPasses) + " entries").c_str());
        return empty;
    }
};

} // namespace

std::string manifest_text(const PassManifest& m) {
    json matrix = json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix.push_back(m.camera_to_world[column][row]);
    json bodies = json::array();
    for (const ManifestBody& body : m.bodies)
        bodies.push_back({{"fixture", body.fixture}, {"key", body.key}, {"rect", body.rect}});
    json lights = json::array();
    for (const ManifestLight& light : m.lights)
        lights.push_back({{"fixture", light.fixture},
                          {"stop", light.stop},
                          {"position_m", numbers(light.position_m)},
                          {"picture", light.picture},
                          {"indirect", light.indirect},
                          {"key", light.key}});
    const json all = {{"version", kPassesVersion},
                      {"camera", m.camera},
                      {"camera_to_world", matrix},
                      {"fov_y_deg", m.fov_y_deg},
                      {"width", m.width},
                      {"height", m.height},
                      {"spp", m.spp},
                      {"bounces", m.bounces},
                      {"primaries", "rec2020"},
                      {"intensity_cd", kPictureCandela},
                      {"geometry_key", m.geometry_key},
                      {"layout_key", m.layout_key},
                      {"folder", m.folder},
                      {"extra_count", m.extra_count},
                      {"has_emission", m.has_emission},
                      {"bodies", bodies},
                      {"lights", lights}};
    return all.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<PassManifest> parse_manifest(std::string_view text, const std::string& where) {
    const auto read = read_json(text, where, {.bytes = kMaxManifestBytes});
    if (!read.ok()) return Error{read.error().what + "; run `ghostlight bake` again", where};
    const json& all = *read;
    std::string problem;
    const Fields top{all, "", problem};
    PassManifest m;
    m.version = static_cast<int>(top.whole("version", 1, INT32_MAX));
    if (problem.empty() && m.version > kPassesVersion)
        return Error{"has version " + std::to_string(m.version) + ", this program reads up to " +
                         std::to_string(kPassesVersion) + "; run `ghostlight bake` again",
                     where};
    m.camera = top.text("camera");
    top.floats("camera_to_world", &m.camera_to_world[0][0], 16);
    m.width = static_cast<int>(top.whole("width", 1, image::kMaxSide));
    m.height = static_cast<int>(top.whole("height", 1, image::kMaxSide));
    m.spp = static_cast<int>(top.whole("spp", 1, 1 << 20));
    m.bounces = static_cast<int>(top.whole("bounces", 0, 64));
    if (const json* fov = top.find("fov_y_deg"); fov != nullptr) {
        if (fov->is_number() && fov->get<float>() > 0.0f && fov->get<float>() < 180.0f)
            m.fov_y_deg = fov->get<float>();
        else
            top.fail("fov_y_deg", "must be between 0 and 180");
    }
    m.geometry_key = top.text("geometry_key");
    m.layout_key = top.text("layout_key");
    m.folder = top.file("folder");
    const std::int64_t pixels = static_cast<std::int64_t>(m.width) * m.height;
    m.extra_count = static_cast<std::size_t>(top.whole("extra_count", 0, kMostExtraFragments * pixels));
    m.has_emission = top.flag("has_emission");
    for (const json& entry : top.list("bodies")) {
        const Fields fields{entry, "bodies[" + std::to_string(m.bodies.size()) + "].", problem};
        ManifestBody body{fields.text("fixture"), fields.text("key"), {}};
        float rect[4] = {};
        fields.floats("rect", rect, 4);
        for (std::size_t k = 0; k < 4; ++k)
            body.rect[k] =
                static_cast<int>(std::fmin(std::fmax(rect[k], 0.0f), static_cast<float>(image::kMaxSide)));
        m.bodies.push_back(std::move(body));
    }
    for (const json& entry : top.list("lights")) {
        const Fields fields{entry, "lights[" + std::to_string(m.lights.size()) + "].", problem};
        ManifestLight light;
        light.fixture = fields.text("fixture");
        light.stop = static_cast<int>(fields.whole("stop", 0, 100000));
        fields.floats("position_m", &light.position_m.x, 3);
        light.picture = fields.file("picture");
        light.indirect = fields.flag("indirect");
        light.key = fields.text("key");
        m.lights.push_back(std::move(light));
    }
    if (!problem.empty()) return Error{problem + "; run `ghostlight bake` again", where};
    return m;
}

Result<PassManifest> read_manifest(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / "manifest.json";
    TRY(const std::string text, read_text_file(path, kMaxManifestBytes));
    return parse_manifest(text, path.string());
}

} // namespace ghost::scene
