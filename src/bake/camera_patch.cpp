// SPDX-License-Identifier: Apache-2.0
// The part of CameraBake that traces only the pixels round moved bodies and takes all others from the
// pictures on disk.
#include "bake/private/camera_bake.h"

#include "bake/private/pictures.h"
#include "image/exr.h"

#include <algorithm>

namespace ghost::bake {
namespace fs = std::filesystem;
namespace {

// Dirty pixels from the patch, the others from the old picture.
template <class T>
std::vector<T> merge_pixels(const std::vector<T>& old, const std::vector<T>& fresh,
                            const std::vector<bool>& dirty) {
    std::vector<T> result = old;
    for (std::size_t p = 0; p < result.size(); ++p)
        if (dirty[p]) result[p] = fresh[p];
    return result;
}

template <class T>
std::vector<T> merge_extras(const std::vector<T>& old, const std::vector<std::uint32_t>& old_first,
                            const std::vector<T>& fresh, const std::vector<std::uint32_t>& fresh_first,
                            const std::vector<bool>& dirty) {
    std::vector<T> result;
    for (std::size_t p = 0; p < dirty.size(); ++p) {
        const std::vector<T>& from = dirty[p] ? fresh : old;
        const std::vector<std::uint32_t>& first = dirty[p] ? fresh_first : old_first;
        result.insert(result.end(), from.begin() + first[p], from.begin() + first[p + 1]);
    }
    return result;
}

} // namespace

Result<void> CameraBake::patch(const Tracer& tracer, const std::function<void(double)>& on_samples,
                               BakeStats& stats) {
    const fs::path from = folder_ / old_->folder;
    TRY(const scene::FragmentTable old_table, scene::read_fragments(from, *old_));
    FrameRequest request;
    request.only = dirty_;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < wanted_.lights.size(); ++k) {
        if (!done_[k]) continue;
        kept.push_back(k);
        request.lights_m.push_back(wanted_.lights[k].position_m);
    }
    std::vector<bool> dirty(old_table.extra_first.size() - 1, false);
    for (const Rect& rect : dirty_)
        for (int y = rect.y0; y < std::min(rect.y1, camera_.height); ++y)
            for (int x = rect.x0; x < std::min(rect.x1, camera_.width); ++x)
                dirty[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width) +
                      static_cast<std::size_t>(x)] = true;
    // No rectangle would mean the whole picture.
    if (request.only.empty()) request.only.push_back({});
    Frame fresh =
        trace(tracer, request, static_cast<std::size_t>(std::count(dirty.begin(), dirty.end(), true)),
              on_samples, stats);
    if (stopped()) return {};
    const scene::FragmentTable fresh_table = take_table(fresh);
    const std::size_t pixels = dirty.size();

    scene::FragmentTable table{camera_.width, camera_.height, {0}, {}};
    for (std::size_t p = 0; p < pixels; ++p) {
        const auto& first = dirty[p] ? fresh_table.extra_first : old_table.extra_first;
        table.extra_first.push_back(table.extra_first.back() + first[p + 1] - first[p]);
    }
    const auto main_of = [&](const scene::FragmentTable& t) {
        return std::vector<glm::vec4>(t.fragments.begin(),
                                      t.fragments.begin() + static_cast<std::ptrdiff_t>(pixels));
    };
    const auto extra_of = [&](const scene::FragmentTable& t) {
        return std::vector<glm::vec4>(t.fragments.begin() + static_cast<std::ptrdiff_t>(pixels),
                                      t.fragments.end());
    };
    table.fragments = merge_pixels(main_of(old_table), main_of(fresh_table), dirty);
    const auto extras = merge_extras(extra_of(old_table), old_table.extra_first, extra_of(fresh_table),
                                     fresh_table.extra_first, dirty);
    table.fragments.insert(table.fragments.end(), extras.begin(), extras.end());
    TRY_VOID(scene::write_fragments(pictures(), table));

    Report report;
    const auto patch_layer = [&](const std::string& name, const Layer& values, float scale,
                                 const std::string& old_key, const std::string& key,
                                 bool there) -> Result<bool> {
        scene::StoredLayer old;
        if (there) {
            TRY(old, scene::read_layer(from, name, old_table, scale, old_key, report));
        } else {
            old.whole.assign(pixels, glm::vec3(0.0f));
            old.extra.assign(old_table.fragments.size() - pixels, glm::vec3(0.0f));
        }
        const scene::StoredLayer add = scene::to_stored(fresh_table, values);
        scene::StoredLayer merged{
            merge_pixels(old.whole, add.whole, dirty),
            merge_extras(old.extra, old_table.extra_first, add.extra, fresh_table.extra_first, dirty)};
        if (!any_light(merged.whole) && name == "emission") return false;
        TRY_VOID(
            scene::write_layer(pictures(), name, table.width, table.height, merged, scale, attributes(key)));
        return true;
    };
    for (const CentrePicture& picture : centre_pictures()) {
        const std::string file = std::string(picture.name) + ".exr";
        TRY(image::ExrFile old, image::read_exr(from / file));
        const std::vector<float> samples = picture.samples(fresh);
        const std::size_t channels = picture.channels.size();
        if (old.pixels.samples.size() != samples.size() || old.channels != picture.channels)
            return Error{"is not what this program writes; delete it and bake again", (from / file).string()};
        for (std::size_t p = 0; p < pixels; ++p)
            if (dirty[p])
                std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(p * channels), channels,
                            old.pixels.samples.begin() + static_cast<std::ptrdiff_t>(p * channels));
        TRY_VOID(write_floats(pictures() / file, table.width, table.height, old.pixels.samples,
                              picture.channels, wanted_.layout_key));
    }
    TRY(const bool ambient, patch_layer("ambient", fresh.ambient, scene::kPictureCandela, old_->layout_key,
                                        wanted_.layout_key, true));
    static_cast<void>(ambient);
    TRY(wanted_.has_emission, patch_layer("emission", fresh.emission, 1.0f, old_->layout_key,
                                          wanted_.layout_key, old_->has_emission));
    written_ = wanted_;
    written_.extra_count = wanted_.extra_count = table.fragments.size() - pixels;
    written_.lights.clear();
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const scene::ManifestLight& light = wanted_.lights[kept[k]];
        TRY(const bool there,
            patch_layer(light.picture, fresh.lights[k], scene::kPictureCandela, light.key, light.key, true));
        static_cast<void>(there);
        if (light.indirect) {
            const std::string file = light.picture + "_indirect.exr";
            TRY(const Layer old, scene::read_picture(from / file, table.width, table.height,
                                                     scene::kPictureCandela, light.key, report));
            TRY_VOID(scene::write_picture(pictures() / file, table.width, table.height,
                                          merge_pixels(old, fresh.indirect[k], dirty), scene::kPictureCandela,
                                          attributes(light.key)));
        }
        written_.lights.push_back(light);
        ++stats.patched;
    }
    extra_first_ = table.extra_first;
    return write_manifest();
}

} // namespace ghost::bake
