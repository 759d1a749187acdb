// SPDX-License-Identifier: Apache-2.0
#include "show/show.h"
#include "show_file/scene_toml.h"

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxModels = 1000;

} // namespace

void read_models(TableReader& top, const std::string& file, Show& show, Report& report) {
    for (const toml::table* table : top.tables("model", kMaxModels)) {
        TableReader reader(*table, "[[model]]", file, report);
        Model model;
        const auto name = reader.text("file");
        if (!reader.has("file")) reader.missing("file", "the name of a model file (.glb)");
        model.position_m = reader.vec3("position_m", kMaxCoordinate_m).value_or(model.position_m);
        model.rotation_deg = reader.vec3("rotation_deg", 36'000).value_or(model.rotation_deg);
        model.scale = static_cast<float>(reader.number("scale", 1e-4, 1e4).value_or(1.0));
        model.where = reader.where("file");
        reader.finish();
        if (!name) continue;
        model.file = show.folder / *name;
        show.models.push_back(std::move(model));
    }
}

} // namespace ghost::scene
