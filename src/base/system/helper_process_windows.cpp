// SPDX-License-Identifier: Apache-2.0
// Of Windows: a job of its own holds the helper's memory, its time and that it starts nothing, and ends it
// with this program; a token of low integrity keeps it from changing what is the user's. There is no filter
// of system calls as Linux has one: what everybody may read stays readable to it, and the network reachable.
#include "base/helper_process.h"

#include "base/private/helper_pipe.h"
#include "base/private/start_windows.h"
#include "base/windows_text.h"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include <sddl.h>

namespace ghost {
namespace {

constexpr DWORD kPipeBytes = 1 << 16;
constexpr DWORD kMostAtOnce = 1 << 20;
constexpr UINT kEndedByUs = 0xFFFF0009;
constexpr DWORD kFirstException = 0xC0000000;

Error not_started(DWORD code) {
    return Error{"cannot start a helper: " + windows_reason(code), ""};
}

struct Ends {
    OwnHandle ours, theirs;
};

// Both ways, of this user alone, and not from elsewhere; the second end is there before anybody else can ask
// for it.
Result<Ends> make_pipe() {
    static std::atomic<unsigned> count{0};
    const std::wstring name = L"\\\\.\\pipe\\ghostlight_" + std::to_wstring(::GetCurrentProcessId()) + L"_" +
                              std::to_wstring(++count) + L"_" + std::to_wstring(::GetTickCount64());
    Ends ends;
    ends.ours = OwnHandle(::CreateNamedPipeW(name.c_str(), PIPE_ACCESS_DUPLEX | FILE_FLAG_FIRST_PIPE_INSTANCE,
                                             PIPE_TYPE_BYTE | PIPE_WAIT | PIPE_REJECT_REMOTE_CLIENTS, 1,
                                             kPipeBytes, kPipeBytes, 0, nullptr));
    if (ends.ours.get() == nullptr) return not_started(::GetLastError());
    ends.theirs = OwnHandle(
        ::CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING, 0, nullptr));
    if (ends.theirs.get() == nullptr) return not_started(::GetLastError());
    return ends;
}

void limit_job(HANDLE job, std::size_t memory_bytes, std::uint64_t cpu_s) {
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_ACTIVE_PROCESS |
                                              JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION |
                                              JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    limits.BasicLimitInformation.ActiveProcessLimit = 1;
    if (memory_bytes != 0) {
        limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
        limits.ProcessMemoryLimit = memory_bytes;
    }
    if (cpu_s != 0) {
        limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_TIME;
        limits.BasicLimitInformation.PerProcessUserTimeLimit.QuadPart =
            static_cast<LONGLONG>(cpu_s * 10'000'000);
    }
    (void)::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
    // No window of others, no clipboard, no log-off.
    JOBOBJECT_BASIC_UI_RESTRICTIONS windows{};
    windows.UIRestrictionsClass = JOB_OBJECT_UILIMIT_DESKTOP | JOB_OBJECT_UILIMIT_DISPLAYSETTINGS |
                                  JOB_OBJECT_UILIMIT_EXITWINDOWS | JOB_OBJECT_UILIMIT_GLOBALATOMS |
                                  JOB_OBJECT_UILIMIT_HANDLES | JOB_OBJECT_UILIMIT_READCLIPBOARD |
                                  JOB_OBJECT_UILIMIT_SYSTEMPARAMETERS | JOB_OBJECT_UILIMIT_WRITECLIPBOARD;
    (void)::SetInformationJobObject(job, JobObjectBasicUIRestrictions, &windows, sizeof windows);
}

// What is the user's cannot be changed by a process of this token.
void lower_integrity() {
    HANDLE opened = nullptr;
    PSID low = nullptr;
    if (!::OpenProcessToken(::GetCurrentProcess(), TOKEN_ADJUST_DEFAULT | TOKEN_QUERY, &opened)) return;
    const OwnHandle token(opened);
    if (!::ConvertStringSidToSidW(L"S-1-16-4096", &low)) return;
    TOKEN_MANDATORY_LABEL label{};
    label.Label.Attributes = SE_GROUP_INTEGRITY;
    label.Label.Sid = low;
    (void)::SetTokenInformation(token.get(), TokenIntegrityLevel, &label, sizeof label + ::GetLengthSid(low));
    ::LocalFree(low);
}

std::wstring own_file() {
    std::wstring file(32768, L'\0');
    file.resize(::GetModuleFileNameW(nullptr, file.data(), 32768));
    return file;
}

} // namespace

std::ptrdiff_t write_to_helper(int descriptor, Bytes bytes) {
    DWORD sent = 0;
    const auto size = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), kMostAtOnce));
    return ::WriteFile(handle_of(descriptor), bytes.data(), size, &sent, nullptr)
               ? static_cast<std::ptrdiff_t>(sent)
               : -1;
}

std::ptrdiff_t read_of_helper(int descriptor, std::span<std::uint8_t> bytes) {
    DWORD got = 0;
    const auto size = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), kMostAtOnce));
    return ::ReadFile(handle_of(descriptor), bytes.data(), size, &got, nullptr)
               ? static_cast<std::ptrdiff_t>(got)
               : -1;
}

// A pipe cannot be waited for without an overlapped read, whose bytes would have to be somewhere.
bool wait_for_helper(int descriptor, int wait_ms) {
    const ULONGLONG begin = ::GetTickCount64();
    for (;;) {
        DWORD there = 0;
        // One that is gone has something to say, too: that.
        if (!::PeekNamedPipe(handle_of(descriptor), nullptr, 0, nullptr, &there, nullptr) || there > 0)
            return true;
        if (::GetTickCount64() - begin >= static_cast<ULONGLONG>(std::max(wait_ms, 0))) return false;
        ::Sleep(1);
    }
}

Result<HelperProcess> HelperProcess::start(const std::string& command) {
    TRY(Ends ends, make_pipe());
    const OwnHandle nothing(::CreateFileW(L"NUL", GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                                          OPEN_EXISTING, 0, nullptr));
    StartWish wish;
    wish.program = own_file();
    wish.line = command_line({"ghostlight", command});
    wish.input = ends.theirs.get();
    wish.output = nothing.get();
    wish.errors = ::GetStdHandle(STD_ERROR_HANDLE);
    // Ctrl+C in a console is for the program, which then ends its helper.
    wish.flags = CREATE_SUSPENDED | CREATE_NEW_PROCESS_GROUP;
    const auto begun = start_windows(wish);
    if (!begun.ok()) return Error{"cannot start a helper: " + begun.error().what, ""};
    const OwnHandle thread(begun->hThread);
    OwnHandle process(begun->hProcess);
    // The handle of this job stays open as long as this program runs: its end is the helper's, too.
    static const OwnHandle family([] {
        const HANDLE job = ::CreateJobObjectW(nullptr, nullptr);
        JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
        limits.BasicLimitInformation.LimitFlags =
            JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
        (void)::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
        return job;
    }());
    (void)::AssignProcessToJobObject(family.get(), process.get());
    if (::ResumeThread(thread.get()) == static_cast<DWORD>(-1)) {
        const DWORD code = ::GetLastError();
        ::TerminateProcess(process.get(), kEndedByUs);
        return not_started(code);
    }
    return HelperProcess(number_of(process.release()), number_of(ends.ours.release()));
}

double HelperProcess::cpu_s() const {
    FILETIME begun{}, ended{}, kernel{}, user{};
    if (!::GetProcessTimes(handle_of(process_), &begun, &ended, &kernel, &user)) return 0.0;
    const auto seconds = [](const FILETIME& time) {
        return 1e-7 * static_cast<double>(std::uint64_t{time.dwHighDateTime} << 32 | time.dwLowDateTime);
    };
    return seconds(kernel) + seconds(user);
}

std::string HelperProcess::end() {
    if (process_ == 0) return "";
    const OwnHandle process(handle_of(process_)), pipe(handle_of(descriptor_));
    process_ = 0;
    // One that is ending keeps its own reason; its stream ends a moment before it does.
    if (::WaitForSingleObject(process.get(), 50) != WAIT_OBJECT_0)
        ::TerminateProcess(process.get(), kEndedByUs);
    ::WaitForSingleObject(process.get(), INFINITE);
    DWORD code = 0;
    ::GetExitCodeProcess(process.get(), &code);
    if (code == kEndedByUs) return "ended";
    char text[32];
    std::snprintf(text, sizeof text, code >= kFirstException ? "exception %lx" : "exit code %lu", code);
    return text;
}

HelperStream confine_helper(std::size_t memory_bytes, std::uint64_t cpu_s) {
    // Never closed: the job is to last as long as the process.
    const HANDLE job = ::CreateJobObjectW(nullptr, nullptr);
    limit_job(job, memory_bytes, cpu_s);
    (void)::AssignProcessToJobObject(job, ::GetCurrentProcess());
    // Reports of crashes are for the program that started it.
    ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);
    lower_integrity();
    return HelperStream(number_of(::GetStdHandle(STD_INPUT_HANDLE)));
}

} // namespace ghost
