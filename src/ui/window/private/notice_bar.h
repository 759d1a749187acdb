#pragma once
// SPDX-License-Identifier: Apache-2.0
// NoticeBar: a line that lies on the top of the picture, so that nothing makes room for it, and says what
// waits for a decision about the show file, or that a show could not be opened (red), with a button for each
// way. Nobody has to answer it. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

#include <QToolBar>

#include <set>
#include <string>

namespace ghost::ui {

class NoticeBar : public QToolBar {
    Q_OBJECT
public:
    // over: the picture.
    NoticeBar(Actions& actions, ShowDocument& document, AppModel& app, QWidget* over);
    // What was refused, until something is done or it is closed, with a button of the action that helps.
    // False: something else waits for an answer.
    bool say_refused(const QString& what, const QString& helps = {});
    void forget_refused();
    QString words() const { return isVisible() ? words_ : QString(); }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void place();
    // Errors that an edit brought with it, or that a show was opened with, as a stage that cannot be read,
    // and what the show file says and is ignored.
    void look_at_messages();
    enum class Kind { question, fault };
    struct Answer {
        QString button;
        QString line;                    // of a script; empty: none
        bool puts_away = line.isEmpty(); // the notice: it was all that there was to decide
    };
    void ask(const QString& words, const std::vector<Answer>& answers, Kind kind = Kind::question);
    void put_away();
    void say_not_opened();
    void say_unseen();
    void say_without_optics();
    void note_edit();
    void mark_undo();

    Actions& actions_;
    ShowDocument& document_;
    AppModel& app_;
    QString words_;
    bool says_not_opened_ = false, says_unseen_ = false, says_refused_ = false;
    bool closed_unseen_ = false;   // by hand, until it is another one
    bool awaits_messages_ = false; // the first ones of a show that was opened
    int edit_ = -1;                // place in the undo list of the newest edit; -1: it is not there
    QAction* undo_ = nullptr;      // of what is said of it
    std::set<std::string> errors_; // of the show that was open, without their lines, which move
};

} // namespace ghost::ui
