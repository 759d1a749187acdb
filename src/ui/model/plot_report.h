#pragma once
// SPDX-License-Identifier: Apache-2.0
// PlotReport: what the show that is open has, as diagnose/plot_page.h puts it, made anew on a thread of its
// own whenever a show opens or is edited: fixture files that could stand in are read for it. Window thread.

#include "diagnose/plot_page.h"
#include "ui/model/app_model.h"

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <optional>
#include <thread>

namespace ghost::ui {

class PlotReport : public QObject {
    Q_OBJECT
public:
    // library: folder with fixture files that may stand in, beside those of the show; empty: there is none.
    PlotReport(AppModel& app, std::filesystem::path library);

    // Null: no show is open, or it comes.
    const scene::PlotPage* page() const { return page_ ? &*page_ : nullptr; }

Q_SIGNALS:
    void changed();

private:
    void begin();
    void put(std::optional<scene::PlotPage> page);

    AppModel& app_;
    std::filesystem::path library_;
    std::optional<scene::PlotPage> page_;
    std::size_t fixtures_ = 0;              // of the show that it is about
    std::shared_ptr<const scene::Show> of_; // that the last one was begun for
    QTimer pause_;                          // news of one show come one behind the other
    bool is_stale_ = false;                 // something came while one was made
    std::jthread worker_;
};

} // namespace ghost::ui
