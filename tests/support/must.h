#pragma once
// SPDX-License-Identifier: Apache-2.0
// The value of a Result that a test cannot go on without. Where there is none the test ends with the error's
// sentence, in functions that return something as well, where ASSERT_TRUE cannot stand.

#include "base/result.h"

#include <stdexcept>
#include <utility>

namespace ghost {

template <class T>
T must(Result<T> result) {
    if (!result.ok()) throw std::runtime_error(result.error().text());
    return std::move(*result);
}

} // namespace ghost
