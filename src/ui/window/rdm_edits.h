#pragma once
// SPDX-License-Identifier: Apache-2.0
// RdmEdits: the switch of RDM (docs/reference/rdm.md), and what desks want of the show as edits of it, each
// one step of the undo list. One a turn of the event loop, so that a desk that sets four hundred addresses
// stops nobody. A show that cannot be edited is only read. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

#include <QObject>

#include <deque>

namespace ghost::ui {

class RdmEdits : public QObject {
    Q_OBJECT
public:
    RdmEdits(AppModel& app, ShowDocument& document, QObject* parent);

    void set_access(RdmAccess access);
    RdmAccess access() const { return access_; } // that was chosen; the request has what can be

    std::function<void(const Error&)> complain;
    std::function<void(const QString& what)> on_done;

private:
    void offer();
    void take(const RdmEdit& asked);
    void do_next();
    Result<void> edit(const RdmEdit& asked);

    AppModel& app_;
    ShowDocument& document_;
    RdmAccess access_ = RdmAccess::off;
    std::deque<RdmEdit> waiting_;
};

// "rdm off|read|edit".
void add_rdm_action(Actions& actions, RdmEdits& edits);

} // namespace ghost::ui
