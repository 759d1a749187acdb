#pragma once
// SPDX-License-Identifier: Apache-2.0
// CueList: the cues of the show ([[cue]] of show.toml) one after the other: go, back, what follows by itself,
// and edits of them, each one step of the undo list. Window thread.

#include "show/cues.h"
#include "ui/actions/actions.h"
#include "ui/model/looks.h"
#include "ui/model/show_document.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ghost::ui {

class CueList : public QObject {
    Q_OBJECT
public:
    CueList(AppModel& app, ShowDocument& document, Looks& looks);

    const std::vector<scene::Cue>& all() const;
    // That was called last; where it was removed since, the one before it.
    std::optional<std::size_t> current() const { return current_; }
    double follows_in_s() const; // until the next one goes by itself; below 0: it does not

    // The next one; what follows it goes by itself.
    Result<void> go();
    // Who goes back, or to one by hand, stands there: nothing follows until the next go.
    Result<void> back();
    Result<void> call(std::size_t index);
    // Cues with a place in the recording are called when it, or its time code, comes by.
    void set_follows_recording(bool follows);
    bool follows_recording() const { return follows_recording_; }

    Result<void> add(const QString& name, const QString& look);
    // what: name, number, look, at, camera, flight, fade, follow, page or notes; words empty: it goes.
    Result<void> set(std::size_t index, const QString& what, const QString& words);
    Result<void> move(std::size_t index, int by); // -1 or 1
    Result<void> remove(std::size_t index);
    // In all cues that recall it, one step. Nothing happens where none does.
    Result<void> rename_look(const std::string& look, const std::string& to);

    std::function<void(const Error&)> complain; // of what follows by itself

Q_SIGNALS:
    void changed();

private:
    enum class Place { goes_there, stays };
    enum class After { follows, stands };
    Result<void> call(std::size_t index, Place place, After after);
    void be_in(std::size_t index, After after);
    void take_cues();
    void find_called();
    void look_at_recording();
    Result<void> edit(const QString& what, const Result<std::string>& text);

    AppModel& app_;
    ShowDocument& document_;
    Looks& looks_;
    std::optional<std::size_t> current_;
    std::string called_;             // name of the cue that was called last, which an edit may have removed
    std::vector<std::string> names_; // of all, as they were seen last
    QTimer follow_;
    bool follows_recording_ = false;
    struct Seen {
        double at_s = 0; // of the recording
        std::uint64_t seeks = 0;
        bool comes = true; // what stands at that second has not come by yet
    } seen_;
};

// "cue-go", "cue-back", "cue NAME|PLACE", "cue-add NAME [LOOK]", "cue-set PLACE WHAT VALUE" and so on.
void add_cue_actions(Actions& actions, CueList& cues);

} // namespace ghost::ui
