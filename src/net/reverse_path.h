#pragma once
// SPDX-License-Identifier: Apache-2.0
// Packets that this machine's reverse path filter dropped (net.ipv4.conf.*.rp_filter): they came by a card by
// which the kernel would not answer their sender, as of a desk in another network. tcpdump sees them and no
// program gets them. From /proc/net/netstat; elsewhere none.

#include <cstdint>
#include <string_view>

namespace ghost::dmx {

// Since the machine started. Any thread.
std::uint64_t reverse_path_drops();

// Of the text of /proc/net/netstat; 0 where it does not say.
std::uint64_t parse_reverse_path_drops(std::string_view netstat);

} // namespace ghost::dmx
