// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/network_panel.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/panel_parts/rdm_box.h"
#include "ui/widgets/theme.h"

#include <QHeaderView>
#include <QHelpEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr int kMostAcross = 32, kStepAcross = 8; // channels in a row
constexpr int kBeside_px = 784;                  // of the panel, from which both halves are beside each other
constexpr qint64 kFresh_ms = 600;                // a value that changed is marked so long
constexpr int kSourceColumns = 10;
constexpr int kIndent_px = 14;
constexpr int kLeastRows = 6; // of the levels, that are seen

QFont small_letters(QFont font) {
    font.setPointSizeF(font.pointSizeF() * 0.9);
    return font;
}

// What is wrong in a colour; what is known of it and what to try, which may be long, as a list below.
QString paragraphs(const scene::Sentence& sentence) {
    // Not after a letter of an abbreviation ("z. B.").
    static const auto kNextSentence = QRegularExpression("(?<=\\w{2}[.?!]|\\)[.?!]) (?=[\\p{Lu}\\d])",
                                                         QRegularExpression::UseUnicodePropertiesOption);
    const QStringList parts = said(sentence.text).toHtmlEscaped().split(kNextSentence);
    QString text = QString("<p style='margin:2px; color:%1'>%2</p>")
                       .arg((sentence.is_problem ? bad() : faint()).name(), parts.front());
    for (const QString& part : parts.mid(1))
        text += QString("<p style='margin:1px 2px 1px %1px'>%2</p>").arg(kIndent_px).arg(part);
    return text;
}

} // namespace

UniverseGrid::UniverseGrid(AppModel& app, QWidget* parent) : QWidget(parent), app_(app) {
    clock_.start();
    changed_ms_.fill(-kFresh_ms);
    owner_.fill(-1);
    setFont(small_letters(font()));
    setMinimumWidth(names_px() + kStepAcross * least_cell().width());
    connect(&app_, &AppModel::rig_came, this, &UniverseGrid::take);
    connect(&app_, &AppModel::opened_show, this, &UniverseGrid::find_owners);
}

QSize UniverseGrid::sizeHint() const {
    return {names_px() + kMostAcross * least_cell().width(),
            static_cast<int>(dmx::kSlots) / kMostAcross * least_cell().height()};
}

// In which a value can be read.
QSize UniverseGrid::least_cell() const {
    return {fontMetrics().horizontalAdvance("000") + 5, fontMetrics().height() + 2};
}

// Of the channel with which a row begins, at its left.
int UniverseGrid::names_px() const {
    return fontMetrics().horizontalAdvance("000") + 8;
}

int UniverseGrid::across() const {
    const int fits = (width() - names_px()) / least_cell().width() / kStepAcross * kStepAcross;
    return std::clamp(fits, kStepAcross, kMostAcross);
}

int UniverseGrid::down() const {
    return (static_cast<int>(dmx::kSlots) + across() - 1) / across();
}

// Rows that find no room are scrolled to.
void UniverseGrid::resizeEvent(QResizeEvent*) {
    setMinimumHeight(down() * least_cell().height());
}

std::optional<QRect> UniverseGrid::first_selected() const {
    for (int slot = 0; slot < static_cast<int>(dmx::kSlots); ++slot)
        if (const int owner = owner_[static_cast<std::size_t>(slot)];
            owner >= 0 && app_.selection().contains(static_cast<std::size_t>(owner)))
            return cell(slot).toAlignedRect();
    return std::nullopt;
}

void UniverseGrid::set_universe(int number) {
    universe_ = number;
    levels_ = {};
    changed_ms_.fill(-kFresh_ms);
    find_owners();
    take();
}

void UniverseGrid::find_owners() {
    owner_.fill(-1);
    if (!app_.show()) return;
    const std::vector<scene::PatchedFixture>& fixtures = app_.show()->fixtures;
    for (std::size_t i = 0; i < fixtures.size(); ++i) {
        if (!fixtures[i].type) continue;
        const fixture::Patch patch = fixtures[i].patch();
        const std::vector<int>& footprint = patch.mode_of().footprint;
        for (std::size_t part = 0; part < std::min(patch.addresses.size(), footprint.size()); ++part) {
            const fixture::Address& address = patch.addresses[part];
            if (address.universe != universe_ || address.channel < 1) continue;
            for (int k = 0; k < footprint[part] && address.channel + k <= static_cast<int>(dmx::kSlots); ++k)
                owner_[static_cast<std::size_t>(address.channel + k - 1)] = static_cast<int>(i);
        }
    }
}

void UniverseGrid::take() {
    const dmx::Universe* universe = app_.rig().universes.find(static_cast<std::uint16_t>(universe_));
    known_ = universe != nullptr;
    const dmx::Levels now = universe ? *universe->levels : dmx::Levels{};
    for (std::size_t slot = 0; slot < now.size(); ++slot)
        if (now[slot] != levels_[slot]) changed_ms_[slot] = clock_.elapsed();
    levels_ = now;
    if (isVisible()) update();
}

QRectF UniverseGrid::cell(int slot) const {
    const double wide = static_cast<double>(width() - names_px()) / across(),
                 high = static_cast<double>(height()) / down();
    return {names_px() + wide * (slot % across()), high * (slot / across()), wide, high};
}

void UniverseGrid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(22, 22, 24));
    painter.setPen(faint());
    for (int slot = 0; slot < static_cast<int>(dmx::kSlots); slot += across()) {
        const QRectF first = cell(slot);
        painter.drawText(QRectF(0, first.top(), names_px() - 5, first.height()),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(slot + 1));
    }
    const qint64 now_ms = clock_.elapsed();
    for (int slot = 0; slot < static_cast<int>(dmx::kSlots); ++slot) {
        const auto index = static_cast<std::size_t>(slot);
        const int level = levels_[index];
        const QRectF box = cell(slot).adjusted(0.5, 0.5, -0.5, -0.5);
        const int shade = 30 + level * 70 / 255;
        const bool owned = owner_[index] >= 0;
        painter.fillRect(box, owned ? QColor(shade, shade, shade + 12) : QColor(shade, shade, shade));
        if (owned && app_.selection().contains(static_cast<std::size_t>(owner_[index]))) {
            painter.setPen(accent());
            painter.drawRect(box.adjusted(0, 0, -1, -1));
        }
        if (!known_) continue;
        const bool fresh = now_ms - changed_ms_[index] < kFresh_ms;
        painter.setPen(fresh       ? accent()
                       : level > 0 ? QColor(235, 235, 235)
                       : owned     ? QColor(130, 130, 135)
                                   : QColor(80, 80, 84));
        painter.drawText(box, Qt::AlignCenter, QString::number(level));
    }
    if (known_) return;
    painter.setPen(faint());
    painter.drawText(rect(), Qt::AlignCenter,
                     translated("Network", "Nothing of universe %1 has come").arg(universe_));
}

bool UniverseGrid::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int row = std::clamp(help->pos().y() * down() / std::max(height(), 1), 0, down() - 1),
              column =
                  std::clamp((help->pos().x() - names_px()) * across() / std::max(width() - names_px(), 1), 0,
                             across() - 1);
    const int slot = std::min(row * across() + column, static_cast<int>(dmx::kSlots) - 1);
    const int owner = owner_[static_cast<std::size_t>(slot)];
    QString text = QString("%1.%2: %3")
                       .arg(universe_)
                       .arg(slot + 1, 3, 10, QChar('0'))
                       .arg(levels_[static_cast<std::size_t>(slot)]);
    if (owner >= 0 && app_.show())
        text += "\n" + QString::fromStdString(app_.show()->fixtures[static_cast<std::size_t>(owner)].name);
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

// Beside each other where both have room to be read.
void NetworkPanel::resizeEvent(QResizeEvent*) {
    fit_sentences();
    const bool is_wide = width() > kBeside_px;
    const Qt::Orientation wanted = is_wide ? Qt::Horizontal : Qt::Vertical;
    if (halves_->orientation() == wanted) return;
    halves_->setOrientation(wanted);
    halves_->setSizes({400, 600});
}

NetworkPanel::NetworkPanel(AppModel& app, Actions& actions, QWidget* parent) : QWidget(parent), app_(app) {
    diagnosis_ = new QLabel(this);
    diagnosis_->setWordWrap(true);
    diagnosis_->setTextFormat(Qt::RichText);
    diagnosis_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    diagnosis_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    sentences_ = new QScrollArea(this);
    sentences_->setFrameShape(QFrame::NoFrame);
    sentences_->setWidgetResizable(true);
    sentences_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    sentences_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    sentences_->setAccessibleName(translated("Network", "What is wrong"));
    sentences_->setWidget(diagnosis_);
    sentences_->hide();
    summary_ = new QLabel(translated("Network", "Nothing has come from the network yet."), this);
    summary_->setWordWrap(true);
    sources_ = new QTableWidget(0, kSourceColumns, this);
    sources_->setTabKeyNavigation(false); // Tab leaves it
    sources_->setAccessibleName(translated("Network", "Sources"));
    sources_->setHorizontalHeaderLabels(
        {translated("Network", "Universe"), translated("Network", "Source"), translated("Network", "Is"),
         translated("Network", "Priority"), translated("Network", "Rate"), translated("Network", "Jitter"),
         translated("Network", "Missed"), translated("Network", "From"), translated("Network", "Protocol"),
         translated("Network", "Patched")});
    sources_->verticalHeader()->hide();
    sources_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    sources_->setSelectionBehavior(QAbstractItemView::SelectRows);
    sources_->setShowGrid(false);
    sources_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    sources_->horizontalHeader()->setStretchLastSection(true);
    universes_ = new QComboBox(this);
    grid_ = new UniverseGrid(app, this);
    auto* left = new QWidget(this);
    auto* left_layout = new QVBoxLayout(left);
    left_layout->setContentsMargins(0, 0, 0, 0);
    left_layout->addWidget(new RdmBox(app, actions, left)); // its switch is seen in a low panel, too
    left_layout->addWidget(summary_);
    left_layout->addWidget(sources_);
    auto* right = new QWidget(this);
    auto* right_layout = new QVBoxLayout(right);
    right_layout->setContentsMargins(0, 0, 0, 0);
    right_layout->addWidget(universes_);
    auto* const scroll = new QScrollArea(right);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumSize(grid_->minimumWidth() + scroll->verticalScrollBar()->sizeHint().width(),
                           kLeastRows * fontMetrics().height());
    scroll->setWidget(grid_);
    right_layout->addWidget(scroll, 1);
    halves_ = new QSplitter(this);
    halves_->addWidget(left);
    halves_->addWidget(right);
    halves_->setStretchFactor(0, 2);
    halves_->setStretchFactor(1, 3);
    halves_->setSizes({400, 600}); // the grid would like to have it all
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(sentences_);
    layout->addWidget(halves_, 1);
    connect(&app_, &AppModel::network_came, this, &NetworkPanel::refresh);
    connect(&app_, &AppModel::rig_came, this, &NetworkPanel::refresh_universes);
    connect(&app_, &AppModel::opened_show, this, &NetworkPanel::refresh_universes);
    connect(&app_, &AppModel::selection_changed, grid_, [this, scroll] {
        grid_->update();
        if (const auto first = grid_->first_selected())
            scroll->ensureVisible(first->center().x(), first->center().y(), 0, 2 * first->height());
    });
    connect(universes_, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (index >= 0) grid_->set_universe(universes_->itemData(index).toInt());
    });
}

void NetworkPanel::refresh() {
    if (!isVisible()) return;
    refresh_diagnosis();
    refresh_sources();
}

void NetworkPanel::refresh_diagnosis() {
    QString text;
    for (const scene::Sentence& sentence : app_.diagnosis()) text += paragraphs(sentence);
    if (text == diagnosis_->text()) return; // who reads on is not taken back to its beginning
    diagnosis_->setText(text);
    sentences_->setVisible(!text.isEmpty());
    fit_sentences();
}

// As high as they are, but the levels below stay in sight, of which they speak; the rest is scrolled to.
void NetworkPanel::fit_sentences() {
    constexpr int kLeastLines = 2, kShareOfPanel = 5;
    const int most_px = std::max(kLeastLines * fontMetrics().lineSpacing() + 8, height() / kShareOfPanel);
    const int bar_px = sentences_->verticalScrollBar()->sizeHint().width();
    const int margins_px = layout()->contentsMargins().left() + layout()->contentsMargins().right();
    const int width_px = std::max(width() - margins_px - bar_px, 1);
    sentences_->setFixedHeight(std::clamp(diagnosis_->heightForWidth(width_px), 0, most_px));
}

void NetworkPanel::refresh_sources() {
    const dmx::Statistics& network = app_.network();
    std::uint64_t dropped = 0;
    for (const std::uint64_t count : network.drops) dropped += count;
    QString text = translated("Network", "sACN %1, Art-Net %2 packets")
                       .arg(network.packets_sacn)
                       .arg(network.packets_artnet);
    if (dropped > 0) text += translated("Network", ", %1 not understood").arg(dropped);
    if (network.merge.missed > 0)
        text += translated("Network", ", %1 lost on the way").arg(network.merge.missed);
    if (network.overflow > 0)
        text += translated("Network", ", %1 lost in this machine").arg(network.overflow);
    if (network.merge.preview > 0)
        text += translated("Network", ", %1 of a desk in preview (blind)").arg(network.merge.preview);
    if (const dmx::Latency& latency = app_.latency(); latency.count() > 0)
        text += translated("Network", "; packet to picture %1 ms (median), %2 (99 %), %3 at most")
                    .arg(latency.percentile_ms(0.5), 0, 'f', 0)
                    .arg(latency.percentile_ms(0.99), 0, 'f', 0)
                    .arg(latency.max_ms(), 0, 'f', 0);
    summary_->setText(text);
    sources_->setRowCount(static_cast<int>(network.sources.size()));
    for (int row = 0; row < sources_->rowCount(); ++row) {
        const dmx::SourceStatus& source = network.sources[static_cast<std::size_t>(row)];
        const QStringList cells{
            QString::number(source.universe),
            QString::fromStdString(source.name.empty() ? source.id : source.name),
            said(scene::role_text(source, network.sources)),
            QString::number(source.priority),
            QString("%1 Hz").arg(source.rate_hz, 0, 'f', 1),
            QString("%1 ms").arg(source.jitter_ms, 0, 'f', 1),
            QString::number(source.missed),
            source.protocol == dmx::Protocol::usb ? QString()
                                                  : QString::fromStdString(dmx::address_text(source.from)),
            QString::fromUtf8(dmx::protocol_name(source.protocol)),
            app_.patch().has(source.universe) ? translated("Network", "yes") : translated("Network", "no"),
        };
        for (int column = 0; column < cells.size(); ++column) {
            QTableWidgetItem* item = sources_->item(row, column);
            if (!item) sources_->setItem(row, column, item = new QTableWidgetItem);
            item->setText(cells[column]);
        }
    }
}

void NetworkPanel::refresh_universes() {
    std::set<int> numbers;
    for (const dmx::Universe& universe : app_.rig().universes.list) numbers.insert(universe.number);
    if (app_.show())
        for (const scene::PatchedFixture& fixture : app_.show()->fixtures) numbers.insert(fixture.universe);
    std::set<int> listed;
    for (int i = 0; i < universes_->count(); ++i) listed.insert(universes_->itemData(i).toInt());
    if (numbers == listed) return;
    const int before = universes_->currentData().toInt();
    const QSignalBlocker blocker(universes_);
    universes_->clear();
    for (const int number : numbers)
        universes_->addItem(translated("Network", "Universe %1").arg(number), number);
    universes_->setCurrentIndex(std::max(universes_->findData(before), 0));
    if (universes_->count() > 0) grid_->set_universe(universes_->currentData().toInt());
}

} // namespace ghost::ui
