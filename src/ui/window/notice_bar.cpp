// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/notice_bar.h"

#include "base/suggest.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/fixture_groups.h"
#include "ui/widgets/shortened.h"

#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLayout>
#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kNoticeLetters = 120; // beyond, paths in it lose their beginnings

// As wide as there is room, and no higher than its words need there: Qt wants one that wraps to be half as
// high as it is wide.
class NoticeWords : public QLabel {
public:
    using QLabel::QLabel;
    QSize sizeHint() const override {
        const int wide = window()->width() / 2;
        return {wide, heightForWidth(wide)};
    }
    QSize minimumSizeHint() const override { return {fontMetrics().averageCharWidth() * 20, 0}; }
};

// What the show file says and nobody understood, a key that is mistyped. Other warnings, of files of fixtures
// and of the patch, stand in Messages alone: many a show has some.
bool is_ignored_key(const Message& message, const scene::Show& show) {
    return message.severity == Severity::warning && message.where.starts_with(show.file.string() + ":") &&
           message.what.find(kUnknownKey) != std::string::npos;
}

} // namespace

NoticeBar::NoticeBar(Actions& actions, ShowDocument& document, AppModel& app, QWidget* over)
    : QToolBar(translated("Notice", "Notice"), over), actions_(actions), document_(document), app_(app) {
    connect(&app_, &AppModel::messages_came, this, &NoticeBar::look_at_messages);
    setObjectName("notice");
    setMovable(false);
    setAutoFillBackground(true);
    setAttribute(Qt::WA_NoMousePropagation); // the picture below it would turn
    over->installEventFilter(this);
    hide();
    connect(&document_, &ShowDocument::draft_found, this, [this](const QString& words) {
        ask(words, {{translated("Notice", "Take them"), "take-changes"},
                    {translated("Notice", "Drop them"), "drop-changes"}});
    });
    connect(&document_, &ShowDocument::found_changed_outside, this, [this](const QString& words) {
        ask(words, {{translated("Notice", "Take what the file says"), "reload"},
                    {translated("Notice", "Save mine over it"), "save over"}});
    });
    connect(&document_, &ShowDocument::found_gone, this, [this](const QString& words) {
        ask(words, {{translated("Notice", "Save it there again"), "save"},
                    {translated("Notice", "Save a copy elsewhere..."), "save-copy"}});
    });
    connect(&document_, &ShowDocument::found_held, this, [this](const QString& words) {
        ask(words, {{translated("Notice", "Take it over"), "take-over"}});
    });
    connect(&document_, &ShowDocument::found_plot_alone, this, [this](const QString& words) {
        const QString plot = QString::fromStdString(app_.show()->file.string());
        ask(words, {{translated("Notice", "Make a show of it"), "import-plot " + quoted(plot), true},
                    {translated("Notice", "Close"), ""}});
    });
    connect(&document_, &ShowDocument::save_failed, this, [this](const QString& words) {
        ask(words,
            {{translated("Notice", "Try again"), "save"},
             {translated("Notice", "Save a copy elsewhere..."), "save-copy"}},
            Kind::fault);
    });
    connect(&document_, &ShowDocument::keep_failed, this, [this](const QString& words) {
        ask(words,
            {{translated("Notice", "Save a copy elsewhere..."), "save-copy"},
             {translated("Notice", "Close and lose them"), "quit anyway"}},
            Kind::fault);
    });
    connect(&document_, &ShowDocument::changed, this, [this] {
        if (!document_.waits_for_answer() && !says_not_opened_ && !says_unseen_) put_away();
    });
    connect(&app_, &AppModel::unseen_stage_came, this, [this] {
        closed_unseen_ = false;
        say_unseen();
    });
    connect(&app_, &AppModel::not_opened, this, &NoticeBar::say_not_opened);
    // It was of the one before.
    connect(&app_, &AppModel::request_changed, this, [this] {
        if (app_.is_opening() && std::exchange(says_not_opened_, false)) put_away();
    });
    connect(&app_.undo_stack(), &QUndoStack::indexChanged, this, [this](int index) {
        if (index < edit_) edit_ = -1; // what comes there now is another one
        mark_undo();
    });
    connect(&app_, &AppModel::opened_show, this, [this] {
        if (app_.opened().is_edit) {
            if (app_.is_taking_edit()) note_edit();
            return;
        }
        if (std::exchange(says_not_opened_, false) && !document_.waits_for_answer()) hide();
        errors_.clear();
        awaits_messages_ = true;
        say_without_optics();
    });
}

bool NoticeBar::say_refused(const QString& what, const QString& helps) {
    const bool is_plot_alone = app_.show() && app_.show()->file == app_.show()->plot_file; // was asked
    if (is_plot_alone && isVisible()) return true;
    if (document_.waits_for_answer() || says_not_opened_) return false;
    std::vector<Answer> answers{{translated("Notice", "Close"), ""}};
    if (const QAction* const help = actions_.item(helps))
        answers.insert(answers.begin(), {help->text(), helps});
    ask(translated("Notice", "Not done: %1").arg(what), answers, Kind::fault);
    says_refused_ = true;
    return true;
}

void NoticeBar::forget_refused() {
    if (std::exchange(says_refused_, false)) put_away();
}

void NoticeBar::say_without_optics() {
    if (isVisible()) return;
    qsizetype dark = 0, assumed = 0;
    for (const FixtureGroup& group : without_optics(*app_.show()))
        for (const std::size_t index : group.fixtures)
            ++(can_shine(app_.show()->fixtures[index]) ? assumed : dark);
    QStringList words;
    if (dark > 0)
        words << translated("Notice", "%n head(s) have no optics and stay dark until another file stands in.",
                            nullptr, dark);
    if (assumed > 0)
        words << translated(
            "Notice", "%n head(s) have no optics in their files: what is seen of their light is assumed.",
            nullptr, assumed);
    if (!words.isEmpty())
        ask(words.join(' '), {{translated("Notice", "Other files for them..."), "panel-plot on"},
                              {translated("Notice", "Close"), ""}});
}

// It goes by itself when the camera does, and takes the place of nothing that waits for an answer.
void NoticeBar::say_unseen() {
    const UnseenStage& unseen = app_.unseen_stage();
    if (!unseen.is_so) {
        if (std::exchange(says_unseen_, false)) hide();
        return;
    }
    if (isVisible() && !says_unseen_) return;
    ask(unseen.body.empty()
            ? translated("Notice", "The camera sees nothing of the stage; Home frames it.")
            : translated("Notice", "The camera is behind '%1' and sees nothing of the stage; Home frames it.")
                  .arg(QString::fromStdString(unseen.body)),
        {{translated("Notice", "Home"), "see-all"}, {translated("Notice", "Close"), ""}});
    says_unseen_ = true;
}

// Then what had to wait is said, if it is so still.
void NoticeBar::put_away() {
    says_unseen_ = false;
    hide();
    if (!closed_unseen_) say_unseen();
}

void NoticeBar::say_not_opened() {
    const Error& error = *app_.open_error();
    static const QRegularExpression kLine("(:\\d+)+$"); // "show.toml:12"
    const QString file = QString::fromStdString(error.where).remove(kLine);
    std::vector<Answer> answers;
    if (QFileInfo(file).isFile())
        answers.push_back({translated("Notice", "Open the file"), "open-outside \"" + file + "\""});
    answers.push_back({translated("Notice", "Close"), ""});
    const QString stays = app_.show() ? " " + translated("Notice", "What was open stays open.") : QString();
    ask(translated("Notice", "Not opened: %1.").arg(shortened(said(error.text()), kNoticeLetters)) + stays,
        answers, Kind::fault);
    says_not_opened_ = true;
}

// Its step is in the list only when this is over, and not at all where one was undone.
void NoticeBar::note_edit() {
    QMetaObject::invokeMethod(
        this,
        [this, before = app_.undo_stack().index()] {
            const int now = app_.undo_stack().index();
            edit_ = now < before ? -1 : now;
            mark_undo();
        },
        Qt::QueuedConnection);
}

// What is said of an edit may come a minute later, and other things were done by then.
void NoticeBar::mark_undo() {
    if (undo_) undo_->setEnabled(app_.undo_stack().index() == edit_);
}

void NoticeBar::look_at_messages() {
    std::set<std::string> errors;
    QStringList anew, ignored;
    for (const Message& message : app_.messages()) {
        const bool is_ignored = is_ignored_key(message, *app_.show());
        if (message.severity != Severity::error && !is_ignored) continue;
        if (errors.insert(message.what).second && !errors_.contains(message.what))
            (is_ignored ? ignored : anew)
                << shortened(said(message.where + ": " + message.what), kNoticeLetters);
    }
    errors_ = std::move(errors);
    const bool was_opened = std::exchange(awaits_messages_, false);
    const bool is_edit = app_.opened().is_edit;
    const bool is_all_ignored = anew.isEmpty();
    anew += ignored;
    if (anew.isEmpty() || (!is_edit && (!was_opened || isVisible()))) return;
    const QString all = is_edit ? translated("Notice", "Since this edit: %1 (and %2 more)")
                        : is_all_ignored
                            ? translated("Notice", "Opened, but this is ignored: %1 (and %2 more)")
                            : translated("Notice", "Opened, but: %1 (and %2 more)");
    const QString one = is_edit          ? translated("Notice", "Since this edit: %1")
                        : is_all_ignored ? translated("Notice", "Opened, but this is ignored: %1")
                                         : translated("Notice", "Opened, but: %1");
    const QString words =
        anew.size() == 1 ? one.arg(anew.front()) : all.arg(anew.front()).arg(anew.size() - 1);
    ask(words,
        {is_edit ? Answer{translated("Notice", "Undo"), "undo"} : Answer{translated("Notice", "Close"), ""},
         {translated("Notice", "All messages"), "panel-messages on"}});
}

void NoticeBar::ask(const QString& words, const std::vector<Answer>& answers, Kind kind) {
    clear();
    undo_ = nullptr;
    words_ = words;
    says_not_opened_ = says_unseen_ = says_refused_ = false;
    setStyleSheet(kind == Kind::fault ? "QToolBar { background: #6e2119; }" : "");
    auto* label = new NoticeWords(words, this);
    label->setContentsMargins(8, 0, 8, 0);
    label->setWordWrap(true);
    label->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(label);
    for (const Answer& answer : answers) {
        QAction* const button = addAction(answer.button);
        if (answer.line == "undo") undo_ = button;
        connect(button, &QAction::triggered, this, [this, answer] {
            if (answer.puts_away) {
                closed_unseen_ = closed_unseen_ || says_unseen_;
                says_not_opened_ = false;
                put_away();
            }
            if (!answer.line.isEmpty()) actions_.choose(answer.line);
        });
    }
    mark_undo();
    show();
    place();
    raise();
}

// As wide as the picture and as high as its words need there.
void NoticeBar::place() {
    const QMargins edge = layout()->contentsMargins();
    int for_words = parentWidget()->width() - edge.left() - edge.right(), high = 0;
    const QLabel* words = nullptr;
    for (QAction* const one : actions()) {
        const QWidget* const part = widgetForAction(one);
        if (const auto* const label = qobject_cast<const QLabel*>(part)) {
            words = label;
        } else {
            for_words -= part->sizeHint().width() + std::max(layout()->spacing(), 0);
            high = std::max(high, part->sizeHint().height());
        }
    }
    if (words)
        high = std::max(high, words->heightForWidth(std::max(for_words, words->minimumSizeHint().width())));
    setGeometry(0, 0, parentWidget()->width(), high + edge.top() + edge.bottom());
}

bool NoticeBar::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QToolBar::eventFilter(object, event);
}

} // namespace ghost::ui
