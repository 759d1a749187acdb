#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a window shows now, as JSON, for scripts and tests: camera, selection, what is set by hand, the
// picture and its figures. Keys: docs/guide/window.md. Window thread.

#include "ui/model/app_model.h"
#include "ui/picture/view.h"

#include <QJsonObject>

namespace ghost::ui {

QJsonObject latency_json(const dmx::Latency& latency);

QJsonObject state_json(const AppModel& app, const View& view);

} // namespace ghost::ui
