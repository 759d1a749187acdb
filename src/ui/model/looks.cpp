// SPDX-License-Identifier: Apache-2.0
#include "ui/model/looks.h"

#include "disk/files.h"
#include "show/cues.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/head_values.h"

#include <QFile>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

namespace ghost::ui {
namespace {

// Where there is no file "", and nothing where there is one that cannot be read.
std::optional<std::string> text_in(const std::filesystem::path& file) {
    auto text = read_text_file(file, scene::kMostLooksBytes);
    if (text.ok()) return std::move(*text);
    std::error_code code;
    if (std::filesystem::exists(file, code) || code) return std::nullopt;
    return std::string();
}

} // namespace

// From one list to another, in the file as well.
class LooksStep : public QUndoCommand {
public:
    LooksStep(Looks& looks, Looks::List before, Looks::List after, const QString& text)
        : QUndoCommand(text), looks_(looks), before_(std::move(before)), after_(std::move(after)) {}
    void undo() override { put(before_); }
    void redo() override {
        if (is_new_)
            is_new_ = false; // it is in the file
        else
            put(after_);
    }

private:
    void put(const Looks::List& list) {
        if (const Result<void> may = looks_.check_writable(); !may.ok()) {
            Q_EMIT looks_.app_.failed(said(may.error().text()));
            return;
        }
        if (!looks_.damage_.empty()) {
            Q_EMIT looks_.app_.failed(
                translated("Notice", "Looks stay as the file has them until this is mended: %1")
                    .arg(said(looks_.damage_)));
            return;
        }
        if (text_in(looks_.file_) != looks_.known_) {
            Q_EMIT looks_.app_.failed(
                translated("Notice", "Looks were changed by another program, which is not undone: %1")
                    .arg(QString::fromStdString(looks_.file_.string())));
            return;
        }
        if (const Result<void> done = looks_.write(list); !done.ok())
            Q_EMIT looks_.app_.failed(QString::fromStdString(done.error().text()));
    }

    Looks& looks_;
    Looks::List before_, after_;
    bool is_new_ = true;
};

Looks::Looks(AppModel& app) : app_(app) {
    connect(&app_, &AppModel::opened_show, this, [this] {
        if (!app_.opened().is_edit) read();
    });
    connect(this, &Looks::changed, this, &Looks::publish);
    connect(&app_, &AppModel::look_changed, this, &Looks::publish);
    connect(&app_, &AppModel::look_called, this, [this](const QString& name, double seconds) {
        if (const Result<void> done = recall(name.toStdString(), seconds); !done.ok())
            Q_EMIT app_.failed(translated("Notice", "Remote control: %1").arg(said(done.error().text())));
    });
    // The folder, for the file may not be there yet, and programs put another one in its place.
    for (const auto signal : {&QFileSystemWatcher::directoryChanged, &QFileSystemWatcher::fileChanged})
        connect(&watcher_, signal, this, &Looks::take_changes);
}

void Looks::publish() {
    const bool are_others = !published_.looks || *published_.looks != looks_;
    const std::string now = current();
    if (!are_others && now == published_.current) return;
    if (are_others) published_.looks = std::make_shared<const List>(looks_);
    published_.current = now;
    app_.publish_looks(published_);
}

void Looks::read() {
    file_ = scene::looks_file(*app_.show());
    last_.clear();
    seen_.clear();
    const QStringList watched = watcher_.files() + watcher_.directories();
    if (!watched.isEmpty()) watcher_.removePaths(watched);
    if (const auto folder = file_.parent_path(); !folder.empty())
        watcher_.addPath(QString::fromStdString(folder.string()));
    load();
}

bool Looks::take_changes() {
    if (!app_.show() || text_in(file_) == known_) return false;
    List before = looks_;
    load();
    if (damage_.empty() && before != looks_)
        app_.undo_stack().push(
            new LooksStep(*this, std::move(before), looks_, translated("Undo", "looks from the file")));
    return true;
}

void Looks::load() {
    looks_.clear();
    if (const QString file = QString::fromStdString(file_.string()); QFile::exists(file))
        watcher_.addPath(file); // again, for it may be another one now
    damage_.clear();
    known_ = text_in(file_).value_or("");
    Report report;
    auto loaded = scene::load_looks(file_, report);
    if (loaded.ok())
        looks_ = std::move(*loaded);
    else
        damage_ = loaded.error().text();
    if (damage_.empty() && report.lost_anything())
        for (const Message& message : report.messages)
            if (message.severity == Severity::error && damage_.empty())
                damage_ = message.where + ": " + message.what;
    Report strangers;
    for (const scene::StoredLook& look : looks_)
        scene::check_look(look, *app_.show(), file_.string(), strangers);
    if (!damage_.empty())
        Q_EMIT app_.failed(QString::fromStdString(damage_));
    else if (!strangers.messages.empty())
        Q_EMIT app_.failed(
            QString::fromStdString(strangers.messages[0].where + ": " + strangers.messages[0].what));
    Q_EMIT changed();
}

Result<void> Looks::write(const List& looks) {
    const std::string text = scene::text_of(looks);
    TRY_VOID(scene::write_looks(file_, text));
    known_ = text;
    looks_ = looks;
    Q_EMIT changed();
    return {};
}

Result<void> Looks::check_writable() const {
    return may_write ? may_write() : Result<void>();
}

Result<void> Looks::edit(const QString& what, List after, const std::function<void()>& with_it) {
    if (!app_.show()) return Error{"no show is open", ""};
    TRY_VOID(check_writable());
    const bool changed_outside = take_changes();
    if (!damage_.empty())
        return Error{"looks cannot be stored before this is mended, for that would lose it: " + damage_, ""};
    if (changed_outside)
        return Error{"was changed by another program and is read again; once more, please", file_.string()};
    if (after == looks_) return {};
    if (after.size() > scene::kMostLooks)
        return Error{"there are " + std::to_string(scene::kMostLooks) + " looks; remove one first", ""};
    List before = looks_;
    TRY_VOID(write(after));
    auto* const step = new LooksStep(*this, std::move(before), std::move(after), what);
    if (with_it) app_.undo_stack().beginMacro(what);
    app_.undo_stack().push(step);
    if (!with_it) return {};
    with_it();
    app_.undo_stack().endMacro();
    return {};
}

Result<void> Looks::put_in(scene::StoredLook look) {
    TRY_VOID(scene::check_stored_name("look", look.name));
    List after = looks_;
    const auto same =
        std::find_if(after.begin(), after.end(), [&](const auto& one) { return one.name == look.name; });
    const std::string name = look.name;
    if (same == after.end()) {
        after.push_back(std::move(look));
    } else {
        look.fade_s = same->fade_s;
        *same = std::move(look);
    }
    TRY_VOID(
        edit(translated("Undo", "Look '%1' stored").arg(QString::fromStdString(name)), std::move(after)));
    last_ = name;
    Q_EMIT changed();
    return {};
}

void Looks::add_movers(scene::StoredLook& look) const {
    for (const auto& [index, values] : app_.look().movers)
        if (index < app_.show()->movers.size()) look.movers[app_.show()->movers[index].name] = values;
}

bool Looks::can_store() const {
    const Look& look = app_.look();
    return app_.show() &&
           (!look.fixtures.empty() || !look.movers.empty() || look.scene != scene::SceneLook{});
}

Result<void> Looks::store(const std::string& name) {
    if (!app_.show()) return Error{"no show is open", ""};
    if (!can_store())
        return Error{
            "nothing is set by hand; 'Store what is seen' in Looks stores what a desk or recording does", ""};
    scene::StoredLook look;
    look.name = name;
    look.scene = app_.look().scene;
    for (const auto& [index, programmer] : app_.look().fixtures)
        if (index < app_.show()->fixtures.size())
            look.fixtures[app_.show()->fixtures[index].name] = programmer;
    add_movers(look);
    return put_in(std::move(look));
}

Result<void> Looks::store_as_it_shines(const std::string& name) {
    if (!app_.show()) return Error{"no show is open", ""};
    scene::StoredLook look;
    look.name = name;
    look.scene = app_.look().scene;
    add_movers(look);
    const fixture::Levels levels = levels_of(app_.rig().universes);
    const std::set<std::size_t>& chosen = app_.selection();
    for (std::size_t i = 0; i < app_.show()->fixtures.size(); ++i) {
        const scene::PatchedFixture& fixture = app_.show()->fixtures[i];
        if (!fixture.type || (!chosen.empty() && !chosen.contains(i))) continue;
        const auto by_hand = app_.look().fixtures.find(i);
        fixture::Programmer programmer =
            by_hand == app_.look().fixtures.end() ? fixture::Programmer{} : by_hand->second;
        if (programmer.levels.empty()) programmer.levels = fixture::levels_of(fixture.patch(), levels);
        look.fixtures[fixture.name] = std::move(programmer);
    }
    TRY_VOID(put_in(std::move(look)));
    seen_ = name;
    hands_of_seen_ = app_.look();
    return {};
}

Result<void> Looks::recall(const std::string& name, double seconds) {
    if (!app_.show()) return Error{"no show is open", ""};
    TRY(const std::size_t index, scene::find_look(looks_, name));
    Look look = app_.look();
    look.fixtures = scene::programmer_of(looks_[index], *app_.show());
    look.movers = scene::movers_of(looks_[index], *app_.show());
    look.scene = looks_[index].scene;
    app_.fade_to(std::move(look), translated("Undo", "look %1").arg(QString::fromStdString(name)),
                 seconds < 0 ? static_cast<double>(looks_[index].fade_s) : seconds);
    last_ = name;
    Q_EMIT changed();
    return {};
}

Result<void> Looks::step(int by) {
    if (looks_.empty()) return Error{"there is no look yet: store one", ""};
    const auto count = static_cast<int>(looks_.size());
    const std::string now = current();
    const Result<std::size_t> last = scene::find_look(looks_, now.empty() ? last_ : now);
    const int next = last.ok() ? static_cast<int>(*last) + by : by > 0 ? 0 : count - 1;
    return recall(looks_[static_cast<std::size_t>((next + count) % count)].name);
}

Result<void> Looks::rename(const std::string& name, const std::string& to) {
    TRY_VOID(scene::check_stored_name("look", to));
    TRY(const std::size_t index, scene::find_look(looks_, name));
    if (name != to && scene::find_look(looks_, to).ok())
        return Error{"another look is called '" + to + "'", ""};
    List after = looks_;
    after[index].name = to;
    TRY_VOID(edit(translated("Undo", "Look '%1' renamed '%2'")
                      .arg(QString::fromStdString(name), QString::fromStdString(to)),
                  std::move(after),
                  [&] { Q_EMIT renamed(QString::fromStdString(name), QString::fromStdString(to)); }));
    if (last_ == name) last_ = to;
    if (seen_ == name) seen_ = to;
    Q_EMIT changed();
    return {};
}

Result<void> Looks::set_fade(const std::string& name, double seconds) {
    TRY(const std::size_t index, scene::find_look(looks_, name));
    List after = looks_;
    after[index].fade_s = static_cast<float>(std::clamp(seconds, 0.0, scene::kLongestFade_s));
    return edit(translated("Undo", "seconds of a look"), std::move(after));
}

Result<void> Looks::remove(const std::string& name) {
    TRY(const std::size_t index, scene::find_look(looks_, name));
    for (const scene::Cue& cue : app_.show()->cues)
        if (cue.look == name)
            return Error{"look '" + name + "' cannot be removed: cue '" + cue.name +
                             "' recalls it; give that cue another look first",
                         ""};
    List after = looks_;
    after.erase(after.begin() + static_cast<std::ptrdiff_t>(index));
    return edit(translated("Undo", "Look '%1' removed").arg(QString::fromStdString(name)), std::move(after));
}

void Looks::rename_fixtures(const std::map<std::string, std::string>& renamed) {
    if (!app_.show()) return;
    take_changes();
    List after = looks_;
    for (scene::StoredLook& look : after) {
        std::map<std::string, fixture::Programmer> fixtures;
        for (const bool has_moved : {false, true}) // values of no fixture give way to those of one
            for (const auto& [name, programmer] : look.fixtures)
                if (const auto to = renamed.find(name); (to != renamed.end()) == has_moved)
                    fixtures.insert_or_assign(has_moved ? to->second : name, programmer);
        look.fixtures = std::move(fixtures);
    }
    if (damage_.empty() && after == looks_) return;
    if (const Result<void> done = edit(translated("Undo", "Name"), std::move(after)); !done.ok())
        Q_EMIT app_.failed(
            translated("Notice", "Looks keep the old names of fixtures: %1").arg(said(done.error().text())));
}

std::string Looks::meant() const {
    const bool is_seen = scene::find_look(looks_, seen_).ok() && app_.show() && app_.look() == hands_of_seen_;
    return is_seen ? seen_ : current();
}

std::string Looks::current() const {
    if (!app_.show()) return "";
    const auto is_there = [&](const scene::StoredLook& look) {
        return app_.look().scene == look.scene &&
               app_.look().movers == scene::movers_of(look, *app_.show()) &&
               app_.look().fixtures == scene::programmer_of(look, *app_.show());
    };
    // Of two that are alike the one that was asked for.
    if (const Result<std::size_t> last = scene::find_look(looks_, last_);
        last.ok() && is_there(looks_[*last]))
        return last_;
    // Who holds nothing has recalled none, be there one without values.
    const auto found = can_store() ? std::find_if(looks_.begin(), looks_.end(), is_there) : looks_.end();
    return found == looks_.end() ? "" : found->name;
}

} // namespace ghost::ui
