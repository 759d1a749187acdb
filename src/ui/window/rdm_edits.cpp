// SPDX-License-Identifier: Apache-2.0
#include "ui/window/rdm_edits.h"

#include "show/show.h"
#include "ui/actions/patch_edit.h"
#include "ui/language/language.h"

#include <QTimer>

#include <algorithm>
#include <iterator>

namespace ghost::ui {

RdmEdits::RdmEdits(AppModel& app, ShowDocument& document, QObject* parent)
    : QObject(parent), app_(app), document_(document) {
    connect(&app_, &AppModel::rdm_edit_asked, this, &RdmEdits::take);
    connect(&app_, &AppModel::opened_show, this, [this] {
        if (!app_.opened().is_edit) waiting_.clear(); // of the show before
        offer();
    });
    connect(&document_, &ShowDocument::changed, this, &RdmEdits::offer);
}

void RdmEdits::set_access(RdmAccess access) {
    access_ = access;
    offer();
}

void RdmEdits::offer() {
    const bool can_edit = document_.can_edit();
    const RdmAccess offered = access_ == RdmAccess::edit && !can_edit ? RdmAccess::read : access_;
    if (offered != app_.request().rdm)
        app_.change_request([&](ViewRequest& request) { request.rdm = offered; });
}

void RdmEdits::take(const RdmEdit& asked) {
    waiting_.push_back(asked);
    if (waiting_.size() == 1) QTimer::singleShot(0, this, &RdmEdits::do_next);
}

void RdmEdits::do_next() {
    if (waiting_.empty()) return;
    const RdmEdit asked = std::move(waiting_.front());
    waiting_.pop_front();
    const Result<void> done = edit(asked);
    if (!done.ok() && complain) complain(Error{"RDM: " + done.error().text(), asked.name});
    if (done.ok() && on_done) on_done(app_.undo_stack().undoText());
    app_.change_request([&](ViewRequest& request) { request.rdm_answered = asked.number; });
    if (!waiting_.empty()) QTimer::singleShot(0, this, &RdmEdits::do_next);
}

Result<void> RdmEdits::edit(const RdmEdit& asked) {
    TRY_VOID(document_.check_editable());
    // The window may have moved on since the engine said so.
    const std::vector<scene::PatchedFixture>& fixtures = app_.show()->fixtures;
    const auto has_name = [&](const scene::PatchedFixture& fixture) { return fixture.name == asked.name; };
    std::size_t index = asked.fixture;
    if (index >= fixtures.size() || !has_name(fixtures[index])) {
        const auto found = std::find_if(fixtures.begin(), fixtures.end(), has_name);
        if (found == fixtures.end()) return Error{"there is no such fixture any more", ""};
        index = static_cast<std::size_t>(std::distance(fixtures.begin(), found));
    }
    const scene::PatchedFixture& fixture = fixtures[index];
    PatchEdit by_desk(app_, document_, index,
                      translated("Undo", " of %1 by RDM").arg(QString::fromStdString(asked.name)));
    if (asked.address) return by_desk.set_address({fixture.universe, *asked.address});
    if (asked.label) return by_desk.rename(QString::fromStdString(*asked.label));
    if (!asked.mode || !fixture.type || *asked.mode >= fixture.type->modes.size())
        return Error{"the fixture has no such mode any more", ""};
    return by_desk.set_mode(QString::fromStdString(fixture.type->modes[*asked.mode].name));
}

void add_rdm_action(Actions& actions, RdmEdits& edits) {
    actions.add({"rdm",
                 "",
                 "rdm",
                 "",
                 "off|read|edit",
                 [&edits](const QStringList& words) -> Result<void> {
                     const std::string word = words.value(0).toStdString();
                     const auto found = std::find(std::begin(kRdmAccess), std::end(kRdmAccess), word);
                     if (found == std::end(kRdmAccess))
                         return Error{"'" + word + "', expected off, read or edit", ""};
                     edits.set_access(static_cast<RdmAccess>(found - std::begin(kRdmAccess)));
                     return {};
                 },
                 {}});
}

} // namespace ghost::ui
