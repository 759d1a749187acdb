#pragma once
// SPDX-License-Identifier: Apache-2.0
// MessageBoard: what a person should know, for the window's Messages: of the network, of what happened since,
// of the show that is open. Engine thread.

#include "base/report.h"
#include "link/link.h"

#include <string>
#include <vector>

namespace ghost::app {

class MessageBoard {
public:
    explicit MessageBoard(ui::Link& link) : link_(link) {}

    // What belongs to no show; the oldest make room.
    void add(Severity severity, const std::string& where, const std::string& what);
    // Of the receiver, instead of what was said of it before. False: it was the same.
    bool set_network(std::vector<Message> said);
    bool has_network() const { return !of_network_.empty(); }
    // Of the show that is open. Tells the window where they are others than the last time.
    void show(const Report& report);
    // Another show is open.
    void show_anew(const Report& report);

private:
    void put();

    ui::Link& link_;
    std::vector<Message> of_network_, news_, of_show_;
};

} // namespace ghost::app
