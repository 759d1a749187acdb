// SPDX-License-Identifier: Apache-2.0
// Of Windows the exit code of a program that crashed is the number of its exception.
#include "base/child.h"

#include "base/private/start_windows.h"
#include "base/windows_text.h"

#include <algorithm>
#include <array>

namespace ghost {
namespace {

struct Started {
    int number; // of the process
    OwnHandle process;
};

// Those of start_child() that nobody has waited for yet; of the main thread, as it is.
std::vector<Started>& started() {
    static std::vector<Started> all;
    return all;
}

// The file of a program; empty: there is none. Other than CreateProcess(), which would take one of the folder
// that we are in before that of PATH.
std::wstring program_file(const std::string& name) {
    const std::wstring wide = wide_text(name);
    const bool in_path = name.find_first_of("/\\:") == std::string::npos;
    std::wstring path(32768, L'\0');
    if (in_path)
        path.resize(::GetEnvironmentVariableW(L"PATH", path.data(), 32768));
    else
        path = L".";
    std::wstring found(32768, L'\0');
    const DWORD letters = ::SearchPathW(path.c_str(), wide.c_str(), L".exe", 32768, found.data(), nullptr);
    found.resize(letters < found.size() ? letters : 0);
    return found;
}

Result<PROCESS_INFORMATION> start(const std::vector<std::string>& words, StartWish wish) {
    wish.program = program_file(words[0]);
    if (wish.program.empty()) return Error{"cannot be started: there is no such program", words[0]};
    std::wstring end =
        wish.program.substr(wish.program.size() - std::min<std::size_t>(4, wish.program.size()));
    std::transform(end.begin(), end.end(), end.begin(), ::towlower);
    // Its words would be read once more by cmd.exe, by other rules.
    if (end == L".bat" || end == L".cmd")
        return Error{"cannot be started: it is a batch file, expected a program", words[0]};
    wish.line = command_line(words);
    auto process = start_windows(wish);
    if (!process.ok()) return Error{"cannot be started: " + process.error().what, words[0]};
    ::CloseHandle(process->hThread);
    return process;
}

} // namespace

Result<ChildResult> run_child(const std::vector<std::string>& words, const std::filesystem::path& from,
                              bool shown) {
    HANDLE read = nullptr, write = nullptr;
    if (!::CreatePipe(&read, &write, nullptr, 0))
        return Error{"cannot be started: " + windows_reason(::GetLastError()), words[0]};
    const OwnHandle in(read);
    OwnHandle out(write);
    StartWish wish;
    wish.from = from.wstring();
    wish.input = ::GetStdHandle(STD_INPUT_HANDLE);
    wish.output = wish.errors = out.get();
    const auto begun = start(words, wish);
    if (!begun.ok()) return begun.error();
    const OwnHandle process(begun->hProcess);
    out.close();
    ChildResult result;
    std::array<char, 4096> bytes;
    DWORD got = 0;
    while (::ReadFile(in.get(), bytes.data(), static_cast<DWORD>(bytes.size()), &got, nullptr)) {
        DWORD wrote = 0;
        if (shown && !::WriteFile(::GetStdHandle(STD_ERROR_HANDLE), bytes.data(), got, &wrote, nullptr))
            shown = false;
        result.output.append(bytes.data(), got);
        if (result.output.size() > 2 * kMostChildOutput)
            result.output.erase(0, result.output.size() - kMostChildOutput);
    }
    if (result.output.size() > kMostChildOutput)
        result.output.erase(0, result.output.size() - kMostChildOutput);
    ::WaitForSingleObject(process.get(), INFINITE);
    DWORD code = 0;
    ::GetExitCodeProcess(process.get(), &code);
    result.exit_code = static_cast<int>(code);
    return result;
}

Result<int> start_child(const std::vector<std::string>& words) {
    StartWish wish;
    wish.input = ::GetStdHandle(STD_INPUT_HANDLE);
    wish.output = ::GetStdHandle(STD_OUTPUT_HANDLE);
    wish.errors = ::GetStdHandle(STD_ERROR_HANDLE);
    const auto process = start(words, wish);
    if (!process.ok()) return process.error();
    const int number = static_cast<int>(process->dwProcessId);
    started().push_back({number, OwnHandle(process->hProcess)});
    return number;
}

int wait_for_child() {
    std::vector<Started>& all = started();
    // At most so many are waited for at once; of more, each part for a moment.
    const DWORD wait_ms = all.size() > MAXIMUM_WAIT_OBJECTS ? 50 : INFINITE;
    for (std::size_t begin = 0; !all.empty();
         begin = begin + MAXIMUM_WAIT_OBJECTS < all.size() ? begin + MAXIMUM_WAIT_OBJECTS : 0) {
        std::vector<HANDLE> part;
        for (std::size_t k = begin; k < all.size() && part.size() < MAXIMUM_WAIT_OBJECTS; ++k)
            part.push_back(all[k].process.get());
        const DWORD ended =
            ::WaitForMultipleObjects(static_cast<DWORD>(part.size()), part.data(), FALSE, wait_ms);
        if (ended == WAIT_FAILED) return -1;
        if (ended >= WAIT_OBJECT_0 + part.size()) continue;
        const auto one = all.begin() + static_cast<std::ptrdiff_t>(begin + ended - WAIT_OBJECT_0);
        const int number = one->number;
        all.erase(one);
        return number;
    }
    return -1;
}

} // namespace ghost
