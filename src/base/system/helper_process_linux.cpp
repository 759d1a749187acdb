// SPDX-License-Identifier: Apache-2.0
#include "base/helper_process.h"

#include "base/private/helper_environment.h"
#include "base/private/helper_pipe.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <seccomp.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ghost {
namespace {

// What instrumented code reserves has nothing to do with what it uses, and its reports open files.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

void limit(int resource, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

// What computing takes: memory, threads, the stream and an end. Everything else is refused as not permitted.
void allow_computing_only() {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
    if (!filter) return;
    for (const int call : {SCMP_SYS(read),
                           SCMP_SYS(write),
                           SCMP_SYS(recvfrom),
                           SCMP_SYS(sendto),
                           SCMP_SYS(poll),
                           SCMP_SYS(ppoll),
                           SCMP_SYS(close),
                           SCMP_SYS(brk),
                           SCMP_SYS(mmap),
                           SCMP_SYS(munmap),
                           SCMP_SYS(mremap),
                           SCMP_SYS(mprotect),
                           SCMP_SYS(madvise),
                           SCMP_SYS(futex),
                           SCMP_SYS(sched_yield),
                           SCMP_SYS(set_robust_list),
                           SCMP_SYS(rseq),
                           SCMP_SYS(set_tid_address),
                           SCMP_SYS(gettid),
                           SCMP_SYS(getpid),
                           SCMP_SYS(tgkill),
                           SCMP_SYS(rt_sigaction),
                           SCMP_SYS(rt_sigprocmask),
                           SCMP_SYS(rt_sigreturn),
                           SCMP_SYS(sigaltstack),
                           SCMP_SYS(restart_syscall),
                           SCMP_SYS(clock_gettime),
                           SCMP_SYS(clock_nanosleep),
                           SCMP_SYS(gettimeofday),
                           SCMP_SYS(getrandom),
                           SCMP_SYS(sched_getaffinity),
                           SCMP_SYS(sysinfo),
                           SCMP_SYS(fstat),
                           SCMP_SYS(newfstatat),
                           SCMP_SYS(exit),
                           SCMP_SYS(exit_group)})
        seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0);
    // Threads, but no processes. The flags of clone3() cannot be looked at: the library then takes clone().
    seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(clone), 1,
                     SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
    seccomp_load(filter); // where the kernel has none, the limits of files and memory still hold
    seccomp_release(filter);
}

} // namespace

std::ptrdiff_t write_to_helper(int descriptor, Bytes bytes) {
    ssize_t sent = 0;
    do sent = ::send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
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
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return Error{std::string("cannot start a helper: ") + std::strerror(errno), ""};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], kHelperDescriptor);
    // Ctrl+C on a terminal is for the program, which then ends its helper.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    std::string name = "ghostlight", argument = command;
    char* arguments[] = {name.data(), argument.data(), nullptr};
    HelperEnvironment environment;
    pid_t process = 0;
    const int fault =
        ::posix_spawn(&process, "/proc/self/exe", &actions, &attributes, arguments, environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (fault != 0) {
        ::close(ends[0]);
        return Error{std::string("cannot start a helper: ") + std::strerror(fault), ""};
    }
    return HelperProcess(process, ends[0]);
}

double HelperProcess::cpu_s() const {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
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
    close_range(kHelperDescriptor + 1, ~0u, 0);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, cpu_s);
    if (!kSanitized) {
        limit(RLIMIT_AS, memory_bytes);
        limit(RLIMIT_NOFILE, kHelperDescriptor + 1);
        allow_computing_only();
    }
    return HelperStream(kHelperDescriptor);
}

} // namespace ghost
