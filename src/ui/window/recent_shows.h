#pragma once
// SPDX-License-Identifier: Apache-2.0
// RecentShows: the shows that were opened last, newest first, each with a small picture of how it looked when
// there was light on it last. Those that are gone leave the list as soon as their disk has said so. Kept in the
// user's settings and cache, never in the show. Window thread.

#include "ui/model/app_model.h"
#include "ui/model/disk_look.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace ghost::ui {

class RecentShows : public QObject {
    Q_OBJECT
public:
    // remembers false: none are known, and none are kept. is_there: asked on a thread of its own.
    using IsThere = std::function<bool(const std::filesystem::path& file)>;
    RecentShows(AppModel& app, bool remembers, const IsThere& is_there = exists);
    ~RecentShows() override; // keeps the picture of the open one

    struct One {
        QString path;    // show.toml or .mvr
        QString name;    // of the show
        QString picture; // file; it may not be there
    };
    static constexpr int kMost = 8;
    const std::vector<One>& all() const { return shows_; }

Q_SIGNALS:
    void changed();

private:
    static bool exists(const std::filesystem::path& file);
    void take_opened();
    void take_picture();
    void keep_picture();

    AppModel& app_;
    bool remembers_;
    std::vector<One> shows_;
    QString open_;                                 // path
    std::shared_ptr<const image::Image8> picture_; // of the open one; null: it was dark
    DiskLook disk_;
};

} // namespace ghost::ui
