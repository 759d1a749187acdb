#pragma once
// SPDX-License-Identifier: Apache-2.0
// RecentShows: the shows that were opened last, newest first, each with a small picture of how it looked when
// there was light on it last. Kept in the user's settings and cache, never in the show. Window thread.

#include "ui/model/app_model.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace ghost::ui {

class RecentShows : public QObject {
    Q_OBJECT
public:
    // remembers false: none are known, and none are kept.
    RecentShows(AppModel& app, bool remembers);
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
    void take_opened();
    void take_picture();
    void keep_picture();

    AppModel& app_;
    bool remembers_;
    std::vector<One> shows_;
    QString open_;                                 // path
    std::shared_ptr<const image::Image8> picture_; // of the open one; null: it was dark
};

} // namespace ghost::ui
