#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests of the patch: a show folder, a window without widgets, and the part of an engine that opens what
// it is told.

#include "support/test_window.h"

#include "disk/files.h"
#include "show_file/show_toml.h"
#include "ui/actions/patch_edit.h"

#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <filesystem>

namespace ghost::ui {

namespace fs = std::filesystem;

inline const std::string kShow = R"([show]
stage = "none.glb" # not opened here
[[camera]]
name = "front"

[[fixture]]
name = "Lamp 1"
gdtf = "lamp.gdtf"
address = 1
position_m = [-3, 0, 4]

[[fixture]]
name = "Lamp 2"
gdtf = "lamp.gdtf"
address = 17
position_m = [-1, 1, 4]

[[fixture]]
name = "Lamp 3"
gdtf = "lamp.gdtf"
address = 33
position_m = [3, 0, 4]
)";

// For PatchEdit::add: there, whatever is added.
inline PatchEdit::Place at(float x_m, float y_m, float z_m) {
    return [=](const scene::PatchedFixture&) { return glm::vec3(x_m, y_m, z_m); };
}

inline std::shared_ptr<const fixture::Type> lamp() {
    static const auto type = [] {
        auto made = std::make_shared<fixture::Type>();
        for (const char* const name : {"Standard", "Short"}) {
            made->modes.emplace_back();
            made->modes.back().name = name;
            made->modes.back().footprint = {name[1] == 't' ? 16 : 8};
        }
        return made;
    }();
    return type;
}

struct Desk {
    explicit Desk(std::string where = "") : folder(std::move(where)) {
        if (folder.empty()) folder = own.path().toStdString();
        file = fs::path(folder) / "show.toml";
        const bool is_there = fs::exists(file) || write_file_atomic(file, kShow).ok();
        EXPECT_TRUE(is_there);
        QObject::connect(&document, &ShowDocument::draft_found,
                         [this](const QString& words) { draft = words; });
    }
    void open() { answer(*read_text_file(file, 1 << 20), false); }
    // What the engine does with the newest wish.
    void follow() {
        settle();
        if (const auto request = link.request.take(); request && request->text) answer(*request->text, true);
    }
    void answer(const std::string& text, bool is_edit) {
        Report report;
        auto parsed = scene::parse_show(text, file, report);
        ASSERT_TRUE(parsed.ok()) << parsed.error().text();
        for (std::size_t i = 0; i < parsed->show.fixtures.size(); ++i) {
            parsed->show.fixtures[i].type = lamp();
            if (const auto mode = fixture::find_mode(*lamp(), parsed->sources[i].mode); mode.ok())
                parsed->show.fixtures[i].mode = *mode;
        }
        Opened opened;
        opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
        opened.is_edit = is_edit;
        opened.text = app.request().text;
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    const scene::PatchedFixture& fixture(std::size_t index) { return app.show()->fixtures[index]; }
    std::string on_disk() { return *read_text_file(file, 1 << 20); }

    QTemporaryDir own;
    std::string folder;
    fs::path file;
    Link link;
    AppModel app{link};
    ShowDocument document{app};
    PatchEdit edit{app, document};
    QString draft;
};

} // namespace ghost::ui
