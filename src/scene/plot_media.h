#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a plot's video projectors show (MVR 1.6, Projector, Sources). Files of a source are those of
// the archive, unpacked into show.cache_folder(), or lie beside the plot; streams (NDI, CITP) become a test
// card, with a message.

#include "scene/plot.h"
#include "scene/show.h"

#include <string>

namespace ghost::scene {

// The medium of a source, added to show.media where it is new. name: of the object; where: for messages.
int media_of_source(Show& show, const PlotSource& source, const std::string& name, const std::string& where,
                    Report& report);

// object: of kind projector; throw and shape are those of its type's beam.
Projector plot_projector(Show& show, const PlotObject& object, const fixture::Type& type,
                         const std::string& where, Report& report);

} // namespace ghost::scene
