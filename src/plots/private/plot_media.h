#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a plot's video projectors show (MVR 1.6, Projector, Sources). Files of a source are those of
// the archive, unpacked into .ghost/media of the folder, or lie beside the plot; streams (NDI, CITP) become a
// test card, with a message.

#include "base/report.h"
#include "fixture/type.h"
#include "mvr/plot.h"
#include "show/projector.h"

#include <cstdint>
#include <string>

namespace ghost::scene {

struct Show;

// The medium of a source, added to show.media where it is new. name: of the object; where: for messages.
int media_of_source(Show& show, const PlotSource& source, const std::string& name, const std::string& where,
                    Report& report);

inline constexpr std::uint64_t kMostFilmBytes = std::uint64_t{2} << 30; // of one plot, unpacked

// Unpacks what show.media needs of the plot's archive and is not there yet, and removes what no plot of the
// folder needs any more. After the last media_of_source().
void unpack_media(const Show& show, Report& report, std::uint64_t most_bytes = kMostFilmBytes);

// object: of kind projector; throw and shape are those of its type's beam.
Projector plot_projector(Show& show, const PlotObject& object, const fixture::Type& type,
                         const std::string& where, Report& report);

} // namespace ghost::scene
