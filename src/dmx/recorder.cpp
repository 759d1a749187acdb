// SPDX-License-Identifier: Apache-2.0
#include "dmx/recording.h"

#include "base/check.h"
#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace ghost::dmx {

namespace {

std::filesystem::path part_of(const std::filesystem::path& path) {
    std::filesystem::path part = path;
    part += ".part";
    return part;
}

} // namespace

Result<Recorder> Recorder::create(const std::filesystem::path& path) {
    if (path.empty()) return Error{"the name of the recording is empty, expected a file name", ""};
    std::error_code unreadable; // then opening it says why
    if (std::filesystem::is_directory(path, unreadable))
        return Error{"this is a folder, expected a file name", path.string()};
    const std::filesystem::path part = part_of(path);
    std::FILE* file = std::fopen(part.c_str(), "wb");
    if (!file) return Error{std::string("cannot write: ") + std::strerror(errno), part.string()};
    Recorder recorder(path, file);
    TRY_VOID(recorder.append("OLA Show\n"));
    return recorder;
}

Recorder::Recorder(Recorder&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, nullptr)),
      written_(std::move(other.written_)), last_(other.last_), frames_(other.frames_), bytes_(other.bytes_) {}

Recorder::~Recorder() {
    if (!file_) return;
    std::fclose(file_);
    std::error_code ignored;
    if (frames_ == 0) std::filesystem::remove(part_of(path_), ignored);
}

Result<void> Recorder::append(const std::string& line) {
    if (std::fwrite(line.data(), 1, line.size(), file_) != line.size() || std::fflush(file_) != 0)
        return Error{std::string("cannot write: ") + std::strerror(errno), part_of(path_).string()};
    bytes_ += line.size();
    return {};
}

Result<void> Recorder::feed(const Universes& universes, std::chrono::nanoseconds now) {
    CHECK(file_ != nullptr);
    const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(now);
    for (const Universe& universe : universes.list) {
        Written& written = written_[universe.number];
        if (universe.revision == written.revision && written.slots > 0) continue;
        written.revision = universe.revision;
        const Levels& levels = *universe.levels;
        std::size_t used = kSlots;
        while (used > 1 && levels[used - 1] == 0) --used;
        written.slots = std::max(written.slots, used);

        std::string text;
        if (frames_ > 0) text = std::to_string((time - last_).count()) + "\n";
        last_ = time;
        text += std::to_string(universe.number);
        for (std::size_t i = 0; i < written.slots; ++i)
            text += (i == 0 ? " " : ",") + std::to_string(static_cast<int>(levels[i]));
        TRY_VOID(append(text + "\n"));
        ++frames_;
    }
    return {};
}

Result<void> Recorder::finish(std::chrono::nanoseconds now) {
    CHECK(file_ != nullptr);
    const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(now);
    if (frames_ > 0) TRY_VOID(append(std::to_string((time - last_).count()) + "\n"));
    if (std::fclose(std::exchange(file_, nullptr)) != 0)
        return Error{std::string("cannot write: ") + std::strerror(errno), part_of(path_).string()};
    return commit_temporary(part_of(path_), path_);
}

} // namespace ghost::dmx
