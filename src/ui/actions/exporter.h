#pragma once
// SPDX-License-Identifier: Apache-2.0
// Exporter: bakes, stills, films, contact sheets, paperwork and cue books as jobs (ui/model/jobs.h): what the
// commands bake, render, sheet, paper and book do, with the arguments that the window's camera, exposure and
// hand-made look ask for. They read the show from its file, so it must be saved. With a farm the job follows
// what the farm does, and the farm goes on where the job is cancelled. Errors: why a job cannot begin. Window
// thread.

#include "base/result.h"
#include "ui/model/app_model.h"
#include "ui/model/show_document.h"

#include <QObject>
#include <QString>

namespace ghost::ui {

struct BakeRequest {
    QString camera; // empty: all
    int spp = 16;
    int bounces = 0;
    QString farm; // empty: none; else as --farm takes it
};

struct PictureRequest {
    QString file;
    QString camera; // empty: as the window sees it, drawn live; else from the passes of that camera
    int width = 1920, height = 1080; // where it is drawn live; passes have their own size
    int supersample = 1;             // likewise
    double from_s = -1, to_s = -1;   // of a film; below 0: a still of AppModel::moment_s
    int fps = 30;
    QString farm; // of a film; likewise
};

// It only follows what a farm does.
bool is_on_farm(const Job& job);

class Exporter : public QObject {
    Q_OBJECT
public:
    Exporter(AppModel& app, ShowDocument& document);

    // Each gives the number of its job.
    Result<int> bake(const BakeRequest& request);
    Result<int> render(const PictureRequest& request);
    Result<int> sheet(const QString& file, int width, int height);
    // command: "paper" or "book", with its own options.
    Result<int> print(const QString& command, const QString& folder, const QStringList& options);

    // Whether its file is as it is seen, so that a job can begin.
    Result<void> check_saved() const;

private:
    Result<QString> show_file() const;
    Result<QStringList> look_arguments(bool for_farm);
    QStringList tone_arguments() const;
    QStringList eye_arguments(int width, int height) const; // of the picture

    AppModel& app_;
    ShowDocument& document_;
};

} // namespace ghost::ui
