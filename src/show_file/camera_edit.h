#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the cameras in show.toml, as those of show_edit.h: all but the edited keys and blocks stays byte
// for byte. cameras: those of the show that is read from the text. Pure; any thread.

#include "base/result.h"
#include "show/camera.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::scene {

// Where the file has no [[camera]], those that were made for the show are written into it: one of its own
// would take their place.
Result<std::string> own_cameras(const std::string& text, const std::vector<Camera>& cameras);
// Cues and trackers that name it, and movers that carry it, have the new name. Error, of both: the file has
// no [[camera]], so that those there are were made from where fixtures hang; or one that cannot be read.
Result<std::string> rename_camera(const std::string& text, const std::vector<Camera>& cameras,
                                  std::size_t index, const std::string& name);
Result<std::string> remove_camera(const std::string& text, const std::vector<Camera>& cameras,
                                  std::size_t index);

} // namespace ghost::scene
