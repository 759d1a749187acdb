// SPDX-License-Identifier: Apache-2.0
#include "ui/drafts.h"

#include "base/crc32.h"
#include "base/files.h"

#include <QFileInfo>
#include <QStandardPaths>

namespace ghost::ui {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
const std::string kHead = "# Ghostlight: changes that were not saved, of a show.toml with CRC ";

std::string crc_of(const std::string& text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    return std::to_string(crc32(Bytes(bytes, text.size())));
}

} // namespace

Drafts::Drafts(const scene::Show& show) : home_(show.folder), beside_(show.cache_folder() / "draft.toml") {
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
    std::filesystem::remove(beside_, code);
    std::filesystem::create_directories(own_.parent_path(), code);
    return write_file_atomic(own_, draft).ok() ? Result<void>() : done;
}

void Drafts::remove() const {
    std::error_code code;
    for (const std::filesystem::path& file : {beside_, own_}) std::filesystem::remove(file, code);
}

std::optional<Drafts::Found> Drafts::find(const std::string& saved) const {
    for (const std::filesystem::path& file : {beside_, own_}) {
        std::error_code code;
        if (!std::filesystem::is_regular_file(file, code)) continue;
        const auto draft = read_text_file(file, kMostBytes);
        if (!draft.ok()) continue;
        const std::size_t head = draft->find('\n');
        const bool is_ours = draft->starts_with(kHead) && head != std::string::npos;
        if (!is_ours || draft->substr(head + 1) == saved) {
            std::filesystem::remove(file, code);
            continue;
        }
        return Found{draft->substr(head + 1), QFileInfo(QString::fromStdString(file.string())).lastModified(),
                     draft->substr(kHead.size(), head - kHead.size()) == crc_of(saved)};
    }
    return std::nullopt;
}

} // namespace ghost::ui
