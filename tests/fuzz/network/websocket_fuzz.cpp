// SPDX-License-Identifier: Apache-2.0
// Any bytes as the frames of a viewer, and their messages.
#include "web/protocol.h"

#include <cmath>
#include <cstdlib>

namespace ghost::web {
namespace {

void check(const Do& what) {
    const ui::Command& command = what.command;
    if (what.n == 0 || command.what.empty() || command.what.size() > kMostWordBytes ||
        command.arguments.size() > kMostArguments)
        std::abort();
    for (const auto& argument : command.arguments) {
        if (const auto* number = std::get_if<double>(&argument); number && !std::isfinite(*number))
            std::abort();
        if (const auto* text = std::get_if<std::string>(&argument); text && text->size() > kMostArgumentBytes)
            std::abort();
    }
}

void check(const Watch& watch) {
    if (watch.width < 1 || watch.width > kMostWidth || (watch.own && !watch.camera.empty())) std::abort();
    if (watch.probe && !(watch.probe->x >= 0 && watch.probe->x <= 1)) std::abort();
    if (!watch.own) return;
    const float far_m = glm::distance(watch.own->position_m, watch.own->target_m);
    if (!(far_m > 0 && far_m < 1e5f && watch.own->fov_y_deg >= 1 && watch.own->fov_y_deg <= 120))
        std::abort();
}

} // namespace
} // namespace ghost::web

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::web;
    for (ghost::Bytes left(data, size);;) {
        const ParsedFrame frame = parse_frame(left);
        if (frame.close != 0 || frame.bytes == 0) return 0;
        if (frame.payload.size() > kMostMessageBytes || frame.bytes > left.size()) std::abort();
        left = left.subspan(frame.bytes);
        if (frame.opcode != Opcode::text && frame.opcode != Opcode::binary) continue;
        const auto message = read_message(frame.opcode, frame.payload, true);
        const auto unread = read_message(frame.opcode, frame.payload, false);
        if (unread.ok() && std::holds_alternative<Do>(*unread)) std::abort();
        if (!message.ok()) continue;
        if (const auto* what = std::get_if<Do>(&*message)) check(*what);
        if (const auto* watch = std::get_if<Watch>(&*message)) check(*watch);
        if (const auto* ping = std::get_if<Ping>(&*message); ping && !std::isfinite(ping->t)) std::abort();
    }
}
