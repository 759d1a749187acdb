#pragma once
// SPDX-License-Identifier: Apache-2.0
// DiskLook: asks a disk on a thread of its own, for a drive of a network that does not answer would hold the
// window for minutes. A question that hangs is left behind, since nothing ends it. Window thread.

#include <QTimer>

#include <functional>
#include <memory>

namespace ghost::ui {

class DiskLook {
public:
    // What is done with the answer, in the window's thread, and not after this one is gone.
    using Then = std::function<void()>;

    DiskLook();
    // False: the one before is not answered yet, and this one is not asked. question: owns what it reads.
    bool ask(std::function<Then()> question);
    // Another one may be asked, and nothing is done with the answer.
    void forget();

private:
    struct Asked;
    void look();

    std::shared_ptr<Asked> asked_; // its thread's, too
    QTimer timer_;
};

} // namespace ghost::ui
