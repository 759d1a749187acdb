#pragma once
// SPDX-License-Identifier: Apache-2.0
// The page: the files of web/ at the top of the sources, as cmake/embed_files.cmake puts them into the
// program.

#include <span>
#include <string_view>

namespace ghost::web {

struct WebFile {
    std::string_view name, bytes;
};
std::span<const WebFile> web_files();

} // namespace ghost::web
