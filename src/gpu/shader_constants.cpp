// SPDX-License-Identifier: Apache-2.0
#include "gpu/private/shader_constants.h"

#include "base/check.h"

#include <map>
#include <optional>
#include <utility>

namespace ghost::gpu {
namespace {

// Of the SPIR-V specification, section 3.
constexpr std::uint32_t kWordsBefore = 5;
constexpr std::uint32_t kSpecId = 1; // a decoration
enum ConstantOp : std::uint32_t {
    type_bool = 20,
    constant_true = 41,
    constant_false = 42,
    constant = 43,
    constant_composite = 44,
    spec_constant_true = 48,
    spec_constant_false = 49,
    spec_constant = 50,
    spec_constant_composite = 51,
    spec_constant_op = 52,
    decoration = 71
};
enum Worked : std::uint32_t {
    subtract = 130,
    logical_or = 166,
    logical_and = 167,
    logical_not = 168,
    select = 169,
    equal = 170,
    not_equal = 171,
    greater = 172,
    greater_equal = 174,
    less = 176,
    shift_left = 196,
    bitwise_and = 199
};

// Of whole numbers without sign and of booleans; nothing for an operation that none of our shaders has.
std::optional<std::uint32_t> worked_out(std::uint32_t operation, const std::vector<std::uint32_t>& of) {
    const auto is = [&](Worked wanted, std::size_t operands) {
        return operation == wanted && of.size() == operands;
    };
    if (is(logical_not, 1)) return of[0] == 0;
    if (is(select, 3)) return of[0] != 0 ? of[1] : of[2];
    if (is(subtract, 2)) return of[0] - of[1];
    if (is(logical_or, 2)) return of[0] != 0 || of[1] != 0;
    if (is(logical_and, 2)) return of[0] != 0 && of[1] != 0;
    if (is(equal, 2)) return of[0] == of[1];
    if (is(not_equal, 2)) return of[0] != of[1];
    if (is(greater, 2)) return of[0] > of[1];
    if (is(greater_equal, 2)) return of[0] >= of[1];
    if (is(less, 2)) return of[0] < of[1];
    if (is(shift_left, 2) && of[1] < 32) return of[0] << of[1];
    if (is(bitwise_and, 2)) return of[0] & of[1];
    return std::nullopt;
}

class Writer {
public:
    explicit Writer(std::span<const std::uint32_t> given) : given_(given) {}

    void copy(std::span<const std::uint32_t> instruction) {
        words.insert(words.end(), instruction.begin(), instruction.end());
    }

    void take(std::span<const std::uint32_t> instruction) {
        const std::uint32_t op = instruction[0] & 0xffffu;
        const auto word = [&](std::size_t k) { return k < instruction.size() ? instruction[k] : 0; };
        switch (op) {
        case type_bool:
            bool_ = word(1);
            return copy(instruction);
        case decoration:
            if (word(2) != kSpecId) return copy(instruction);
            if (word(3) < given_.size())
                value_of_[word(1)] = given_[word(3)]; // it stands before all constants
            return;
        case constant:
            if (instruction.size() == 4) value_of_[word(2)] = word(3);
            return copy(instruction);
        case constant_true:
        case constant_false:
        case spec_constant_true:
        case spec_constant_false:
            return put(word(1), word(2), op == constant_true || op == spec_constant_true);
        case spec_constant:
            CHECK_EQ(instruction.size(), std::size_t{4}); // of 32 bits
            return put(word(1), word(2), word(3));
        case spec_constant_composite:
            copy(instruction);
            if (!known(instruction.subspan(3)).empty())
                words[words.size() - instruction.size()] ^= spec_constant_composite ^ constant_composite;
            return;
        case spec_constant_op:
            if (const auto value = worked_out(word(3), known(instruction.subspan(4))))
                return put(word(1), word(2), *value);
            return copy(instruction);
        default:
            return copy(instruction);
        }
    }

    std::vector<std::uint32_t> words;

private:
    // A constant: its value, unless another one was given.
    void put(std::uint32_t type, std::uint32_t id, std::uint32_t value) {
        value = value_of_.try_emplace(id, value).first->second;
        if (type == bool_)
            copy(std::vector{3u << 16 | (value != 0 ? constant_true : constant_false), type, id});
        else
            copy(std::vector{4u << 16 | constant, type, id, value});
    }

    // Their values; none where one is unknown.
    std::vector<std::uint32_t> known(std::span<const std::uint32_t> ids) const {
        std::vector<std::uint32_t> values;
        for (const std::uint32_t id : ids)
            if (const auto found = value_of_.find(id); found != value_of_.end())
                values.push_back(found->second);
        return values.size() == ids.size() ? values : std::vector<std::uint32_t>();
    }

    std::span<const std::uint32_t> given_;
    std::uint32_t bool_ = 0;                          // the type
    std::map<std::uint32_t, std::uint32_t> value_of_; // of constants, by their ids
};

} // namespace

std::vector<std::uint32_t> with_constants(const Shader& shader, std::span<const std::uint32_t> values) {
    const std::span<const std::uint32_t> words = shader.words;
    Writer writer(values);
    writer.words.reserve(words.size());
    writer.copy(words.first(kWordsBefore));
    for (std::size_t at = kWordsBefore; at < words.size();) {
        const std::uint32_t length = words[at] >> 16;
        CHECK(length > 0 && at + length <= words.size()); // bindings_of has read it
        writer.take(words.subspan(at, length));
        at += length;
    }
    return std::move(writer.words);
}

} // namespace ghost::gpu
