#pragma once
// SPDX-License-Identifier: Apache-2.0
// Result<T>: a value, or an Error that says what was wrong and where. For everything that comes from outside
// (files, packets, options); bugs use CHECK. Values only, safe on every thread.

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace ghost {

// what: one sentence, with the expectation ("unknown key 'postion', did you mean 'position'?").
// where: file, file:line or file:element; may be empty where there is no place.
struct Error {
    std::string what;
    std::string where;

    std::string text() const { return where.empty() ? what : where + ": " + what; }
};

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }
    T& value() & { return std::get<0>(state_); }
    const T& value() const& { return std::get<0>(state_); }
    T&& value() && { return std::get<0>(std::move(state_)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    const Error& error() const { return std::get<1>(state_); }

private:
    std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    bool ok() const { return !error_.has_value(); }
    explicit operator bool() const { return ok(); }
    const Error& error() const { return *error_; }

private:
    std::optional<Error> error_;
};

} // namespace ghost

#define GHOST_JOIN_INNER(a, b) a##b
#define GHOST_JOIN(a, b) GHOST_JOIN_INNER(a, b)

// TRY(auto value, call()): declares value, or returns the error to the caller.
#define TRY(declaration, expression)                                                                         \
    auto GHOST_JOIN(result_, __LINE__) = (expression);                                                       \
    if (!GHOST_JOIN(result_, __LINE__).ok()) return GHOST_JOIN(result_, __LINE__).error();                   \
    declaration = std::move(*GHOST_JOIN(result_, __LINE__))

// TRY_VOID(call()): returns the error of a Result<void> to the caller.
#define TRY_VOID(expression)                                                                                 \
    do {                                                                                                     \
        if (auto GHOST_JOIN(void_, __LINE__) = (expression); !GHOST_JOIN(void_, __LINE__).ok())              \
            return GHOST_JOIN(void_, __LINE__).error();                                                      \
    } while (false)
