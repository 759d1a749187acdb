#pragma once
// SPDX-License-Identifier: Apache-2.0
// Invitation: where browsers are let in, in words: addresses with and without their secret. Any thread.

#include "web/server.h"

#include <string>
#include <vector>

namespace ghost::web {

// A place where a server may listen.
struct Place {
    std::string name; // "eth0", or words
    std::uint32_t address = 0;
};
// This machine alone, each network with an IPv4 address, and whoever reaches us.
std::vector<Place> places();

// "http://10.0.0.5:8010/", the one that others reach first; behind a proxy "https://lights.example.org/"
// last.
std::vector<std::string> addresses_of(const ServerOptions& options, std::uint16_t port);
// With a token behind it, as it is opened or scanned.
std::string with_secret(const std::string& address, const std::string& token);

} // namespace ghost::web
