#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_gdtf: FTMacros of a mode.

#include "fixture_files/gdtf/private/gdtf_reader.h"

#include <functional>
#include <string>
#include <vector>

namespace ghost::fixture {

// The channels that a link means: one, or one per instance of a referenced geometry.
using FindChannels = std::function<std::vector<int>(const std::string& link)>;

// list: an FTMacros element. Values for channels that the mode has not are left out and said. Without
// say_missing, for misplaced lists that are tried on every mode, a macro that does not fit is left out whole.
void read_macros(GdtfReader& reader, pugi::xml_node list, const FindChannels& find_channels, bool say_missing,
                 Mode& mode);

} // namespace ghost::fixture
