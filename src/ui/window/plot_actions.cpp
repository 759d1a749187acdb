// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/plot_actions.h"

#include "disk/files.h"
#include "show/show.h"
#include "show_file/substitute_edit.h"
#include "ui/actions/patch_edit.h"
#include "ui/actions/show_actions.h"
#include "ui/language/language.h"

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace ghost::ui {
namespace {

// What waits until a plot has become a show.
class AfterImport : public QObject {
public:
    AfterImport(Actions& actions, AppModel& app, ShowDocument& document)
        : QObject(&app), actions_(actions), app_(app), document_(document) {
        connect(&app_, &AppModel::opened_show, this, [this] {
            if (!waiting_ || app_.opened().is_edit) return;
            // Once all have heard of the show: files may be copied meanwhile.
            QMetaObject::invokeMethod(
                this,
                [this, waiting = *std::exchange(waiting_, std::nullopt)] { substitute_in_show(waiting); },
                Qt::QueuedConnection);
        });
        connect(&app_, &AppModel::not_opened, this, [this] {
            if (!waiting_ || is_importing()) return; // another show was asked for meanwhile
            waiting_.reset();
            actions_.complain({"the show that was made of the plot cannot be opened: no fixture file is "
                               "substituted",
                               ""});
        });
        connect(&app_.jobs(), &Jobs::ended, this, [this](const Job& job) {
            if (!waiting_ || job.number != waiting_->import || job.state == Job::State::done) return;
            waiting_.reset();
            actions_.complain(
                {"the plot was not imported: no fixture file is substituted", job.title.toStdString()});
        });
    }

    Result<void> take(const std::vector<Substitute>& all) {
        if (!app_.show()) return Error{"no show is open", ""};
        if (app_.show()->file != app_.show()->plot_file) return substitute(app_, document_, all);
        const QString plot = QString::fromStdString(app_.show()->file.string());
        // Until the show is open, which may be long after it was made, the plot is what is seen.
        if (waiting_ && waiting_->folder == folder_for_plot(plot).toStdString()) {
            waiting_->all.insert(waiting_->all.end(), all.begin(), all.end());
            return {};
        }
        if (waiting_)
            return Error{"another plot is being imported: take it when that is done", plot.toStdString()};
        TRY_VOID(actions_.run("import-plot " + quoted(plot)));
        const Job& import = app_.jobs().all().back();
        if (import.is_over()) return Error{"the plot was not imported: no fixture file is substituted", ""};
        waiting_ = {import.number, folder_for_plot(plot).toStdString(), all};
        return {};
    }

private:
    struct Waiting {
        int import = 0; // number of the job
        std::filesystem::path folder;
        std::vector<Substitute> all;
    };

    void substitute_in_show(const Waiting& waiting) {
        std::error_code code;
        if (!std::filesystem::equivalent(app_.show()->folder, waiting.folder, code)) {
            actions_.complain(
                {"another show was opened: no fixture file is substituted", app_.show()->folder.string()});
            return;
        }
        if (const auto done = substitute(app_, document_, waiting.all); !done.ok())
            actions_.complain(done.error());
    }

    bool is_importing() const {
        const std::deque<Job>& jobs = app_.jobs().all();
        return waiting_ && std::any_of(jobs.begin(), jobs.end(), [&](const Job& job) {
                   return job.number == waiting_->import && !job.is_over();
               });
    }

    Actions& actions_;
    AppModel& app_;
    ShowDocument& document_;
    std::optional<Waiting> waiting_;
};

Result<const scene::PlotPage*> page_of(const PlotReport& report) {
    if (!report.page()) return Error{"no show is open, or it is still being looked through", ""};
    return report.page();
}

std::string some_words(const QStringList& words) {
    return words.join(' ').toStdString();
}

// What the page says about a file, or about a kind of fault.
Result<std::set<std::size_t>> fixtures_of(const scene::PlotPage& page, const std::string& words) {
    std::set<std::size_t> fixtures;
    for (const scene::LightlessType& type : page.lightless)
        if (type.wanted == words) fixtures.insert(type.fixtures.begin(), type.fixtures.end());
    for (const scene::PageGroup& group : page.groups)
        if (group.kind == words || group.title == words)
            fixtures.insert(group.fixtures.begin(), group.fixtures.end());
    if (fixtures.empty())
        return Error{"the page of the plot has no fixtures of a file, a kind or a title called so", words};
    return fixtures;
}

} // namespace

Result<void> substitute(AppModel& app, ShowDocument& document, const std::vector<Substitute>& all) {
    TRY_VOID(document.check_editable());
    std::vector<std::string> inside;
    for (const Substitute& one : all) {
        TRY(std::string file, PatchEdit(app, document).fixture_beside_show(one.file));
        inside.push_back(std::move(file));
    }
    std::string text = document.text(); // as it is when they are there
    for (std::size_t i = 0; i < all.size(); ++i) {
        TRY(text, scene::set_substitute(text, all[i].wanted, inside[i], all[i].mode));
    }
    const QString what =
        all.size() == 1
            ? translated("Undo", "'%1' substituted").arg(QString::fromStdString(all.front().wanted))
            : translated("Undo", "%n fixture file(s) substituted", nullptr, all.size());
    return document.edit(what, {std::move(text), app.look(), app.selection()});
}

void add_plot_actions(Actions& actions, AppModel& app, ShowDocument& document, const PlotReport& report) {
    auto* const after = new AfterImport(actions, app, document);
    actions.add({"substitute",
                 "Edit",
                 translated("Action", "Substitute fixture files"),
                 "",
                 "[FOR FILE [MODE]]",
                 [&actions, &app, after](const QStringList& words) -> Result<void> {
                     if (words.size() == 1)
                         return Error{"it needs the file to stand in, too", words[0].toStdString()};
                     if (words.isEmpty()) {
                         if (!app.show()) return Error{"no show is open", ""};
                         return actions.run("panel-plot on");
                     }
                     return after->take(
                         {{words[0].toStdString(), words[1].toStdString(), words.value(2).toStdString()}});
                 },
                 {}});
    actions.add(
        {"substitute-same",
         "",
         "substitute-same",
         "",
         "",
         [after, &report](const QStringList&) -> Result<void> {
             TRY(const scene::PlotPage* const page, page_of(report));
             std::vector<Substitute> all;
             for (const scene::LightlessType& type : page->lightless)
                 if (!type.stand_ins.empty() && type.stand_ins.front().seems_same)
                     all.push_back({type.wanted, type.stand_ins.front().file, type.stand_ins.front().mode});
             if (all.empty()) return Error{"there is no fixture file that seems to be the same", ""};
             return after->take(all);
         },
         {}});
    actions.add({"plot-select",
                 "",
                 "plot-select",
                 "",
                 "FILE|KIND",
                 [&app, &report](const QStringList& words) -> Result<void> {
                     TRY(const scene::PlotPage* const page, page_of(report));
                     TRY(std::set<std::size_t> fixtures, fixtures_of(*page, some_words(words)));
                     app.select(std::move(fixtures));
                     return {};
                 },
                 {}});
    actions.add({"plot-copy",
                 "",
                 "plot-copy",
                 "",
                 "",
                 [&report](const QStringList&) -> Result<void> {
                     TRY(const scene::PlotPage* const page, page_of(report));
                     QGuiApplication::clipboard()->setText(QString::fromStdString(text_of(*page)));
                     return {};
                 },
                 {}});
    actions.add({"plot-text",
                 "Show",
                 translated("Action", "Save what the plot has as text..."),
                 "",
                 "FILE",
                 [&report](const QStringList& words) -> Result<void> {
                     TRY(const scene::PlotPage* const page, page_of(report));
                     return write_file_atomic(words.value(0).toStdString(), text_of(*page));
                 },
                 {},
                 {translated("Files", "What the plot has, as text"), translated("Files", "Text (*.txt)"),
                  "plot.txt"}});
}

} // namespace ghost::ui
