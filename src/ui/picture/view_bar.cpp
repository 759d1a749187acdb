// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/view_bar.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ghost::ui {
namespace {

constexpr double kLeastEv = -10, kMostEv = 20;
constexpr int kShortCamera_px = 96;
constexpr int kMenuMargin_px = 17; // round a word, as Qt's style Fusion has it

} // namespace

ViewBar::ViewBar(AppModel& app, Actions& actions, QMenuBar* menus)
    : QWidget(menus), app_(app), menus_(*menus), camera_(new QComboBox(this)),
      exposure_(new QDoubleSpinBox(this)), strip_(new QToolButton(this)), automatic_(new QToolButton(this)),
      tone_(new QComboBox(this)) {
    setObjectName("view-bar");
    camera_->setAccessibleName(translated("View bar", "Camera"));
    camera_->setToolTip(translated("View bar", "The cameras of the show: 1 to 9; Ctrl+K keeps this one"));
    camera_->setPlaceholderText(translated("View bar", "free camera"));
    camera_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    camera_->setMinimumContentsLength(11); // a line of menus does not learn of another width
    exposure_->setRange(kLeastEv, kMostEv);
    exposure_->setSingleStep(0.5);
    exposure_->setDecimals(1);
    exposure_->setPrefix("EV ");
    exposure_->setKeyboardTracking(false);
    exposure_->setAccessibleName(translated("View bar", "Exposure"));
    exposure_->setToolTip(
        translated("View bar", "Exposure: + and - by half a stop; a smaller number is brighter"));
    automatic_->setDefaultAction(actions.item("auto-exposure"));
    automatic_->setText(translated("View bar", "Auto"));
    tone_->setAccessibleName(translated("View bar", "Tone curve"));
    tone_->setToolTip(translated("View bar", "Tone curve (T)"));
    tone_->addItems({"AgX", "ACES", translated("View bar", "no curve")});
    strip_->setDefaultAction(actions.item("camera-strip"));
    strip_->setText(translated("View bar", "Strip"));
    auto* work_light = new QToolButton(this);
    work_light->setDefaultAction(actions.item("work-light"));
    work_light->setText(translated("View bar", "Work light"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->setSpacing(4);
    for (QWidget* const one :
         std::initializer_list<QWidget*>{camera_, strip_, exposure_, automatic_, tone_, work_light}) {
        one->setFocusPolicy(one == exposure_ ? Qt::ClickFocus : Qt::NoFocus);
        layout->addWidget(one);
    }
    // The words of the menu are longer.
    const auto keep_words = [this, work_light] {
        strip_->setText(translated("View bar", "Strip"));
        automatic_->setText(translated("View bar", "Auto"));
        work_light->setText(translated("View bar", "Work light"));
    };
    for (QToolButton* const button : {strip_, automatic_, work_light})
        connect(button->defaultAction(), &QAction::changed, this, keep_words);
    connect(camera_, &QComboBox::activated, this,
            [&actions](int index) { actions.choose(QString("camera %1").arg(index + 1)); });
    connect(exposure_, &QDoubleSpinBox::valueChanged, this, [this, &actions](double ev) {
        if (!follows_) actions.choose(QString("exposure %1").arg(ev));
    });
    connect(tone_, &QComboBox::activated, this, [&actions](int index) {
        actions.choose(
            "tone " + QString::fromStdString(image::name_of(image::kTones[static_cast<std::size_t>(index)])));
    });
    connect(&app_, &AppModel::opened_show, this, &ViewBar::name_cameras);
    for (const auto signal : {&AppModel::request_changed, &AppModel::picture_came})
        connect(&app_, signal, this, &ViewBar::refresh);
    setEnabled(false);
    menus_.installEventFilter(this);
}

bool ViewBar::eventFilter(QObject* object, QEvent* event) {
    if (object == &menus_ && event->type() == QEvent::Resize) leave_room();
    return false;
}

void ViewBar::leave_room() {
    int words_px = kMenuMargin_px;
    for (const QAction* const menu : menus_.actions())
        words_px += menus_.fontMetrics().horizontalAdvance(menu->text()) + kMenuMargin_px;
    const std::initializer_list<QWidget*> kSpare{strip_, tone_, automatic_};
    const auto is_wide = [&] { return words_px + sizeHint().width() > menus_.width(); };
    for (QWidget* const one : kSpare) one->show();
    camera_->setMaximumWidth(QWIDGETSIZE_MAX);
    for (QWidget* const one : kSpare)
        if (is_wide()) one->hide();
    if (is_wide()) camera_->setMaximumWidth(kShortCamera_px);
}

void ViewBar::name_cameras() {
    {
        const Following following(follows_);
        camera_->clear();
        for (const scene::Camera& camera : app_.show()->cameras)
            camera_->addItem(QString::fromStdString(camera.name));
    }
    setEnabled(true);
    refresh();
}

// The stored camera where the picture is seen from, if it is one.
void ViewBar::refresh() {
    if (!app_.show() || follows_) return;
    const Following following(follows_);
    const scene::Camera& now = app_.camera();
    const std::optional<std::size_t> stored = app_.stored_camera();
    const int index = stored ? static_cast<int>(*stored) : -1;
    if (camera_->currentIndex() != index) camera_->setCurrentIndex(index);
    const double ev = static_cast<double>(now.auto_exposure ? app_.picture().ev100 : now.ev100);
    if (!exposure_->hasFocus() && std::abs(exposure_->value() - ev) > 0.04) exposure_->setValue(ev);
    tone_->setCurrentIndex(static_cast<int>(app_.request().tone));
}

} // namespace ghost::ui
