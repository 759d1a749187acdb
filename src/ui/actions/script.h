#pragma once
// SPDX-License-Identifier: Apache-2.0
// Script: lines of actions, done one after the other, as a test or another program wants them
// (docs/guide/window.md). Beside the actions: "wait SECONDS", "wait opened", "wait picture", "wait settled",
// "wait saved", "wait jobs". Blank lines and lines that begin with # are left out. RemoteControl takes the
// same lines from a local socket and answers each with "ok" or "error: ...". Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QElapsedTimer>
#include <QLocalServer>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <deque>

namespace ghost::ui {

class Script : public QObject {
    Q_OBJECT
public:
    Script(Actions& actions, AppModel& app, QObject* parent);

    void add(const QString& line);
    // Forgets the lines that are left.
    void stop() { lines_.clear(); }
    bool is_done() const { return lines_.empty() && !runs_; }
    // After each line, in their order; a line that did nothing counts.
    std::function<void(const Result<void>&)> on_line;

private:
    void step();
    // Whether what "wait" waits for is there; an error where it never comes.
    Result<bool> is_over(const QStringList& words);

    Actions& actions_;
    AppModel& app_;
    std::deque<QString> lines_;
    bool runs_ = false; // an action may bring up a dialog, whose loop calls step again
    QElapsedTimer waited_;
    bool waits_ = false;
    QTimer timer_;
};

class RemoteControl : public QObject {
    Q_OBJECT
public:
    RemoteControl(Actions& actions, AppModel& app, QObject* parent);
    // A name, or a path of a socket; only this user may connect. Error: it cannot be made.
    Result<void> listen(const QString& name);

private:
    void accept();

    Actions& actions_;
    AppModel& app_;
    QLocalServer server_;
};

} // namespace ghost::ui
