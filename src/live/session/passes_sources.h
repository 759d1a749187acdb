#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whether baked passes are of the show as it is: a hash of all that they are made from, kept beside them. The
// bake itself compares in detail; this only says whether it has to be asked. Reads whole files; any thread.

#include "base/result.h"
#include "show/show.h"

#include <string>

namespace ghost::app {

// Of the show file, the stage with what lies beside it, the fixture files and the baker.
std::string passes_fingerprint(const scene::Show& show);
// Of the passes that a camera has: another one means that it was baked meanwhile.
std::string baked_fingerprint(const scene::Show& show, const std::string& camera);
// The passes of this camera were made from that.
Result<void> remember_sources(const scene::Show& show, const std::string& camera,
                              const std::string& fingerprint);
bool passes_are_of(const scene::Show& show, const std::string& camera, const std::string& fingerprint);

} // namespace ghost::app
