#pragma once
// SPDX-License-Identifier: Apache-2.0
// ShowDocument: show.toml as the window edits it. Its text is the document: an edit is a step of the undo
// list from one text to the next, and undone it leaves not one other byte. What is not saved is a draft
// (ui/model/drafts.h) half a second later, so that neither a crash nor a window that is closed loses more;
// the next time it is offered. Errors go to who asked. Window thread.

#include "show/same_fixtures.h"
#include "show/show.h"
#include "show_folder/hold.h"
#include "show_folder/load_show.h"
#include "ui/model/app_model.h"
#include "ui/model/disk_look.h"
#include "ui/model/drafts.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ghost::ui {

class ShowDocument : public QObject {
    Q_OBJECT
public:
    explicit ShowDocument(AppModel& app);
    ~ShowDocument() override; // writes the draft that waits

    const std::string& text() const { return text_; }
    bool is_changed() const { return text_ != saved_; }
    using FixtureNames = scene::FixtureNames;
    // Changes of an earlier window, or of one that crashed, that wait for take_draft or drop_draft; nothing
    // is edited before.
    bool has_draft() const { return draft_.has_value(); }
    // Whether the file says something else now than when it was read or written here.
    bool is_changed_outside() const { return changed_outside_; }
    // Whether another window has the show, on this machine or another: nothing is edited, saved or kept here.
    bool is_read_only() const { return hold_ && !hold_->is_ours(); }
    // Whether something waits for a person: a draft, a change outside, a disk that takes
    // nothing, a show file that is gone, another window.
    bool waits_for_answer() const {
        return has_draft() || is_changed_outside() || !is_kept_ || save_failed_ || is_gone_ || is_read_only();
    }

    // Of what is about to be edited. Error: no show, an .mvr that was opened as it is, which is told to
    // found_plot_alone, too, or a draft that waits.
    Result<void> check_editable();
    bool can_edit() const { return why_not_editable().ok(); }
    // Error: another window has the show, and all that belongs to it is written there.
    Result<void> check_ours() const;
    // One step. look and selection: as they are with the new text, for indices may move.
    struct Edit {
        std::string text;
        Look look;
        std::set<std::size_t> selection;
    };
    // Edits of one kind that follow each other closely, as those of a slider, are one step; kind 0: always a
    // step of its own.
    Result<void> edit(const QString& what, Edit edit, int kind = 0);
    // Likewise, one step together with what fixtures_renamed brings about.
    Result<void> edit_names(const QString& what, Edit edit, const FixtureNames& renamed);

    // A fixture file that was read for an edit, which is not read again to show it.
    void know(const std::filesystem::path& file, std::shared_ptr<const fixture::Type> type);

    // Whole or not at all. Error: cannot be written, or the file was changed outside meanwhile and over is
    // false.
    Result<void> save(bool over);
    // As it is now, elsewhere; the show stays where it is, with what is not saved. For a disk that is full.
    Result<void> save_copy(const std::filesystem::path& file);
    // The same before that copy is opened: what is not saved here is saved there, and no draft any more.
    Result<void> save_as(const std::filesystem::path& file);
    // What the file says, as a step that can be undone; of what it names, too. Error: it cannot be read; all
    // stays as it was.
    Result<void> reload();
    // Files that the show names are others now.
    void read_again();
    // Writes what is not saved where the next window finds it. Error: nowhere, nor was it saved as a copy.
    Result<void> keep();
    // Of a window that closes: others may have the show, while this program still ends.
    void let_go();
    Result<void> take_draft();
    Result<void> drop_draft();
    // From another window, which keeps what it has not saved in a file of its own and becomes read-only.
    Result<void> take_over();

Q_SIGNALS:
    void changed(); // any of the above
    // What lies in other files and goes by name is renamed with them.
    void fixtures_renamed(const ghost::ui::ShowDocument::FixtureNames& renamed);
    void draft_found(const QString& words);
    void found_changed_outside(const QString& words); // and could not be taken
    void found_gone(const QString& words);
    void found_held(const QString& words);       // by another window
    void found_plot_alone(const QString& words); // and an edit was wanted, for which it must become a show
    void save_failed(const QString& words);
    void keep_failed(const QString& words); // the next window would not find what is not saved

private:
    friend class EditStep;

    // What somebody else wrote: hands and selection are on the same heads, whatever numbers these have there.
    struct Outside {
        Edit edit;
        FixtureNames renamed;
        std::vector<std::string> lost; // of what hands hold
    };

    // The next step's text, with the show that it is.
    struct Prepared {
        std::string text;
        scene::Show show;
    };

    Result<void> why_not_editable() const;
    Result<Outside> from_outside(std::string text) const;
    Result<bool> prepare(const Edit& edit);
    void push(const QString& what, Edit edit, int kind);
    void read_opened();
    void put(const Edit& edit);
    void keep_draft();
    void find_draft();
    void look_at_file();
    void look_at_disk();
    void look_whether_gone(bool is_there, bool has_folder);
    void look_who_holds();
    void notice_loss();
    void hold(Hold::Other other);
    void begin_editing();
    void watch();

    AppModel& app_;
    std::filesystem::path file_; // empty: nothing that can be edited
    Drafts drafts_;
    std::optional<Hold> hold_; // none: nothing can be written there
    bool was_ours_ = false;    // at the last look
    std::string text_;
    std::string saved_;  // as the file has it
    std::string copied_; // as it was saved as a copy
    std::optional<std::string> draft_;
    std::optional<Prepared> prepared_;
    scene::KnownTypes known_;
    bool is_kept_ = true;
    bool save_failed_ = false;
    bool changed_outside_ = false;
    bool is_gone_ = false;                    // the show file
    int misses_ = 0;                          // looks that did not find it
    std::optional<std::string> seen_outside_; // what it says there
    QTimer draft_timer_, gone_timer_;
    DiskLook disk_;
    QFileSystemWatcher watcher_;
};

} // namespace ghost::ui
