// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/print_dialog.h"

#include "show/looks.h"
#include "show/show.h"
#include "ui/language/language.h"

#include <QDesktopServices>
#include <QDir>
#include <QDoubleValidator>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontMetrics>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QImageReader>
#include <QJsonArray>
#include <QJsonObject>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kMostPictures = 24, kMostChangesShown = 2;
constexpr int kLeastLetters = 16, kBesideLetters_px = 8;
constexpr qsizetype kMostLinesShown = 6;
constexpr QSize kPreview(240, 135);
constexpr double kFarthest_m = 10'000; // of a section, as the command takes it
constexpr std::array<std::pair<const char*, const char*>, 4> kMetricScales{
    {{"1:25", "1:25"}, {"1:50", "1:50"}, {"1:100", "1:100"}, {"1:200", "1:200"}}};
constexpr std::array<std::pair<const char*, const char*>, 4> kImperialScales{{{"1/2\" = 1'-0\"", "1:24"},
                                                                              {"1/4\" = 1'-0\"", "1:48"},
                                                                              {"1/8\" = 1'-0\"", "1:96"},
                                                                              {"1/16\" = 1'-0\"", "1:192"}}};

// As wide as the longest of what it lists where there is room; less on a small display.
class Choice : public QComboBox {
public:
    using QComboBox::QComboBox;
    QSize sizeHint() const override {
        int letters_px = 0;
        for (int i = 0; i < count(); ++i)
            letters_px = std::max(letters_px, fontMetrics().horizontalAdvance(itemText(i)));
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const QSize letters(letters_px + kBesideLetters_px, fontMetrics().height());
        return style()
            ->sizeFromContents(QStyle::CT_ComboBox, &option, letters, this)
            .expandedTo(QComboBox::sizeHint());
    }
};

// Likewise as wide as what it says while nothing stands in it.
class Line : public QLineEdit {
public:
    using QLineEdit::QLineEdit;
    QSize sizeHint() const override {
        const int letters_px = fontMetrics().horizontalAdvance(placeholderText()) + 2 * kBesideLetters_px;
        return QLineEdit::sizeHint().expandedTo({letters_px, 0});
    }
};

class Choices : public QScrollArea {
public:
    using QScrollArea::QScrollArea;
    QSize sizeHint() const override {
        return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0);
    }
};

QComboBox* choice(const QString& name, std::initializer_list<std::pair<const char*, const char*>> words,
                  QWidget* parent) {
    auto* box = new Choice(parent);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // small displays, long words
    box->setMinimumContentsLength(kLeastLetters);
    for (const auto& [text, option] : words) box->addItem(translated("Print", text), option);
    box->setAccessibleName(name);
    return box;
}

// Lines to read and to copy, of no more height than they need, up to six.
QPlainTextEdit* lines_of(const QString& name, QWidget* parent) {
    auto* lines = new QPlainTextEdit(parent);
    lines->setReadOnly(true);
    lines->setTabChangesFocus(true);
    lines->setAccessibleName(name);
    lines->hide();
    return lines;
}

void put(QPlainTextEdit& lines, const QStringList& sentences) {
    lines.setPlainText(sentences.join('\n'));
    lines.setVisible(!sentences.isEmpty());
    const int rows = static_cast<int>(std::clamp<qsizetype>(2 * sentences.size(), 2, kMostLinesShown));
    lines.setFixedHeight(rows * lines.fontMetrics().lineSpacing() + 12);
}

// Number and name of an entry, and the first two of its changes.
QStringList words_of(const QJsonObject& entry) {
    const QString number = entry["number"].toString();
    QStringList lines{(number.isEmpty() ? "" : number + ". ") + entry["name"].toString()};
    for (const QJsonValue& change : entry["changes"].toArray()) {
        if (lines.size() > kMostChangesShown) break;
        const QString fixtures = change["fixtures"].toVariant().toStringList().join(", ");
        lines << (fixtures.isEmpty() ? "" : fixtures + ": ") + change["what"].toString();
    }
    return lines;
}

// As wide as it asks, as high as there is room.
QScrollArea* scrolled(QWidget* content, QWidget* parent) {
    auto* area = new Choices(parent);
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(content->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width());
    return area;
}

} // namespace

void add_print_actions(Actions& actions, AppModel& app, ShowDocument& document, QWidget& window) {
    const auto add = [&](const char* name, const QString& text, PrintDialog::What what) {
        actions.add({name,
                     "Show",
                     text,
                     "",
                     "",
                     [&actions, &app, &document, &window, what, name](const QStringList&) -> Result<void> {
                         if (!app.show()) return Error{"no show is open", ""};
                         auto* dialog = window.findChild<PrintDialog*>(name);
                         if (!dialog) {
                             dialog = new PrintDialog(what, app, document, actions, &window);
                             dialog->setObjectName(name);
                         }
                         dialog->show();
                         dialog->raise();
                         return {};
                     },
                     {}});
    };
    add("paperwork", translated("Action", "Paperwork..."), PrintDialog::What::paper);
    add("cue-book", translated("Action", "Cue book..."), PrintDialog::What::book);
}

PrintDialog::PrintDialog(What what, AppModel& app, ShowDocument& document, Actions& actions, QWidget* parent)
    : QDialog(parent), what_(what), app_(app), document_(document), was_changed_(document.is_changed()),
      actions_(actions) {
    if (QAction* const save = actions.item("save")) addAction(save);
    setWindowTitle(what == What::paper ? translated("Print", "Paperwork") : translated("Print", "Cue book"));
    // On a small display the choices scroll; the buttons and the progress below them are always seen.
    auto* choices = new QWidget;
    auto* form = new QFormLayout(choices);
    form->setContentsMargins(0, 0, 0, 0);
    folder_ = new QLineEdit(this);
    folder_->setAccessibleName(translated("Print", "Folder to make"));
    auto* choose = new QPushButton(translated("Print", "Choose..."), this);
    choose->setAccessibleName(translated("Print", "Choose the folder"));
    connect(choose, &QPushButton::clicked, this, [this] {
        const QString chosen =
            QFileDialog::getSaveFileName(this, translated("Print", "A folder to make"), folder_->text(), "",
                                         nullptr, QFileDialog::ShowDirsOnly);
        if (!chosen.isEmpty()) folder_->setText(chosen);
    });
    auto* place = new QHBoxLayout;
    place->addWidget(folder_, 1);
    place->addWidget(choose);
    form->addRow(translated("Print", "Folder"), place);
    pdf_ = new QCheckBox(
        what == What::paper ? translated("Print", "All tables as PDF") : translated("Print", "As PDF"), this);
    page_ = choice(translated("Print", "Page"), {{"A4", "A4"}, {"Letter", "Letter"}}, this);
    what == What::paper ? add_paper_choices(*form) : add_book_choices(*form);
    language_ = choice(translated("Print", "Language"), {{"English", "en"}, {"Deutsch", "de"}}, this);
    language_->setCurrentIndex(std::max(language_->findData(language()), 0));
    units_ = choice(translated("Print", "Units"),
                    {{QT_TRANSLATE_NOOP("Print", "Metres, kilograms"), "metric"},
                     {QT_TRANSLATE_NOOP("Print", "Feet, pounds"), "imperial"}},
                    this);
    connect(units_, &QComboBox::currentIndexChanged, this, &PrintDialog::offer_scales);
    offer_scales();
    form->addRow(translated("Print", "Language"), language_);
    form->addRow(translated("Print", "Units"), units_);
    form->addRow(translated("Print", "Page"), page_);
    form->addRow(pdf_);

    said_ = new QLabel(this);
    said_->setWordWrap(true);
    said_->setTextFormat(Qt::PlainText);
    bar_ = new QProgressBar(this);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(translated("Print", "Progress"));
    make_ = new QPushButton(translated("Print", "Make"), this);
    make_->setDefault(true);
    cancel_ = new QPushButton(translated("Print", "Cancel"), this);
    open_ = new QPushButton(translated("Print", "Open in the browser"), this);
    connect(make_, &QPushButton::clicked, this, &PrintDialog::make);
    connect(cancel_, &QPushButton::clicked, this, [this] { app_.jobs().cancel(job_); });
    connect(open_, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(QDir(made_).filePath("index.html"))); });
    open_folder_ = new QPushButton(translated("Print", "Open the folder"), this);
    connect(open_folder_, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(made_)); });
    auto* buttons = new QGridLayout;
    buttons->addWidget(make_, 0, 0);
    buttons->addWidget(cancel_, 0, 1);
    buttons->addWidget(open_, 1, 0);
    buttons->addWidget(open_folder_, 1, 1);
    auto* left = new QVBoxLayout;
    left->addWidget(scrolled(choices, this), 1);
    left->addWidget(said_);
    left->addWidget(bar_);
    left->addLayout(buttons);
    auto* whole = new QHBoxLayout(this);
    whole->addLayout(left);
    whole->addWidget(make_preview(), 1);
    constexpr int kFrame = 40; // and title of a window
    resize(QSize(1020, 560).boundedTo(screen()->availableSize() - QSize(kFrame, kFrame)));
    connect(&app_, &AppModel::opened_show, this, &PrintDialog::name_show);
    connect(&app_.jobs(), &Jobs::changed, this, &PrintDialog::follow);
    connect(&document_, &ShowDocument::changed, this, &PrintDialog::hear_of_save);
    connect(folder_, &QLineEdit::textEdited, said_, &QLabel::clear);
    connect(folder_, &QLineEdit::textChanged, folder_, &QWidget::setToolTip); // often longer than the line
    name_show();
    follow();
    show_empty();
}

void PrintDialog::add_paper_choices(QFormLayout& form) {
    plan_ = new QCheckBox(translated("Print", "Plan and section"), this);
    focus_ = new QCheckBox(translated("Print", "Focus charts"), this);
    scale_ = choice(translated("Print", "Scale"), {}, this);
    sheet_ = choice(translated("Print", "Sheet of the plan"),
                    {{QT_TRANSLATE_NOOP("Print", "As the page asks"), ""},
                     {"A4", "A4"},
                     {"A3", "A3"},
                     {"A2", "A2"},
                     {"A1", "A1"},
                     {"Letter", "Letter"},
                     {"Tabloid", "Tabloid"},
                     {"Arch D", "ArchD"}},
                    this);
    section_ = new Line(this);
    section_->setAccessibleName(translated("Print", "Where the section is cut"));
    section_->setPlaceholderText(translated("Print", "x in metres; empty: not cut"));
    auto* numbers = new QDoubleValidator(-kFarthest_m, kFarthest_m, 3, section_);
    numbers->setLocale(QLocale::c());
    numbers->setNotation(QDoubleValidator::StandardNotation);
    section_->setValidator(numbers);
    date_ = new Line(this);
    date_->setAccessibleName(translated("Print", "Date in the title block"));
    date_->setPlaceholderText(translated("Print", "printed as it is"));
    moment_ = choice(translated("Print", "Moment of the focus charts"), {}, this);
    const auto belongs = [](QCheckBox* to, std::initializer_list<QWidget*> choices) {
        for (QWidget* const one : choices) {
            one->setEnabled(false);
            connect(to, &QCheckBox::toggled, one, &QWidget::setEnabled);
        }
    };
    belongs(plan_, {scale_, sheet_, section_, date_});
    belongs(focus_, {moment_});
    form.addRow(plan_);
    form.addRow(translated("Print", "Scale"), scale_);
    form.addRow(translated("Print", "Sheet"), sheet_);
    form.addRow(translated("Print", "Section"), section_);
    form.addRow(translated("Print", "Date"), date_);
    form.addRow(focus_);
    form.addRow(translated("Print", "Moment"), moment_);
}

// Those of the ruler that goes with the units.
void PrintDialog::offer_scales() {
    if (!scale_) return;
    scale_->clear();
    scale_->addItem(translated("Print", "Largest that fits"), "fit");
    const bool is_metric = units_->currentData().toString() == "metric";
    for (const auto& [text, scale] : is_metric ? kMetricScales : kImperialScales)
        scale_->addItem(text, scale);
}

// data: the option of the command and its value.
void PrintDialog::offer_moments() {
    if (!moment_) return;
    const QVariant chosen = moment_->currentData();
    moment_->clear();
    moment_->addItem(translated("Print", "Nothing is sent"), QStringList{"", ""});
    for (const scene::Cue& cue : app_.show()->cues) {
        const QString name = QString::fromStdString(cue.name);
        moment_->addItem(translated("Print", "Cue %1").arg(name), QStringList{"--cue", name});
    }
    Report unheard; // the job says it
    const auto looks = scene::load_looks(scene::looks_file(*app_.show()), unheard);
    if (looks.ok())
        for (const scene::StoredLook& look : *looks) {
            const QString name = QString::fromStdString(look.name);
            moment_->addItem(translated("Print", "Look %1").arg(name), QStringList{"--look", name});
        }
    moment_->setCurrentIndex(std::max(moment_->findData(chosen), 0));
}

void PrintDialog::add_book_choices(QFormLayout& form) {
    entries_ = choice(translated("Print", "Entries"),
                      {{QT_TRANSLATE_NOOP("Print", "Cues, else looks"), ""},
                       {QT_TRANSLATE_NOOP("Print", "Cues"), "--cues"},
                       {QT_TRANSLATE_NOOP("Print", "Looks"), "--looks"},
                       {QT_TRANSLATE_NOOP("Print", "Where the recording rests"), "--find"},
                       {QT_TRANSLATE_NOOP("Print", "Marks in a CSV file"), "--marks"}},
                      this);
    marks_ = new Line(this);
    marks_->setAccessibleName(translated("Print", "File of the marks"));
    marks_->setPlaceholderText(translated("Print", "time, number, name, note"));
    auto* choose = new QPushButton(translated("Print", "Choose..."), this);
    choose->setAccessibleName(translated("Print", "Choose the file of the marks"));
    connect(choose, &QPushButton::clicked, this, [this] {
        const QString chosen =
            QFileDialog::getOpenFileName(this, translated("Print", "Marks in a CSV file"), marks_->text());
        if (!chosen.isEmpty()) marks_->setText(chosen);
    });
    auto* marks = new QHBoxLayout;
    marks->addWidget(marks_, 1);
    marks->addWidget(choose);
    const auto ask_for_marks = [this, choose] {
        for (QWidget* const one : std::initializer_list<QWidget*>{marks_, choose})
            one->setEnabled(takes_marks());
    };
    connect(entries_, &QComboBox::currentIndexChanged, this, ask_for_marks);
    ask_for_marks();
    camera_ = choice(translated("Print", "Camera"), {}, this);
    size_ = choice(translated("Print", "Size of pictures"),
                   {{"640x360", "640x360"}, {"480x270", "480x270"}, {"1280x720", "1280x720"}}, this);
    layout_ = choice(translated("Print", "Layout"),
                     {{QT_TRANSLATE_NOOP("Print", "Four on a page, with what changes"), "list"},
                      {QT_TRANSLATE_NOOP("Print", "Twelve on a page"), "grid"}},
                     this);
    against_ = new Line(this);
    against_->setAccessibleName(translated("Print", "An older show, plot or book to compare with"));
    against_->setPlaceholderText(translated("Print", "an older show, plot or book"));
    form.addRow(translated("Print", "Entries"), entries_);
    form.addRow(translated("Print", "Marks"), marks);
    form.addRow(translated("Print", "Camera"), camera_);
    form.addRow(translated("Print", "Pictures"), size_);
    form.addRow(translated("Print", "Layout"), layout_);
    form.addRow(translated("Print", "Compare with"), against_);
}

QWidget* PrintDialog::make_preview() {
    auto* preview = new QWidget(this);
    auto* layout = new QVBoxLayout(preview);
    layout->setContentsMargins(0, 0, 0, 0);
    unknown_ = lines_of(translated("Print", "What is left empty, and why"), preview);
    remarks_ = lines_of(translated("Print", "Remarks"), preview);
    empty_ = new QLabel(translated("Print", "What is made is shown here."), preview);
    empty_->setAlignment(Qt::AlignCenter);
    if (what_ == What::book) {
        pictures_ = new QListWidget(preview);
        pictures_->setAccessibleName(translated("Print", "Pictures of the book"));
        pictures_->setViewMode(QListView::IconMode);
        pictures_->setIconSize(kPreview);
        pictures_->setMovement(QListView::Static);
        pictures_->setResizeMode(QListView::Adjust);
        pictures_->setSpacing(6);
        layout->addWidget(empty_, 1);
        layout->addWidget(unknown_);
        layout->addWidget(pictures_, 1);
        layout->addWidget(remarks_);
        return preview;
    }
    tables_ = new QComboBox(preview);
    tables_->setAccessibleName(translated("Print", "Table to look at"));
    table_ = new QTableWidget(preview);
    table_->setTabKeyNavigation(false); // Tab leaves it
    table_->setAccessibleName(translated("Print", "Preview of the table"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->hide();
    layout->addWidget(empty_, 1);
    layout->addWidget(tables_);
    layout->addWidget(unknown_);
    layout->addWidget(table_, 1);
    layout->addWidget(remarks_);
    connect(tables_, &QComboBox::currentIndexChanged, this, &PrintDialog::show_table);
    return preview;
}

void PrintDialog::name_show() {
    if (!app_.show()) return;
    const QDir folder = QFileInfo(QString::fromStdString(app_.show()->file.string())).absoluteDir();
    const QString beside = folder.filePath(what_ == What::paper ? "paper" : "book");
    if (folder_->text() == proposed_) folder_->setText(beside); // else somebody typed it
    proposed_ = beside;
    offer_moments();
    if (!camera_) return;
    const QVariant chosen = camera_->currentData(); // an edit opens the show anew
    camera_->clear();
    camera_->addItem(translated("Print", "Where the cues put the picture"), "");
    for (const scene::Camera& camera : app_.show()->cameras) {
        const QString name = QString::fromStdString(camera.name);
        camera_->addItem(name, name);
    }
    camera_->setCurrentIndex(std::max(camera_->findData(chosen), 0));
}

bool PrintDialog::takes_marks() const {
    return entries_->currentData().toString() == "--marks";
}

QString PrintDialog::options() const {
    QStringList words;
    const auto add = [&](const QString& option, const QString& value) {
        if (!value.isEmpty()) words << option << quoted(value);
    };
    add("--paper", page_->currentData().toString());
    add("--language", language_->currentData().toString());
    add("--units", units_->currentData().toString());
    if (pdf_->isChecked()) words << "--pdf";
    if (what_ == What::book) {
        if (takes_marks())
            add("--marks", marks_->text());
        else if (const QString kind = entries_->currentData().toString(); !kind.isEmpty())
            words << kind;
        add("--view", camera_->currentData().toString());
        add("--size", size_->currentData().toString());
        add("--layout", layout_->currentData().toString());
        add("--against", against_->text());
        return words.join(' ');
    }
    if (focus_->isChecked()) {
        words << "--focus";
        const QStringList moment = moment_->currentData().toStringList();
        add(moment[0], moment[1]);
    }
    if (plan_->isChecked()) {
        words << "--plan";
        add("--scale", scale_->currentData().toString());
        add("--sheet", sheet_->currentData().toString());
        add("--section", section_->text().trimmed());
        add("--date", date_->text());
    }
    return words.join(' ');
}

void PrintDialog::forget_result() {
    printed_.clear();
    if (tables_) {
        tables_->clear();
        show_table();
    }
    if (pictures_) pictures_->clear();
    for (QPlainTextEdit* const lines : {unknown_, remarks_}) put(*lines, {});
    show_empty();
}

// Until something is made, and where nothing came of it.
void PrintDialog::show_empty() {
    const bool is_empty = pictures_ ? pictures_->count() == 0 : printed_.empty();
    empty_->setVisible(is_empty);
    for (QWidget* const one : std::initializer_list<QWidget*>{tables_, table_, pictures_})
        if (one) one->setVisible(!is_empty);
}

// What was said of a show that is not saved does not hold any more.
void PrintDialog::hear_of_save() {
    if (!std::exchange(was_changed_, document_.is_changed()) || was_changed_ || !make_->isEnabled()) return;
    said_->setText(
        translated("Notice", "Saved: %1").arg(QString::fromStdString(app_.show()->file.filename().string())));
}

void PrintDialog::make() {
    forget_result();
    if (folder_->text().trimmed().isEmpty()) {
        said_->setText(translated("Print", "Say in which folder it is to lie."));
        folder_->setFocus();
        return;
    }
    const QString command = what_ == What::paper ? "export-paper " : "export-book ";
    const Result<void> begun = actions_.run(command + quoted(folder_->text()) + " " + options());
    if (!begun.ok()) {
        said_->setText(said(begun.error().text()));
        return;
    }
    made_ = folder_->text();
    job_ = app_.jobs().all().back().number;
    is_shown_ = false;
    follow();
}

void PrintDialog::follow() {
    const auto& jobs = app_.jobs().all();
    const auto job =
        std::find_if(jobs.begin(), jobs.end(), [this](const Job& one) { return one.number == job_; });
    const bool runs = job != jobs.end() && !job->is_over();
    const bool is_done = job != jobs.end() && job->state == Job::State::done;
    make_->setEnabled(!runs);
    cancel_->setEnabled(runs && !job->is_given_up);
    bar_->setVisible(runs);
    open_->setEnabled(is_done);
    open_folder_->setEnabled(is_done);
    if (job == jobs.end()) return;
    bar_->setValue(static_cast<int>(1000 * job->share));
    QString words = job->is_given_up && runs ? translated("Jobs", "stopping")
                                             : translated("Jobs", state_name(job->state));
    if (runs && !job->doing.isEmpty()) words += ": " + said(job->doing);
    if (runs && !job->left.isEmpty()) words += translated("Jobs", ", %1 left").arg(job->left);
    if (job->state == Job::State::failed) words += ": " + said(job->last_said);
    if (is_done && job->remark_count > 0)
        words += translated("Print", ", with %n remark(s)", nullptr, job->remark_count);
    said_->setText(words);
    QStringList remarks;
    for (const QString& remark : job->remarks) remarks << said(remark);
    put(*remarks_, remarks);
    if (is_done && !is_shown_) show_result();
}

void PrintDialog::show_result() {
    is_shown_ = true;
    if (what_ == What::book) {
        show_pictures();
        show_empty();
        return;
    }
    const QString before = tables_->currentText();
    tables_->clear();
    printed_ = printed_tables(made_);
    for (const PrintedTable& table : printed_) tables_->addItem(table.title);
    tables_->setCurrentIndex(std::max(tables_->findText(before), 0));
    show_empty();
}

void PrintDialog::show_table() {
    table_->clear();
    table_->setRowCount(0);
    table_->setColumnCount(0);
    put(*unknown_, {});
    const auto index = static_cast<std::size_t>(tables_->currentIndex());
    if (index >= printed_.size()) return;
    QStringList sentences = printed_[index].unknown;
    const PrintedRows printed = printed_rows(printed_[index].file);
    const std::vector<QStringList>& rows = printed.rows;
    if (!printed.is_whole)
        sentences << translated("Print", "Here are the first %1 rows; all are in the folder.")
                         .arg(std::max<std::size_t>(rows.size(), 1) - 1);
    put(*unknown_, sentences);
    if (rows.empty()) return;
    table_->setColumnCount(static_cast<int>(rows.front().size()));
    table_->setRowCount(static_cast<int>(rows.size()) - 1);
    table_->setHorizontalHeaderLabels(rows.front());
    for (std::size_t row = 1; row < rows.size(); ++row)
        for (qsizetype column = 0; column < rows[row].size(); ++column)
            table_->setItem(static_cast<int>(row) - 1, static_cast<int>(column),
                            new QTableWidgetItem(rows[row][column]));
    table_->resizeColumnsToContents();
}

void PrintDialog::show_pictures() {
    pictures_->clear();
    const PrintedBook book = printed_book(made_);
    QStringList sentences = book.unknown;
    if (book.entries.size() > kMostPictures)
        sentences << translated("Print", "Here are the first %1 of %2 entries; all are in the folder.")
                         .arg(kMostPictures)
                         .arg(book.entries.size());
    put(*unknown_, sentences);
    for (const QJsonValue& entry : book.entries) {
        if (pictures_->count() == kMostPictures) break;
        const QString file = entry["pictures"].toArray().first().toObject()["file"].toString();
        QImageReader reader(QDir(made_).filePath(file));
        reader.setScaledSize(reader.size().scaled(kPreview, Qt::KeepAspectRatio));
        QStringList words = words_of(entry.toObject());
        auto* const item = new QListWidgetItem(QIcon(QPixmap::fromImage(reader.read())), "", pictures_);
        item->setToolTip(words.join('\n')); // what is shortened below the picture
        for (QString& line : words)
            line = pictures_->fontMetrics().elidedText(line, Qt::ElideRight, kPreview.width());
        item->setText(words.join('\n'));
    }
}

} // namespace ghost::ui
