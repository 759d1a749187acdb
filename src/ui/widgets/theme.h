#pragma once
// SPDX-License-Identifier: Apache-2.0
// Theme: dark, for a dark room, with contrast that can be read from an arm's length. Window thread.

#include <QApplication>
#include <QColor>

namespace ghost::ui {

void set_theme(QApplication& application);

inline QColor accent() {
    return {255, 179, 71}; // warm: what is selected, and what is set by hand
}
inline QColor bad() {
    return {255, 107, 94};
}
inline QColor good() {
    return {120, 205, 130};
}
inline QColor faint() {
    return {150, 150, 150};
}

} // namespace ghost::ui
