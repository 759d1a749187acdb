// SPDX-License-Identifier: Apache-2.0
// Prints what a lamp at address 1 sends out with all its channels at 0 and at 255: light FILE.gdtf
#include <cstdio>
#include <fixture_files/load_type.h>
#include <light/rig.h>
#include <shared/develop.h>
#include <show/show.h>

int main(int count, char** words) {
    using namespace ghost;
    if (count != 2) return 2;
    auto loaded = fixture::load_type(words[1]);
    if (!loaded.ok()) {
        std::fprintf(stderr, "%s\n", loaded.error().text().c_str());
        return 1;
    }
    scene::Show show;
    show.fixtures.emplace_back().type = std::make_shared<const fixture::Type>(std::move(loaded->type));
    Report report;
    const scene::GoboStack gobos = scene::build_gobos(show, report);
    scene::Rig rig(show);
    for (const int level : {0, 255}) {
        dmx::Levels levels;
        levels.fill(static_cast<std::uint8_t>(level));
        dmx::Universes universes;
        universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
        rig.step(universes, 10); // seconds: whatever its motors and filament take
        for (const shared::Light& light : rig.lights(gobos, scene::DistanceMaps{}))
            std::printf("%d: %.0f cd\n", level,
                        static_cast<double>(shared::luminance_of(light.intensity_cd)));
    }
    return 0;
}
