// SPDX-License-Identifier: Apache-2.0
#include "live/engine/message_board.h"

#include <algorithm>

namespace ghost::app {
namespace {

constexpr std::size_t kMostNews = 300;

} // namespace

void MessageBoard::put() {
    std::vector<Message> all = of_network_;
    all.insert(all.end(), news_.begin(), news_.end());
    all.insert(all.end(), of_show_.begin(), of_show_.end());
    link_.messages.put(std::move(all));
    link_.on_news();
}

void MessageBoard::add(Severity severity, const std::string& where, const std::string& what) {
    if (news_.size() >= kMostNews) news_.erase(news_.begin());
    news_.push_back({severity, where, what});
    put();
}

bool MessageBoard::set_network(std::vector<Message> said) {
    const auto same = [](const Message& a, const Message& b) {
        return a.where == b.where && a.what == b.what;
    };
    if (std::equal(said.begin(), said.end(), of_network_.begin(), of_network_.end(), same)) return false;
    of_network_ = std::move(said);
    put();
    return true;
}

void MessageBoard::show(const Report& report) {
    if (report.messages.size() != of_show_.size()) show_anew(report);
}

void MessageBoard::show_anew(const Report& report) {
    of_show_ = report.messages;
    put();
}

} // namespace ghost::app
