// SPDX-License-Identifier: Apache-2.0
#include "base/child.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace ghost {
namespace {

// In the shape that exec takes; the words must outlive it.
std::vector<char*> pointers(const std::vector<std::string>& words) {
    std::vector<char*> list;
    for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
    list.push_back(nullptr);
    return list;
}

struct Actions {
    posix_spawn_file_actions_t value;
    Actions() { ::posix_spawn_file_actions_init(&value); }
    ~Actions() { ::posix_spawn_file_actions_destroy(&value); }
};

Result<int> spawn(const std::vector<std::string>& words, const Actions& actions) {
    // Who started us may ignore what becomes of children, which is passed on; then nobody can wait for one.
    struct sigaction before = {};
    if (::sigaction(SIGCHLD, nullptr, &before) == 0 && before.sa_handler == SIG_IGN)
        ::signal(SIGCHLD, SIG_DFL);
    pid_t process = 0;
    const int fault =
        ::posix_spawnp(&process, words[0].c_str(), &actions.value, nullptr, pointers(words).data(), environ);
    if (fault != 0) return Error{"cannot be started: " + std::string(std::strerror(fault)), words[0]};
    return process;
}

} // namespace

Result<ChildResult> run_child(const std::vector<std::string>& words, const std::filesystem::path& from,
                              bool shown) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return Error{"cannot be started: " + std::string(std::strerror(errno)), words[0]};
    Actions actions;
    if (!from.empty()) ::posix_spawn_file_actions_addchdir_np(&actions.value, from.c_str());
    ::posix_spawn_file_actions_adddup2(&actions.value, ends[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions.value, ends[1], STDERR_FILENO);
    const Result<int> process = spawn(words, actions);
    ::close(ends[1]);
    ChildResult result;
    std::array<char, 4096> bytes;
    for (;;) {
        const ssize_t got = process.ok() ? ::read(ends[0], bytes.data(), bytes.size()) : 0;
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        const auto size = static_cast<std::size_t>(got);
        if (shown && ::write(STDERR_FILENO, bytes.data(), size) < 0) shown = false;
        result.output.append(bytes.data(), size);
        if (result.output.size() > 2 * kMostChildOutput)
            result.output.erase(0, result.output.size() - kMostChildOutput);
    }
    ::close(ends[0]);
    if (!process.ok()) return process.error();
    if (result.output.size() > kMostChildOutput)
        result.output.erase(0, result.output.size() - kMostChildOutput);
    int status = 0;
    pid_t ended = 0;
    do ended = ::waitpid(*process, &status, 0);
    while (ended < 0 && errno == EINTR);
    if (ended < 0) return Error{"ended, nobody knows how: " + std::string(std::strerror(errno)), words[0]};
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

Result<int> start_child(const std::vector<std::string>& words) {
    return spawn(words, Actions());
}

int wait_for_child() {
    int status = 0;
    pid_t process = 0;
    do process = ::waitpid(-1, &status, 0);
    while (process < 0 && errno == EINTR);
    return process;
}

} // namespace ghost
