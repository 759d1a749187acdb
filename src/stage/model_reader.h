#pragma once
// SPDX-License-Identifier: Apache-2.0
// Models are read in a process apart (base/helper_process.h): what a parser of other people's does wrong
// costs the one model that it was given. One process reads many; where it is ended by a fault, or by us
// because it takes too long, the next model gets a new one. Any thread.

#include "stage/model_file.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ghost::scene {

// Of a model with all its instances, and of a stage that is made of several.
inline constexpr std::size_t kMaxDrawnTriangles = 20'000'000;

// What may come from where: archives (GDTF, MVR) hold .3ds, .glb and .gltf; a show's folder .obj, too.
enum class ModelSource { archive, folder };

// As read_model(), with the format allowed. More than 10 s of the processor and 1 s for each MiB of the model
// and of what it refers to, or 8 GiB of memory, is an error.
Result<Stage> load_model(Bytes bytes, const std::string& extension, const std::string& name,
                         ModelSource source, Report& report, const ReadCompanion& read_companion);

// Without anything beside it.
Result<Stage> load_model(Bytes bytes, const std::string& extension, const std::string& name,
                         ModelSource source, Report& report);

// Files that it refers to lie in its folder or in home (the show's), wherever links lead.
Result<Stage> load_stage_file(const std::filesystem::path& path, const std::filesystem::path& home,
                              Report& report);

// The same with home being the folder of the file.
Result<Stage> load_stage_file(const std::filesystem::path& path, Report& report);

// What main() does where this is its only argument: serve_models().
inline constexpr const char* kReadModels = "--read-models";

// The process apart: reads models until the other end is gone. Returns the exit code. read: read_model(), but
// in tests.
using ReadModel = std::function<Result<Stage>(Bytes, const std::string&, const std::string&, Report&,
                                              const ReadCompanion&)>;
int serve_models(const ReadModel& read = read_model);

// Fuzz targets read in their own process, which is to see the faults. Before the first model.
void read_models_in_this_process();

} // namespace ghost::scene
