// SPDX-License-Identifier: Apache-2.0
#include "ui/model/plot_report.h"

#include "fixture_files/load_type.h"
#include "mvr/mvr_load.h"
#include "show/show.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace ghost::ui {
namespace {

namespace fs = std::filesystem;

constexpr int kPause_ms = 200;
constexpr std::size_t kMostOffers = 2000;

void add_files(const fs::path& folder, std::vector<fs::path>& files) {
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end && files.size() < kMostOffers;
         entry.increment(code))
        if (std::error_code other;
            fixture::has_type_extension(entry->path()) && entry->is_regular_file(other))
            files.push_back(entry->path());
}

scene::FixtureOffers offers_for(const scene::Show& show, const fs::path& library) {
    scene::FixtureOffers offers;
    for (const fs::path& folder : {show.folder, show.folder / "fixtures", library})
        if (!folder.empty()) add_files(folder, offers.files);
    std::sort(offers.files.begin(), offers.files.end());
    for (const fs::path& file : offers.files) offers.names.push_back(file.filename().string());
    offers.load = [files = offers.files](std::size_t k) -> std::shared_ptr<const fixture::Type> {
        auto loaded = fixture::load_type(files[k]);
        return loaded.ok() ? std::make_shared<const fixture::Type>(std::move(loaded->type)) : nullptr;
    };
    return offers;
}

scene::PlotPage page_of(scene::Show show, std::vector<Message> messages, const fs::path& library) {
    // The plot that is open belongs to the engine's thread.
    if (show.plot) {
        auto plot = scene::load_mvr(show.plot_file);
        show.plot = plot.ok() ? std::make_shared<scene::LoadedPlot>(std::move(*plot)) : nullptr;
    }
    Report report;
    report.messages = std::move(messages);
    const scene::FixtureOffers offers = offers_for(show, library);
    // Stand-ins are looked for once, by the page.
    return scene::plot_page(show, scene::findings_of(show, report, {}), offers);
}

} // namespace

PlotReport::PlotReport(AppModel& app, fs::path library) : app_(app), library_(std::move(library)) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPause_ms);
    connect(&pause_, &QTimer::timeout, this, &PlotReport::begin);
    connect(&app_, &AppModel::opened_show, this, [this] {
        pause_.start();
        if (app_.opened().is_edit || !page_) return;
        page_.reset();
        Q_EMIT changed();
    });
    connect(&app_, &AppModel::messages_came, &pause_, qOverload<>(&QTimer::start));
}

void PlotReport::begin() {
    if (!app_.show()) return;
    is_stale_ = worker_.joinable();
    if (is_stale_) return;
    worker_ = std::jthread([this, show = app_.show(), messages = app_.messages(), library = library_] {
        std::optional<scene::PlotPage> page;
        try {
            page = page_of(*show, messages, library);
        } catch (const std::exception&) { // no memory for it: the picture goes on without
        }
        QMetaObject::invokeMethod(
            this,
            [this, page = std::move(page), show]() mutable {
                worker_.join();
                worker_ = {};
                if (is_stale_) begin();
                if (!page || show->file != app_.show()->file) return;
                page_ = std::move(page);
                Q_EMIT changed();
            },
            Qt::QueuedConnection);
    });
}

} // namespace ghost::ui
