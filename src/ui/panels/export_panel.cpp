// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/export_panel.h"

#include "show/show.h"
#include "ui/actions/export_actions.h"
#include "ui/actions/exporter.h"
#include "ui/language/language.h"
#include "ui/widgets/theme.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QScrollArea>

#include <algorithm>
#include <set>

namespace ghost::ui {
namespace {

constexpr double kLongest_s = 99999; // of a film; scripts take more

QString job_words(const Job& job) {
    QString words = "<b>" + job.title.toHtmlEscaped() + "</b>: ";
    if (job.is_given_up && !job.is_over()) return words + translated("Jobs", "stopping");
    if (job.state == Job::State::runs) {
        words += job.doing.isEmpty() ? translated("Jobs", "begins") : said(job.doing).toHtmlEscaped();
        if (!job.left.isEmpty()) words += translated("Jobs", ", %1 left").arg(job.left);
        return words;
    }
    words += outcome_words(job).toHtmlEscaped();
    if (job.state == Job::State::cancelled && is_on_farm(job))
        words += ". " + said(job.last_said).toHtmlEscaped();
    return words;
}

QSpinBox* number_box(int low, int high, int value, const QString& name, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setRange(low, high);
    box->setValue(value);
    box->setAccessibleName(name);
    return box;
}

// Who does it: this machine, or a farm.
QComboBox* maker_box(const QString& name, QWidget* parent) {
    auto* box = new QComboBox(parent);
    box->addItem(translated("Export", "This machine"), "");
    box->addItem(translated("Export", "A farm (Slurm)"), " slurm");
    box->setToolTip(translated(
        "Export", "A farm cuts it into tasks for many machines, which must see the show under the same "
                  "path. Its partition: "
                  "SBATCH_PARTITION in the environment. Cancel stops following it only."));
    box->setAccessibleName(name);
    return box;
}

} // namespace

ExportPanel::ExportPanel(AppModel& app, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), actions_(actions) {
    auto* inside = new QWidget(this);
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(make_bake());
    layout->addWidget(make_pictures());
    list_ = new QVBoxLayout;
    layout->addLayout(list_);
    layout->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    for (QGroupBox* const box : inside->findChildren<QGroupBox*>()) {
        box->setEnabled(false); // there is nothing to draw
        connect(&app_, &AppModel::opened_show, box, [box] { box->setEnabled(true); });
    }
    connect(&app_, &AppModel::opened_show, this, &ExportPanel::name_cameras);
    connect(&app_.jobs(), &Jobs::changed, this, &ExportPanel::show_jobs);
}

QWidget* ExportPanel::make_bake() {
    auto* box = new QGroupBox(translated("Export", "Bake"), this);
    box->setToolTip(translated(
        "Export",
        "The final picture of a fixed camera, lit live. What is finished stays if it is cancelled."));
    auto* form = new QFormLayout(box);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    bake_camera_ = new QComboBox(box);
    bake_camera_->setAccessibleName(translated("Export", "Camera to bake"));
    spp_ = number_box(1, 1024, 16, translated("Export", "Samples per pixel"), box);
    bounces_ = number_box(0, 16, 0, translated("Export", "Bounces of indirect light"), box);
    auto* button = new QPushButton(translated("Export", "Bake"), box);
    connect(button, &QPushButton::clicked, this, [this] {
        if (can_begin && !can_begin()) return;
        const QString camera =
            bake_camera_->currentIndex() <= 0 ? QString("all") : quoted(bake_camera_->currentText());
        run("bake " + camera + QString(" %1 %2").arg(spp_->value()).arg(bounces_->value()) +
            bake_by_->currentData().toString());
    });
    bake_by_ = maker_box(translated("Export", "Who bakes"), box);
    form->addRow(translated("Export", "Camera"), bake_camera_);
    form->addRow(translated("Export", "Samples"), spp_);
    form->addRow(translated("Export", "Bounces"), bounces_);
    form->addRow(translated("Export", "By"), bake_by_);
    form->addRow(button);
    return box;
}

QWidget* ExportPanel::make_pictures() {
    auto* box = new QGroupBox(translated("Export", "Pictures"), this);
    auto* form = new QFormLayout(box);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    camera_ = new QComboBox(box);
    camera_->setToolTip(
        translated("Export", "As the window sees it: drawn live. A camera of the show: from its passes."));
    camera_->setAccessibleName(translated("Export", "Camera of pictures"));
    size_ = new QComboBox(box);
    size_->setEditable(true);
    size_->addItems({"1920x1080", "1280x720", "3840x2160", "7680x4320"});
    size_->setAccessibleName(translated("Export", "Size of pictures"));
    for (QComboBox* one : {bake_camera_, camera_, size_}) {
        one->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        one->setMinimumContentsLength(8);
    }
    from_ = new QDoubleSpinBox(box);
    to_ = new QDoubleSpinBox(box);
    for (QDoubleSpinBox* seconds : {from_, to_}) {
        seconds->setRange(0, kLongest_s);
        seconds->setSuffix(" s");
        seconds->setDecimals(1);
    }
    from_->setAccessibleName(translated("Export", "Begin of the film"));
    to_->setAccessibleName(translated("Export", "End of the film"));
    fps_ = number_box(1, 240, 30, translated("Export", "Pictures a second"), box);
    auto* still = new QPushButton(translated("Export", "Still..."), box);
    auto* film = new QPushButton(translated("Export", "Film..."), box);
    auto* sheet = new QPushButton(translated("Export", "Contact sheet..."), box);
    sheet->setToolTip(translated("Export", "All looks from all cameras; without looks, the cues"));
    // Before a file is asked for, which would be for nothing.
    const auto can_be = [this](const Result<void>& done) {
        if (!done.ok()) actions_.complain(done.error());
        return done.ok();
    };
    const auto of_what = [this] {
        return quoted(camera_->currentIndex() <= 0 ? size_->currentText() : camera_->currentText());
    };
    connect(still, &QPushButton::clicked, this, [this, can_be, of_what] {
        if (camera_->currentIndex() <= 0 && !can_be(check_picture_of(app_, size_->currentText()))) return;
        run_with_file("export-still",
                      {translated("Export", "Save a still"), translated("Files", "Pictures (*.png *.exr)"),
                       "still.png"},
                      of_what());
    });
    connect(film, &QPushButton::clicked, this, [this, can_be, of_what] {
        if (const auto size = size_of(size_->currentText());
            camera_->currentIndex() <= 0 && !can_be(size.ok() ? Result<void>() : size.error()))
            return;
        run_with_file("export-film",
                      {translated("Export", "Save a film"), translated("Files", "Films (*.mp4)"), "film.mp4"},
                      QString("%1 %2 %3 ").arg(from_->value()).arg(to_->value()).arg(fps_->value()) +
                          of_what() + film_by_->currentData().toString());
    });
    connect(sheet, &QPushButton::clicked, this, [this] {
        run_with_file("export-sheet",
                      {translated("Export", "Save a contact sheet"), translated("Files", "Pictures (*.png)"),
                       "sheet.png"},
                      "");
    });
    auto* range = new QHBoxLayout;
    range->addWidget(from_);
    range->addWidget(new QLabel(translated("Export", "to"), box));
    range->addWidget(to_);
    form->addRow(translated("Export", "Camera"), camera_);
    form->addRow(translated("Export", "Size"), size_);
    form->addRow(translated("Export", "Film"), range);
    form->addRow(translated("Export", "Its rate"), fps_);
    film_by_ = maker_box(translated("Export", "Who draws films"), box);
    form->addRow(translated("Export", "By"), film_by_);
    fps_->setSuffix(translated("Export", " a second"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {still, film}) buttons->addWidget(button);
    form->addRow(buttons);
    form->addRow(sheet);
    return box;
}

void ExportPanel::run(const QString& line) {
    actions_.choose(line);
}

void ExportPanel::run_with_file(const QString& action, const FileQuestion& asks, const QString& arguments) {
    if (can_begin && !can_begin()) return;
    const QString file = actions_.ask_file(asks, this);
    if (!file.isEmpty()) run(action + " " + quoted(file) + " " + arguments);
}

void ExportPanel::name_cameras() {
    const auto fill = [this](QComboBox* box, const QString& first) {
        const QString before = box->currentText();
        const int place = box->currentIndex(), count = box->count();
        box->clear();
        box->addItem(first);
        for (const scene::Camera& camera : app_.show()->cameras)
            box->addItem(QString::fromStdString(camera.name));
        // One that is not there any more was renamed, where an edit left as many.
        const int now = place > 0 ? box->findText(before) : 0;
        const bool is_renamed = now < 0 && app_.opened().is_edit && box->count() == count;
        box->setCurrentIndex(is_renamed ? place : std::max(now, 0));
    };
    fill(bake_camera_, translated("Export", "All cameras"));
    fill(camera_, translated("Export", "As the window sees it"));
    if (app_.opened().is_edit) return;
    if (!app_.opened().again) from_->setValue(0);
    to_->setValue(app_.opened().recording_s);
}

ExportPanel::Row ExportPanel::add_row(const Job& job) {
    Row row{};
    row.widget = new QWidget(this);
    auto* layout = new QVBoxLayout(row.widget);
    layout->setContentsMargins(0, 4, 0, 4);
    row.words = new QLabel(row.widget);
    row.words->setTextFormat(Qt::RichText);
    row.words->setWordWrap(true);
    row.bar = new QProgressBar(row.widget);
    row.bar->setRange(0, 1000);
    row.bar->setTextVisible(false);
    row.cancel = new QPushButton(translated("Export", "Cancel"), row.widget);
    connect(row.cancel, &QPushButton::clicked, this,
            [this, number = job.number] { app_.jobs().cancel(number); });
    auto* line = new QHBoxLayout;
    line->addWidget(row.bar, 1);
    line->addWidget(row.cancel);
    layout->addWidget(row.words);
    layout->addLayout(line);
    list_->insertWidget(0, row.widget); // the newest on top
    return row;
}

void ExportPanel::show_jobs() {
    std::set<int> there;
    for (const Job& job : app_.jobs().all()) {
        there.insert(job.number);
        if (!rows_.contains(job.number)) rows_[job.number] = add_row(job);
        const Row& row = rows_.at(job.number);
        row.words->setText(job_words(job));
        row.words->setToolTip(said(job.last_said));
        row.bar->setValue(static_cast<int>(1000 * job.share));
        row.bar->setVisible(!job.is_over());
        row.cancel->setVisible(!job.is_over());
        row.cancel->setEnabled(!job.is_given_up);
    }
    for (auto row = rows_.begin(); row != rows_.end();) {
        if (there.contains(row->first)) {
            ++row;
            continue;
        }
        delete row->second.widget;
        row = rows_.erase(row);
    }
}

} // namespace ghost::ui
