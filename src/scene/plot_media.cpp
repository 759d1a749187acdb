// SPDX-License-Identifier: Apache-2.0
#include "scene/plot_media.h"

#include "base/files.h"
#include "scene/mvr_load.h"

#include <algorithm>
#include <cstdio>
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

// FFmpeg reads files by their names: a film of the archive is unpacked beside what is baked, once.
Result<std::filesystem::path> unpacked(const Show& show, const std::string& member) {
    char checksum[16];
    std::snprintf(checksum, sizeof checksum, "%08x-", show.plot->archive.checksum(member));
    const std::filesystem::path folder = show.cache_folder() / "media";
    const std::filesystem::path file =
        folder / (checksum + std::filesystem::path(member).filename().string());
    std::error_code code;
    if (std::filesystem::is_regular_file(file, code)) return file;
    TRY(const std::vector<std::uint8_t> bytes, show.plot->archive.read(member));
    TRY_VOID(make_folders(folder, show.folder));
    TRY_VOID(write_file_atomic(file, bytes));
    return file;
}

} // namespace

int media_of_source(Show& show, const PlotSource& source, const std::string& name, const std::string& where,
                    Report& report) {
    Media media;
    media.name = name;
    media.where = where;
    if (source.type == "File" && !source.member.empty()) {
        auto file = unpacked(show, source.member);
        if (file.ok())
            media.file = std::move(*file);
        else
            report.add(Severity::error, where,
                       "'" + name + "' shows '" + source.value + "': " + file.error().text());
    } else if (source.type == "File") {
        // Beside the plot; what it names may be another machine's path. check_files (show.cpp) says if it is
        // missing.
        std::string file = source.value;
        std::replace(file.begin(), file.end(), '\\', '/');
        media.file = show.folder / std::filesystem::path(file).filename();
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
