#pragma once
// SPDX-License-Identifier: Apache-2.0
// Site: which answer a request gets. The page lies in the program: no file system stands behind an address.
// Who has not the right host, origin and token gets no further, in this order. There are two tokens: one to
// look on, one to control as well, which there is only while that is allowed. Pure but for random numbers.

#include "web/access.h"
#include "web/http.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::web {

inline constexpr std::string_view kProtocol = "ghostlight.1";

struct Access {
    OwnNames own;
    std::string token;
    std::optional<Pairing> pairing;           // none: nobody comes in by digits
    std::string control_token = {};           // empty: nobody may control
    std::vector<std::string> taken_back = {}; // tokens that controlled: who has one still looks on

    // Another one, or none.
    void allow_control(bool allowed);
    // Tokens are others, and no digits hold.
    void renew();
};

enum class Right { none, view, control };
// What the page calls it.
std::string_view name_of(Right right);
Right right_of(std::string_view token, const Access& access);

struct Routed {
    Answer answer;
    bool is_live = false;            // 101: it goes on as a WebSocket
    Right right = Right::none;       // of who asks, where that was asked
    std::optional<std::string> book; // a file of the cue book is wanted, by its name there; answer is a 404
};
Routed route(const Head& head, std::string_view body, Access& access, double now_s);
// With a sentence for people.
Answer refusal(int status);

} // namespace ghost::web
