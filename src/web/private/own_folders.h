#pragma once
// SPDX-License-Identifier: Apache-2.0
// OwnFolders: takes the folders of this machine out of what viewers read: "/home/anna/tour/show.toml:12" is
// "show.toml:12", and such a folder itself goes by its last name, one's home by "~". Names of files stay.
// Known are the folders of the show, of its files, of files that messages are about, and the home of who runs
// this; what lies elsewhere stays as it is. One thread.

#include "base/report.h"

#include <span>
#include <string>
#include <vector>

namespace ghost::scene {
struct Show;
}

namespace ghost::web {

class OwnFolders {
public:
    OwnFolders(); // the home alone

    // show: null as long as none is open.
    void take(const scene::Show* show, std::span<const Message> messages);
    std::string taken_out(std::string text) const;

private:
    std::vector<std::string> folders_; // absolute, each with a slash at its end, the longest first
    std::string home_;                 // one of them, or empty
};

} // namespace ghost::web
