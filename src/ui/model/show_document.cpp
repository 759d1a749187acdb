// SPDX-License-Identifier: Apache-2.0
#include "ui/model/show_document.h"

#include "disk/files.h"
#include "disk/user_file.h"
#include "link/carried.h"
#include "show_folder/load_show.h"
#include "ui/language/language.h"
#include "ui/model/private/undo_ids.h"

#include <QLocale>

#include <algorithm>
#include <memory>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kDraftAfter_ms = 500;
constexpr int kDraftAgain_ms = 5000; // where it could not be written
constexpr int kLookAgain_ms = 1000;
constexpr int kGoneAfter = 2; // looks, for editors take a file away for a moment

} // namespace

// From one text to another, with what is by index of the fixture.
class EditStep : public QUndoCommand {
public:
    EditStep(ShowDocument& document, ShowDocument::Edit before, ShowDocument::Edit after, const QString& text,
             int kind)
        : QUndoCommand(text), document_(document), before_(std::move(before)), after_(std::move(after)),
          kind_(kind) {
        age_.start();
    }
    void undo() override { document_.put(before_); }
    void redo() override { document_.put(after_); }
    int id() const override { return kind_ == 0 ? -1 : kFirstEditId + kind_; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* later = static_cast<const EditStep*>(next);
        if (age_.elapsed() > kMergeWithin_ms) return false;
        after_ = later->after_;
        age_.restart();
        return true;
    }

private:
    ShowDocument& document_;
    ShowDocument::Edit before_, after_;
    int kind_;
    QElapsedTimer age_;
};

ShowDocument::ShowDocument(AppModel& app) : app_(app) {
    draft_timer_.setSingleShot(true);
    // No watcher tells of a folder that is renamed, or of a disk that is taken out.
    gone_timer_.start(kLookAgain_ms);
    connect(&gone_timer_, &QTimer::timeout, this, &ShowDocument::look_at_disk);
    connect(&draft_timer_, &QTimer::timeout, this, &ShowDocument::keep_draft);
    for (const auto signal : {&QFileSystemWatcher::directoryChanged, &QFileSystemWatcher::fileChanged})
        connect(&watcher_, signal, this, &ShowDocument::look_at_file);
    connect(&app_, &AppModel::opened_show, this, [this] {
        const bool goes_on = app_.opened().again && app_.show()->file == file_;
        if (!app_.opened().is_edit && !goes_on) read_opened();
        // What was edited while it was opened is in the text and not in what was opened, whose fixtures may
        // be other ones by their numbers.
        if (!app_.opened().is_edit && goes_on && app_.is_taking_edit())
            QMetaObject::invokeMethod(
                this,
                [this] {
                    if (const auto ours = from_outside(text_); ours.ok()) put(ours->edit);
                },
                Qt::QueuedConnection);
    });
}

ShowDocument::~ShowDocument() {
    if (draft_timer_.isActive()) static_cast<void>(keep()); // who closes was told
}

void ShowDocument::watch() {
    // The folder, too: editors take the file away for a moment and put another one in its place.
    if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
    const QString folder = QString::fromStdString(file_.parent_path().string());
    for (const QString& other : watcher_.directories())
        if (other != folder) watcher_.removePath(other);
    if (file_.empty()) return;
    watcher_.addPath(QString::fromStdString(file_.string()));
    if (!watcher_.directories().contains(folder)) watcher_.addPath(folder);
}

void ShowDocument::read_opened() {
    if (draft_timer_.isActive()) keep_draft(); // of the show that was open
    hold_.reset();
    file_ = app_.show()->file;
    drafts_ = Drafts(*app_.show());
    known_.clear();
    text_.clear();
    copied_.clear();
    draft_.reset();
    is_kept_ = true;
    save_failed_ = false;
    changed_outside_ = false;
    seen_outside_.reset();
    is_gone_ = false;
    misses_ = 0;
    disk_.forget();
    if (file_.extension() != ".toml") file_.clear();
    if (!file_.empty()) {
        if (auto text = read_text_file(file_, scene::kMaxShowBytes); text.ok())
            text_ = std::move(*text);
        else
            file_.clear();
    }
    saved_ = text_;
    watch();
    if (!file_.empty()) hold(Hold::Other::keeps);
    if (is_read_only())
        Q_EMIT found_held(translated("Notice", "Another window has this show open: %1. Here it is read only.")
                              .arg(QString::fromStdString(hold_->holder())));
    else if (!file_.empty())
        find_draft();
    Q_EMIT changed();
}

void ShowDocument::let_go() {
    gone_timer_.stop();
    disk_.forget();
    hold_.reset();
}

void ShowDocument::hold(Hold::Other other) {
    if (auto taken = drafts_.hold(other); taken.ok()) hold_ = std::move(*taken);
    was_ours_ = hold_ && hold_->is_ours();
}

void ShowDocument::look_who_holds() {
    notice_loss();
    if (!is_read_only()) return;
    hold(Hold::Other::keeps); // the other one may have closed it
    if (!is_read_only()) begin_editing();
}

void ShowDocument::begin_editing() {
    look_at_file();
    find_draft();
    Q_EMIT changed();
}

void ShowDocument::notice_loss() {
    if (!was_ours_ || !is_read_only()) return;
    was_ours_ = false;
    draft_.reset();            // the other window offers it
    app_.undo_stack().clear(); // a step back would change a text that is the other's
    QString kept;
    if (is_changed()) {
        // The draft is the other window's now.
        const auto copy = drafts_.write_aside(text_);
        is_kept_ = copy.ok();
        kept = copy.ok() ? " " + translated("Notice", "What was not saved here is kept in %1.")
                                     .arg(QString::fromStdString(copy->string()))
                         : " " + translated("Notice", "What is not saved here can be saved as a copy.");
    }
    Q_EMIT found_held(translated("Notice", "Another window took this show over: %1. Here it is read only.")
                          .arg(QString::fromStdString(hold_->holder())) +
                      kept);
    Q_EMIT changed();
}

void ShowDocument::find_draft() {
    auto found = drafts_.find(text_);
    if (!found) return;
    draft_ = std::move(found->text);
    Q_EMIT draft_found(translated("Notice", "Changes of %1 were not saved.")
                           .arg(QLocale(language()).toString(found->when, "d MMM hh:mm")) +
                       (found->of_this
                            ? QString()
                            : " " + translated("Notice", "The show file was changed since; taking them drops "
                                                         "what was changed there.")));
}

Result<void> ShowDocument::check_editable() {
    if (app_.show() && app_.show()->file == app_.show()->plot_file)
        Q_EMIT found_plot_alone(
            translated("Notice", "A plot that is opened as it is cannot be edited. A show that is made of it "
                                 "can, and its changes outlive the designer's next version."));
    return why_not_editable();
}

Result<void> ShowDocument::why_not_editable() const {
    if (!app_.show()) return Error{"no show is open", ""};
    if (app_.is_opening_copy()) // the file before stays what it was
        return Error{"the show is being opened under its new name, which takes a moment: nothing is changed", ""};
    if (file_.empty())
        return Error{"a plot that is opened as it is cannot be edited; make a show of it first (in a script: "
                     "import-plot)",
                     app_.show()->file.string()};
    TRY_VOID(check_ours());
    if (draft_)
        return Error{"changes of an earlier time wait: take them or drop them first (Edit menu)",
                     file_.string()};
    return {};
}

Result<void> ShowDocument::check_ours() const {
    if (!is_read_only()) return {};
    return Error{"is open in another window: " + hold_->holder() +
                     "; close it there, or take it over (in a script: take-over)",
                 file_.string()};
}

Result<ShowDocument::Outside> ShowDocument::from_outside(std::string text) const {
    const scene::Show& before = *app_.show();
    TRY(const scene::Show now, scene::preview_edit(before, text));
    return Outside{
        {std::move(text), carried(app_.look(), before, now), carried(app_.selection(), before, now)},
        scene::renamed_fixtures(before, now),
        lost_of(app_.look(), before, now)};
}

Result<void> ShowDocument::edit(const QString& what, Edit edit, int kind) {
    TRY(const bool changes, prepare(edit));
    if (changes) push(what, std::move(edit), kind);
    return {};
}

// Whether it changes anything; it opens then.
Result<bool> ShowDocument::prepare(const Edit& edit) {
    TRY_VOID(check_editable());
    if (edit.text == text_) return false;
    if (edit.text.size() > scene::kMaxShowBytes) // else it is saved and never opened again
        return Error{"would be " + std::to_string(edit.text.size()) + " bytes, and no more than " +
                         std::to_string(scene::kMaxShowBytes) +
                         " are read again: nothing is changed; a palette of fewer fixtures needs less",
                     file_.string()};
    TRY(scene::Show preview, scene::preview_edit(*app_.show(), edit.text, known_));
    prepared_ = {edit.text, std::move(preview)};
    return true;
}

void ShowDocument::push(const QString& what, Edit edit, int kind) {
    Edit before{text_, app_.look(), app_.selection()};
    app_.undo_stack().push(new EditStep(*this, std::move(before), std::move(edit), what, kind));
    prepared_.reset();
}

Result<void> ShowDocument::edit_names(const QString& what, Edit edit, const FixtureNames& renamed) {
    TRY(const bool changes, prepare(edit));
    if (!changes) return {};
    app_.undo_stack().beginMacro(what);
    push(what, std::move(edit), 0);
    if (!renamed.empty()) Q_EMIT fixtures_renamed(renamed);
    app_.undo_stack().endMacro();
    return {};
}

void ShowDocument::know(const std::filesystem::path& file, std::shared_ptr<const fixture::Type> type) {
    known_[file.lexically_normal()] = std::move(type);
}

void ShowDocument::put(const Edit& edit) {
    text_ = edit.text;
    auto preview = prepared_ && prepared_->text == text_ ? Result<scene::Show>(std::move(prepared_->show))
                                                         : scene::preview_edit(*app_.show(), text_, known_);
    prepared_.reset();
    if (preview.ok())
        app_.put_edit(std::make_shared<const std::string>(text_), std::move(*preview), edit.look,
                      edit.selection);
    // Who types on must not put it off.
    if (!draft_timer_.isActive() || draft_timer_.remainingTime() > kDraftAfter_ms)
        draft_timer_.start(kDraftAfter_ms);
    Q_EMIT changed();
}

void ShowDocument::keep_draft() {
    const bool was_kept = is_kept_;
    const Result<void> kept = keep();
    if (kept.ok() || !was_kept) return; // said once
    Q_EMIT keep_failed(
        translated("Notice", "Changes that are not saved cannot be kept: %1").arg(said(kept.error().text())));
}

Result<void> ShowDocument::keep() {
    draft_timer_.stop();
    notice_loss();
    if (file_.empty() || draft_) return {};
    if (is_read_only())
        return is_kept_ || text_ == copied_
                   ? Result<void>()
                   : Error{"another window has the show, and what is not saved here is kept nowhere",
                           file_.string()};
    Result<void> kept;
    if (is_changed())
        kept = drafts_.write(text_, saved_);
    else
        drafts_.remove();
    const bool is_kept = kept.ok();
    if (is_kept != is_kept_) {
        is_kept_ = is_kept;
        Q_EMIT changed();
    }
    if (is_kept) return {};
    draft_timer_.start(kDraftAgain_ms);
    if (text_ == copied_) return {};
    return kept;
}

void ShowDocument::look_at_file() {
    watch(); // a file that was replaced is another one
    const auto now = read_text_file(file_, scene::kMaxShowBytes);
    if (!now.ok() || now->empty()) return; // away or being written, or look_whether_gone says so
    const bool was_gone = std::exchange(is_gone_, false);
    const bool outside = *now != saved_ && *now != text_;
    if (outside ? seen_outside_ == *now : !changed_outside_) {
        if (was_gone) Q_EMIT changed();
        return;
    }
    if (is_read_only() && !is_changed()) { // it follows the other window
        const auto outside_edit = from_outside(*now);
        if (!outside_edit.ok()) return;
        saved_ = *now;
        put(outside_edit->edit);
        app_.tell_lost(outside_edit->lost);
        return;
    }
    changed_outside_ = outside;
    seen_outside_ = outside ? std::optional(*now) : std::nullopt;
    QString why = translated(
        "Notice", "Another program changed the show file, and there are changes here that are not saved.");
    if (outside && !is_changed() && !draft_) {
        const Result<void> taken = reload();
        if (taken.ok()) return;
        why = translated("Notice", "Another program changed the show file, and it cannot be taken: %1")
                  .arg(said(taken.error().text()));
    }
    if (outside) Q_EMIT found_changed_outside(why);
    Q_EMIT changed();
}

// Before anything here touches it: where it does not answer, the window goes on.
void ShowDocument::look_at_disk() {
    if (file_.empty()) return;
    disk_.ask([this, file = file_]() -> DiskLook::Then {
        std::error_code code;
        const bool is_there = std::filesystem::exists(file, code);
        const bool has_folder = is_there || std::filesystem::exists(file.parent_path(), code);
        return [this, is_there, has_folder] {
            look_whether_gone(is_there, has_folder);
            look_who_holds();
        };
    });
}

void ShowDocument::look_whether_gone(bool is_there, bool has_folder) {
    misses_ = is_there ? 0 : misses_ + 1;
    if (is_there && is_gone_) {
        watcher_.removePaths(watcher_.directories()); // it may be another folder
        look_at_file();
    }
    if (misses_ < kGoneAfter || is_gone_) return;
    is_gone_ = true;
    Q_EMIT found_gone(
        has_folder
            ? translated("Notice", "The show file is gone: deleted, renamed, or its disk was taken out. "
                                   "What is open here stays as it is.")
            : translated("Notice", "The show folder is gone: deleted, renamed, or its disk was taken "
                                   "out. What is open here stays as it is."));
    Q_EMIT changed();
}

Result<void> ShowDocument::save(bool over) {
    TRY_VOID(check_editable());
    const auto now = read_text_file(file_, scene::kMaxShowBytes);
    std::error_code code;
    if (!over && !now.ok() && std::filesystem::exists(std::filesystem::symlink_status(file_, code)))
        return Error{now.error().what +
                         ": nobody can say whether another program changed it; save yours over "
                         "it (in a script: save over), or save a copy",
                     file_.string()};
    const auto is_another = [&] { return now.ok() && *now != saved_ && *now != text_; };
    if (!over && is_another()) {
        look_at_file(); // asks what shall be: no watcher hears of what other machines do
        if (is_another())
            return Error{
                "was changed by another program since it was read here: take what the file says, or save "
                "yours over it (in a script: reload, save over)",
                file_.string()};
    }
    if (const Result<void> written = write_user_file(file_, text_); !written.ok()) {
        save_failed_ = true;
        Q_EMIT save_failed(
            translated("Notice", "The show is not saved: %1").arg(said(written.error().text())));
        return written;
    }
    save_failed_ = is_gone_ = false;
    misses_ = 0;
    disk_.forget(); // an answer that is on its way may be of before
    saved_ = text_;
    changed_outside_ = false;
    keep_draft();
    watch();
    Q_EMIT changed();
    return {};
}

Result<void> ShowDocument::save_copy(const std::filesystem::path& file) {
    if (!is_read_only()) TRY_VOID(check_editable());
    std::error_code code;
    if (std::filesystem::equivalent(file, file_, code))
        return Error{"is the show file itself, which 'save' writes", file.string()};
    TRY_VOID(write_file_atomic(file, text_));
    copied_ = text_;
    return {};
}

Result<void> ShowDocument::save_as(const std::filesystem::path& file) {
    TRY_VOID(save_copy(file));
    draft_timer_.stop();
    if (!is_read_only()) drafts_.remove();
    return {};
}

Result<void> ShowDocument::reload() {
    TRY_VOID(check_editable());
    TRY(std::string now, read_text_file(file_, scene::kMaxShowBytes));
    if (now == text_) { // perhaps the files that it names are others
        saved_ = std::move(now);
        changed_outside_ = false;
        read_again();
        Q_EMIT changed();
        return {};
    }
    TRY(Outside outside, from_outside(std::move(now)));
    // Before the step, which asks what is saved.
    std::string before = std::exchange(saved_, outside.edit.text);
    const bool was_outside = std::exchange(changed_outside_, false);
    Result<void> done = edit_names(translated("Undo", "Reload"), std::move(outside.edit), outside.renamed);
    if (!done.ok()) {
        saved_ = std::move(before); // what cannot be taken must not be written over unasked
        changed_outside_ = was_outside;
        return done;
    }
    app_.tell_lost(outside.lost);
    return {};
}

void ShowDocument::read_again() {
    app_.read_again(std::make_shared<const std::string>(text_));
}

Result<void> ShowDocument::take_draft() {
    if (!draft_) return Error{"there are no changes of an earlier time", ""};
    TRY(Outside outside, from_outside(*draft_)); // looks have its names already
    draft_.reset();
    TRY_VOID(edit(translated("Undo", "Take changes"), std::move(outside.edit)));
    app_.tell_lost(outside.lost);
    return {};
}

Result<void> ShowDocument::take_over() {
    if (!is_read_only()) return Error{"no other window has this show open", file_.string()};
    hold(Hold::Other::gives_way);
    if (is_read_only()) return why_not_editable();
    begin_editing();
    return {};
}

Result<void> ShowDocument::drop_draft() {
    notice_loss();
    if (!draft_) return Error{"there are no changes of an earlier time", ""};
    // Looks were renamed with the fixtures of the draft, and written.
    const auto dropped = scene::preview_edit(*app_.show(), *draft_);
    const FixtureNames back = dropped.ok() ? scene::renamed_fixtures(*dropped, *app_.show()) : FixtureNames{};
    draft_.reset();
    drafts_.remove();
    if (!back.empty()) Q_EMIT fixtures_renamed(back);
    Q_EMIT changed();
    return {};
}

} // namespace ghost::ui
