#pragma once
// SPDX-License-Identifier: Apache-2.0
// PictureSurface: a part of a window in which the graphics device itself shows the picture. A window of its
// own lies over the widget, lets mouse and keys through, and has what the widget and its children paint over
// the picture as an image, painted anew when any of them is. Surfaces: all of these, and what the engine says
// of them (link/surfaces.h). Where there can be none, or the window is faster, widgets paint the picture
// themselves. Window thread.

#include "link/surfaces.h"
#include "ui/model/app_model.h"

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <QVulkanInstance>
#include <QWidget>
#include <QWindow>

#include <cstdint>
#include <memory>
#include <vector>

namespace ghost::ui {

class PictureSurface;
class Surfaces;

// Lies over the widget and is only seen.
class SurfaceWindow : public QWindow {
    Q_OBJECT
public:
    SurfaceWindow(PictureSurface& of, QWindow* parent);
    void forget() { is_forgotten_ = true; }

protected:
    bool event(QEvent* event) override;

private:
    PictureSurface& of_;
    bool is_forgotten_ = false; // whose end nobody has to be told
};

class PictureSurface : public QObject {
    Q_OBJECT
public:
    // What the widget is to paint now.
    enum class Painting {
        all,
        covers,  // all but the picture, on what is transparent
        nothing, // it is not seen
    };

    // Paints the picture, too: on a picture of the window.
    class Whole {
    public:
        Whole() { ++count_; }
        ~Whole() { --count_; }
        Whole(const Whole&) = delete;
        Whole& operator=(const Whole&) = delete;

    private:
        friend class PictureSurface;
        static int count_;
    };

    PictureSurface(AppModel& app, QWidget& widget);
    ~PictureSurface() override;

    Painting painting() const;
    const ShowerNow& shower() const;
    // Nobody sees what is painted now.
    bool is_measuring() const { return is_measuring_; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    friend class Surfaces;
    friend class SurfaceWindow;

    void begin();
    void end();
    void place();
    void lose(); // Qt takes its window away
    void show_again();
    void paint_covers();
    void measure();
    double time_of(Painting what);
    QSize pixels() const;

    Surfaces& surfaces_;
    QWidget& widget_;
    QPointer<SurfaceWindow> window_; // a child of that of the widget; null: there is none now
    Surface surface_;                // number 0: none
    QTimer paint_timer_;
    bool paints_covers_ = false, is_measuring_ = false;
};

class Surfaces : public QObject {
    Q_OBJECT
public:
    // That of the window.
    static Surfaces& of(AppModel& app);
    explicit Surfaces(AppModel& app);

private:
    friend class PictureSurface;
    enum class State {
        none,     // nobody has offered to
        measured, // it is about to be
        device,
        window, // for good
    };

    void read_news();
    bool take(const SurfaceOffer& offer);
    void give_up();
    void send();

    AppModel& app_;
    State state_ = State::none;
    ShowerNow now_;
    std::shared_ptr<void> held_; // of instance_, and goes after it
    QVulkanInstance instance_;
    std::function<void(std::uint64_t)> let_go_;
    std::vector<PictureSurface*> all_;
    std::uint64_t numbers_ = 0;
    QTimer patience_; // with a measurement
};

} // namespace ghost::ui
