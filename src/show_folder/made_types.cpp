// SPDX-License-Identifier: Apache-2.0
#include "show_folder/private/made_types.h"

#include "fixture_files/common/laser_type.h"
#include "fixture_files/common/projector_type.h"
#include "fixture_files/common/wall_type.h"
#include "light/led_wall_light.h"
#include "show/show.h"

namespace ghost::scene {

std::shared_ptr<const fixture::Type> type_without_file(const PatchedFixture& fixture) {
    if (fixture.wall)
        return fixture::led_wall_type(fixture.wall->size_m, cells_of(*fixture.wall), fixture.wall->nits);
    if (fixture.projector) return fixture::video_projector_type();
    return fixture.laser ? fixture::show_laser_type() : nullptr;
}

} // namespace ghost::scene
