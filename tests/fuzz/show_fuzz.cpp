// SPDX-License-Identifier: Apache-2.0
// show.toml from anybody: never a crash, and whatever is kept is within its limits.
#include "base/check.h"
#include "show/mover_motion.h"
#include "show_file/show_toml.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ghost::Report report;
    auto parsed = ghost::scene::parse_show(std::string_view(reinterpret_cast<const char*>(data), size),
                                           "fuzz/show.toml", report);
    if (!parsed.ok()) return 0;
    ghost::scene::check_movers(parsed->show, report);
    const ghost::scene::Show& show = parsed->show;
    CHECK_EQ(parsed->sources.size(), show.fixtures.size());
    for (const auto& camera : show.cameras) {
        CHECK(camera.width >= 1 && camera.height >= 1 && camera.width <= 16384 && camera.height <= 16384);
        const glm::mat4 matrix = ghost::scene::camera_to_world(camera);
        for (int k = 0; k < 4; ++k) CHECK(std::isfinite(matrix[k].x + matrix[k].y + matrix[k].z));
    }
    for (const auto& fixture : show.fixtures) {
        CHECK(!fixture.name.empty() && fixture.name.find('/') == std::string::npos);
        CHECK(fixture.address >= 0 && fixture.address <= 512 && fixture.universe >= 1);
        for (std::size_t stop = 0; stop < fixture.stops_m().size(); ++stop)
            CHECK(std::isfinite(ghost::scene::fixture_to_world(fixture, stop)[3].x));
    }
    ghost::scene::MoverMotion motion(show.movers);
    motion.step({}, 1.0, 0.1, show.motion);
    for (std::size_t k = 0; k < show.movers.size(); ++k)
        for (int column = 0; column < 4; ++column)
            CHECK(std::isfinite(glm::dot(motion.moved(k)[column], glm::vec4(1))));
    return 0;
}
