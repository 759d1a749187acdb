// SPDX-License-Identifier: Apache-2.0
// The links of bounced light as a file of .ghost/bounce, and a part of such that were stopped: any bytes
// behind a right head and before a right checksum. Links that are taken carry light to places that are there.
#include "fuzz_folder.h"

#include "bounce/bounce_file.h"
#include "bounce/bounce_parts.h"
#include "bounce/bounce_volumes.h"
#include "disk/crc32.h"

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace ghost;
using namespace ghost::scene;

namespace {

void solve(const Bounce& bounce) {
    BounceSolver solver(bounce);
    solver.set_haze({0.02f, 0.02f, 0.7f, -0.3f, 0.1f});
    shared::Light lamp{};
    lamp.position_m = (bounce.grid.low_m + bounce.grid.high_m()) * 0.5f;
    lamp.axis_u = {1, 0, 0};
    lamp.axis_v = {0, 1, 0};
    lamp.axis_w = {0, 0, -1};
    lamp.tan_field = lamp.cut_radius = lamp.iris_radius = lamp.profile_power = lamp.profile_scale = 1;
    lamp.lens_m = 0.1f;
    lamp.split = shared::kNoSplit;
    lamp.intensity_cd = lamp.bounce_cd = glm::vec3(1000);
    LampSight sight;
    sight.position_m = lamp.position_m;
    sight.size = kSmallLampSightSize;
    const std::size_t texels = kSmallLampSightSize * kSmallLampSightSize;
    sight.albedo.assign(texels, packed_albedo(glm::vec3(0.5f)));
    sight.surfel.assign(texels, bounce.fine.surfels.empty() ? kNoNode : 0);
    sight.distance_m.assign(texels, 0x4000); // 2 m, as a half
    const BounceSolution& solution = solver.solve({lamp}, {&sight}, {});
    if (solution.lux.size() != bounce.fine.surfels.size()) std::abort();
    BounceVolumes volumes;
    fill_lux(bounce, solution, volumes);
    fill_glow(bounce, solver.air(), solution, {0, -5, 2}, volumes);
    (void)lux_on(volumes, lamp.position_m, {0, 0, 1});
}

const std::string kKey(32, 'a');

std::vector<std::uint8_t> file_of(const std::string& magic, const std::uint8_t* data, std::size_t size) {
    const std::string head = magic + kKey;
    std::vector<std::uint8_t> file(head.begin(), head.end());
    file.insert(file.end(), data, data + size);
    const std::uint32_t check = crc32(file);
    for (int k = 0; k < 4; ++k) file.push_back(static_cast<std::uint8_t>(check >> (8 * k)));
    return file;
}

void take_part(const std::uint8_t* data, std::size_t size) {
    fuzz_file("room.near-0.part", file_of("ghostlight bounce part 3\n", data, size));
    BounceLevel level;
    level.cells.resize(1);
    level.surfels.resize(1);
    BounceParts parts(fuzz_folder() / "room.bin", fuzz_folder(), kKey);
    std::vector<std::vector<FoundLink>> rows(2);
    std::vector<float> far_share(level.first_slot(rows.size()));
    if (!parts.take(level, false, 0, rows, far_share)) return;
    for (const auto& row : rows)
        for (const FoundLink& link : row)
            if (link.receiver >= level.slots() || link.emitter >= level.slots()) std::abort();
    if (!std::all_of(far_share.begin(), far_share.end(), is_share)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    take_part(data, size);
    const auto bounce =
        read_bounce(fuzz_file("room.bin", file_of("ghostlight bounce 4\n", data, size)), kKey);
    if (!bounce.ok() || !*bounce) return 0;
    solve(**bounce);
    const std::filesystem::path copy = fuzz_folder() / "again.bin";
    if (!write_bounce(copy, kKey, **bounce).ok() || !read_bounce(copy, kKey).ok()) std::abort();
    return 0;
}
