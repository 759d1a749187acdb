// SPDX-License-Identifier: Apache-2.0
#include "scene/plot_media.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace ghost::scene {
namespace {

constexpr float kLeastThrow = 0.1f;
constexpr float kMostThrow = 100.0f;

int add_media(Show& show, Media media, Report& report) {
    const auto same = std::find_if(show.media.begin(), show.media.end(), [&](const Media& one) {
        return one.kind == media.kind && one.file == media.file && one.card == media.card;
    });
    if (same != show.media.end()) return static_cast<int>(same - show.media.begin());
    if (show.media.size() >= kMaxMedia) {
        report.add(Severity::error, media.where,
                   "more than " + std::to_string(kMaxMedia) +
                       " media in one show; the first one is shown instead");
        return 0;
    }
    show.media.push_back(std::move(media));
    return static_cast<int>(show.media.size()) - 1;
}

} // namespace

int media_of_source(Show& show, const PlotSource& source, const std::string& name, const std::string& where,
                    Report& report) {
    Media media;
    media.name = name;
    media.where = where;
    if (source.type == "File") {
        // Files of a plot stand in no folder; what it names may be another machine's path.
        std::string file = source.value;
        std::replace(file.begin(), file.end(), '\\', '/');
        media.file = show.folder / std::filesystem::path(file).filename();
        std::error_code code;
        if (!std::filesystem::is_regular_file(media.file, code))
            report.add(Severity::error, where,
                       "'" + name + "' shows '" + source.value + "', expected beside the plot as " +
                           media.file.string() + "; a striped card is shown until it is there");
    } else if (source.type == "CaptureDevice") {
        media.kind = MediaKind::camera;
        media.file = source.value;
    } else {
        media.kind = MediaKind::card;
        if (!source.type.empty())
            report.add(Severity::warning, where,
                       "'" + name + "' shows a stream (" + source.type + " '" + source.value +
                           "'), which cannot be received; a test card is shown");
    }
    return add_media(show, std::move(media), report);
}

Projector plot_projector(Show& show, const PlotObject& object, const fixture::Type& type,
                         const std::string& where, Report& report) {
    Projector projector;
    for (const fixture::Geometry& geometry : type.geometries) {
        if (!geometry.beam) continue;
        if (geometry.beam->throw_ratio >= kLeastThrow && geometry.beam->throw_ratio <= kMostThrow)
            projector.throw_ratio = geometry.beam->throw_ratio;
        if (geometry.beam->rectangle_ratio >= 0.1f && geometry.beam->rectangle_ratio <= 10.0f)
            projector.aspect = geometry.beam->rectangle_ratio;
        break;
    }
    PlotSource source;
    for (const PlotProjection& projection : object.projections) {
        if (projection.sources.empty()) continue;
        source = projection.sources.front();
        projector.fit = projection.scale == PictureScale::ignore_ratio ? Fit::stretch : Fit::contain;
        break;
    }
    projector.media =
        media_of_source(show, source, object.name.empty() ? "projector" : object.name, where, report);
    return projector;
}

} // namespace ghost::scene
