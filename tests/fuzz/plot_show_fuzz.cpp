// SPDX-License-Identifier: Apache-2.0
// A plot as a whole: opened, imported into a new folder, opened there, imported once more, exported. What is
// written is read again and has the same fixtures. Input that starts with "PK" is taken as the .mvr itself,
// other input as the description of one.
#include "fuzz_folder.h"
#include "stored_zip.h"

#include "plots/export_plot.h"
#include "plots/import_plot.h"
#include "show_folder/load_show.h"
#include "stage/model_reader.h"

#include <cstdlib>

using namespace ghost;
using namespace ghost::scene;

// Assimp 5.2 forgets the meshes that it had begun when it gives up on a 3DS file: less than the file is long.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libassimp";
}

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    read_models_in_this_process();
    return 0;
}

namespace {

// One triangle.
constexpr std::string_view kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void require(bool holds) {
    if (!holds) std::abort();
}

Bytes bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes input(data, size);
    const bool is_zip = size >= 2 && data[0] == 'P' && data[1] == 'K';
    const std::filesystem::path plot = fuzz_file(
        "plot.mvr",
        is_zip ? input
               : Bytes(stored_zip({{"GeneralSceneDescription.xml", input}, {"a.obj", bytes_of(kObj)}})));
    Report report;
    const auto opened = load_show(plot, true, report);
    if (!opened.ok()) return 0;
    const std::filesystem::path folder = fuzz_folder() / "show";
    std::filesystem::remove_all(folder);
    const auto imported = import_plot(*opened, folder, report);
    require(imported.ok() && imported->fixtures == opened->fixtures.size());
    const auto show = load_show(folder, false, report);
    require(show.ok() && show->plot && show->fixtures.size() == opened->fixtures.size());
    require(show->cameras.size() == opened->cameras.size());
    for (std::size_t k = 0; k < show->fixtures.size(); ++k)
        require(show->fixtures[k].name == opened->fixtures[k].name);
    const auto again = import_plot(*opened, folder, report);
    require(again.ok() && again->merge);
    const auto exported = export_plot(folder, fuzz_folder() / "out.mvr", {}, report);
    require(!exported.ok() || load_show(fuzz_folder() / "out.mvr", false, report).ok());
    return 0;
}
