// SPDX-License-Identifier: Apache-2.0
// This test, started once more as its own helper, before anything else runs.
#include "base/helper_process.h"

#include "support/wine.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include <windows.h>

namespace ghost {
namespace {

constexpr const char* kHelper = "--as-the-helper";

void say(HelperStream& stream, std::uint8_t byte) {
    stream.send({&byte, 1});
    stream.flush();
}

// A word of one letter: e: echoes what follows, x: exits with 5, c: crashes, m: takes memory, s: starts a
// program.
int serve() {
    HelperStream stream = confine_helper(std::size_t{256} << 20, 2);
    for (std::uint8_t letter = 0; stream.receive({&letter, 1});) {
        if (letter == 'x') return 5;
        if (letter == 'c') ::RaiseException(0xC0000005, EXCEPTION_NONCONTINUABLE, 0, nullptr);
        if (letter == 'm') {
            std::uint8_t taken = 0;
            for (std::vector<std::unique_ptr<char[]>> all; taken < 16; ++taken) {
                all.emplace_back(new (std::nothrow) char[std::size_t{64} << 20]);
                if (all.back() == nullptr) break;
                std::memset(all.back().get(), 1, std::size_t{64} << 20);
            }
            say(stream, taken);
        }
        if (letter == 's') {
            STARTUPINFOW start{};
            PROCESS_INFORMATION process{};
            wchar_t line[] = L"cmd /c exit";
            say(stream, ::CreateProcessW(nullptr, line, nullptr, nullptr, FALSE, 0, nullptr, nullptr, &start,
                                         &process)
                            ? 1
                            : 0);
        }
        if (letter == 'e') {
            std::vector<std::uint8_t> bytes(200'000);
            if (!stream.receive(bytes) || !stream.send(bytes) || !stream.flush()) return 6;
        }
    }
    return 0;
}

// Before main(), which belongs to the library of the tests.
const bool kServed = [] {
    if (std::strstr(::GetCommandLineA(), kHelper) != nullptr) std::_Exit(serve());
    return true;
}();

std::uint8_t ask(HelperProcess& helper, std::uint8_t letter) {
    std::uint8_t answer = 0xFF;
    helper.stream().send({&letter, 1});
    EXPECT_TRUE(helper.stream().receive({&answer, 1}));
    return answer;
}

HelperProcess start() {
    auto helper = HelperProcess::start(kHelper);
    EXPECT_TRUE(helper.ok()) << helper.error().text();
    return std::move(*helper);
}

TEST(HelperProcess, what_is_sent_comes_back) {
    ASSERT_TRUE(kServed);
    HelperProcess helper = start();
    std::vector<std::uint8_t> bytes(200'000), back(bytes.size());
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(k * 7);
    const std::uint8_t letter = 'e';
    for (int round = 0; round < 3; ++round) {
        EXPECT_TRUE(helper.stream().send({&letter, 1}) && helper.stream().send(bytes));
        ASSERT_TRUE(helper.stream().receive(back));
        EXPECT_EQ(back, bytes);
    }
    EXPECT_FALSE(helper.stream().wait(20));
    EXPECT_EQ(helper.end(), "ended");
}

TEST(HelperProcess, tells_how_it_ended) {
    const auto reason = [](std::uint8_t letter) {
        HelperProcess helper = start();
        std::uint8_t answer = 0;
        helper.stream().send({&letter, 1});
        EXPECT_FALSE(helper.stream().receive({&answer, 1}));
        EXPECT_TRUE(helper.stream().wait(0));
        return helper.end();
    };
    EXPECT_EQ(reason('x'), "exit code 5");
    EXPECT_EQ(reason('c'), "exception c0000005");
}

TEST(HelperProcess, has_only_so_much_memory) {
    if (is_wine()) GTEST_SKIP() << "Wine keeps no limits of jobs";
    HelperProcess helper = start();
    EXPECT_LT(ask(helper, 'm'), 4);
}

TEST(HelperProcess, starts_nothing) {
    if (is_wine()) GTEST_SKIP() << "Wine keeps no limits of jobs";
    HelperProcess helper = start();
    EXPECT_EQ(ask(helper, 's'), 0);
    EXPECT_GE(helper.cpu_s(), 0.0);
}

} // namespace
} // namespace ghost
