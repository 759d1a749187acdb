#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pages that open from file:// and print: one file each, style and script within. Names come from outside,
// so all text goes through html_text. Pure, any thread.

#include "print/paper_size.h"
#include "print/print_style.h"

#include <string>
#include <string_view>

namespace ghost::scene {

// As text within an element or a quoted attribute; controls and bytes that are not UTF-8 are shown.
std::string html_text(std::string_view text);
// A name that somebody chose, of any script: its direction stays its own.
std::string html_name(std::string_view name);
// is_wide: prints landscape.
std::string html_begin(std::string_view title, PaperSize paper, Language language, bool is_wide = false);
std::string html_end();

} // namespace ghost::scene
