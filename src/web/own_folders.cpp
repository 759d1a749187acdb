// SPDX-License-Identifier: Apache-2.0
#include "web/private/own_folders.h"

#include "show/show.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace ghost::web {
namespace fs = std::filesystem;

OwnFolders::OwnFolders() {
    take(nullptr, {});
}

void OwnFolders::take(const scene::Show* show, std::span<const Message> messages) {
    folders_.clear();
    const auto add = [&](const fs::path& folder) {
        if (folder.empty()) return;
        std::error_code code;
        const fs::path whole = fs::absolute(folder, code).lexically_normal();
        if (code) return;
        std::string text = whole.generic_string();
        if (!text.ends_with('/')) text += '/';
        if (text != "/") folders_.push_back(std::move(text));
    };
    if (const char* const home = std::getenv("HOME")) add(home);
    if (show) {
        add(show->folder);
        for (const fs::path& file : {show->file, show->stage_file, show->plot_file, show->recording}) {
            if (file.is_absolute()) add(file.parent_path());
        }
    }
    // "/srv/tour/band.mvr: GeneralSceneDescription.xml:12"
    for (const Message& message : messages)
        if (message.where.starts_with('/'))
            add(fs::path(message.where.substr(0, message.where.find(':'))).parent_path());
    // What lies in the folder of a show in one's home is named from the show.
    std::sort(folders_.begin(), folders_.end(), [](const std::string& a, const std::string& b) {
        return a.size() != b.size() ? a.size() > b.size() : a < b;
    });
    folders_.erase(std::unique(folders_.begin(), folders_.end()), folders_.end());
}

std::string OwnFolders::taken_out(std::string text) const {
    for (const std::string& folder : folders_) {
        std::string rest;
        std::size_t from = 0;
        for (std::size_t at; (at = text.find(folder, from)) != std::string::npos; from = at + folder.size())
            rest.append(text, from, at - from);
        if (from == 0) continue;
        text = rest.append(text, from);
    }
    return text;
}

} // namespace ghost::web
