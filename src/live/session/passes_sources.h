#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whether baked passes are of the show as it is: a hash of all that they are made from, kept beside them. The
// bake itself compares in detail; this only says whether it has to be asked. Reads whole files; any thread.

#include "base/result.h"
#include "show/show.h"

#include <cstdint>
#include <string>

namespace ghost::app {

inline constexpr std::uintmax_t kMostSourceBytes = std::uintmax_t{4} << 30; // of all sources that are read

// Of the show file, the stage with what lies beside it, the fixture files and the baker. A file of many names
// counts once. Of files that do not fit into most_bytes together, size and time.
std::string passes_fingerprint(const scene::Show& show, std::uintmax_t most_bytes = kMostSourceBytes);
// Of the passes that a camera has: another one means that it was baked meanwhile.
std::string baked_fingerprint(const scene::Show& show, const std::string& camera);
// The passes of this camera were made from that.
Result<void> remember_sources(const scene::Show& show, const std::string& camera,
                              const std::string& fingerprint);
bool passes_are_of(const scene::Show& show, const std::string& camera, const std::string& fingerprint);

} // namespace ghost::app
