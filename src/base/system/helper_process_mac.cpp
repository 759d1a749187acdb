// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
// Of macOS: the profile "pure computation" of its sandbox takes files, network and other programs away.
// Address space has no limit there that the kernel keeps: memory_bytes is asked for as data, which it keeps
// in part.
#include "base/helper_process.h"

#include "base/private/helper_environment.h"
#include "base/private/helper_pipe.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <libproc.h>
#include <mach-o/dyld.h>
#include <poll.h>
#include <sandbox.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ghost {
namespace {

void limit(int resource, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(resource, &both);
}

Error not_started(int fault) {
    return Error{std::string("cannot start a helper: ") + std::strerror(fault), ""};
}

} // namespace

std::ptrdiff_t write_to_helper(int descriptor, Bytes bytes) {
    ssize_t sent = 0;
    do sent = ::send(descriptor, bytes.data(), bytes.size(), 0);
    while (sent < 0 && errno == EINTR);
    return sent;
}

std::ptrdiff_t read_of_helper(int descriptor, std::span<std::uint8_t> bytes) {
    ssize_t got = 0;
    do got = ::recv(descriptor, bytes.data(), bytes.size(), 0);
    while (got < 0 && errno == EINTR);
    return got;
}

bool wait_for_helper(int descriptor, int wait_ms) {
    pollfd one{descriptor, POLLIN, 0};
    return ::poll(&one, 1, wait_ms) > 0;
}

Result<HelperProcess> HelperProcess::start(const std::string& command) {
    if (is_helper())
        return Error{"this program is a helper whose main() does not know '" + command + "'", ""};
    std::array<char, 4096> file{};
    auto size = static_cast<std::uint32_t>(file.size());
    if (_NSGetExecutablePath(file.data(), &size) != 0) return not_started(ENAMETOOLONG);
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) return not_started(errno);
    const int on = 1;
    for (const int end : ends) { // a write to one that is gone is an error, no signal
        (void)::fcntl(end, F_SETFD, FD_CLOEXEC);
        (void)::setsockopt(end, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addinherit_np(&actions, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], kHelperDescriptor);
    // Ctrl+C on a terminal is for the program, which then ends its helper. All that is not named here is
    // closed.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_CLOEXEC_DEFAULT);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    std::string name = "ghostlight", argument = command;
    char* arguments[] = {name.data(), argument.data(), nullptr};
    HelperEnvironment environment;
    pid_t process = 0;
    const int fault =
        ::posix_spawn(&process, file.data(), &actions, &attributes, arguments, environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (fault != 0) {
        ::close(ends[0]);
        return not_started(fault);
    }
    return HelperProcess(process, ends[0]);
}

double HelperProcess::cpu_s() const {
    proc_taskinfo info{}; // nanoseconds on Intel; ticks of the machine's clock on ARM, where one is 125/3 ns
    if (proc_pidinfo(process_, PROC_PIDTASKINFO, 0, &info, sizeof info) != static_cast<int>(sizeof info))
        return 0.0;
#if defined(__arm64__)
    constexpr double kTick_s = 125e-9 / 3;
#else
    constexpr double kTick_s = 1e-9;
#endif
    return kTick_s * static_cast<double>(info.pti_total_user + info.pti_total_system);
}

std::string HelperProcess::end() {
    if (process_ == 0) return "";
    ::close(descriptor_);
    int status = 0;
    // One that ended by itself keeps its own reason: until it is waited for, this signal changes nothing.
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "exit code " + std::to_string(WEXITSTATUS(status));
}

HelperStream confine_helper(std::size_t memory_bytes, std::uint64_t cpu_s) {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, cpu_s);
    limit(RLIMIT_DATA, memory_bytes);
    limit(RLIMIT_NOFILE, kHelperDescriptor + 1);
    char* problem = nullptr;
#pragma clang diagnostic push
#pragma clang diagnostic ignored                                                                             \
    "-Wdeprecated-declarations" // there is no other way for a program without a bundle
    if (sandbox_init(kSBXProfilePureComputation, SANDBOX_NAMED, &problem) != 0) sandbox_free_error(problem);
#pragma clang diagnostic pop
    return HelperStream(kHelperDescriptor);
}

} // namespace ghost
