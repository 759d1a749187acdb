// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/value_panel.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/head_parameters.h"
#include "ui/widgets/theme.h"

#include <QHeaderView>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

constexpr int kAddressFrom_letters = 47; // of the panel's width

// A channel's value before a bar as long as its share of the most.
class BarPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QRectF all = QRectF(option.rect).adjusted(4, 3, -4, -3);
        painter->fillRect(all, QColor(52, 52, 56));
        const double share = index.data(ChannelModel::kShare).toDouble();
        painter->fillRect(QRectF(all.x(), all.y(), all.width() * share, all.height()), QColor(58, 88, 128));
        painter->setPen(index.data(Qt::ForegroundRole).isValid() ? faint()
                                                                 : option.palette.color(QPalette::Text));
        painter->drawText(option.rect.adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter,
                          index.data().toString());
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return QStyledItemDelegate::sizeHint(option, index) + QSize(12, 0); // around the bar
    }
};

double share_of(const scene::ChannelFacts& channel) {
    const auto bytes = static_cast<int>(channel.places.size());
    const double most = bytes <= 1 ? 255.0 : bytes == 2 ? 65535.0 : bytes == 3 ? 16777215.0 : 4294967295.0;
    return std::clamp(static_cast<double>(channel.reading.raw) / most, 0.0, 1.0);
}

// In the words of the other panels, without the geometry that every row would repeat.
QString attribute_of(const scene::ChannelFacts& channel) {
    return attribute_words(channel.attribute.empty() ? channel.name : channel.attribute);
}

// What a hand sets in this channel's place.
QString words_by_hand(const scene::ChannelFacts& channel, const fixture::Programmer& programmer) {
    using fixture::Role;
    const auto degrees = [](const std::optional<float>& value) {
        return value ? QString("%1\u00b0").arg(static_cast<double>(*value), 0, 'f', 1) : QString();
    };
    const auto share = programmer.channels.find(channel.name);
    if (share != programmer.channels.end())
        return QString("%1 %").arg(100 * static_cast<double>(share->second), 0, 'f', 0);
    switch (channel.role) {
    case Role::dimmer:
        return programmer.intensity
                   ? QString("%1 %").arg(100 * static_cast<double>(*programmer.intensity), 0, 'f', 0)
                   : QString();
    case Role::shutter:
    case Role::strobe:
    case Role::strobe_random:
    case Role::strobe_pulse:
        return programmer.intensity ? translated("Values", "open") : QString();
    case Role::zoom:
        return degrees(programmer.zoom_deg);
    case Role::pan:
        return degrees(programmer.pan_deg);
    case Role::tilt:
        return degrees(programmer.tilt_deg);
    case Role::gobo_wheel:
        return programmer.gobo ? translated("Values", "slot %1").arg(*programmer.gobo) : QString();
    case Role::color_add:
    case Role::color_sub_c:
    case Role::color_sub_m:
    case Role::color_sub_y:
    case Role::color_wheel:
    case Role::color_rgb:
        return programmer.colour ? translated("Values", "colour") : QString();
    default:
        return {};
    }
}

// The words of diagnose/explain_print.h stand in columns, as in a terminal. In a panel as wide as a hand
// lines wrap, and what wraps is indented instead.
QString as_paragraphs(const QString& words) {
    static const QRegularExpression kColumns(" {2,}");
    const QString gap = QString(" ") + QChar(QChar::Nbsp);
    QString html;
    for (const QString& line :
         words.split('\n', Qt::SkipEmptyParts).mid(1)) { // the first is the verdict above
        const QStringList parts = line.split(kColumns, Qt::SkipEmptyParts);
        const bool has_title = !line.startsWith(' ') && parts.size() > 1;
        QString text = has_title ? "<b>" + parts[0].toHtmlEscaped() + "</b>" + gap : QString();
        text += parts.mid(has_title ? 1 : 0).join("  ").toHtmlEscaped().replace("  ", gap);
        html += QString("<p style='margin:0 0 0 %1px; text-indent:-10px'>%2</p>")
                    .arg(has_title ? 10 : 20)
                    .arg(text);
    }
    return html;
}

} // namespace

void ChannelModel::show(const scene::Explanation& explanation, const fixture::Programmer& programmer) {
    const bool same = channels_.size() == explanation.channels.size();
    if (!same) beginResetModel();
    channels_ = explanation.channels;
    programmer_ = programmer;
    if (!same)
        endResetModel();
    else if (!channels_.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ChannelModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(channels_.size());
}

int ChannelModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant ChannelModel::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (row >= channels_.size()) return {};
    const scene::ChannelFacts& channel = channels_[row];
    if (role == kShare) return share_of(channel);
    if (role == Qt::ToolTipRole)
        return QString::fromStdString(channel.addresses) + " " +
               QString::fromStdString(channel.name + ": " + channel.function);
    if (role == Qt::ForegroundRole && index.column() == by_hand) return accent();
    if (role == Qt::ForegroundRole && !channel.reading.received) return faint();
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
    case address:
        return QString::fromStdString(channel.addresses);
    case attribute:
        return attribute_of(channel);
    case value:
        return QString::fromStdString(channel.value);
    case meaning:
        return said(channel.meaning);
    case by_hand:
        return words_by_hand(channel, programmer_);
    default:
        return {};
    }
}

QVariant ChannelModel::headerData(int section, Qt::Orientation orientation, int role) const {
    static const char* const kTitles[kColumns] = {
        QT_TRANSLATE_NOOP("Values", "Address"), QT_TRANSLATE_NOOP("Values", "Attribute"), "DMX",
        QT_TRANSLATE_NOOP("Values", "Means"), QT_TRANSLATE_NOOP("Values", "By hand")};
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return translated("Values", kTitles[section]);
}

ValuePanel::ValuePanel(AppModel& app, QWidget* parent) : QWidget(parent), app_(app) {
    title_ = new QLabel(this);
    QFont font = title_->font();
    font.setBold(true);
    title_->setFont(font);
    verdict_ = new QLabel(this);
    verdict_->setWordWrap(true);
    model_ = new ChannelModel(this);
    table_ = new QTableView(this);
    table_->setModel(model_);
    table_->setAccessibleName(translated("Values", "Channels"));
    table_->setItemDelegateForColumn(ChannelModel::value, new BarPainter(this));
    table_->setShowGrid(false);
    table_->setAlternatingRowColors(true);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setFocusPolicy(Qt::NoFocus);
    table_->verticalHeader()->hide();
    // What a channel means may take two lines.
    table_->verticalHeader()->setMinimumSectionSize(table_->fontMetrics().height() + 7);
    table_->verticalHeader()->setResizeContentsPrecision(0);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    for (const int column : {ChannelModel::address, ChannelModel::value})
        table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setResizeContentsPrecision(0);
    table_->setColumnWidth(ChannelModel::attribute, 12 * table_->fontMetrics().averageCharWidth());
    words_ = new QTextBrowser(this);
    words_->setAccessibleName(translated("Values", "The way from the packet to the light"));
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->addWidget(table_);
    splitter->addWidget(words_);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(title_);
    layout->addWidget(verdict_);
    layout->addWidget(splitter, 1);
    for (const auto signal : {&AppModel::explanation_came, &AppModel::selection_changed,
                              &AppModel::opened_show, &AppModel::look_changed})
        connect(&app_, signal, this, &ValuePanel::refresh);
    refresh();
}

// What a channel means is read more often than its address, which its tip has, too.
void ValuePanel::resizeEvent(QResizeEvent*) {
    table_->setColumnHidden(ChannelModel::address,
                            width() < kAddressFrom_letters * fontMetrics().averageCharWidth());
}

void ValuePanel::refresh() {
    const auto current = app_.current();
    const auto say_alone = [this](const QString& words) {
        verdict_->setText(words);
        verdict_->setStyleSheet(QString());
        model_->show({}, {});
        words_->clear();
        shown_words_.clear();
    };
    if (!app_.show() || !current) {
        title_->setText(translated("Values", "No fixture is selected"));
        say_alone(translated("Values", "Click a lamp in the picture or a row of the list."));
        return;
    }
    QString title = QString::fromStdString(app_.show()->fixtures[*current].name);
    if (app_.selection().size() > 1)
        title = translated("Values", "%1 and %2 more").arg(title).arg(app_.selection().size() - 1);
    title_->setText(title);
    const Explained& explained = app_.explained();
    if (explained.fixture != *current || explained.words.empty()) { // it comes
        say_alone(translated("Values", "It is being looked at ..."));
        return;
    }
    verdict_->setText(said(explained.explanation.verdict));
    verdict_->setStyleSheet(
        QString("color: %1")
            .arg((explained.explanation.visibility == scene::Visibility::lit ? good() : bad()).name()));
    const auto by_hand = app_.look().fixtures.find(*current);
    model_->show(explained.explanation,
                 by_hand == app_.look().fixtures.end() ? fixture::Programmer{} : by_hand->second);
    table_->setColumnHidden(ChannelModel::by_hand, by_hand == app_.look().fixtures.end());
    if (shown_words_ == explained.words || words_->textCursor().hasSelection()) return;
    shown_words_ = explained.words;
    const int at = words_->verticalScrollBar()->value();
    words_->setHtml(as_paragraphs(QString::fromStdString(shown_words_)));
    words_->verticalScrollBar()->setValue(at);
}

} // namespace ghost::ui
