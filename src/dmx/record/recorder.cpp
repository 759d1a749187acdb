// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/recorder.h"

#include "base/check.h"
#include "base/text.h"
#include "disk/disk_sync.h"
#include "disk/files.h"
#include "dmx/record/ghostdmx_writer.h"
#include "dmx/record/ola_show.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace ghost::dmx {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kSyncEvery{2};

Error cannot_write(const fs::path& part) {
    return Error{std::string("cannot write: ") + std::strerror(errno), part.string()};
}

// The first of "a.unfinished-1.ghostdmx", "a.unfinished-2.ghostdmx", ... that is free.
fs::path free_name(const fs::path& path) {
    std::error_code unreadable;
    for (int number = 1;; ++number) {
        fs::path name = path.parent_path() / path.stem();
        name += ".unfinished-" + std::to_string(number);
        name += path.extension();
        if (!fs::exists(name, unreadable)) return name;
    }
}

// Opens for writing what no other program writes; locked until it is closed.
Result<std::FILE*> open_part(const fs::path& part) {
    std::FILE* const file = open_stream(part, "ab");
    if (!file) return cannot_write(part);
    if (lock_file(file)) return file;
    std::fclose(file);
    return Error{"another program is recording into it", part.string()};
}

} // namespace

Result<Recorder> Recorder::create(const fs::path& path) {
    if (path.empty()) return Error{"the name of the recording is empty, expected a file name", ""};
    std::error_code unreadable; // then opening it says why
    if (fs::is_directory(path, unreadable))
        return Error{"this is a folder, expected a file name", path.string()};
    const std::string ending = lower(path.extension().string());
    const bool ola = ending == ".show" || ending == ".txt";
    if (!ola && ending != ".ghostdmx")
        return Error{"expected a name that ends in .ghostdmx, or in .show or .txt for an OLA show file",
                     path.string()};

    Recorder recorder;
    recorder.out_ = std::make_unique<Out>();
    Out* const out = recorder.out_.get();
    out->path = out->part = path;
    out->part += ".part";
    TRY(std::FILE* const file, open_part(out->part));
    out->file = file;
    std::error_code code;
    if (fs::file_size(out->part, code) > 0 && !code) {
        recorder.kept_ = free_name(path);
        fs::rename(out->part, recorder.kept_, code);
        std::fclose(std::exchange(out->file, nullptr));
        if (code)
            return Error{"holds a recording that was not finished and cannot be moved: " + code.message(),
                         out->part.string()};
        TRY(std::FILE* const anew, open_part(out->part));
        out->file = anew;
    }
    const ByteSink sink = [out](Bytes bytes) -> Result<void> {
        if (std::fwrite(bytes.data(), 1, bytes.size(), out->file) != bytes.size() ||
            std::fflush(out->file) != 0)
            return cannot_write(out->part);
        out->bytes += bytes.size();
        return {};
    };
    if (ola)
        recorder.writer_ = std::make_unique<OlaShowWriter>(sink);
    else
        recorder.writer_ = std::make_unique<GhostdmxWriter>(sink);
    return recorder;
}

Recorder::~Recorder() {
    if (!out_ || !out_->file) return;
    if (frames_ == 0)
        discard();
    else
        std::fclose(out_->file);
}

void Recorder::discard() {
    if (out_->file) std::fclose(std::exchange(out_->file, nullptr));
    std::error_code ignored;
    fs::remove(out_->part, ignored);
}

Result<void> Recorder::append(const RecordedFrame& frame) {
    CHECK(out_->file != nullptr);
    const Result<void> written = writer_->append(frame);
    if (!written.ok())
        return written.error().where.empty() ? Error{written.error().what, out_->part.string()}
                                             : written.error();
    ++frames_;
    return {};
}

Result<void> Recorder::flush(std::chrono::microseconds now) {
    TRY_VOID(writer_->flush(now));
    const auto present = std::chrono::steady_clock::now();
    if (present - out_->synced < kSyncEvery || out_->bytes == out_->synced_bytes) return {};
    out_->synced = present;
    out_->synced_bytes = out_->bytes;
    if (!sync_to_disk(out_->file)) return cannot_write(out_->part);
    return {};
}

Result<void> Recorder::finish(std::chrono::microseconds duration) {
    CHECK(out_->file != nullptr);
    TRY_VOID(writer_->finish(duration));
    if (std::fclose(std::exchange(out_->file, nullptr)) != 0) return cannot_write(out_->part);
    return commit_temporary(out_->part, out_->path);
}

} // namespace ghost::dmx
