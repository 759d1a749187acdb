// SPDX-License-Identifier: Apache-2.0
#include "live/session/picture_room.h"

#include <algorithm>
#include <cmath>

namespace ghost::app {
scene::Camera fitted(const scene::Camera& wanted, std::uint64_t room_bytes) {
    const double pixels = static_cast<double>(wanted.width) * static_cast<double>(wanted.height);
    const double room = static_cast<double>(room_bytes) / static_cast<double>(kPictureBytesPerPixel);
    if (pixels <= room) return wanted;
    scene::Camera less = wanted;
    const double share = std::sqrt(room / pixels);
    const auto side = [&](int pixels_wanted) {
        return std::min(std::max(static_cast<int>(share * pixels_wanted), kLeastPixels), pixels_wanted);
    };
    less.width = side(wanted.width);
    less.height = side(wanted.height);
    return less;
}

} // namespace ghost::app
