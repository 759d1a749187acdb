// SPDX-License-Identifier: Apache-2.0
#include "ui/window/substitute.h"

#include "base/text.h"
#include "diagnose/doctor_substitute.h"
#include "fixture/values.h"
#include "show/show.h"
#include "show_file/substitute_edit.h"
#include "ui/actions/patch_edit.h"
#include "ui/model/fixture_groups.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace ghost::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOffers = 500;

void add_files(const fs::path& folder, std::vector<fs::path>& files) {
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
        const std::string ending = lower(entry->path().extension().string());
        if ((ending == ".gdtf" || ending == ".qxf") && files.size() < kMostOffers)
            files.push_back(entry->path());
    }
}

// The likest first.
std::vector<fs::path> offers_for(const QString& wanted, const std::vector<fs::path>& files) {
    std::vector<fs::path> offers = files;
    const auto likeness = [&](const fs::path& file) {
        return scene::likeness(wanted.toStdString(), file.filename().string());
    };
    std::stable_sort(offers.begin(), offers.end(),
                     [&](const fs::path& a, const fs::path& b) { return likeness(a) > likeness(b); });
    std::erase_if(offers,
                  [&](const fs::path& one) { return one.filename().string() == wanted.toStdString(); });
    return offers;
}

} // namespace

Result<void> substitute(AppModel& app, ShowDocument& document, const std::string& wanted,
                        const fs::path& file) {
    TRY_VOID(document.check_editable());
    TRY(const std::string inside, PatchEdit(app, document).fixture_beside_show(file));
    TRY(std::string text, scene::set_substitute(document.text(), wanted, inside));
    return document.edit("Substitute '" + QString::fromStdString(wanted) + "'",
                         {std::move(text), app.look(), app.selection()});
}

SubstituteDialog::SubstituteDialog(Actions& actions, AppModel& app, const std::string& library,
                                   QWidget* parent)
    : QDialog(parent), actions_(actions), app_(app), library_(library), table_(new QTableWidget(0, 3, this)) {
    setWindowTitle("Substitute fixture files");
    setAttribute(Qt::WA_DeleteOnClose);
    auto* words =
        new QLabel("These files of the plot say nothing of their light: their heads shine by a beam that "
                   "was assumed, or not at all. Another file can stand in; the plot itself stays as it is.",
                   this);
    words->setWordWrap(true);
    table_->setAccessibleName("Files without optics");
    table_->setHorizontalHeaderLabels({"File of the plot", "Heads", "Stands in"});
    table_->verticalHeader()->hide();
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addWidget(table_);
    resize(720, 360);
    connect(&app_, &AppModel::opened_show, this, &SubstituteDialog::fill);
    fill();
}

void SubstituteDialog::fill() {
    table_->setRowCount(0);
    if (!app_.show()) return;
    std::vector<fs::path> files;
    add_files(app_.show()->folder, files);
    add_files(library_, files);
    for (const FixtureGroup& group : without_optics(*app_.show())) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        table_->setItem(row, 0, new QTableWidgetItem(group.title));
        table_->setItem(row, 1, new QTableWidgetItem(QString::number(group.fixtures.size())));
        auto* choice = new QComboBox(table_);
        choice->setAccessibleName("Stands in for " + group.title);
        choice->addItem("as it is");
        for (const fs::path& offer : offers_for(group.title, files))
            choice->addItem(QString::fromStdString(offer.filename().string()),
                            QString::fromStdString(offer.string()));
        choice->addItem("Another file ...");
        table_->setCellWidget(row, 2, choice);
        connect(choice, &QComboBox::activated, this, [this, choice, wanted = group.title](int index) {
            if (index == 0) return;
            QString file = choice->itemData(index).toString();
            if (file.isEmpty())
                file = QFileDialog::getOpenFileName(this, "A fixture that stands in", {},
                                                    "Fixtures (*.gdtf *.qxf *.json);;All files (*)");
            if (file.isEmpty()) choice->setCurrentIndex(0);
            // The row goes while its own list is told of.
            if (!file.isEmpty())
                QMetaObject::invokeMethod(
                    this,
                    [this, wanted, file] {
                        actions_.choose("substitute \"" + wanted + "\" \"" + file + "\"");
                    },
                    Qt::QueuedConnection);
        });
    }
}

void add_substitute_action(Actions& actions, AppModel& app, ShowDocument& document,
                           const std::string& library, QWidget& window) {
    actions.add({"substitute",
                 "Edit",
                 "Substitute fixture files",
                 "",
                 "[FOR FILE]",
                 [&actions, &app, &document, library, &window](const QStringList& words) -> Result<void> {
                     if (words.size() >= 2)
                         return substitute(app, document, words[0].toStdString(), words[1].toStdString());
                     if (!words.isEmpty())
                         return Error{"it needs the file to stand in, too", words[0].toStdString()};
                     TRY_VOID(document.check_editable());
                     if (without_optics(*app.show()).empty())
                         return Error{"all fixture files of the plot say what their light is", ""};
                     (new SubstituteDialog(actions, app, library, &window))->show();
                     return {};
                 },
                 {}});
}

} // namespace ghost::ui
