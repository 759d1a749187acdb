// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/surfaces.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QPlatformSurfaceEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kPatience_ms = 3000;
constexpr std::size_t kTimes = 3;

// Those of Qt's platforms whose windows Vulkan knows.
bool has_surfaces() {
    static const QStringList kKnown{"xcb", "wayland", "wayland-egl", "windows", "cocoa"};
    return kKnown.contains(QGuiApplication::platformName());
}

} // namespace

SurfaceWindow::SurfaceWindow(PictureSurface& of, QWindow* parent) : QWindow(parent), of_(of) {
    setSurfaceType(QSurface::VulkanSurface);
    setFlags(Qt::FramelessWindowHint | Qt::WindowTransparentForInput | Qt::WindowDoesNotAcceptFocus);
}

bool SurfaceWindow::event(QEvent* event) {
    if (event->type() == QEvent::PlatformSurface && !is_forgotten_ &&
        static_cast<QPlatformSurfaceEvent*>(event)->surfaceEventType() ==
            QPlatformSurfaceEvent::SurfaceAboutToBeDestroyed)
        of_.lose();
    // What lay over it went: a display keeps nothing of what it covered.
    if (event->type() == QEvent::Expose && !is_forgotten_ && isExposed()) of_.show_again();
    return QWindow::event(event);
}

int PictureSurface::Whole::count_ = 0;

PictureSurface::PictureSurface(AppModel& app, QWidget& widget)
    : surfaces_(Surfaces::of(app)), widget_(widget) {
    surfaces_.all_.push_back(this);
    paint_timer_.setSingleShot(true);
    paint_timer_.setInterval(0);
    connect(&paint_timer_, &QTimer::timeout, this, &PictureSurface::paint_covers);
    qApp->installEventFilter(this);
}

PictureSurface::~PictureSurface() {
    qApp->removeEventFilter(this);
    end();
    std::erase(surfaces_.all_, this);
}

const ShowerNow& PictureSurface::shower() const {
    return surfaces_.now_;
}

PictureSurface::Painting PictureSurface::painting() const {
    if (paints_covers_) return Painting::covers;
    const bool is_shown = window_ && surfaces_.state_ == Surfaces::State::device;
    return is_shown && Whole::count_ == 0 && !is_measuring_ ? Painting::nothing : Painting::all;
}

QSize PictureSurface::pixels() const {
    const double ratio = widget_.devicePixelRatioF();
    return {static_cast<int>(std::lround(widget_.width() * ratio)),
            static_cast<int>(std::lround(widget_.height() * ratio))};
}

// Of the widget, and of what lies on it.
bool PictureSurface::eventFilter(QObject* object, QEvent* event) {
    switch (event->type()) {
    case QEvent::Paint:
        if (window_ && !paints_covers_ && !is_measuring_ && object->isWidgetType() &&
            (object == &widget_ || widget_.isAncestorOf(static_cast<QWidget*>(object))))
            paint_timer_.start();
        break;
    case QEvent::Show:
        if (object == &widget_) // its window comes with it
            QMetaObject::invokeMethod(this, &PictureSurface::begin, Qt::QueuedConnection);
        break;
    case QEvent::Hide:
        if (object == &widget_) end();
        break;
    case QEvent::Move:
    case QEvent::Resize:
        if (object == &widget_) place();
        break;
    default:
        break;
    }
    return false;
}

void PictureSurface::begin() {
    if (window_ || !widget_.isVisible() ||
        (surfaces_.state_ != Surfaces::State::measured && surfaces_.state_ != Surfaces::State::device))
        return;
    QWindow* const parent = widget_.window()->windowHandle();
    if (!parent || !parent->isVisible()) return;
    measure();
    window_ = new SurfaceWindow(*this, parent);
    window_->setVulkanInstance(&surfaces_.instance_);
    place();
    window_->show();
    const VkSurfaceKHR handle = QVulkanInstance::surfaceForWindow(window_);
    if (!handle) {
        surfaces_.give_up();
        return;
    }
    static_assert(sizeof handle <= sizeof surface_.handle);
    std::memcpy(&surface_.handle, &handle, sizeof handle);
    surface_.number = ++surfaces_.numbers_;
    surface_.covers = nullptr;
    paint_covers();
}

void PictureSurface::end() {
    paint_timer_.stop();
    if (!window_) return;
    window_->forget();
    lose();
    delete window_;
    widget_.update();
}

void PictureSurface::show_again() {
    if (surface_.number > 0 && surface_.covers) surfaces_.send();
}

void PictureSurface::lose() {
    const std::uint64_t number = std::exchange(surface_.number, 0);
    if (number == 0) return;
    surfaces_.let_go_(number);
    surfaces_.send();
    if (!window_) return;
    // Not in the middle of its end.
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (surface_.number > 0 || !window_) return;
            end();
            begin();
        },
        Qt::QueuedConnection);
}

void PictureSurface::place() {
    if (!window_) return;
    const QPoint at = widget_.mapTo(widget_.window(), QPoint(0, 0));
    window_->setGeometry(QRect(at, widget_.size()));
    paint_timer_.start();
}

void PictureSurface::paint_covers() {
    if (!window_ || surface_.number == 0) return;
    const QSize size = pixels();
    auto covers = std::make_shared<image::Image8>(size.width(), size.height(), 4);
    QImage image(covers->samples.data(), size.width(), size.height(), 4 * size.width(),
                 QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(widget_.devicePixelRatioF());
    paints_covers_ = true;
    widget_.render(&image, QPoint(), QRegion(), QWidget::DrawChildren);
    paints_covers_ = false;
    const glm::ivec2 of(size.width(), size.height());
    if (surface_.covers && surface_.size == of && surface_.covers->samples == covers->samples) return;
    surface_.size = of;
    surface_.covers = std::move(covers);
    surfaces_.send();
}

// What the window takes for a picture, and for what lies over it.
void PictureSurface::measure() {
    if (surfaces_.state_ != Surfaces::State::measured) return;
    surface_.paint_ms = time_of(Painting::all);
    surface_.paint_covers_ms = time_of(Painting::covers);
}

double PictureSurface::time_of(Painting what) {
    QImage image(pixels(),
                 what == Painting::all ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(widget_.devicePixelRatioF());
    std::array<double, kTimes> took_ms{};
    is_measuring_ = true;
    paints_covers_ = what == Painting::covers;
    for (double& ms : took_ms) {
        QElapsedTimer clock;
        clock.start();
        image.fill(0);
        widget_.render(&image, QPoint(), QRegion(), QWidget::DrawChildren);
        ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    }
    is_measuring_ = paints_covers_ = false;
    std::sort(took_ms.begin(), took_ms.end());
    return took_ms[kTimes / 2];
}

Surfaces& Surfaces::of(AppModel& app) {
    if (auto* const there = app.findChild<Surfaces*>(QString(), Qt::FindDirectChildrenOnly)) return *there;
    return *new Surfaces(app);
}

Surfaces::Surfaces(AppModel& app) : QObject(&app), app_(app) {
    patience_.setSingleShot(true);
    patience_.setInterval(kPatience_ms);
    connect(&patience_, &QTimer::timeout, this, &Surfaces::give_up);
    connect(&app_, &AppModel::news_came, this, &Surfaces::read_news);
}

void Surfaces::read_news() {
    if (const auto offer = app_.link().surface_offer.take(); offer && take(*offer))
        for (PictureSurface* const one : all_) one->begin();
    const auto news = app_.link().shower.take();
    if (!news || state_ == State::window) return;
    now_ = *news;
    for (PictureSurface* const one : all_) one->widget_.update(); // which may say so
    if (news->is_decided && !news->is_device) {
        give_up();
        return;
    }
    if (news->is_decided) {
        state_ = State::device;
        patience_.stop();
    }
    for (PictureSurface* const one : all_)
        if (news->lost > 0 && one->surface_.number == news->lost) {
            one->end();
            one->begin();
        }
}

// True: there can be surfaces from now on.
bool Surfaces::take(const SurfaceOffer& offer) {
    if (state_ != State::none || !has_surfaces()) return false; // those that there are go on
    held_ = offer.instance;
    let_go_ = offer.let_go;
    instance_.setVkInstance(static_cast<VkInstance>(held_.get()));
    instance_.setFlags(QVulkanInstance::NoDebugOutputRedirect);
    if (!instance_.create()) {
        state_ = State::window;
        return false;
    }
    state_ = offer.is_measured ? State::measured : State::device;
    if (offer.is_measured) patience_.start();
    return true;
}

void Surfaces::give_up() {
    if (state_ == State::window) return;
    state_ = State::window;
    patience_.stop();
    for (PictureSurface* const one : all_) one->end();
}

void Surfaces::send() {
    std::vector<Surface> all;
    for (const PictureSurface* const one : all_)
        if (one->surface_.number > 0 && one->surface_.covers) all.push_back(one->surface_);
    app_.link().surfaces.put(std::move(all));
    app_.link().wake.raise();
}

} // namespace ghost::ui
