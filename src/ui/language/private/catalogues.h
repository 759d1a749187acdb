#pragma once
// SPDX-License-Identifier: Apache-2.0
// Catalogues as lrelease made them of assets/translations/*.ts; cmake/translations.cmake puts them into the
// program. Constant, any thread.

#include <span>
#include <string_view>

namespace ghost::ui {

struct Catalogue {
    std::string_view code; // "de"
    std::span<const unsigned char> bytes;
};
std::span<const Catalogue> catalogues();

} // namespace ghost::ui
