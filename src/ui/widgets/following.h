#pragma once
// SPDX-License-Identifier: Apache-2.0
// Following: while one lives, a panel shows what the model has, and what its widgets report is no request of
// a person. They nest: only the outermost ends it. Window thread.

namespace ghost::ui {

class Following {
public:
    explicit Following(bool& follows) : follows_(follows), before_(follows) { follows_ = true; }
    ~Following() { follows_ = before_; }
    Following(const Following&) = delete;
    Following& operator=(const Following&) = delete;

private:
    bool& follows_;
    bool before_;
};

} // namespace ghost::ui
