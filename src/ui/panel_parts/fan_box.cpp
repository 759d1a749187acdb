// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/fan_box.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"

#include <QGridLayout>
#include <QLineEdit>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

constexpr const char* kWords[] = { // kHeadWords
    QT_TRANSLATE_NOOP("Programmer", "Intensity"), QT_TRANSLATE_NOOP("Programmer", "Zoom"),
    QT_TRANSLATE_NOOP("Programmer", "Pan"),       QT_TRANSLATE_NOOP("Programmer", "Tilt"),
    QT_TRANSLATE_NOOP("Programmer", "Gobo"),      QT_TRANSLATE_NOOP("Programmer", "Colour")};
constexpr const char* kKinds[] = {QT_TRANSLATE_NOOP("Fan", "First to last"),
                                  QT_TRANSLATE_NOOP("Fan", "Symmetric"),
                                  QT_TRANSLATE_NOOP("Fan", "From the centre")};
constexpr const char* kOrders[] = {QT_TRANSLATE_NOOP("Fan", "As selected"),
                                   QT_TRANSLATE_NOOP("Fan", "As listed"),
                                   QT_TRANSLATE_NOOP("Fan", "Left to right")};
constexpr std::pair<const char*, const char*> kNames[] = {
    {QT_TRANSLATE_NOOP("Fan", "First"), QT_TRANSLATE_NOOP("Fan", "Last")},
    {QT_TRANSLATE_NOOP("Fan", "Ends"), QT_TRANSLATE_NOOP("Fan", "Middle")},
    {QT_TRANSLATE_NOOP("Fan", "Middle"), QT_TRANSLATE_NOOP("Fan", "Ends by")}};

QPushButton* button(const QString& text, const QString& tip, QWidget* parent) {
    auto* one = new QPushButton(text, parent);
    one->setToolTip(tip);
    return one;
}

} // namespace

FanBox::FanBox(AppModel& app, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), actions_(actions), unfold_(new QToolButton(this)),
      what_(new QComboBox(this)), kind_(new QComboBox(this)), order_(new QComboBox(this)),
      a_name_(new QLabel(this)), b_name_(new QLabel(this)), a_(new QDoubleSpinBox(this)),
      b_(new QDoubleSpinBox(this)),
      as_first_(button(translated("Fan", "All as first"),
                       translated("Fan", "All get the value of the first one that was selected"), this)),
      as_last_(button(translated("Fan", "All as last"),
                      translated("Fan", "All get the value of the last one that was selected"), this)),
      between_(button(translated("Fan", "Between them"),
                      translated("Fan", "Evenly from what the first has to what the last has"), this)) {
    unfold_->setText(translated("Fan", "Fan and align"));
    unfold_->setCheckable(true);
    unfold_->setAutoRaise(true);
    unfold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    unfold_->setArrowType(Qt::RightArrow);
    unfold_->setToolTip(
        translated("Fan", "Spreads a value over the selected heads, or gives them that of one"));
    auto* inside = new QWidget(this);
    add_rows(*inside);
    inside->hide();
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the panel may be narrow
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(unfold_);
    layout->addWidget(inside);
    connect(unfold_, &QToolButton::toggled, this, [this, inside](bool on) {
        unfold_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        inside->setVisible(on);
        begin();
    });
    for (QComboBox* const one : {what_, kind_, order_})
        connect(one, &QComboBox::activated, this, &FanBox::begin);
    for (QDoubleSpinBox* const one : {a_, b_})
        connect(one, &QDoubleSpinBox::valueChanged, this, [this] {
            if (!follows_) fan(false);
        });
    connect(between_, &QPushButton::clicked, this, [this] { fan(true); });
    for (const auto& [one, line] :
         {std::pair{as_first_, "align-values first "}, {as_last_, "align-values last "}})
        connect(one, &QPushButton::clicked, this, [this, line] {
            actions_.choose(line + word());
            begin();
        });
    connect(&app_, &AppModel::selection_changed, this, &FanBox::begin);
    // Undone, or set elsewhere: one step of a number would bring back the other one as it was.
    connect(&app_, &AppModel::look_changed, this, [this] {
        if (unfold_->isChecked() && !fans_ && !is_being_typed()) begin();
    });
    set_parameters({});
}

void FanBox::add_rows(QWidget& inside) {
    what_->setAccessibleName(translated("Fan", "What is spread"));
    kind_->setAccessibleName(translated("Fan", "How it is spread"));
    order_->setAccessibleName(translated("Fan", "Order of the heads"));
    for (const char* const one : kKinds) kind_->addItem(translated("Fan", one));
    for (const char* const one : kOrders) order_->addItem(translated("Fan", one));
    auto* grid = new QGridLayout(&inside);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(3);
    grid->addWidget(what_, 0, 0, 1, 3);
    grid->addWidget(kind_, 0, 3, 1, 3);
    grid->addWidget(a_name_, 1, 0);
    grid->addWidget(a_, 1, 1, 1, 2);
    grid->addWidget(b_name_, 1, 3);
    grid->addWidget(b_, 1, 4, 1, 2);
    grid->addWidget(order_, 2, 0, 1, 3);
    grid->addWidget(between_, 2, 3, 1, 3);
    grid->addWidget(as_first_, 3, 0, 1, 3);
    grid->addWidget(as_last_, 3, 3, 1, 3);
    for (int column = 0; column < 6; ++column) grid->setColumnStretch(column, 1);
    for (QComboBox* const one : {what_, kind_, order_}) {
        one->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        one->setMinimumContentsLength(8);
    }
    for (QDoubleSpinBox* const one : {a_, b_}) one->setKeyboardTracking(false);
}

void FanBox::set_parameters(const std::vector<HeadParameter>& parameters) {
    const QString before = word();
    what_->clear();
    for (std::size_t i = 0; i < kHeadWords.size(); ++i)
        what_->addItem(translated("Programmer", kWords[i]), kHeadWords[i]);
    for (const HeadParameter& parameter : parameters)
        what_->addItem(parameter.name, QString::fromStdString(parameter.attribute));
    what_->setCurrentIndex(before.isEmpty() ? what_->findData("pan") : std::max(what_->findData(before), 0));
    begin();
}

QString FanBox::word() const {
    return what_->currentData().toString();
}

bool FanBox::is_being_typed() const {
    for (const QDoubleSpinBox* const one : {a_, b_})
        if (const auto* const text = one->findChild<QLineEdit*>();
            one->hasFocus() && text && text->isModified())
            return true;
    return false;
}

double FanBox::per_unit() const {
    const QString what = word();
    return what == "zoom" || what == "pan" || what == "tilt" || what == "gobo" ? 1.0 : 0.01;
}

// Shows what the heads have now.
void FanBox::begin() {
    const auto kind = static_cast<std::size_t>(kind_->currentIndex());
    const bool is_number = word() != "colour";
    a_name_->setText(translated("Fan", kNames[kind].first));
    b_name_->setText(translated("Fan", kNames[kind].second));
    a_->setAccessibleName(a_name_->text());
    b_->setAccessibleName(b_name_->text());
    const std::size_t count = app_.selection().size();
    setEnabled(count > 1);
    for (QWidget* const one : std::initializer_list<QWidget*>{a_, b_, a_name_, b_name_, kind_})
        one->setEnabled(is_number);
    if (!app_.show() || count == 0 || !is_number) return;
    const Following following(follows_);
    const bool is_degrees = word() == "pan" || word() == "tilt" || word() == "zoom";
    for (QDoubleSpinBox* const one : {a_, b_}) {
        one->setRange(word() == "pan" || word() == "tilt" ? -3600 : 0, is_degrees         ? 3600
                                                                       : word() == "gobo" ? 255
                                                                                          : 100);
        one->setDecimals(is_degrees ? 1 : 0);
        one->setSuffix(is_degrees ? QString("\u00b0") : word() == "gobo" ? "" : " %");
    }
    if (static_cast<Fan>(kind) == Fan::centre) b_->setRange(-b_->maximum(), b_->maximum());
    std::vector<std::size_t> heads = heads_in(static_cast<HeadOrder>(order_->currentIndex()), app_);
    const std::string what = word().toStdString();
    std::erase_if(heads, [&](std::size_t head) { return !has_value(app_.show()->fixtures[head], what); });
    if (heads.empty()) return;
    const HeadReader reader(*app_.show(), app_.look(), app_.rig());
    const auto number = [&](std::size_t place) {
        const auto value = reader.value(heads[place], what);
        const auto* const one = value ? std::get_if<float>(&*value) : nullptr;
        return one ? static_cast<double>(*one) / per_unit() : 0.0;
    };
    const double first = number(0), middle = number((heads.size() - 1) / 2), last = number(heads.size() - 1);
    const Fan fan = static_cast<Fan>(kind);
    a_->setValue(fan == Fan::centre ? middle : first);
    b_->setValue(fan == Fan::line ? last : fan == Fan::symmetric ? middle : (last - first) / 2);
}

void FanBox::fan(bool between_them) {
    const QString numbers = between_them ? QString("between")
                                         : QString("%1 %2 %3")
                                               .arg(a_->value() * per_unit())
                                               .arg(b_->value() * per_unit())
                                               .arg(kFans[static_cast<std::size_t>(kind_->currentIndex())]);
    {
        const Following own(fans_);
        actions_.choose("fan " + word() + " " + numbers + " " +
                        kHeadOrders[static_cast<std::size_t>(order_->currentIndex())]);
    }
    if (between_them) begin();
}

} // namespace ghost::ui
