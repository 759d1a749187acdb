#pragma once
// SPDX-License-Identifier: Apache-2.0
// PlotInbox: plots that come from the network (MVR-xchange) while a show is drawn, until somebody takes them.
// Engine thread.

#include "base/report.h"
#include "base/result.h"
#include "link/link.h"
#include "xchange/xchange.h"

#include <functional>
#include <memory>

namespace ghost::app {

class PlotInbox {
public:
    explicit PlotInbox(ui::Link& link) : link_(link) {}

    Result<void> begin(const XchangeOptions& options);
    // Tells what came since the last call. say: what a person should know.
    void look(const std::function<void(const Message&)>& say);
    // The newest plot, where it is wanted and was not given out before, or null.
    const ui::ReceivedPlot* take(std::uint64_t wanted, bool takes_all);

private:
    ui::Link& link_;
    std::unique_ptr<Xchange> xchange_;
    ui::ReceivedPlot newest_;
    std::uint64_t taken_ = 0; // its number
};

} // namespace ghost::app
