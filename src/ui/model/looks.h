#pragma once
// SPDX-License-Identifier: Apache-2.0
// Looks: the looks of the show that is open (show/looks.h), as the window edits them. Every change is a step
// of the undo list and is in the file at once; what another program writes there is taken as a step, too. A
// file with mistakes is shown as far as it can be read, but
// not written, for that would lose them. Errors go to who asked. Window thread.

#include "show/looks.h"
#include "ui/model/app_model.h"

#include <QFileSystemWatcher>
#include <QObject>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ghost::ui {

class Looks : public QObject {
    Q_OBJECT
public:
    explicit Looks(AppModel& app);

    // Error: the file is not to be written here. None: it is.
    std::function<Result<void>()> may_write;

    const std::vector<scene::StoredLook>& all() const { return looks_; }
    // The one that was stored or recalled last, while nothing was changed by hand since; empty: none.
    std::string current() const;

    // What is meant by who asks for the look of this moment: one that was stored as it shines, until hands or
    // another look change it; else the current one.
    std::string meant() const;

    // Whether anything is set by hand.
    bool can_store() const;
    // All that is set by hand; under a name that is there it replaces that one, and keeps its seconds.
    Result<void> store(const std::string& name);
    // All that the fixtures are asked for now, whoever asks for it: all of them, or the selected ones.
    Result<void> store_as_it_shines(const std::string& name);
    // Stays what it is with objects, surfaces and solo. seconds: below 0, those of the look.
    Result<void> recall(const std::string& name, double seconds = -1);
    // The next one in the list, or the one before (-1); round at the ends.
    Result<void> step(int by);
    // One step together with what `renamed` brings about.
    Result<void> rename(const std::string& name, const std::string& to);
    Result<void> set_fade(const std::string& name, double seconds);
    // Error: a cue recalls it, too.
    Result<void> remove(const std::string& name);
    // Fixtures that got other names, from the old one to the new one: their values stay theirs, in all looks.
    // A file with a mistake stays as it is, which is said.
    void rename_fixtures(const std::map<std::string, std::string>& renamed);

Q_SIGNALS:
    void changed();
    void renamed(const QString& name, const QString& to); // cues name it

private:
    friend class LooksStep;
    using List = std::vector<scene::StoredLook>;

    void read();
    void load();
    // Whether the file says something else than it did here; it is read then, as a step.
    bool take_changes();
    Result<void> put_in(scene::StoredLook look);
    void add_movers(scene::StoredLook& look) const; // those under the hand
    Result<void> check_writable() const;
    // with_it: what is done in the same step.
    Result<void> edit(const QString& what, List after, const std::function<void()>& with_it = {});
    Result<void> write(const List& looks);
    // Where something is another than it was when it was published last.
    void publish();

    AppModel& app_;
    std::filesystem::path file_; // empty: no show
    List looks_;
    LooksNow published_;
    std::string known_;  // text of the file as it was read or written here
    std::string damage_; // why it is not written; empty: it can be
    std::string last_;   // name
    std::string seen_;   // name of the one that was stored last as it shines
    Look hands_of_seen_; // then
    QFileSystemWatcher watcher_;
};

} // namespace ghost::ui
