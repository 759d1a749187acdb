// SPDX-License-Identifier: Apache-2.0
#include "web/access.h"

#include "base/text.h"
#include "net/socket.h"
#include "net/tcp.h"

#include <algorithm>
#include <random>

namespace ghost::web {
namespace {

struct HostAndPort {
    std::string name;
    std::string_view port; // with its colon
};

HostAndPort parts_of(std::string_view host) {
    const std::size_t colon = host.starts_with('[') ? host.find(':', host.find(']')) : host.find(':');
    return {lower(host.substr(0, colon)), colon == std::string_view::npos ? "" : host.substr(colon)};
}

} // namespace

std::string make_token() {
    constexpr int kWords = 4;
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::random_device random("/dev/urandom");
    std::string token;
    for (int word = 0; word < kWords; ++word) {
        const std::random_device::result_type bits = random();
        for (int digit = 0; digit < 8; ++digit) token += kDigits[(bits >> (4 * digit)) & 15];
    }
    return token;
}

bool is_same_secret(std::string_view given, std::string_view secret) {
    unsigned differs = given.size() == secret.size() ? 0u : 1u;
    for (std::size_t i = 0; i < secret.size(); ++i) {
        const char other = i < given.size() ? given[i] : '\0';
        differs |=
            static_cast<unsigned>(static_cast<unsigned char>(other) ^ static_cast<unsigned char>(secret[i]));
    }
    return differs == 0 && !secret.empty();
}

Pairing::Pairing(double now_s) : until_s_(now_s + kValid_s) {
    std::random_device random("/dev/urandom");
    for (int digit = 0; digit < 6; ++digit)
        digits_ += static_cast<char>('0' + std::uniform_int_distribution<int>(0, 9)(random));
}

bool Pairing::accepts(std::string_view digits, double now_s) {
    if (tries_ >= kMostTries || now_s > until_s_) return false;
    ++tries_;
    return is_same_secret(digits, digits_);
}

OwnNames own_names(std::uint16_t port, const std::string& proxied) {
    OwnNames own{{"localhost", "127.0.0.1", "[::1]"}, port, lower(proxied)};
    for (const dmx::NetInterface& interface : dmx::list_interfaces())
        if (interface.address != 0) own.names.push_back(dmx::ipv4_text(interface.address));
    if (const std::string name = lower(dmx::host_name()); !name.empty()) {
        own.names.push_back(name);
        own.names.push_back(name + ".local");
    }
    return own;
}

bool is_own_host(std::string_view host, const OwnNames& own) {
    const HostAndPort parts = parts_of(host);
    if (!own.proxied.empty() && parts.name == own.proxied) return true;
    const bool has_port =
        parts.port == ":" + std::to_string(own.port) || (parts.port.empty() && own.port == 80);
    return has_port && std::find(own.names.begin(), own.names.end(), parts.name) != own.names.end();
}

bool is_trusted_host(std::string_view host, const OwnNames& own) {
    const std::string name = parts_of(host).name;
    return name == "localhost" || name == "127.0.0.1" || name == "[::1]" ||
           (!own.proxied.empty() && name == own.proxied);
}

bool is_own_origin(std::string_view origin, std::string_view host, const OwnNames& own) {
    const std::string small = lower(origin), own_host = lower(host);
    if (small == "http://" + own_host) return true;
    return !own.proxied.empty() && parts_of(host).name == own.proxied && small == "https://" + own_host;
}

} // namespace ghost::web
