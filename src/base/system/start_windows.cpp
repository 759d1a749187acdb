// SPDX-License-Identifier: Apache-2.0
#include "base/private/start_windows.h"

#include "base/windows_text.h"

#include <algorithm>
#include <array>

namespace ghost {
namespace {

// The rules of CommandLineToArgvW: backslashes count only before a quotation mark.
void append_quoted(std::wstring& line, const std::wstring& word) {
    if (!word.empty() && word.find_first_of(L" \t\n\v\"") == std::wstring::npos) {
        line += word;
        return;
    }
    line += L'"';
    for (std::size_t at = 0;; ++at) {
        std::size_t backslashes = 0;
        for (; at < word.size() && word[at] == L'\\'; ++at) ++backslashes;
        if (at == word.size()) {
            line.append(2 * backslashes, L'\\');
            break;
        }
        line.append(word[at] == L'"' ? 2 * backslashes + 1 : backslashes, L'\\');
        line += word[at];
    }
    line += L'"';
}

// The same file for the program that is started; what is no file of a process, such as none, stays so.
OwnHandle heritable(HANDLE handle) {
    HANDLE copy = nullptr;
    if (handle == nullptr || handle == INVALID_HANDLE_VALUE ||
        !::DuplicateHandle(::GetCurrentProcess(), handle, ::GetCurrentProcess(), &copy, 0, TRUE,
                           DUPLICATE_SAME_ACCESS))
        return OwnHandle();
    return OwnHandle(copy);
}

} // namespace

std::wstring command_line(const std::vector<std::string>& words) {
    std::wstring line;
    for (const std::string& word : words) {
        if (!line.empty()) line += L' ';
        append_quoted(line, wide_text(word));
    }
    return line;
}

Result<PROCESS_INFORMATION> start_windows(const StartWish& wish) {
    const std::array<OwnHandle, 3> files{heritable(wish.input), heritable(wish.output),
                                         heritable(wish.errors)};
    std::vector<HANDLE> inherited;
    for (const OwnHandle& file : files)
        if (file.get() != nullptr) inherited.push_back(file.get());
    SIZE_T bytes = 0;
    ::InitializeProcThreadAttributeList(nullptr, 1, 0, &bytes);
    std::vector<unsigned char> memory(bytes);
    auto* const list = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(memory.data());
    if (!::InitializeProcThreadAttributeList(list, 1, 0, &bytes))
        return Error{windows_reason(::GetLastError()), ""};
    STARTUPINFOEXW start{};
    start.StartupInfo.cb = sizeof start;
    start.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    start.StartupInfo.hStdInput = files[0].get();
    start.StartupInfo.hStdOutput = files[1].get();
    start.StartupInfo.hStdError = files[2].get();
    // Another thread may start a program at the same time: each gets its own files alone.
    if (!inherited.empty() &&
        ::UpdateProcThreadAttribute(list, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, inherited.data(),
                                    inherited.size() * sizeof(HANDLE), nullptr, nullptr))
        start.lpAttributeList = list;
    std::wstring line = wish.line; // which the system may write into
    PROCESS_INFORMATION process{};
    const BOOL done =
        ::CreateProcessW(wish.program.c_str(), line.data(), nullptr, nullptr, !inherited.empty(),
                         wish.flags | EXTENDED_STARTUPINFO_PRESENT, nullptr,
                         wish.from.empty() ? nullptr : wish.from.c_str(), &start.StartupInfo, &process);
    const DWORD code = ::GetLastError();
    ::DeleteProcThreadAttributeList(list);
    if (!done) return Error{windows_reason(code), ""};
    return process;
}

} // namespace ghost
