// SPDX-License-Identifier: Apache-2.0
#include "web/private/own_folders.h"

#include "show/show.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

namespace ghost::web {
namespace fs = std::filesystem;

namespace {

bool is_of_path(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) ||
           std::string_view("/._-~").find(letter) != std::string_view::npos;
}

// Not in the middle of "../../tmp/lamp.gdtf".
bool begins_path(std::string_view text, std::size_t at) {
    return at == 0 || !is_of_path(text[at - 1]);
}

// The full stop of a sentence is of no path.
bool ends_word(std::string_view text, std::size_t end) {
    if (end < text.size() && text[end] == '.') ++end;
    return end == text.size() || !is_of_path(text[end]);
}

} // namespace

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
    home_ = folders_.empty() ? "" : folders_.front();
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
        const std::string_view bare = std::string_view(folder).substr(0, folder.size() - 1);
        std::string rest;
        std::size_t from = 0;
        for (std::size_t at = 0; (at = text.find(bare, at)) != std::string::npos;) {
            const std::size_t end = at + bare.size();
            const bool has_more = end < text.size() && text[end] == '/';
            if (!begins_path(text, at) || !(has_more || ends_word(text, end))) {
                at = end;
                continue;
            }
            rest.append(text, from, at - from);
            if (!has_more) rest += folder == home_ ? "~" : bare.substr(bare.rfind('/') + 1);
            at = from = has_more ? end + 1 : end;
        }
        text = rest.append(text, from);
    }
    return text;
}

} // namespace ghost::web
