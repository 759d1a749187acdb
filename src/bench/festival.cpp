// SPDX-License-Identifier: Apache-2.0
#include "bench/festival.h"

#include "base/child.h"
#include "bench/bench.h"

#include <filesystem>

namespace ghost::app {
namespace {

constexpr const char* kMaker = "tools/make_festival.py";
constexpr const char* kRecordingSeconds = "30"; // of its recording

} // namespace

Result<Festival> Festival::make(int fixtures) {
    const std::string count = std::to_string(fixtures);
    Festival made(bench_file("-festival-" + count).string());
    const auto made_by = run_child(
        {"python3", kMaker, "--out", made.folder_, "--fixtures", count, "--seconds", kRecordingSeconds}, "",
        true);
    if (!made_by.ok()) return made_by.error();
    if (made_by->exit_code != 0)
        return Error{"makes no festival; the bench runs in the source folder and needs Python", kMaker};
    return made;
}

Festival::~Festival() {
    if (folder_.empty()) return;
    std::error_code code;
    std::filesystem::remove_all(folder_, code);
}

} // namespace ghost::app
