#pragma once
// SPDX-License-Identifier: Apache-2.0
// The languages of the window; without Qt, for the command line. Constant, any thread.

namespace ghost::ui {

struct LanguageChoice {
    const char* code; // of assets/translations/ghostlight_<code>.ts
    const char* name; // in itself
};
inline constexpr LanguageChoice kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}};

} // namespace ghost::ui
