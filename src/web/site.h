#pragma once
// SPDX-License-Identifier: Apache-2.0
// Site: which answer a request gets. The page lies in the program: no file system stands behind an address.
// Who has not the right host, origin and token gets no further, in this order. Pure but for random numbers.

#include "web/access.h"
#include "web/http.h"

#include <optional>
#include <string>
#include <string_view>

namespace ghost::web {

inline constexpr std::string_view kProtocol = "ghostlight.1";

struct Access {
    OwnNames own;
    std::string token;
    std::optional<Pairing> pairing;
};

struct Routed {
    Answer answer;
    bool is_live = false; // 101: it goes on as a WebSocket
};
Routed route(const Head& head, std::string_view body, Access& access, double now_s);
// With a sentence for people.
Answer refusal(int status);

} // namespace ghost::web
