// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ghost {
namespace {

std::string fault_of(const std::string& text, const JsonLimits& limits = {}) {
    const auto read = read_json(text, "a.json", limits);
    return read.ok() ? "" : read.error().text();
}
std::string brackets(std::size_t count) {
    return std::string(count, '[') + std::string(count, ']');
}

TEST(Json, is_read_as_it_stands) {
    const auto read = read_json(R"({"b": [1, "\u00e9"], "a": {"b": null}})", "a.json");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ((*read)["b"][1], "\xc3\xa9");
    const auto ordered = read_ordered_json(R"({"b": 1, "a": 2})", "a.json");
    ASSERT_TRUE(ordered.ok());
    EXPECT_EQ(ordered->begin().key(), "b");
}

TEST(Json, is_as_deep_as_its_limit_and_no_deeper) {
    EXPECT_EQ(fault_of(brackets(32)), "");
    EXPECT_EQ(fault_of(brackets(33)), "a.json: is nested deeper than 32");
    EXPECT_EQ(fault_of(std::string(5'000'000, '['), {.bytes = 1u << 30}), "a.json: is nested deeper than 32");
    EXPECT_EQ(fault_of(brackets(33), {.depth = 33}), "");
}

TEST(Json, has_limits_of_size_and_counts) {
    EXPECT_EQ(fault_of("[1, 2]", {.bytes = 5}), "a.json: is 6 bytes of JSON, at most 5 are read");
    EXPECT_EQ(fault_of("[1, 2]", {.values = 2}), "a.json: has more than 2 values");
    EXPECT_EQ(fault_of(R"({"a": 1, "b": 2})", {.members = 1}),
              "a.json: has an object of more than 1 members");
}

TEST(Json, has_no_key_twice) {
    EXPECT_EQ(fault_of(R"({"a": 1, "b": {"a": 2}, "\u0061": 3})"),
              "a.json: has the key 'a' twice in one object");
    EXPECT_EQ(fault_of(R"([{"a": 1}, {"a": 2}])"), "");
}

TEST(Json, is_utf8_and_whole) {
    EXPECT_NE(fault_of("[\"\xe9\"]").find("a.json: is not JSON: parse error at line 1"), std::string::npos);
    const std::string whole = R"({"a": [1, true, "x"]})";
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(fault_of(whole.substr(0, size)), "") << size;
}

} // namespace
} // namespace ghost
