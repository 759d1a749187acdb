// SPDX-License-Identifier: Apache-2.0
// Films and sounds of any bytes: what is shown has a size, what is heard is a number. FFmpeg itself has no
// counters here, so this lives by its seeds: small files of every kind.
#include "fuzz_folder.h"

#include "video/files/movie.h"
#include "video/files/sound_file.h"

#include <cmath>
#include <cstdlib>
#include <vector>

using namespace ghost;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

void watch(const std::filesystem::path& path) {
    const auto movie = video::Movie::open(path);
    if (!movie.ok()) return;
    require((*movie)->width() > 0 && (*movie)->height() > 0);
    require((*movie)->duration_s() > 0 && std::isfinite((*movie)->duration_s()));
    const auto show_some = [&] {
        for (int k = 0; k < 4; ++k) {
            const auto shown = (*movie)->next();
            if (!shown.ok() || !*shown) return;
            require(std::isfinite(**shown));
            const auto picture = (*movie)->picture(video::Movie::Which::newest, 32, 18);
            require(!picture.ok() || (picture->width == 32 && picture->height == 18));
        }
    };
    show_some();
    if ((*movie)->seek((*movie)->duration_s() / 2).ok()) show_some();
}

void listen(const std::filesystem::path& path) {
    const auto sound = video::SoundFile::open(path);
    if (!sound.ok()) return;
    std::vector<float> pairs(2 * video::kSoundRate_hz / 10);
    for (int k = 0; k < 4; ++k) {
        const std::size_t count = (*sound)->read(pairs.data(), pairs.size() / 2);
        require(count <= pairs.size() / 2);
        for (std::size_t i = 0; i < 2 * count; ++i) require(std::isfinite(pairs[i]));
        (*sound)->skip(0.05);
    }
    (void)(*sound)->problem();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::filesystem::path path = fuzz_file("film", {data, size});
    watch(path);
    listen(path);
    return 0;
}
