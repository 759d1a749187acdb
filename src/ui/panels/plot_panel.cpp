// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/plot_panel.h"

#include "ui/language/language.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/wrapped_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr std::size_t kMostRows = 50;   // of files, each with widgets; as many have suggestions
constexpr int kFixtures = Qt::UserRole; // role: which ones a line is about

QString heads(std::size_t count) {
    return translated("Plot", "%n head(s)", nullptr, count);
}

} // namespace

PlotPanel::PlotPanel(AppModel& app, const PlotReport& report, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), report_(report), actions_(actions), title_(new QLabel(this)),
      tree_(new QTreeWidget(this)),
      same_(new QPushButton(translated("Plot", "Take what seems the same"), this)),
      select_(new QPushButton(translated("Plot", "Select these"), this)),
      copy_(new QPushButton(translated("Plot", "Copy"), this)),
      save_(new QPushButton(translated("Plot", "Save as text..."), this)) {
    title_->setWordWrap(true);
    title_->setTextFormat(Qt::PlainText);
    tree_->setAccessibleName(translated("Plot", "What the plot has"));
    tree_->setHeaderHidden(true);
    tree_->setWordWrap(true);
    tree_->setIndentation(14);
    tree_->setTextElideMode(Qt::ElideMiddle);
    tree_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->setItemDelegate(new WrappedText(tree_));
    tree_->setToolTip(
        translated("Plot", "Double click or Enter: the fixtures that it is about are selected."));
    same_->setToolTip(
        translated("Plot", "For each file the one whose name says that it is the same fixture"));
    select_->setToolTip(
        translated("Plot", "The fixtures that the chosen line is about, ringed in the picture"));
    copy_->setToolTip(translated("Plot", "All of it as text, for a mail"));
    auto* buttons = new QGridLayout;
    buttons->addWidget(same_, 0, 0, 1, 2);
    buttons->addWidget(select_, 1, 0, 1, 2);
    buttons->addWidget(copy_, 2, 0);
    buttons->addWidget(save_, 2, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(title_);
    layout->addWidget(tree_, 1);
    layout->addLayout(buttons);
    connect(&report_, &PlotReport::changed, this, &PlotPanel::fill);
    connect(tree_, &QTreeWidget::currentItemChanged, this, &PlotPanel::refresh);
    connect(tree_, &QTreeWidget::itemActivated, this, &PlotPanel::select_these);
    connect(select_, &QPushButton::clicked, this, &PlotPanel::select_these);
    for (const auto& [button, line] :
         {std::pair{same_, "substitute-same"}, {copy_, "plot-copy"}, {save_, "plot-text"}})
        connect(button, &QPushButton::clicked, this, [this, line] { actions_.choose(line); });
    fill();
}

QTreeWidgetItem* PlotPanel::add_section(const QString& title, const QColor& colour) {
    auto* section = new QTreeWidgetItem(tree_, {title});
    section->setForeground(0, colour);
    QFont font = tree_->font();
    font.setBold(true);
    section->setFont(0, font);
    section->setExpanded(true);
    return section;
}

QTreeWidgetItem* PlotPanel::add(QTreeWidgetItem& below, const QString& words,
                                const std::vector<std::size_t>& fixtures) {
    auto* item = new QTreeWidgetItem(&below, {words});
    item->setToolTip(0, words);
    QVariantList numbers;
    for (const std::size_t fixture : fixtures) numbers << QVariant::fromValue(fixture);
    item->setData(0, kFixtures, numbers);
    return item;
}

// A line, and below it what could stand in with a button that takes it.
void PlotPanel::add_lightless(QTreeWidgetItem& section, const scene::LightlessType& type) {
    const QString wanted = QString::fromStdString(type.wanted);
    QTreeWidgetItem* const item =
        add(section, QString("%1: %2 %3").arg(heads(type.fixtures.size()), wanted, said(type.why)),
            type.fixtures);
    item->setExpanded(true);
    auto* row = new QWidget(tree_);
    auto* choice = new QComboBox(row);
    choice->setAccessibleName(translated("Plot", "Stands in for %1").arg(wanted));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(6);
    for (const scene::StandIn& one : type.stand_ins) {
        const QString label = QString::fromStdString(one.label);
        choice->addItem(
            label, QStringList{QString::fromStdString(one.file.string()), QString::fromStdString(one.mode)});
        choice->setItemData(choice->count() - 1,
                            translated("Plot", "%1, mode '%2'").arg(label, QString::fromStdString(one.mode)) +
                                "\n" + QString::fromStdString(one.file.string()),
                            Qt::ToolTipRole);
    }
    choice->addItem(translated("Plot", "Choose a file..."));
    auto* take = new QToolButton(row);
    take->setText(translated("Plot", "Take"));
    take->setAccessibleName(translated("Plot", "Take it for %1").arg(wanted));
    const auto say = [choice] { choice->setToolTip(choice->currentData(Qt::ToolTipRole).toString()); };
    connect(choice, &QComboBox::currentIndexChanged, choice, say);
    say();
    connect(take, &QToolButton::clicked, this, [this, choice, wanted] {
        QStringList file = choice->currentData().toStringList();
        if (file.isEmpty())
            file << actions_.ask_file({translated("Plot", "A fixture that stands in"),
                                       translated("Files", "Fixtures (*.gdtf *.qxf *.json);;All files (*)"),
                                       ""},
                                      this);
        if (file.first().isEmpty()) return;
        QString line = "substitute " + quoted(wanted);
        for (const QString& word : file) line += " " + quoted(word);
        // The row goes when it is done.
        QMetaObject::invokeMethod(
            this, [this, line] { actions_.choose(line); }, Qt::QueuedConnection);
    });
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 1, 2, 3);
    layout->addWidget(choice, 1);
    layout->addWidget(take);
    auto* below = new QTreeWidgetItem(item);
    below->setFlags(Qt::ItemIsEnabled);
    below->setSizeHint(0, row->sizeHint());
    tree_->setItemWidget(below, 0, row);
}

void PlotPanel::add_groups(const QString& title, Severity severity, const QColor& colour) {
    const scene::PlotPage& page = *report_.page();
    const int count = page.count(severity);
    if (count == 0) return;
    QTreeWidgetItem* const section = add_section(QString("%1: %2").arg(title).arg(count), colour);
    for (const scene::PageGroup& group : page.groups) {
        if (group.severity != severity) continue;
        QTreeWidgetItem* const kind =
            add(*section, QString("%1: %2").arg(said(group.title)).arg(group.times), group.fixtures);
        for (const scene::PageLine& line : group.lines) {
            QString words = said(line.words);
            if (!line.advice.empty()) words += "\n" + translated("Plot", "To do: %1").arg(said(line.advice));
            add(*kind, words, line.fixtures);
        }
    }
    section->setExpanded(severity != Severity::note);
}

void PlotPanel::fill() {
    const int scrolled = tree_->verticalScrollBar()->value();
    tree_->clear();
    const scene::PlotPage* const page = report_.page();
    setEnabled(page != nullptr);
    same_->hide();
    title_->setText(translated("Plot", "What a plot has is listed here."));
    if (!page) return;
    title_->setText(translated("Plot", "%1: %2 missing, %3 guessed")
                        .arg(QString::fromStdString(page->name))
                        .arg(page->count(Severity::error))
                        .arg(page->count(Severity::warning)));
    std::size_t dark = 0, assumed = 0;
    for (const scene::LightlessType& type : page->lightless)
        (type.is_dark ? dark : assumed) += type.fixtures.size();
    if (dark + assumed > 0) {
        QTreeWidgetItem* const section =
            add_section(dark == 0 ? translated("Plot", "%1 with a light that is assumed").arg(heads(assumed))
                        : assumed == 0 ? translated("Plot", "%1 without light").arg(heads(dark))
                                       : translated("Plot", "%1 without light, %2 with one that is assumed")
                                             .arg(heads(dark))
                                             .arg(assumed),
                        dark > 0 ? bad() : accent());
        const std::size_t shown = std::min(page->lightless.size(), kMostRows);
        for (std::size_t k = 0; k < shown; ++k) add_lightless(*section, page->lightless[k]);
        std::vector<std::size_t> others;
        for (std::size_t k = shown; k < page->lightless.size(); ++k)
            others.insert(others.end(), page->lightless[k].fixtures.begin(),
                          page->lightless[k].fixtures.end());
        if (const std::size_t more = page->lightless.size() - shown; more > 0)
            add(*section, translated("Plot", "and %n file(s) more", nullptr, more), others);
    }
    add_groups(translated("Plot", "Missing"), Severity::error, bad());
    add_groups(translated("Plot", "Guessed or repaired"), Severity::warning, accent());
    QTreeWidgetItem* const found = add_section(translated("Plot", "Found"), good());
    for (const scene::PageLine& line : page->found) add(*found, said(line.words), line.fixtures);
    add_groups(translated("Plot", "Odd, but nothing is lost"), Severity::note, faint());
    const auto same = std::count_if(page->lightless.begin(), page->lightless.end(), [](const auto& type) {
        return !type.stand_ins.empty() && type.stand_ins.front().seems_same;
    });
    same_->setText(translated("Plot", "Take what seems the same (%1)").arg(same));
    same_->setVisible(same > 0);
    tree_->verticalScrollBar()->setValue(scrolled);
    refresh();
}

void PlotPanel::select_these() {
    const QTreeWidgetItem* const item = tree_->currentItem();
    if (!item) return;
    std::set<std::size_t> fixtures;
    for (const QVariant& number : item->data(0, kFixtures).toList())
        fixtures.insert(number.value<std::size_t>());
    if (!fixtures.empty()) app_.select(std::move(fixtures));
}

void PlotPanel::refresh() {
    const QTreeWidgetItem* const item = tree_->currentItem();
    select_->setEnabled(item && !item->data(0, kFixtures).toList().isEmpty());
}

} // namespace ghost::ui
