#pragma once
// SPDX-License-Identifier: Apache-2.0
// The bake of one camera: compares the manifest on disk with what the show wants, traces what differs,
// writes. The manifest names only files that are complete. One thread drives it; tracing uses all cores.

#include "bake/bake_show.h"
#include "bake/frame.h"
#include "bake/keys.h"
#include "passes/passes_file.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace ghost::bake {

class CameraBake {
public:
    CameraBake(const scene::Show& show, const scene::Stage& stage, const StageKeys& keys,
               const scene::Camera& camera, const BakeOptions& options);

    // Compares with the disk; the work ahead in samples, 0 where nothing is to be done.
    double plan();
    std::size_t light_count() const { return wanted_.lights.size(); }
    // After plan(): why everything is made again where nothing of the show changed.
    bool replaces_earlier_version() const {
        return old_ && old_->version < scene::kPassesVersion && layout_ == Layout::traced;
    }
    // on_samples: samples traced since the last call, from any thread.
    Result<void> run(const Tracer& tracer, const std::function<void(double samples)>& on_samples,
                     BakeStats& stats);
    // Instead: BakeOptions::part. Error: the surroundings are not there, or were traced by another kind of
    // processor.
    Result<void> run_part(const Tracer& tracer, const std::function<void(double samples)>& on_samples,
                          BakeStats& stats);

private:
    enum class Layout { kept, patched, traced };

    bool stopped() const { return options_.stop && options_.stop(); }
    double now_s() const { return options_.now_s ? options_.now_s() : 0.0; }
    // Whether what the old manifest names can be read, wholly.
    bool complete(const scene::ManifestLight& light, const scene::FragmentTable& table) const;
    bool surroundings_complete(const scene::FragmentTable& table) const;
    Frame trace(const Tracer& tracer, FrameRequest request, std::size_t rows_pixels,
                const std::function<void(double)>& on_samples, BakeStats& stats);
    Result<void> trace_batch(const Tracer& tracer, bool surroundings, const std::vector<std::size_t>& batch,
                             const std::function<void(double)>& on_samples, BakeStats& stats);
    Result<void> patch(const Tracer& tracer, const std::function<void(double)>& on_samples, BakeStats& stats);
    Result<void> write_surroundings(const scene::FragmentTable& table, const Frame& frame);
    Result<void> write_manifest();
    void remove_unwanted() const;
    // Surroundings that a part baked, as a manifest without lights.
    bool adopt_part(); // true: it did
    std::vector<std::size_t> missing_of_part() const;
    std::filesystem::path pictures() const { return folder_ / wanted_.folder; }

    const scene::Camera& camera_;
    const BakeOptions& options_;
    std::filesystem::path home_; // of the show
    std::filesystem::path folder_;
    scene::PassManifest wanted_;                            // with all lights
    scene::PassManifest written_;                           // what the manifest on disk says now
    std::optional<scene::PassManifest> old_;                // what it said at first
    std::vector<bool> done_;                                // per wanted light
    std::vector<Rect> dirty_;                               // of a patch
    std::optional<std::vector<std::uint32_t>> extra_first_; // of the pictures on disk, to check against
    bool manifest_is_right_ = false;                        // it names what is wanted
    Layout layout_ = Layout::traced;
};

} // namespace ghost::bake
