#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whether this system is Wine, which does not do all that Windows does.
#if defined(_WIN32)
#include <windows.h>
#undef interface // a word of COM
#endif

namespace ghost {

inline bool is_wine() {
#if defined(_WIN32)
    const HMODULE library = ::GetModuleHandleW(L"ntdll.dll");
    return library != nullptr && ::GetProcAddress(library, "wine_get_version") != nullptr;
#else
    return false;
#endif
}

} // namespace ghost
