#pragma once
// SPDX-License-Identifier: Apache-2.0
// NetworkPanel: who sends what: what is wrong, in sentences; all sources with their rates and losses; the 512
// values of one universe as a grid; how late the picture is; RDM. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QTableWidget>
#include <QWidget>

#include <optional>

namespace ghost::ui {

// The 512 values of a universe, 32 in a row; a value is bright where it is high, and marked for a while after
// it changed.
class UniverseGrid : public QWidget {
    Q_OBJECT
public:
    UniverseGrid(AppModel& app, QWidget* parent);
    void set_universe(int number);
    QSize sizeHint() const override;
    int across() const; // channels in a row, as many as can be read
    QRectF cell(int slot) const;
    std::optional<QRect> first_selected() const; // cell of the first channel of a selected fixture

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    bool event(QEvent* event) override; // tool tips

private:
    QSize least_cell() const;
    int names_px() const;
    int down() const;
    void take();

    AppModel& app_;
    int universe_ = 1;
    bool known_ = false;
    dmx::Levels levels_{};
    std::array<qint64, dmx::kSlots> changed_ms_{};
    std::array<int, dmx::kSlots> owner_{}; // fixture that reads the slot, or -1
    QElapsedTimer clock_;
    friend class NetworkPanel;
    void find_owners();
};

class NetworkPanel : public QWidget {
    Q_OBJECT
public:
    NetworkPanel(AppModel& app, Actions& actions, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void refresh();
    void refresh_diagnosis();
    void fit_sentences();
    void refresh_sources();
    void refresh_universes();

    AppModel& app_;
    QLabel* diagnosis_;
    QScrollArea* sentences_; // of it
    QLabel* summary_;
    QTableWidget* sources_;
    QComboBox* universes_;
    UniverseGrid* grid_;
    QSplitter* halves_; // sources, and a universe
};

} // namespace ghost::ui
