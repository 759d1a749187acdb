#pragma once
// SPDX-License-Identifier: Apache-2.0
// Text and errors between us, who have UTF-8, and Windows, which has UTF-16. On Windows alone. Any thread.

#include <string>
#include <string_view>

namespace ghost {

std::wstring wide_text(std::string_view utf8); // what is no UTF-8 becomes U+FFFD
std::string utf8_text(std::wstring_view wide);

// What a number of GetLastError() or WSAGetLastError() means, without a full stop.
std::string windows_reason(unsigned long code);

} // namespace ghost
