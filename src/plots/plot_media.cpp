// SPDX-License-Identifier: Apache-2.0
#include "plots/private/plot_media.h"

#include "disk/files.h"
#include "disk/own_folder.h"
#include "mvr/mvr_load.h"
#include "show/show.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::uintmax_t kMaxListBytes = 1u << 20;
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

namespace fs = std::filesystem;

// FFmpeg reads files by their names: films of archives are unpacked beside what is baked. Named by their
// content, so that all versions of a plot share them.
fs::path media_folder(const Show& show) {
    return show.cache_root() / "media";
}

std::string stored_name(const LoadedPlot& plot, const std::string& member) {
    char checksum[16];
    std::snprintf(checksum, sizeof checksum, "%08x-", plot.archive.checksum(member));
    return checksum + fs::path(member).filename().string();
}

bool is_stored_name(const std::string& name) {
    return name.size() > 9 && name[8] == '-' &&
           name.find_first_not_of("0123456789abcdef") == std::string::size_type{8};
}

bool is_plain_file(const fs::path& path) {
    std::error_code code;
    return fs::is_regular_file(fs::symlink_status(path, code));
}

// The names that a show needs, one a line.
constexpr const char* kListName = "media.txt";

std::set<std::string> listed(const fs::path& file) {
    std::set<std::string> names;
    const auto text = read_text_file(file, kMaxListBytes);
    if (!text.ok()) return names;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) names.insert(line);
    return names;
}

// Of all shows of the folder that are still there.
std::set<std::string> needed_by_others(const Show& show) {
    const fs::path home = show.cache_root();
    std::set<std::string> needed = listed(home / kListName);
    std::error_code code;
    for (fs::directory_iterator entry(home, code), end; !code && entry != end; entry.increment(code))
        if (std::error_code unknown; fs::exists(show.folder / entry->path().filename(), unknown))
            needed.merge(listed(entry->path() / kListName));
    return needed;
}

void remove_unneeded(const Show& show, std::set<std::string> needed) {
    needed.merge(needed_by_others(show));
    const auto folder = OwnFolder::open(media_folder(show), show.cache_home());
    if (!folder.ok()) return;
    for (const OwnFolder::File& file : folder->entries().files)
        if (is_stored_name(file.name) && !needed.contains(file.name)) folder->remove_file(file.name);
}

Result<void> unpack(const Show& show, const std::string& member, const fs::path& file,
                    std::uint64_t& left_bytes) {
    std::error_code code;
    if (!is_plain_file(file)) {
        TRY(const std::vector<std::uint8_t> bytes, show.plot->archive.read(member, left_bytes));
        TRY_VOID(make_folders(media_folder(show), show.cache_home()));
        TRY_VOID(write_file_atomic(file, bytes));
    }
    left_bytes -= std::min<std::uint64_t>(left_bytes, fs::file_size(file, code));
    return {};
}

} // namespace

int media_of_source(Show& show, const PlotSource& source, const std::string& name, const std::string& where,
                    Report& report) {
    Media media;
    media.name = name;
    media.where = where;
    if (source.type == "File" && !source.member.empty()) {
        media.file = media_folder(show) / stored_name(*show.plot, source.member);
    } else if (source.type == "File") {
        // Beside the plot; what it names may be another machine's path. check_files (show.cpp) says if it is
        // missing.
        std::string file = source.value;
        std::replace(file.begin(), file.end(), '\\', '/');
        media.file = show.folder / std::filesystem::path(file).filename();
    } else if (source.type == "CaptureDevice") {
        // Somebody else's words: a device of another machine, or any file of this one.
        const std::filesystem::path device = std::filesystem::path(source.value).lexically_normal();
        if (device.string().starts_with("/dev/")) {
            media.kind = MediaKind::camera;
            media.file = device;
        } else {
            media.kind = MediaKind::card;
            report.add(Severity::warning, where,
                       "'" + name + "' shows the capture device '" + source.value.substr(0, 120) +
                           "', expected a device such as /dev/video0; a test card is shown");
        }
    } else {
        media.kind = MediaKind::card;
        if (!source.type.empty())
            report.add(Severity::warning, where,
                       "'" + name + "' shows a stream (" + source.type + " '" + source.value +
                           "'), which cannot be received; a test card is shown");
    }
    return add_media(show, std::move(media), report);
}

void unpack_media(const Show& show, Report& report, std::uint64_t most_bytes) {
    const fs::path folder = media_folder(show);
    std::error_code code;
    for (const fs::path& path : {folder.parent_path(), folder})
        if (fs::is_symlink(path, code)) {
            report.add(Severity::error, path.string(),
                       "is a link, expected a folder of this show: the films of the plot are not unpacked");
            return;
        }
    std::map<std::string, std::string> members; // by the name that they are stored under
    for (const std::string& member : show.plot->archive.names())
        members.emplace(stored_name(*show.plot, member), member);
    std::set<std::string> needed;
    std::string list;
    for (const Media& media : show.media)
        if (media.file.parent_path() == folder && needed.insert(media.file.filename().string()).second)
            list += media.file.filename().string() + "\n";
    const fs::path list_file = show.cache_folder() / kListName;
    if (list.empty() && !is_plain_file(list_file)) return;
    // First the list: from then on no other show takes away what is needed here.
    if (const auto had = read_text_file(list_file, kMaxListBytes); !had.ok() || *had != list) {
        auto written = make_folders(show.cache_folder(), show.cache_home());
        if (written.ok()) written = write_file_atomic(list_file, list);
        if (!written.ok()) report.add(Severity::warning, written.error().where, written.error().what);
    }
    std::uint64_t left_bytes = most_bytes;
    for (const Media& media : show.media) {
        const auto member = members.find(media.file.filename().string());
        if (media.file.parent_path() != folder || member == members.end()) continue;
        if (const auto done = unpack(show, member->second, media.file, left_bytes); !done.ok())
            report.add(Severity::error, media.where,
                       "'" + media.name + "' shows '" + member->second + "': " + done.error().text());
    }
    remove_unneeded(show, std::move(needed));
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
