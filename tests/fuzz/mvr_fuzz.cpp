// SPDX-License-Identifier: Apache-2.0
// load_mvr, its helpers, the editing of the description and merging, on anything. Input that starts with "PK"
// is taken as the zip itself, other input as the description of one. Seeds: tests/support/mvr_files.h.
#include "stored_zip.h"

#include "mvr/mvr_edit.h"
#include "mvr/mvr_load.h"
#include "mvr/mvr_merge.h"

#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using namespace ghost;
using namespace ghost::scene;

std::vector<std::uint8_t> zip_of(Bytes xml) {
    return stored_zip({{"GeneralSceneDescription.xml", xml}});
}

void require(bool holds) {
    if (!holds) std::abort();
}

void check(const Plot& plot) {
    for (std::size_t i = 0; i < plot.objects.size(); ++i) {
        const PlotObject& object = plot.objects[i];
        require(object.parent < static_cast<int>(i));
        require(object.layer >= 0 && object.layer < static_cast<int>(plot.layers.size()));
        for (int k = 0; k < 16; ++k) require(std::isfinite(object.world[k / 4][k % 4]));
        (void)patch_addresses(plot, object);
        require(object.device.gdtf < static_cast<int>(plot.gdtf_files.size()));
    }
    const std::vector<MeshInstance> instances = mesh_instances(plot);
    require(instances.size() <= kMaxMeshInstances);
    for (const MeshInstance& instance : instances)
        require(instance.mesh >= 0 && instance.mesh < static_cast<int>(plot.meshes.size()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, size);
    const bool is_zip = size >= 2 && data[0] == 'P' && data[1] == 'K';
    auto loaded = load_mvr(is_zip ? std::vector<std::uint8_t>(data, data + size) : zip_of(bytes), "fuzz.mvr");
    if (!loaded.ok()) return 0;
    check(loaded->plot);
    std::vector<PlotChange> changes;
    std::vector<PlotEdit> edits;
    for (std::size_t i = 0; i < loaded->plot.objects.size() && i < 5; ++i)
        for (const auto what : {PlotChange::What::address, PlotChange::What::mode, PlotChange::What::position,
                                PlotChange::What::name}) {
            PlotChange change{
                .uuid = loaded->plot.objects[i].uuid, .what = what, .address = {2, 3}, .text = "<&\">"};
            change.local[3][0] = 1.5;
            edits.push_back({static_cast<int>(i), change});
            changes.push_back(change);
        }
    check(merge_plots(loaded->plot, loaded->plot, changes).plot);
    const auto description = loaded->archive.read(loaded->description);
    require(description.ok());
    const auto edited = edit_description(*description, loaded->plot, edits, "fuzz");
    if (!edited.ok() || !*edited) return 0;
    const auto& text = **edited;
    const auto again =
        load_mvr(zip_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), "again.mvr");
    require(again.ok());
    require(again->plot.objects.size() == loaded->plot.objects.size());
    return 0;
}
