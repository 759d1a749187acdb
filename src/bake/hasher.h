#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hasher: the content that something on disk was made from, as 32 digits (XXH3 of 128 bits; not
// cryptographic). Sizes go in with what has one, so that "a", "bc" is not "ab", "c". The digits are those of
// every machine of the same byte order. One thread.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct XXH3_state_s;

namespace ghost::bake {

class Hasher {
public:
    Hasher();
    // Of a fixed size.
    void bytes(const void* data, std::size_t size);
    void text(std::string_view value);
    template <class T>
    void value(const T& item) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        bytes(&item, sizeof item);
    }
    template <class T>
    void list(const std::vector<T>& items) {
        static_assert(std::is_trivially_copyable_v<T>);
        value(items.size());
        bytes(items.data(), items.size() * sizeof(T));
    }
    std::string hex() const; // 32 digits

private:
    struct Free {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Free> state_;
};

} // namespace ghost::bake
