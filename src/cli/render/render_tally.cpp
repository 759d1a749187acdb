// SPDX-License-Identifier: Apache-2.0
#include "cli/render/render_film.h"

#include "base/log.h"
#include "base/print.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::string in_ms(double ms) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f ms", ms);
    return text;
}

std::string size_text(const std::pair<int, int>& size) {
    return std::to_string(size.first) + "x" + std::to_string(size.second);
}

} // namespace

void print_tally(const RenderArguments& arguments, const Session& session, const PictureWriter& writer,
                 const Tally& tally) {
    const double median = percentile(tally.draw_ms, 0.5);
    const double p99 = percentile(tally.draw_ms, 0.99);
    if (arguments.json) {
        nlohmann::json row{
            {"out", writer.first_path().string()},
            {"written", writer.written()},
            {"device", session.device->name()},
            {"width", session.show->cameras[session.camera].width / arguments.session.supersample},
            {"height", session.show->cameras[session.camera].height / arguments.session.supersample},
            {"frames", tally.draw_ms.size()},
            {"draw_ms_median", median},
            {"draw_ms_p99", p99},
            {"lights_drawn", tally.drawn},
            {"additions", tally.additions},
            {"ev100", session.relighter->ev100_used()}};
        for (const auto& [size, frames] : tally.sizes) row["frames_by_size"][size_text(size)] = frames;
        if (arguments.live_input) {
            row["late_frames"] = tally.late;
            row["packet_to_picture_ms_median"] = tally.latency.percentile_ms(0.5);
            row["packet_to_picture_ms_p99"] = tally.latency.percentile_ms(0.99);
            row["packet_to_picture_ms_max"] = tally.latency.max_ms();
            row["frames_with_new_packets"] = tally.latency.count();
            row["quality_level"] = tally.quality_level;
            row["quality_changes"] = tally.quality_changes;
        }
        print_text("%s\n", row.dump().c_str());
        return;
    }
    const std::size_t drawn = tally.draw_ms.size();
    const std::string frames = std::to_string(drawn + static_cast<std::size_t>(tally.late)) + " frames";
    log_info(writer.written() + ": " + frames +
             (tally.late > 0 ? ", " + std::to_string(drawn) + " drawn" : "") + ", " + in_ms(median) +
             " a drawing (median), " + in_ms(p99) + " (99 %)");
    if (arguments.hold_fps > 0 && !tally.sizes.empty()) {
        std::string sizes;
        for (const auto& [size, count] : tally.sizes)
            sizes += (sizes.empty() ? "" : ", ") + std::to_string(count) + " with " + size_text(size);
        log_info(writer.written() + ": to hold " + std::to_string(arguments.hold_fps) +
                 " frames a second on this machine, frames were drawn: " + sizes);
    }
    if (arguments.live_input && tally.latency.count() > 0)
        log_info("packet to picture: " + in_ms(tally.latency.percentile_ms(0.5)) + " (median), " +
                 in_ms(tally.latency.percentile_ms(0.99)) + " (99 %), " + in_ms(tally.latency.max_ms()) +
                 " at most; " + std::to_string(tally.late) +
                 " film frames repeat a picture because drawing took longer than a frame");
}

} // namespace ghost::app
