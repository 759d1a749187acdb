// SPDX-License-Identifier: Apache-2.0
// Plots that come from the network while a show is drawn: said, and merged into the show when somebody takes
// them. The newer show is opened beside the older one, which is drawn until then.
#include "live/engine/engine.h"

#include "plots/import_plot.h"
#include "show_folder/load_show.h"

namespace ghost::app {

namespace {

// A show that names its plot gets the new one; whatever else is open, the plot is opened as it is.
Result<std::unique_ptr<Session>> open_with_plot(SessionOptions options, const std::string& plot, bool merges,
                                                const std::string& folder) {
    Report report;
    std::string merged;
    if (merges) {
        TRY(const scene::Show opened, scene::load_show(plot, true, report));
        TRY(const scene::ImportedPlot imported, scene::import_plot(opened, folder, report));
        if (imported.merge) merged = scene::text_of(*imported.merge);
    }
    TRY(std::unique_ptr<Session> session, open_session(options));
    if (!merged.empty()) session->report.add(Severity::note, plot, "merged into the show: " + merged);
    return session;
}

} // namespace

void Engine::look_for_plots() {
    plots_.look([this](const Message& said) { messages_.add(said.severity, said.where, said.what); });
    adopt_opened();
    take_plot();
}

void Engine::take_plot() {
    if (opening_.is_running()) return;
    const ui::ReceivedPlot* const plot = plots_.take(request_.take_plot, options_.takes_plots);
    if (!plot) return;
    const scene::Show* const show = session_ ? session_->show.get() : nullptr;
    const bool merges = show && !show->plot_file.empty() && show->file != show->plot_file;
    const std::string path = merges ? show->file.string() : plot->file;
    link_.activity.put("taking over " + plot->file);
    link_.on_news();
    opening_.begin(Opening::Kind::newer_plot, [options = session_options(path), file = plot->file, merges,
                                               folder = show ? show->folder.string() : std::string()] {
        return open_with_plot(options, file, merges, folder);
    });
}

void Engine::adopt_opened() {
    std::optional<Opening::Opened> opened = opening_.take();
    if (!opened) return;
    link_.activity.put("");
    if (!opened->ok()) {
        messages_.add(Severity::error, opened->error().where, opened->error().what);
        link_.failed.put(opened->error());
        link_.on_news();
        return;
    }
    adopt(std::move(**opened), session_ ? opening_.kind() : Opening::Kind::another);
}

} // namespace ghost::app
