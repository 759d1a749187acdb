// SPDX-License-Identifier: Apache-2.0
#include "bench/private/festival.h"

#include "bench/private/loaded_window.h"

#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace ghost::app {
namespace {

constexpr const char* kMaker = "tools/make_festival.py";
constexpr const char* kSeconds = "30"; // of its recording

} // namespace

Result<Festival> Festival::make(int fixtures) {
    const std::string count = std::to_string(fixtures);
    Festival made(loaded_window_file("-festival-" + count).string());
    const pid_t child = ::fork();
    if (child < 0) return Error{"cannot start a process", kMaker};
    if (child == 0) {
        ::dup2(STDERR_FILENO, STDOUT_FILENO); // rows only there
        ::execlp("python3", "python3", kMaker, "--out", made.folder_.c_str(), "--fixtures", count.c_str(),
                 "--seconds", kSeconds, static_cast<char*>(nullptr));
        ::_exit(127);
    }
    int status = 0;
    if (::waitpid(child, &status, 0) < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return Error{"makes no festival; the bench runs in the source folder and needs Python", kMaker};
    return made;
}

Festival::~Festival() {
    if (folder_.empty()) return;
    std::error_code code;
    std::filesystem::remove_all(folder_, code);
}

} // namespace ghost::app
