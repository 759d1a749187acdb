// SPDX-License-Identifier: Apache-2.0
#include "disk/own_program.h"

#include <windows.h>

#include <string>

namespace ghost {

std::filesystem::path own_program() {
    std::wstring file(32768, L'\0'); // the longest path that there is
    file.resize(::GetModuleFileNameW(nullptr, file.data(), static_cast<DWORD>(file.size())));
    return starter_of(file);
}

} // namespace ghost
