#pragma once
// SPDX-License-Identifier: Apache-2.0
// What sockets of Windows share. Any thread.

#include "base/windows_text.h"

#include <cstring>
#include <string>

#include <winsock2.h>

#include <windows.h>

#include <iphlpapi.h>
#include <mswsock.h>
#include <setupapi.h>
#include <ws2tcpip.h>

// A word of COM, which a header of the system has for "struct".
#undef interface

namespace ghost::dmx {

// Before the first call of the system's sockets; false: it has none.
inline bool need_winsock() {
    static const bool is_there = [] {
        WSADATA data{};
        return ::WSAStartup(MAKEWORD(2, 2), &data) == 0;
    }();
    return is_there;
}

inline std::string socket_reason(int code = ::WSAGetLastError()) {
    return windows_reason(static_cast<unsigned long>(code));
}

// A socket is a handle of the system, of which 32 bits count; so headers call it int.
inline SOCKET socket_of(int number) {
    return number == -1 ? INVALID_SOCKET : static_cast<SOCKET>(static_cast<INT_PTR>(number));
}
inline int number_of(SOCKET socket) {
    return socket == INVALID_SOCKET ? -1 : static_cast<int>(static_cast<INT_PTR>(socket));
}

// Not inherited, never waiting; -1: the system gives none.
int open_windows_socket(int family, int type);

template <class Value>
bool set_option(int number, int level, int option, const Value& value) {
    return ::setsockopt(socket_of(number), level, option, reinterpret_cast<const char*>(&value),
                        static_cast<int>(sizeof value)) == 0;
}

} // namespace ghost::dmx
