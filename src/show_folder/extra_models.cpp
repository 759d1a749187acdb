// SPDX-License-Identifier: Apache-2.0
#include "show_folder/private/extra_models.h"

#include "show/show.h"
#include "show_folder/private/show_types.h"
#include "stage/model_reader.h"

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {
namespace {

glm::mat4 place_of(const Model& model) {
    return glm::scale(placed(model.position_m, model.rotation_deg), glm::vec3(model.scale));
}

} // namespace

void check_models(const Show& show, Report& report) {
    for (const Model& model : show.models)
        if (!is_file(model.file))
            report.add(Severity::error, model.where,
                       "[[model]] file: no such file " + model.file.string() + ". The stage is without it.");
}

void add_models(const Show& show, Stage& stage, Report& report) {
    for (const Model& model : show.models) {
        if (!is_file(model.file)) continue; // said by check_models
        auto loaded = load_stage_file(model.file, show.folder, report);
        if (!loaded.ok()) {
            report.add(Severity::error, loaded.error().where,
                       loaded.error().what + "; the stage is without it");
            continue;
        }
        if (stage.drawn_triangles() + loaded->drawn_triangles() > kMaxDrawnTriangles) {
            report.add(Severity::error, model.where,
                       "[[model]] '" + model.file.filename().string() +
                           "' would make more than 20 million triangles of the stage; it is left out");
            continue;
        }
        std::vector<Instance> objects = absorb(std::move(*loaded), place_of(model), stage);
        stage.instances.insert(stage.instances.end(), std::make_move_iterator(objects.begin()),
                               std::make_move_iterator(objects.end()));
    }
}

} // namespace ghost::scene
