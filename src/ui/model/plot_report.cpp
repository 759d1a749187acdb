// SPDX-License-Identifier: Apache-2.0
#include "ui/model/plot_report.h"

#include "fixture_files/load_type.h"
#include "mvr/mvr_load.h"
#include "show/show.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <stop_token>
#include <utility>

namespace ghost::ui {
namespace {

namespace fs = std::filesystem;

constexpr int kPause_ms = 200;
constexpr std::size_t kMostOffers = 2000;

void add_files(const fs::path& folder, const std::stop_token& stop, std::vector<fs::path>& files) {
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end;
         !code && entry != end && files.size() < kMostOffers && !stop.stop_requested(); entry.increment(code))
        if (std::error_code other;
            fixture::has_type_extension(entry->path()) && entry->is_regular_file(other))
            files.push_back(entry->path());
}

scene::FixtureOffers offers_for(const scene::Show& show, const fs::path& library,
                                const std::stop_token& stop) {
    scene::FixtureOffers offers;
    for (const fs::path& folder : {show.folder, show.folder / "fixtures", library})
        if (!folder.empty()) add_files(folder, stop, offers.files);
    std::sort(offers.files.begin(), offers.files.end());
    for (const fs::path& file : offers.files) offers.names.push_back(file.filename().string());
    offers.load = [files = offers.files, stop](std::size_t k) -> std::shared_ptr<const fixture::Type> {
        if (stop.stop_requested()) return nullptr;
        auto loaded = fixture::load_type(files[k]);
        return loaded.ok() ? std::make_shared<const fixture::Type>(std::move(loaded->type)) : nullptr;
    };
    return offers;
}

// Nothing: it was stopped.
std::optional<scene::PlotPage> page_of(scene::Show show, std::vector<Message> messages,
                                       const fs::path& library, const std::stop_token& stop) {
    Report report;
    report.messages = std::move(messages);
    // The plot that is open belongs to the engine's thread.
    if (show.plot) {
        std::atomic<bool> is_stopped = false;
        const std::stop_callback stops(stop, [&] { is_stopped = true; });
        auto plot = scene::load_mvr(show.plot_file, {.progress = {}, .cancel = &is_stopped});
        if (!plot.ok()) report.add(Severity::error, plot.error().where, plot.error().what);
        show.plot = plot.ok() ? std::make_shared<scene::LoadedPlot>(std::move(*plot)) : nullptr;
    }
    const scene::FixtureOffers offers = offers_for(show, library, stop);
    if (stop.stop_requested()) return std::nullopt;
    // Stand-ins are looked for once, by the page.
    scene::PlotPage page = scene::plot_page(show, scene::findings_of(show, report, {}), offers);
    return stop.stop_requested() ? std::nullopt : std::optional(std::move(page));
}

} // namespace

PlotReport::PlotReport(AppModel& app, fs::path library) : app_(app), library_(std::move(library)) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPause_ms);
    connect(&pause_, &QTimer::timeout, this, &PlotReport::begin);
    connect(&app_, &AppModel::opened_show, this, [this] {
        pause_.start();
        // Its lines name fixtures by number.
        if (app_.opened().is_edit && app_.show()->fixtures.size() == fixtures_) return;
        put(std::nullopt);
    });
    connect(&app_, &AppModel::messages_came, &pause_, qOverload<>(&QTimer::start));
}

void PlotReport::begin() {
    if (!app_.show()) return;
    is_stale_ = worker_.joinable();
    if (is_stale_) {
        // With news of the same show it goes on: such news may come faster than a page is made.
        if (of_ != app_.show()) worker_.request_stop();
        return;
    }
    of_ = app_.show();
    worker_ = std::jthread(
        [this, show = of_, messages = app_.messages(), library = library_](const std::stop_token& stop) {
            std::optional<scene::PlotPage> page;
            try {
                page = page_of(*show, messages, library, stop);
            } catch (const std::exception&) { // no memory for it: the picture goes on without
            }
            QMetaObject::invokeMethod(
                this,
                [this, page = std::move(page), show]() mutable {
                    worker_.join();
                    worker_ = {};
                    if (is_stale_) begin();
                    if (show != app_.show()) return; // the next one comes
                    fixtures_ = show->fixtures.size();
                    put(std::move(page));
                },
                Qt::QueuedConnection);
        });
}

void PlotReport::put(std::optional<scene::PlotPage> page) {
    const bool was_there = page_.has_value();
    page_ = std::move(page);
    if (was_there || page_) Q_EMIT changed();
}

} // namespace ghost::ui
