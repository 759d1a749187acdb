// SPDX-License-Identifier: Apache-2.0
#include "live/engine/plot_inbox.h"

namespace ghost::app {

Result<void> PlotInbox::begin(const XchangeOptions& options) {
    TRY(xchange_, Xchange::start(options));
    return {};
}

void PlotInbox::look(const std::function<void(const Message&)>& say) {
    if (!xchange_) return;
    for (const XchangeEvent& event : xchange_->take()) {
        const bool trouble = event.kind == XchangeEvent::Kind::trouble;
        say({trouble ? Severity::warning : Severity::note,
             event.station.empty() ? "MVR-xchange" : "MVR-xchange, " + event.station,
             std::string(trouble ? "" : name_of(event.kind)) + (trouble ? "" : ": ") + event.text});
        if (event.kind != XchangeEvent::Kind::received) continue;
        newest_ = {newest_.number + 1, event.file.string(), event.station, event.comment};
        link_.plot.put(newest_);
        link_.on_news();
    }
}

const ui::ReceivedPlot* PlotInbox::take(std::uint64_t wanted, bool takes_all) {
    if ((!takes_all && wanted != newest_.number) || newest_.number == taken_) return nullptr;
    taken_ = newest_.number;
    return &newest_;
}

} // namespace ghost::app
