#pragma once
// SPDX-License-Identifier: Apache-2.0
// edit_description: the text of an MVR description with some of its objects changed. Only elements that
// change are touched; comments, blanks, entities, elements and attributes that we do not know stay as they
// are written (but attributes are set in double quotes, and empty elements all look alike). Pure.

#include "base/byte_reader.h"
#include "base/result.h"
#include "mvr/plot.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

struct PlotEdit {
    int object = -1; // Plot::objects
    PlotChange change;
};

// xml: what the plot was read from. Nothing where it says all of this already. Error: it is not what the plot
// was read from (any more).
Result<std::optional<std::string>>
edit_description(Bytes xml, const Plot& plot, std::span<const PlotEdit> edits, const std::string& where);

} // namespace ghost::scene
