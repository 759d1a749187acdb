// SPDX-License-Identifier: Apache-2.0
// main() of the tests that read models: like the program, a test is also the process apart that reads them.
// For models of certain names that one does what a fault of a parser would do.
#include "stage/model_reader.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace ghost;

namespace {

std::string outcome(const char* what, int result) {
    return std::string(what) + (result < 0 ? " refused; " : " works; ");
}

// What a parser that was taken over could try.
Error what_works() {
    std::string text = outcome("open", ::open("/etc/passwd", O_RDONLY));
    text += outcome("socket", ::socket(AF_INET, SOCK_STREAM, 0));
    text += outcome("unlink", ::unlink("/tmp/ghostlight-no-such-file") == 0 || errno != EPERM ? 0 : -1);
    text += outcome("fork", ::fork());
    text += outcome("exec", ::execl("/bin/true", "true", nullptr) == 0 || errno != EPERM ? 0 : -1);
    return {text, ""};
}

Result<scene::Stage> read_as_told(Bytes bytes, const std::string& extension, const std::string& name,
                                  Report& report, const scene::ReadCompanion& read_companion) {
    const auto is = [&](const char* word) { return name.find(word) != std::string::npos; };
    if (is("crashes.glb")) std::abort();
    if (is("spins.glb"))
        for (volatile unsigned k = 0;;) k = k + 1;
    if (is("is-hungry.glb")) {
        std::vector<std::unique_ptr<char[]>> eaten; // without touching it
        try {
            while (true) eaten.emplace_back(new char[std::size_t{1} << 28]);
        } catch (const std::bad_alloc&) {
            return Error{"out of memory after " + std::to_string(eaten.size() / 4) + " GiB", name};
        }
    }
    if (is("tries.glb")) return what_works();
    return scene::read_model(bytes, extension, name, report, read_companion);
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == scene::kReadModels)
        return scene::serve_models(read_as_told);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
