// SPDX-License-Identifier: Apache-2.0
#include "farm/farm.h"

#include "base/log.h"
#include "disk/files.h"
#include "farm/private/own_plans.h"
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
    const std::string text = json({{"engine", submitted.options.engine},
                                   {"options", submitted.options.options},
                                   {"at_once", submitted.options.jobs},
                                   {"jobs", submitted.jobs}})
                                 .dump() +
                             "\n";
    TRY_VOID(write_file_atomic(submitted_file(plan), text));
    if (const Result<void> noted = note_as_ours(submitted_file(plan), text); !noted.ok())
        log_debug(noted.error().text()); // the plan's own note said it
    return {};
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
        for (const json& job : all->at("jobs")) {
            const auto number = job.get<std::string>();
            // Words of scancel are more than numbers.
            if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos)
                submitted.jobs.push_back(number);
        }
        submitted.is_ours = is_noted_as_ours(submitted_file(plan), *text);
    } catch (const json::exception&) {
        log_warning(submitted_file(plan).string() +
                    ": is not what was written there; as if nothing were submitted");
        return {};
    }
    return submitted;
}

} // namespace ghost::app
