#pragma once
// SPDX-License-Identifier: Apache-2.0
// A program that Windows starts: what child.h and helper_process.h share. Any thread.

#include "base/result.h"

#include <string>
#include <utility>
#include <vector>

#include <windows.h>

namespace ghost {

// Closed on every way out.
class OwnHandle {
public:
    OwnHandle() = default;
    explicit OwnHandle(HANDLE handle) : handle_(handle == INVALID_HANDLE_VALUE ? nullptr : handle) {}
    OwnHandle(OwnHandle&& other) noexcept : handle_(other.release()) {}
    OwnHandle& operator=(OwnHandle&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~OwnHandle() { close(); }

    HANDLE get() const { return handle_; }
    HANDLE release() { return std::exchange(handle_, nullptr); }
    void close() {
        if (handle_ != nullptr) ::CloseHandle(release());
    }

private:
    HANDLE handle_ = nullptr;
};

// Handles of the system have 32 bits that count, in programs of 64 bits, too; so headers call them int.
inline int number_of(HANDLE handle) {
    return static_cast<int>(reinterpret_cast<INT_PTR>(handle));
}
inline HANDLE handle_of(int number) {
    return reinterpret_cast<HANDLE>(static_cast<INT_PTR>(number));
}

// As a program takes its command line apart again.
std::wstring command_line(const std::vector<std::string>& words);

struct StartWish {
    std::wstring program;                                       // its file
    std::wstring line;                                          // command_line()
    std::wstring from;                                          // its folder; empty: ours
    HANDLE input = nullptr, output = nullptr, errors = nullptr; // null: none; nothing else of ours is its own
    DWORD flags = 0;
};
// Error: why not, without a place.
Result<PROCESS_INFORMATION> start_windows(const StartWish& wish);

} // namespace ghost
