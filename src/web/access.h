#pragma once
// SPDX-License-Identifier: Apache-2.0
// Access: who may look on. A token of 128 random bits opens all, six digits exchange for it once; which names
// a browser may call us by, so that no foreign page reaches us through its reader's browser (DNS rebinding,
// CSRF). Times: seconds of any clock that goes on. Pure but for the random numbers of the system.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::web {

// 32 hexadecimal digits; from the system's random numbers.
std::string make_token();
// In a time that tells nothing of where they differ.
bool is_same_secret(std::string_view given, std::string_view secret);

// Six digits for those who cannot take the whole address over.
class Pairing {
public:
    static constexpr double kValid_s = 120;
    static constexpr int kMostTries = 5; // in all, whoever tries

    explicit Pairing(double now_s); // random digits
    Pairing(std::string digits, double now_s) : digits_(std::move(digits)), until_s_(now_s + kValid_s) {}

    const std::string& digits() const { return digits_; }
    double until_s() const { return until_s_; }
    // Each call is a try.
    bool accepts(std::string_view digits, double now_s);

private:
    std::string digits_;
    double until_s_;
    int tries_ = 0;
};

// The names of this machine by which a browser may call.
struct OwnNames {
    std::vector<std::string> names; // in small letters, without port
    std::uint16_t port = 0;
    std::string proxied; // whoever stands before us is called so, at any port; empty: nobody does
};
// localhost, our IPv4 addresses, the name of the machine alone and with .local.
OwnNames own_names(std::uint16_t port, const std::string& proxied);

// host: of a Host field. With our port, or without one where it is 80.
bool is_own_host(std::string_view host, const OwnNames& own);
// Whether browsers trust what comes from there though it is plain HTTP to us: this machine, or TLS before us.
bool is_trusted_host(std::string_view host, const OwnNames& own);
// origin: of an Origin field; the page that it names came from that host.
bool is_own_origin(std::string_view origin, std::string_view host, const OwnNames& own);

} // namespace ghost::web
