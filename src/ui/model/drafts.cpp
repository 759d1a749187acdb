// SPDX-License-Identifier: Apache-2.0
#include "ui/model/drafts.h"

#include "base/log.h"
#include "disk/crc32.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "disk/user_file.h"
#include "show/show.h"

#include <QFileInfo>
#include <QStandardPaths>

#include <tuple>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kMostAside = 100;
constexpr std::size_t kMostHead = 128; // bytes above the text
const std::string kHead = "# Ghostlight: changes that were not saved, of a show.toml with CRC ";

std::string crc_of(const std::string& text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    return std::to_string(crc32(Bytes(bytes, text.size())));
}

// Shows that lie in one folder have drafts of their own.
std::string name_of(const std::filesystem::path& show) {
    const std::string file = show.filename().string();
    return file == "show.toml" ? "draft.toml" : "draft of " + file;
}

} // namespace

Drafts::Drafts(const scene::Show& show)
    : home_(show.cache_home()), beside_(show.cache_folder() / name_of(show.file)) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    std::error_code code;
    own_ = std::filesystem::path(folder.toStdString()) / "ghostlight" / "drafts" /
           (crc_of(std::filesystem::absolute(show.file, code).string()) + ".toml");
}

Result<void> Drafts::write(const std::string& text, const std::string& saved) const {
    const std::string draft = kHead + crc_of(saved) + "\n" + text;
    std::error_code code;
    Result<void> done = make_folders(beside_.parent_path(), home_);
    if (done.ok()) done = write_file_atomic(beside_, draft);
    if (done.ok()) {
        std::filesystem::remove(own_, code);
        return {};
    }
    std::filesystem::create_directories(own_.parent_path(), code);
    if (!write_file_atomic(own_, draft).ok()) return done; // an older one beside is better than none
    remove_beside();
    return {};
}

Result<std::filesystem::path> Drafts::write_aside(const std::string& text) const {
    const std::string name =
        "draft-" + QDateTime::currentDateTime().toString("yyyyMMdd-hhmmss").toStdString();
    for (const std::filesystem::path& folder : {beside_.parent_path(), own_.parent_path()}) {
        const bool is_beside = folder == beside_.parent_path();
        std::error_code code;
        if (!is_beside) std::filesystem::create_directories(folder, code);
        if (is_beside && !make_folders(folder, home_).ok()) continue;
        const std::filesystem::path temporary = temporary_beside(folder / "draft.toml");
        if (!write_file_atomic(temporary, text).ok()) continue;
        for (int number = 1; number <= kMostAside; ++number) {
            const std::filesystem::path path = folder / (name + "-" + std::to_string(number) + ".toml");
            if (const auto done = commit_new(temporary, path); done.ok() && *done) return path;
        }
        std::filesystem::remove(temporary, code);
    }
    return Error{"what is not saved can be kept nowhere", beside_.string()};
}

Result<Hold> Drafts::hold(Hold::Other other) const {
    auto beside = Hold::take(beside_.parent_path() / "window.lock", home_, other);
    if (beside.ok()) return beside;
    const std::filesystem::path folder = own_.parent_path().parent_path() / "locks";
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    return Hold::take(folder / own_.stem(), folder, other);
}

void Drafts::remove() const {
    std::error_code code;
    remove_beside();
    std::filesystem::remove(own_, code);
}

void Drafts::remove_beside() const {
    const auto folder = OwnFolder::open(beside_.parent_path(), home_);
    if (folder.ok()) folder->remove_file(beside_.filename().string());
}

// A disk that stops taking anything keeps the older one of the two. One of this text goes before one of
// another, which may be that of another disk at the same place.
std::optional<Drafts::Found> Drafts::find(const std::string& saved) const {
    const bool is_ours_beside = OwnFolder::open(beside_.parent_path(), home_).ok();
    std::optional<Found> best;
    for (const std::filesystem::path& file : {beside_, own_}) {
        std::error_code code;
        if ((file == beside_ && !is_ours_beside) || !std::filesystem::is_regular_file(file, code)) continue;
        const auto draft = read_text_file(file, scene::kMaxShowBytes + kMostHead);
        if (!draft.ok()) {
            log_warning(draft.error().text() + ": the draft is not offered");
            continue;
        }
        const std::size_t head = draft->find('\n');
        const bool is_ours = draft->starts_with(kHead) && head < kMostHead;
        if (is_ours && draft->size() - head - 1 > scene::kMaxShowBytes) { // no edit takes it
            log_warning(file.string() + ": holds more than a show file may: the draft is not offered");
            continue;
        }
        if (!is_ours || draft->substr(head + 1) == saved) {
            if (is_ours) std::filesystem::remove(file, code);
            continue;
        }
        Found found{draft->substr(head + 1), QFileInfo(QString::fromStdString(file.string())).lastModified(),
                    draft->substr(kHead.size(), head - kHead.size()) == crc_of(saved)};
        if (!best || std::tie(found.of_this, found.when) > std::tie(best->of_this, best->when))
            best = std::move(found);
    }
    return best;
}

} // namespace ghost::ui
