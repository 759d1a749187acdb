#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sentences for a line that is too short for them: paths lose their folders but the last, the reason behind
// them stays.
// Pure.

#include <QString>

namespace ghost::ui {

// "/home/me/shows/tour/show.toml:12: expected a number" -> ".../tour/show.toml:12: expected a number", the
// longest path first, only as many as it takes.
QString shortened(const QString& sentence, int most_letters);

} // namespace ghost::ui
