// SPDX-License-Identifier: Apache-2.0
#include "bake/private/camera_bake.h"

#include "bake/hasher.h"
#include "bake/private/pictures.h"
#include "beam_groups/light_places.h"

#include "disk/files.h"
#include "disk/own_folder.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tbb/parallel_for.h>

namespace ghost::bake {
namespace fs = std::filesystem;
namespace {

// Rays per sample of the surroundings: the camera's, and those to the sky.
constexpr double kSurroundingsCost = 5.0;

constexpr char kSurroundings[] = "surroundings";
constexpr char kPartFile[] = "surroundings.json"; // beside pictures that no manifest names yet
constexpr std::uintmax_t kMostPartBytes = 16u << 20;
constexpr std::size_t kLayoutDigits = 12; // of its key: the name of its folder

std::string pass_name(const scene::ManifestLight& light) {
    return light.fixture + (light.stop > 0 ? " stop " + std::to_string(light.stop) : "");
}

} // namespace

CameraBake::CameraBake(const scene::Show& show, const scene::Stage& stage, const StageKeys& keys,
                       const scene::Camera& camera, const BakeOptions& options)
    : camera_(camera), options_(options), home_(show.cache_home()),
      folder_(scene::passes_folder(show, camera.name)) {
    wanted_.camera = camera.name;
    wanted_.camera_to_world = scene::camera_to_world(camera);
    wanted_.fov_y_deg = camera.fov_y_deg;
    wanted_.width = camera.width;
    wanted_.height = camera.height;
    wanted_.spp = options.spp;
    wanted_.bounces = options.bounces;
    wanted_.geometry_key = geometry_key(keys, camera, options.spp);
    Hasher layout;
    layout.text(wanted_.geometry_key);
    std::set<std::string> names;
    for (std::size_t k = 0; k < show.fixtures.size(); ++k) {
        const scene::PatchedFixture& fixture = show.fixtures[k];
        const Rect rect = body_rect(stage, static_cast<int>(k), camera);
        if (!keys.bodies[k].empty() && !rect.empty()) {
            wanted_.bodies.push_back({fixture.name, keys.bodies[k], {rect.x0, rect.y0, rect.x1, rect.y1}});
            layout.text(keys.bodies[k]);
        }
        if (scene::light_places_m(fixture, 0).empty()) continue; // no type, or it only glows
        for (std::size_t stop = 0; stop < fixture.stops_m().size(); ++stop) {
            scene::ManifestLight light;
            light.fixture = fixture.name;
            light.stop = static_cast<int>(stop);
            light.position_m = scene::light_position_m(fixture, stop);
            light.key = light_key(wanted_.geometry_key, light.position_m, options.bounces);
            light.indirect = options.bounces > 0;
            light.picture = "light_" + scene::file_name_of(fixture.name) + "_" + std::to_string(stop);
            while (!names.insert(light.picture).second) light.picture += "_";
            wanted_.lights.push_back(std::move(light));
        }
    }
    wanted_.layout_key = layout.hex();
    wanted_.folder = wanted_.layout_key.substr(0, kLayoutDigits);
    done_.assign(wanted_.lights.size(), false);
}

bool CameraBake::complete(const scene::ManifestLight& light, const scene::FragmentTable& table) const {
    const fs::path base = folder_ / old_->folder;
    Report unread;
    return scene::read_layer(base, light.picture, table, scene::kPictureCandela, light.key, unread).ok() &&
           (!light.indirect || scene::read_picture(base / (light.picture + "_indirect.exr"), table.width,
                                                   table.height, scene::kPictureCandela, light.key, unread)
                                   .ok());
}

bool CameraBake::surroundings_complete(const scene::FragmentTable& table) const {
    const fs::path base = folder_ / old_->folder;
    Report unread;
    const auto whole = [&](const char* name, float scale) {
        return scene::read_layer(base, name, table, scale, old_->layout_key, unread).ok();
    };
    return whole("ambient", scene::kPictureCandela) && (!old_->has_emission || whole("emission", 1.0f));
}

double CameraBake::plan() {
    // A manifest that cannot be read is no manifest: everything is baked.
    if (auto manifest = scene::read_manifest(folder_); manifest.ok()) old_ = std::move(*manifest);
    const auto same_light = [](const scene::ManifestLight& a, const scene::ManifestLight& b) {
        return a.key == b.key && a.picture == b.picture;
    };
    const bool is_adopted = adopt_part();
    manifest_is_right_ = !is_adopted && old_ && std::ranges::equal(old_->lights, wanted_.lights, same_light);
    const double pixels = static_cast<double>(camera_.width) * camera_.height;
    double patch_pixels = 0;
    std::optional<scene::FragmentTable> table;
    if (old_ && old_->geometry_key == wanted_.geometry_key)
        if (auto read = scene::read_fragments(folder_ / old_->folder, *old_);
            read.ok() && surroundings_complete(*read))
            table = std::move(*read);
    if (table) {
        layout_ = Layout::kept;
        if (old_->layout_key != wanted_.layout_key) {
            layout_ = Layout::patched;
            const auto differing = [&](const std::vector<scene::ManifestBody>& from,
                                       const std::vector<scene::ManifestBody>& other) {
                for (const scene::ManifestBody& body : from) {
                    const bool same =
                        std::any_of(other.begin(), other.end(), [&](const scene::ManifestBody& b) {
                            return b.key == body.key && b.rect == body.rect;
                        });
                    if (!same) dirty_.push_back({body.rect[0], body.rect[1], body.rect[2], body.rect[3]});
                }
            };
            differing(old_->bodies, wanted_.bodies);
            differing(wanted_.bodies, old_->bodies);
            for (const Rect& rect : dirty_)
                patch_pixels += static_cast<double>(rect.x1 - rect.x0) * (rect.y1 - rect.y0);
            if (patch_pixels > 0.5 * pixels) layout_ = Layout::traced;
        }
    }
    if (layout_ != Layout::traced) {
        std::vector<char> whole(wanted_.lights.size(), 0); // no vector<bool>: written from several threads
        tbb::parallel_for(std::size_t{0}, whole.size(), [&](std::size_t k) {
            // Whatever the manifest says: parts do not write into it.
            whole[k] = complete(wanted_.lights[k], *table) ? 1 : 0;
        });
        done_.assign(whole.begin(), whole.end());
    }
    const auto kept = static_cast<std::size_t>(std::count(done_.begin(), done_.end(), true));
    const auto missing = static_cast<double>(wanted_.lights.size() - kept);
    const double per_light = 1.0 + 2.0 * options_.bounces;
    double work = missing * pixels * per_light;
    if (layout_ == Layout::traced) work += pixels * kSurroundingsCost;
    if (layout_ == Layout::patched)
        work += std::max(1.0, patch_pixels) * (kSurroundingsCost + static_cast<double>(kept) * per_light);
    // A fixture that went away leaves an entry behind; parts leave pictures without one.
    if (work == 0 && !manifest_is_right_) work = 1;
    if (options_.part) {
        work = static_cast<double>(missing_of_part().size()) * pixels * per_light;
        if (options_.part->surroundings && layout_ != Layout::kept) work += pixels * kSurroundingsCost;
    }
    return work * options_.spp;
}

Frame CameraBake::trace(const Tracer& tracer, FrameRequest request, std::size_t pixels,
                        const std::function<void(double)>& on_samples, BakeStats& stats) {
    request.spp = options_.spp;
    request.bounces = options_.bounces;
    request.stop = options_.stop;
    const double per_pixel = (request.surroundings ? kSurroundingsCost : 0.0) +
                             static_cast<double>(request.lights_m.size()) * (1.0 + 2.0 * options_.bounces);
    const double per_row = static_cast<double>(pixels) * per_pixel * options_.spp / camera_.height;
    request.on_row = [&] { on_samples(per_row); };
    const double begin_s = now_s();
    std::uint64_t rays = 0;
    Frame frame = trace_frame(tracer, camera_, request, rays);
    const double took_s = now_s() - begin_s;
    stats.rays += rays;
    stats.trace_seconds += took_s;
    return frame;
}

Result<void> CameraBake::write_manifest() {
    if (options_.part) {
        if (!options_.part->surroundings) return {};
        scene::PassManifest part = written_;
        part.lights.clear(); // which of them are there, their pictures say
        return write_file_atomic(pictures() / kPartFile, scene::manifest_text(part));
    }
    return write_file_atomic(folder_ / "manifest.json", scene::manifest_text(written_));
}

Result<void> CameraBake::write_surroundings(const scene::FragmentTable& table, const Frame& frame) {
    const std::string& key = wanted_.layout_key;
    TRY_VOID(scene::write_fragments(pictures(), table));
    for (const CentrePicture& picture : centre_pictures())
        TRY_VOID(write_floats(pictures() / (std::string(picture.name) + ".exr"), table.width, table.height,
                              picture.samples(frame), picture.channels, key));
    TRY_VOID(scene::write_layer(pictures(), "ambient", table.width, table.height,
                                scene::to_stored(table, frame.ambient), scene::kPictureCandela,
                                attributes(key)));
    wanted_.has_emission = any_light(frame.emission);
    if (wanted_.has_emission)
        TRY_VOID(scene::write_layer(pictures(), "emission", table.width, table.height,
                                    scene::to_stored(table, frame.emission), 1.0f, attributes(key)));
    return {};
}

Result<void> CameraBake::trace_batch(const Tracer& tracer, bool surroundings,
                                     const std::vector<std::size_t>& batch,
                                     const std::function<void(double)>& on_samples, BakeStats& stats) {
    FrameRequest request;
    request.surroundings = surroundings;
    for (const std::size_t light : batch) request.lights_m.push_back(wanted_.lights[light].position_m);
    const std::uint64_t rays_before = stats.rays;
    const double seconds_before = stats.trace_seconds;
    Frame frame = trace(tracer, request,
                        static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height),
                        on_samples, stats);
    if (stopped()) return {};
    const scene::FragmentTable table = take_table(frame);
    if (surroundings) {
        TRY_VOID(write_surroundings(table, frame));
        wanted_.extra_count = table.fragments.size() - static_cast<std::size_t>(camera_.width) *
                                                           static_cast<std::size_t>(camera_.height);
        written_ = wanted_;
        written_.lights.clear();
        extra_first_ = table.extra_first;
    } else if (table.extra_first != *extra_first_) {
        // Another kind of processor traced the others: its rounding may hit other triangles. All anew, then.
        extra_first_.reset();
        done_.assign(done_.size(), false);
        return {};
    }
    for (std::size_t k = 0; k < batch.size(); ++k) {
        const scene::ManifestLight& light = wanted_.lights[batch[k]];
        TRY_VOID(scene::write_layer(pictures(), light.picture, table.width, table.height,
                                    scene::to_stored(table, frame.lights[k]), scene::kPictureCandela,
                                    attributes(light.key)));
        if (light.indirect)
            TRY_VOID(scene::write_picture(pictures() / (light.picture + "_indirect.exr"), table.width,
                                          table.height, frame.indirect[k], scene::kPictureCandela,
                                          attributes(light.key)));
        done_[batch[k]] = true;
    }
    written_.lights.clear();
    for (std::size_t k = 0; k < wanted_.lights.size(); ++k)
        if (done_[k]) written_.lights.push_back(wanted_.lights[k]);
    TRY_VOID(write_manifest());

    // The surroundings' fraction of the time, by their fraction of the rays.
    const double lights = static_cast<double>(batch.size()) * (1.0 + 2.0 * options_.bounces);
    const double fraction = surroundings ? kSurroundingsCost / (kSurroundingsCost + lights) : 0.0;
    const double ms = (stats.trace_seconds - seconds_before) * 1000;
    const auto rays = static_cast<double>(stats.rays - rays_before);
    const auto add = [&](const std::string& name, double part) {
        stats.passes.push_back({camera_.name, name, ms * part, static_cast<std::uint64_t>(rays * part)});
    };
    if (surroundings) add(kSurroundings, batch.empty() ? 1.0 : fraction);
    for (const std::size_t light : batch)
        add(pass_name(wanted_.lights[light]), (1.0 - fraction) / static_cast<double>(batch.size()));
    return {};
}

Result<void> CameraBake::run(const Tracer& tracer, const std::function<void(double)>& on_samples,
                             BakeStats& stats) {
    TRY_VOID(make_folders(pictures(), home_));

    const int kept = static_cast<int>(std::count(done_.begin(), done_.end(), true));
    if (layout_ == Layout::patched) {
        const int patched_before = stats.patched;
        if (const Result<void> patched = patch(tracer, on_samples, stats); !patched.ok()) {
            // The old pictures cannot be used: from scratch then, unless the disk is at fault, which shows
            // again at once.
            stats.patched = patched_before;
            extra_first_.reset();
            done_.assign(done_.size(), false);
        }
        if (stopped()) return {};
    } else if (layout_ == Layout::kept) {
        written_ = *old_;
        wanted_.extra_count = old_->extra_count;
        wanted_.has_emission = old_->has_emission;
        stats.kept += kept;
        const bool all = kept == static_cast<int>(wanted_.lights.size());
        if (!all || !manifest_is_right_) {
            // Entries whose files are about to be replaced leave the manifest first.
            written_ = wanted_;
            written_.lights.clear();
            for (std::size_t k = 0; k < wanted_.lights.size(); ++k)
                if (done_[k]) written_.lights.push_back(wanted_.lights[k]);
            TRY_VOID(write_manifest());
        }
        if (all) {
            remove_unwanted();
            return {};
        }
        if (auto table = scene::read_fragments(pictures(), *old_); table.ok())
            extra_first_ = std::move(table->extra_first);
        else
            done_.assign(done_.size(), false);
    }
    while (!extra_first_ || std::count(done_.begin(), done_.end(), false) > 0) {
        std::vector<std::size_t> batch;
        for (std::size_t k = 0; k < done_.size() && batch.size() < kBatch; ++k)
            if (!done_[k]) batch.push_back(k);
        TRY_VOID(trace_batch(tracer, !extra_first_, batch, on_samples, stats));
        if (stopped()) return {};
    }
    remove_unwanted();
    return {};
}

bool CameraBake::adopt_part() {
    if (old_ && old_->layout_key == wanted_.layout_key) return false;
    const fs::path file = pictures() / kPartFile;
    const auto text = read_text_file(file, kMostPartBytes);
    if (!text.ok()) return false;
    auto part = scene::parse_manifest(*text, file.string());
    if (!part.ok() || part->layout_key != wanted_.layout_key || part->folder != wanted_.folder) return false;
    old_ = std::move(*part);
    return true;
}

std::vector<std::size_t> CameraBake::missing_of_part() const {
    std::vector<std::size_t> missing;
    const std::size_t first = options_.part->surroundings ? 0 : options_.part->first_light;
    const std::size_t last = options_.part->surroundings ? kBatch - 1 : options_.part->last_light;
    for (std::size_t k = first; k <= last && k < done_.size(); ++k)
        if (layout_ != Layout::kept || !done_[k]) missing.push_back(k);
    return missing;
}

Result<void> CameraBake::run_part(const Tracer& tracer, const std::function<void(double)>& on_samples,
                                  BakeStats& stats) {
    TRY_VOID(make_folders(pictures(), home_));
    if (options_.part->surroundings && layout_ != Layout::kept)
        return trace_batch(tracer, true, missing_of_part(), on_samples, stats);
    if (layout_ != Layout::kept)
        return Error{"the surroundings of camera '" + camera_.name + "' are not baked yet", folder_.string()};
    written_ = *old_;
    wanted_.extra_count = old_->extra_count;
    TRY(scene::FragmentTable table, scene::read_fragments(pictures(), *old_));
    extra_first_ = std::move(table.extra_first);
    const std::vector<std::size_t> missing = missing_of_part();
    for (std::size_t k = 0; k < missing.size() && !stopped(); k += kBatch) {
        const auto begin = missing.begin() + static_cast<std::ptrdiff_t>(k);
        const std::vector<std::size_t> batch(
            begin, begin + static_cast<std::ptrdiff_t>(std::min(kBatch, missing.size() - k)));
        TRY_VOID(trace_batch(tracer, false, batch, on_samples, stats));
        if (!extra_first_)
            return Error{
                "the surroundings of camera '" + camera_.name +
                    "' were traced by another kind of processor, which rounds in another way; let one "
                    "kind bake",
                folder_.string()};
    }
    return {};
}

void CameraBake::remove_unwanted() const {
    std::set<std::string> files;
    for (const CentrePicture& picture : centre_pictures()) files.insert(std::string(picture.name) + ".exr");
    for (const char* name : {"fragments", "ambient", "ambient.extra", "emission", "emission.extra"})
        files.insert(std::string(name) + ".exr");
    for (const scene::ManifestLight& light : wanted_.lights) {
        files.insert(light.picture + ".exr");
        files.insert(light.picture + ".extra.exr");
        if (light.indirect) files.insert(light.picture + "_indirect.exr");
    }
    const auto camera = OwnFolder::open(folder_, home_);
    if (!camera.ok()) return;
    camera->remove_file("sources.txt"); // the program's word on the passes that were here before
    for (const std::string& layout : camera->entries().folders) {
        if (layout.size() != kLayoutDigits ||
            layout.find_first_not_of("0123456789abcdef") != std::string::npos)
            continue;
        const auto pictures = camera->below(layout);
        if (!pictures.ok()) continue;
        for (const OwnFolder::File& file : pictures->entries().files)
            if ((file.name.ends_with(".exr") || file.name == kPartFile) && !is_temporary_in_use(file.name) &&
                (layout != wanted_.folder || !files.contains(file.name)))
                pictures->remove_file(file.name);
        if (layout != wanted_.folder) camera->remove_empty_folder(layout);
    }
}

} // namespace ghost::bake
