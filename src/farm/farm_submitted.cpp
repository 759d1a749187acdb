// SPDX-License-Identifier: Apache-2.0
#include "farm/farm.h"

#include "base/log.h"
#include "disk/files.h"
#include "json_xml_toml/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

using nlohmann::json;

constexpr JsonLimits kSubmittedLimits{.bytes = 1 << 20};

std::filesystem::path submitted_file(const FarmPlan& plan) {
    return plan.folder / "submitted.json";
}

} // namespace

Result<void> write_submitted(const FarmPlan& plan, const Submitted& submitted) {
    return write_file_atomic(submitted_file(plan), json({{"engine", submitted.options.engine},
                                                         {"options", submitted.options.options},
                                                         {"at_once", submitted.options.jobs},
                                                         {"jobs", submitted.jobs}})
                                                           .dump() +
                                                       "\n");
}

Submitted read_submitted(const FarmPlan& plan) {
    Submitted submitted;
    const auto text = read_text_file(submitted_file(plan), kSubmittedLimits.bytes);
    if (!text.ok()) return submitted;
    const auto all = read_json(*text, submitted_file(plan).string(), kSubmittedLimits);
    if (!all.ok()) return submitted;
    try {
        submitted.options.engine = all->at("engine").get<std::string>();
        submitted.options.options = all->at("options").get<std::string>();
        submitted.options.jobs = std::clamp(all->at("at_once").get<int>(), 1, 1024);
        for (const json& job : all->at("jobs")) submitted.jobs.push_back(job.get<std::string>());
    } catch (const json::exception&) {
        log_warning(submitted_file(plan).string() +
                    ": is not what was written there; as if nothing were submitted");
        return {};
    }
    return submitted;
}

} // namespace ghost::app
