// SPDX-License-Identifier: Apache-2.0
// New files beside others on file systems that know neither a rename that replaces nothing nor links: a
// filter of the kernel refuses both calls, with each of the errors that such file systems have.
#include "disk/files.h"
#include "disk/user_file.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <iterator>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

namespace ghost {
namespace {

namespace fs = std::filesystem;

bool refuse_both_calls(int error) {
#if defined(SYS_link)
    constexpr unsigned kLink = SYS_link;
#else
    constexpr unsigned kLink = SYS_linkat;
#endif
    sock_filter filter[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_renameat2, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_linkat, 1, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kLink, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<unsigned>(error)),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog program{std::size(filter), filter};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

// In a process of its own: a filter stays. Returns its exit code, 0: all is as it should be.
int committed(const fs::path& folder, int error) {
    const auto holds = [](const fs::path& path, const char* text) {
        const auto read = read_text_file(path, 100);
        return read.ok() && *read == text;
    };
    const fs::path temporary = folder / ".tour.part1_0.mvr", taken = folder / "tour.mvr",
                   link = folder / "link.mvr", free = folder / "tour (2).mvr", none = folder / "none.mvr";
    std::error_code code;
    fs::create_symlink("nowhere", link, code);
    if (code || !write_file_atomic(temporary, std::string_view("new")).ok() ||
        !write_file_atomic(taken, std::string_view("old")).ok() || !refuse_both_calls(error))
        return 1;
    for (const fs::path& path : {taken, link})
        if (const auto done = commit_new(temporary, path); !done.ok() || *done) return 2;
    if (!holds(taken, "old") || fs::exists(folder / "nowhere")) return 3;
    if (const auto done = commit_new(temporary, free); !done.ok() || !*done) return 4;
    if (!holds(free, "new") || fs::exists(temporary)) return 5;
    if (commit_new(folder / "missing", none).ok() || fs::exists(none)) return 6; // no empty file stays
    return 0;
}

TEST(NewNames, replace_nothing_where_the_disk_knows_no_way_to_do_it_at_once) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const int error : {EINVAL, ENOSYS, EPERM, EOPNOTSUPP})
        EXPECT_EXIT(
            {
                int done = 0;
                {
                    const TestFolder folder;
                    done = committed(folder.path, error);
                }
                std::_Exit(done);
            },
            testing::ExitedWithCode(0), "")
            << error;
}

} // namespace
} // namespace ghost
