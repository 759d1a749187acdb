// SPDX-License-Identifier: Apache-2.0
#include "live/session/passes_sources.h"

#include "bake/hasher.h"
#include "bake/keys.h"
#include "disk/files.h"
#include "passes/passes_file.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxSourceBytes = 1u << 30;

fs::path file_beside(const scene::Show& show, const std::string& camera) {
    return scene::passes_folder(show, camera) / "sources.txt";
}

std::string stamp_of(const fs::path& file) {
    std::error_code unknown;
    return std::to_string(fs::file_size(file, unknown)) + " " +
           std::to_string(fs::last_write_time(file, unknown).time_since_epoch().count());
}

// Files beside the stage that it may refer to: textures, materials, buffers. Their sizes and times.
void add_companions(const fs::path& stage, const fs::path& cache, bake::Hasher& hasher) {
    constexpr int kMostFiles = 10000;
    static const std::set<std::string> kEndings{".png",  ".jpg",  ".jpeg", ".tga", ".bmp",
                                                ".tif",  ".tiff", ".gif",  ".psd", ".hdr",
                                                ".webp", ".ktx2", ".dds",  ".mtl", ".bin"};
    std::set<std::string> found; // in an order of its own
    std::error_code code;
    int seen = 0;
    for (fs::recursive_directory_iterator
             entry(stage.parent_path(), fs::directory_options::skip_permission_denied, code),
         end;
         !code && entry != end && ++seen <= kMostFiles; entry.increment(code)) {
        if (entry->path().filename() == cache.filename()) {
            entry.disable_recursion_pending();
            continue;
        }
        std::error_code unknown;
        std::string ending = entry->path().extension().string();
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
        if (!kEndings.contains(ending)) continue;
        found.insert(entry->path().lexically_relative(stage.parent_path()).string() + " " +
                     std::to_string(entry->file_size(unknown)) + " " +
                     std::to_string(entry->last_write_time(unknown).time_since_epoch().count()));
    }
    for (const std::string& file : found) hasher.text(file);
}

} // namespace

std::string passes_fingerprint(const scene::Show& show, std::uintmax_t most_bytes) {
    std::set<fs::path> sources{show.file, show.stage_file, show.plot_file};
    for (const scene::Model& model : show.models) sources.insert(model.file);
    for (const scene::PatchedFixture& fixture : show.fixtures) sources.insert(show.folder / fixture.gdtf);
    bake::Hasher hasher;
    hasher.value(bake::kBakerVersion);
    std::set<fs::path> seen;
    std::uintmax_t left = most_bytes;
    for (const fs::path& source : sources) {
        std::error_code code;
        const fs::path real = fs::canonical(source, code);
        if (!code && !seen.insert(real).second) continue;
        hasher.text(source.filename().string());
        const auto bytes = read_file(source, std::min(kMaxSourceBytes, left));
        if (bytes.ok()) {
            hasher.list(*bytes);
            left -= bytes->size();
        } else if (!code && fs::is_regular_file(real, code)) {
            hasher.text(stamp_of(real));
        }
    }
    if (!show.stage_file.empty()) add_companions(show.stage_file, show.cache_folder(), hasher);
    for (const scene::Model& model : show.models) add_companions(model.file, show.cache_folder(), hasher);
    return hasher.hex();
}

std::string baked_fingerprint(const scene::Show& show, const std::string& camera) {
    bake::Hasher hasher;
    const auto manifest = read_file(scene::passes_folder(show, camera) / "manifest.json", kMaxSourceBytes);
    if (manifest.ok()) hasher.list(*manifest);
    return hasher.hex();
}

Result<void> remember_sources(const scene::Show& show, const std::string& camera,
                              const std::string& fingerprint) {
    const fs::path file = file_beside(show, camera);
    TRY_VOID(make_folders(file.parent_path(), show.cache_home()));
    return write_file_atomic(file, fingerprint);
}

bool passes_are_of(const scene::Show& show, const std::string& camera, const std::string& fingerprint) {
    const auto had = read_text_file(file_beside(show, camera), 1024);
    return had.ok() && *had == fingerprint;
}

} // namespace ghost::app
