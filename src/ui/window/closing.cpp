// SPDX-License-Identifier: Apache-2.0
// Window: what it asks before it is closed.
#include "show/show.h"
#include "ui/actions/exporter.h"
#include "ui/language/language.h"
#include "ui/window/window.h"

#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <deque>

namespace ghost::ui {

// Whether it asks, because something is not saved. What is kept nobody sees, so it is said.
bool Window::asks_to_close() {
    if (!document_.is_changed()) return false;
    auto* const box = new QMessageBox(QMessageBox::NoIcon, "Ghostlight",
                                      translated("Window", "'%1' has changes that are not saved.")
                                          .arg(QString::fromStdString(app_.show()->file.filename().string())),
                                      QMessageBox::NoButton, this);
    box->setTextFormat(Qt::PlainText);
    QString more = translated(
        "Window", "Closed without saving they are kept, and offered when the show is opened again.");
    const std::deque<Job>& jobs = app_.jobs().all();
    const auto here = std::count_if(jobs.begin(), jobs.end(),
                                    [](const Job& job) { return !job.is_over() && !is_on_farm(job); });
    if (here > 0)
        more += "\n\n" + translated("Window",
                                    "%n job(s) of Export end with the window; a bake keeps what is finished.",
                                    nullptr, here);
    box->setInformativeText(more);
    const auto closes = [this] { QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection); };
    QPushButton* const save = box->addButton(translated("Window", "Save and close"), QMessageBox::AcceptRole);
    connect(save, &QPushButton::clicked, this, [this, closes] {
        if (const Result<void> saved = document_.save(false); saved.ok())
            closes();
        else
            actions_.complain(saved.error());
    });
    connect(box->addButton(translated("Window", "Close"), QMessageBox::DestructiveRole),
            &QPushButton::clicked, this, closes);
    box->setEscapeButton(box->addButton(translated("Window", "Cancel"), QMessageBox::RejectRole));
    box->setDefaultButton(save);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
    return true;
}

} // namespace ghost::ui
