#pragma once
// SPDX-License-Identifier: Apache-2.0
// load_mvr: reads an .mvr archive (zip with GeneralSceneDescription.xml) into a Plot. Only the zip's index
// and the description are read; meshes, GDTF files and pictures when archive.read asks for them. What cannot
// be kept is a message with file, line and path of the element; an Error only where nothing can be kept (no
// zip, no description, not well formed, over a limit that protects memory) or when it was cancelled. Any
// thread, one at a time per LoadedPlot.

#include "archives/archive.h"
#include "base/byte_reader.h"
#include "base/report.h"
#include "base/result.h"
#include "mvr/plot.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

// More than the largest plots we know of; less than what would fill a machine.
inline constexpr std::uintmax_t kMaxMvrBytes = 3ull << 30; // the archive
inline constexpr std::size_t kMaxMvrEntries = 65'535;
inline constexpr std::uint64_t kMaxMvrMemberBytes = 512ull << 20; // one member, unpacked
inline constexpr std::uint64_t kMaxMvrTotalBytes = 16ull << 30;   // all that is read over the session
inline constexpr std::size_t kMaxMvrXmlBytes = 64u << 20;         // the description
inline constexpr int kMaxMvrDepth = 64;                           // objects in objects
inline constexpr std::size_t kMaxMvrObjects = 100'000;
inline constexpr std::size_t kMaxMvrSymbols = 50'000;
inline constexpr std::size_t kMaxMvrParts = 1'000'000; // geometries, addresses, commands .. of the whole plot
inline constexpr std::size_t kMaxMeshInstances = 1'000'000; // with all symbols taken apart
inline constexpr std::size_t kMaxMvrText = 4096; // bytes of one text that the Plot keeps; the export has all

struct MvrLoading {
    // share 0..1 and what is being done; called from the loading thread, a few hundred times at most.
    std::function<void(double share, std::string_view what)> progress;
    const std::atomic<bool>* cancel = nullptr; // set: load_mvr returns an error soon
    fixture::ArchiveLimits limits = {kMaxMvrEntries, kMaxMvrMemberBytes, kMaxMvrTotalBytes};
};

struct LoadedPlot {
    Plot plot;
    std::shared_ptr<const Plot> unchanged; // as its file has it, where a show changes it; else null
    Report report; // at most 1001 (base/message_cap.h), then one that says how many more there were
    fixture::Archive archive; // stays open: read(PlotMesh::member), read(PlotGdtf::member) ..
    std::string description;  // name of the description in the archive
    std::string name;         // of the file, for messages
    std::shared_ptr<const std::vector<std::uint8_t>> bytes; // what archive reads from, if it was no file
};

Result<LoadedPlot> load_mvr(const std::filesystem::path& path, const MvrLoading& loading = {});
Result<LoadedPlot> load_mvr(std::vector<std::uint8_t> bytes, const std::string& name,
                            const MvrLoading& loading = {});

} // namespace ghost::scene
