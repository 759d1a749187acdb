// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/air_panel.h"

#include "show/haze_presets.h"
#include "show/show.h"
#include "ui/actions/air_edit.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ghost::ui {
namespace {

struct HazerColumn {
    const char* title;
    const char* what; // for hazer_edit
    const char* tip;
};
constexpr HazerColumn kHazerColumns[] = {
    {QT_TRANSLATE_NOOP("Air", "Place m"), "place", QT_TRANSLATE_NOOP("Air", "X Y Z of the nozzle")},
    {QT_TRANSLATE_NOOP("Air", "Blows to"), "direction",
     QT_TRANSLATE_NOOP("Air", "X Y Z; any length: 0 0 1 is up")},
    {QT_TRANSLATE_NOOP("Air", "Rate"), "rate",
     QT_TRANSLATE_NOOP("Air", "Density 1 m before the nozzle, as a multiple of the room's")},
    {QT_TRANSLATE_NOOP("Air", "Spread°"), "spread", QT_TRANSLATE_NOOP("Air", "Full angle of the plume")},
    {QT_TRANSLATE_NOOP("Air", "Reach m"), "reach",
     QT_TRANSLATE_NOOP("Air", "From here on it is as thin as the room")},
};

// All digits that it has: an edit of one number of a cell writes the others as they stand there.
QString words(float number) {
    std::array<char, 64> digits;
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                          number == 0 ? 0.0f : number, std::chars_format::fixed)
                                .ptr;
    return QString::fromLatin1(digits.data(), end - digits.data());
}

QString words(const glm::vec3& numbers) {
    return words(numbers.x) + " " + words(numbers.y) + " " + words(numbers.z);
}

// Of a length that is none of anybody's: the show makes it 1.
QString way_words(const glm::vec3& way) {
    QStringList numbers;
    for (int axis = 0; axis < 3; ++axis) numbers << QString::number(static_cast<double>(way[axis]), 'g', 4);
    return numbers.join(' ');
}

QString text_of(const scene::Hazer& hazer, int column) {
    switch (column) {
    case 0:
        return words(hazer.position_m);
    case 1:
        return way_words(hazer.direction);
    case 2:
        return words(hazer.rate);
    case 3:
        return words(hazer.spread_deg);
    default:
        return words(hazer.reach_m);
    }
}

} // namespace

AirPanel::AirPanel(AppModel& app, ShowDocument& document, Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app), document_(document) {
    auto* layout = new QVBoxLayout(this);
    auto* about = new QLabel(
        translated("Air", "The air as the show has it: saved with it. Smoke by hand is in Scene."), this);
    about->setWordWrap(true);
    layout->addWidget(about);
    add_rows(layout);
    add_hazers(layout, actions);
    connect(&app_, &AppModel::opened_show, this, &AirPanel::refresh);
    connect(&document_, &ShowDocument::changed, this, &AirPanel::refresh);
    setEnabled(false);
}

void AirPanel::take(const Result<void>& done) {
    if (!done.ok() && complain) complain(done.error());
    refresh();
}

void AirPanel::add_rows(QLayout* layout) {
    haze_ = new QComboBox(this);
    haze_->setAccessibleName(translated("Air", "Haze"));
    connect(haze_, &QComboBox::activated, this, [this](int index) {
        const QString preset = haze_->itemData(index).toString();
        if (!preset.isEmpty()) take(AirEdit(app_, document_).set_haze(preset));
    });
    auto* haze_row = new QWidget(this);
    auto* haze_layout = new QHBoxLayout(haze_row);
    haze_layout->setContentsMargins(0, 0, 0, 0);
    auto* haze_label = new QLabel(translated("Air", "Haze"), haze_row);
    haze_label->setFixedWidth(ValueRow::label_width(*this));
    haze_label->setBuddy(haze_);
    haze_layout->addWidget(haze_label);
    haze_layout->addWidget(haze_, 1);
    layout->addWidget(haze_row);
    bounce_ = new BounceRow(app_, document_, this);
    bounce_->on_done = [this](const Result<void>& done) { take(done); };
    layout->addWidget(bounce_);
    clouds_ = new ValueRow(translated("Air", "Clouds"), {0, 1, 2, ""}, this);
    clouds_->setToolTip(translated("Air", "0: the same everywhere; 1: from nothing to twice as thick"));
    clouds_->on_change = [this](double value) {
        take(AirEdit(app_, document_).set_clouds(static_cast<float>(value)));
    };
    size_ = new ValueRow(translated("Air", "Cloud size"), {0.1, 100, 1, " m", true}, this);
    size_->on_change = [this](double value) {
        take(AirEdit(app_, document_).set_cloud_size(static_cast<float>(value)));
    };
    wind_ = new ValueRow(translated("Air", "Wind"), {0, 28, 2, " m/s"}, this);
    wind_->setToolTip(translated("Air", "Clouds drift with it, along the floor"));
    wind_->on_change = [this](double value) { blow(value, towards_deg_); };
    towards_ = new ValueRow(translated("Air", "Wind towards"), {-180, 180, 0, "°"}, this);
    towards_->setToolTip(
        translated("Air", "0: to the right as the house sees it, 90: up-stage, -90: into the house"));
    towards_->on_change = [this](double value) {
        const glm::vec3& wind_m_s = app_.show()->haze.wind_m_s;
        blow(static_cast<double>(glm::length(glm::vec2(wind_m_s))), value);
    };
    for (ValueRow* row : {clouds_, size_, wind_, towards_}) layout->addWidget(row);
}

void AirPanel::add_hazers(QLayout* layout, Actions& actions) {
    hazers_ = new QTableWidget(0, static_cast<int>(std::size(kHazerColumns)), this);
    hazers_->setTabKeyNavigation(false); // Tab leaves it
    hazers_->setAccessibleName(translated("Air", "Hazers"));
    for (int column = 0; column < hazers_->columnCount(); ++column) {
        auto* title = new QTableWidgetItem(translated("Air", kHazerColumns[column].title));
        title->setToolTip(translated("Air", kHazerColumns[column].tip));
        hazers_->setHorizontalHeaderItem(column, title);
    }
    hazers_->setSelectionBehavior(QAbstractItemView::SelectRows);
    hazers_->setSelectionMode(QAbstractItemView::SingleSelection);
    hazers_->setAlternatingRowColors(true);
    hazers_->horizontalHeader()->setStretchLastSection(true);
    hazers_->verticalHeader()->hide(); // all columns find room
    const int letter = fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair{0, 14}, {1, 12}, {2, 7}, {3, 10}, {4, 10}})
        hazers_->setColumnWidth(column, letters * letter);
    hazers_->setMinimumHeight(6 * fontMetrics().height());
    connect(hazers_, &QTableWidget::cellChanged, this, &AirPanel::edit_cell);
    connect(hazers_, &QTableWidget::itemSelectionChanged, this,
            [this] { remove_->setEnabled(hazers_->currentRow() >= 0); });
    layout->addWidget(hazers_);
    auto* add = new QPushButton(translated("Air", "Add a hazer"), this);
    add->setToolTip(translated("Air", "On the floor below what is looked at"));
    connect(add, &QPushButton::clicked, this, [this, &actions] { take(actions.run("add-hazer")); });
    remove_ = new QPushButton(translated("Air", "Remove the hazer"), this);
    remove_->setEnabled(false);
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (hazers_->currentRow() >= 0)
            take(AirEdit(app_, document_).remove_hazer(static_cast<std::size_t>(hazers_->currentRow())));
    });
    layout->addWidget(add);
    layout->addWidget(remove_);
}

// The wind's third number stays.
void AirPanel::blow(double speed_m_s, double towards_deg) {
    towards_deg_ = towards_deg;
    const auto angle_rad = static_cast<float>(towards_deg * M_PI / 180);
    const auto speed = static_cast<float>(speed_m_s);
    const glm::vec3 wind_m_s(std::cos(angle_rad) * speed, std::sin(angle_rad) * speed,
                             app_.show()->haze.wind_m_s.z);
    // Thousandths: who reads the file reads "0.5", not "0.49999997".
    take(AirEdit(app_, document_)
             .set_wind(glm::clamp(glm::round(wind_m_s * 1000.0f) / 1000.0f, -kMostWind_m_s, kMostWind_m_s)));
}

void AirPanel::edit_cell(int row, int column) {
    if (follows_) return;
    const QStringList numbers = hazers_->item(row, column)->text().split(' ', Qt::SkipEmptyParts);
    const Result<scene::HazerEdit> edit = hazer_edit(kHazerColumns[column].what, numbers);
    take(edit.ok() ? AirEdit(app_, document_).edit_hazer(static_cast<std::size_t>(row), *edit)
                   : Result<void>(edit.error()));
}

void AirPanel::refresh() {
    if (!app_.show()) return;
    setEnabled(document_.can_edit());
    const scene::HazeMedium& haze = app_.show()->haze;
    const Following following(follows_);
    show_haze();
    bounce_->show_detail(app_.show()->bounce);
    const glm::vec2 along(haze.wind_m_s);
    if (glm::length(along) > 0) {
        // -180 and 180 are the same: the one that a hand chose stays.
        const double is_deg =
            std::atan2(static_cast<double>(along.y), static_cast<double>(along.x)) * 180 / M_PI;
        if (std::abs(std::remainder(is_deg - towards_deg_, 360)) > 0.5) towards_deg_ = is_deg;
    }
    clouds_->show_value(static_cast<double>(haze.unevenness), false);
    size_->show_value(static_cast<double>(haze.patch_m), false);
    wind_->show_value(static_cast<double>(glm::length(along)), false);
    towards_->show_value(towards_deg_, false);
    show_hazers();
}

// By name, or as a number where it is none of them.
void AirPanel::show_haze() {
    const double is_per_m = static_cast<double>(app_.show()->haze.extinction_per_m);
    int found = -1;
    haze_->clear();
    for (const scene::HazePreset& preset : scene::kHazePresets) {
        const QString name =
            QString::fromUtf8(preset.name.data(), static_cast<qsizetype>(preset.name.size()));
        const double per_m = preset.extinction_per_m();
        if (std::abs(per_m - is_per_m) < 1e-6) found = haze_->count();
        haze_->addItem(translated("Air", "%1, %2 per metre").arg(said(name)).arg(per_m, 0, 'g', 4), name);
    }
    if (found < 0) {
        found = haze_->count();
        haze_->addItem(translated("Air", "%1 per metre").arg(is_per_m, 0, 'g', 4));
    }
    haze_->setCurrentIndex(found);
}

void AirPanel::show_hazers() {
    const std::vector<scene::Hazer>& hazers = app_.show()->hazers;
    hazers_->setRowCount(static_cast<int>(hazers.size()));
    for (int row = 0; row < hazers_->rowCount(); ++row)
        for (int column = 0; column < hazers_->columnCount(); ++column) {
            const QString text = text_of(hazers[static_cast<std::size_t>(row)], column);
            if (QTableWidgetItem* item = hazers_->item(row, column))
                item->setText(text);
            else
                hazers_->setItem(row, column, new QTableWidgetItem(text));
        }
    remove_->setEnabled(hazers_->currentRow() >= 0 && hazers_->currentRow() < hazers_->rowCount());
}

} // namespace ghost::ui
