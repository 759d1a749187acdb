// SPDX-License-Identifier: Apache-2.0
#include "cli/render/chosen_cameras.h"

#include <set>

namespace ghost::app {

Result<std::vector<scene::Camera>>
chosen_cameras(const scene::Show& show, const std::vector<std::string>& views, int width, int height) {
    std::vector<scene::Camera> cameras = show.cameras;
    if (cameras.size() > 1) cameras.pop_back(); // that of the size of the sheet, see open_session
    if (!views.empty()) {
        scene::Show named; // without the one that was added
        named.file = show.file;
        named.cameras = cameras;
        std::vector<scene::Camera> chosen;
        std::set<std::size_t> taken; // who says a camera twice sees it once
        for (const std::string& view : views) {
            TRY(const std::size_t index, named.find_camera(view));
            if (taken.insert(index).second) chosen.push_back(cameras[index]);
        }
        cameras = std::move(chosen);
    }
    for (scene::Camera& camera : cameras) {
        camera.width = width;
        camera.height = height;
    }
    return cameras;
}

} // namespace ghost::app
