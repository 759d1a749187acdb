#pragma once
// SPDX-License-Identifier: Apache-2.0
// Drafts: changes of a show file that are not saved, where the next window finds them: .ghost/draft.toml
// ("draft of NAME" for a show file of another name), or, where that disk takes nothing or the show's folder
// is gone, the user's own folder. Window thread.

#include "base/result.h"
#include "show_folder/hold.h"

#include <QDateTime>

#include <filesystem>
#include <optional>
#include <string>

namespace ghost::scene {
struct Show;
} // namespace ghost::scene

namespace ghost::ui {

class Drafts {
public:
    Drafts() = default;
    explicit Drafts(const scene::Show& show);

    // saved: what the show file says. Error: neither place takes it.
    Result<void> write(const std::string& text, const std::string& saved) const;
    void remove() const;
    // Beside the draft, which another window has: where.
    Result<std::filesystem::path> write_aside(const std::string& text) const;

    struct Found {
        std::string text;
        QDateTime when;
        bool of_this = true; // the show file says what it said then
    };
    // Who has them: one window of a show. Error: neither place takes a lock.
    Result<Hold> hold(Hold::Other other) const;
    // The draft that differs from what the show file says; those that do not go.
    std::optional<Found> find(const std::string& saved) const;

private:
    void remove_beside() const;

    std::filesystem::path home_; // the show's folder
    std::filesystem::path beside_, own_;
};

} // namespace ghost::ui
