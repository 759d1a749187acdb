// SPDX-License-Identifier: Apache-2.0
#include "ui/colour_row.h"

#include "ui/theme.h"
#include "ui/value_row.h"

#include <QHBoxLayout>

namespace ghost::ui {

ColourRow::ColourRow(const QString& name, QWidget* parent)
    : QWidget(parent), name_(name), label_(new QLabel(name, this)), button_(new QPushButton(this)),
      release_(new QToolButton(this)) {
    label_->setFixedWidth(ValueRow::label_width(*this));
    button_->setAccessibleName(name);
    release_->setText("\u21BA"); // back
    release_->setToolTip("Give it back to the show and the desk");
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label_);
    layout->addWidget(button_, 1);
    layout->addWidget(release_);
    connect(button_, &QPushButton::clicked, this, &ColourRow::open_palette);
    connect(release_, &QToolButton::clicked, this, [this] {
        if (on_release) on_release();
    });
    show_colour(Qt::white, false);
}

ColourRow::~ColourRow() {
    delete palette_;
}

void ColourRow::open_palette() {
    if (!palette_) {
        palette_ = new QColorDialog(colour_, this);
        palette_->setAttribute(Qt::WA_DeleteOnClose);
        palette_->setOption(QColorDialog::NoButtons);
        palette_->setOption(QColorDialog::DontUseNativeDialog); // some are modal whatever they are told
        palette_->setWindowTitle(name_);
        connect(palette_, &QColorDialog::currentColorChanged, this, [this](const QColor& colour) {
            if (colour != colour_ && on_change) on_change(colour);
        });
    }
    palette_->show();
    palette_->raise();
    palette_->activateWindow();
}

void ColourRow::show_colour(const QColor& colour, bool by_hand) {
    colour_ = colour;
    button_->setText(by_hand ? "By hand" : "");
    button_->setStyleSheet(QString("background: %1; color: %2; border: 1px solid #55555a; padding: 4px;")
                               .arg(colour.name(), colour.lightnessF() > 0.5f ? "#111111" : "#eeeeee"));
    release_->setEnabled(by_hand);
    QPalette colours = palette();
    if (by_hand) colours.setColor(QPalette::WindowText, accent());
    label_->setPalette(colours);
}

} // namespace ghost::ui
