// SPDX-License-Identifier: Apache-2.0
#include "app/input_options.h"

#include <algorithm>
#include <charconv>

namespace ghost::app {

namespace {

constexpr std::size_t kMaxListed = 4096;

bool read_number(std::string_view text, int& value) {
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() && end == text.data() + text.size() && value >= 1 &&
           value <= dmx::kMaxUniverse;
}

} // namespace

void add_input_options(CLI::App& command, InputOptions& options) {
    command.add_option("--interface", options.interface,
                       "network interface, by name or by its IPv4 address; default: all");
    command.add_option("--protocols", options.protocols, "what to listen for: sacn, artnet or both")
        ->check(CLI::IsMember({"sacn", "artnet", "both"}))
        ->capture_default_str();
    command.add_option(
        "--universes", options.universes,
        "universes to join and accept, like 1-4,7; default: join 1-64, accept whatever arrives");
    command
        .add_option("--artnet-offset", options.artnet_offset,
                    "universe = Art-Net Port-Address + this (Port-Address 0 is universe 1)")
        ->check(CLI::Range(kLowestArtnetOffset, kHighestArtnetOffset))
        ->capture_default_str();
    command.add_flag("--show-preview", options.show_preview,
                     "use packets that the desk marks as preview (blind) too");
    command.add_flag("--no-poll-reply", options.no_poll_reply, "stay silent: do not answer ArtPoll");
}

Result<std::vector<std::uint16_t>> parse_universes(std::string_view text) {
    std::vector<std::uint16_t> result;
    const Error expected{"universes '" + std::string(text) +
                             "', expected numbers and ranges of 1 to 63999, at most 4096 "
                             "in all, like 1-4,7",
                         "--universes"};
    if (text.empty()) return result;
    for (std::string_view left = text;;) {
        const std::size_t comma = left.find(',');
        const std::string_view part = left.substr(0, comma);
        const std::size_t dash = part.find('-');
        int first = 0, last = 0;
        if (!read_number(part.substr(0, dash), first)) return expected;
        last = first;
        if (dash != std::string_view::npos && !read_number(part.substr(dash + 1), last)) return expected;
        if (last < first || result.size() + static_cast<std::size_t>(last - first) >= kMaxListed)
            return expected;
        for (int number = first; number <= last; ++number)
            result.push_back(static_cast<std::uint16_t>(number));
        if (comma == std::string_view::npos) break;
        left.remove_prefix(comma + 1);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

Result<dmx::ReceiverOptions> receiver_options(const InputOptions& options) {
    dmx::ReceiverOptions result;
    result.interface = options.interface;
    result.sacn = options.protocols != "artnet";
    result.artnet = options.protocols != "sacn";
    TRY(result.universes, parse_universes(options.universes));
    result.artnet_offset = options.artnet_offset;
    result.show_preview = options.show_preview;
    result.answer_polls = !options.no_poll_reply;
    return result;
}

} // namespace ghost::app
