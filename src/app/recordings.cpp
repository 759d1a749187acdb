// SPDX-License-Identifier: Apache-2.0
#include "app/recordings.h"

#include "app/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "dmx/recorder.h"

#include <chrono>

namespace ghost::app {

namespace {

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Reading with a bar; false from its function when the user interrupts.
class ReadingBar {
public:
    ReadingBar(const std::string& label, const std::filesystem::path& path, bool quiet)
        : bar_(label, quiet ? Progress::Style::silent : Progress::style_for_stderr(), now_s()),
          name_(path.filename().string()) {}
    ~ReadingBar() { bar_.finish(); }
    ReadingBar(const ReadingBar&) = delete;
    ReadingBar& operator=(const ReadingBar&) = delete;

    dmx::ReadOptions options(const dmx::CaptureOptions& capture) {
        return {capture, [this](double share) {
                    bar_.update(share, now_s(), name_);
                    return !interrupted();
                }};
    }

private:
    InterruptScope scope_;
    Progress bar_;
    std::string name_;
};

} // namespace

dmx::CaptureOptions capture_options(const InputOptions& options) {
    dmx::CaptureOptions result;
    result.sacn_port = options.sacn_port;
    result.artnet_port = options.artnet_port;
    result.artnet_offset = options.artnet_offset;
    result.show_preview = options.show_preview;
    return result;
}

Result<dmx::Recording> open_recording(const std::filesystem::path& path, const dmx::CaptureOptions& capture,
                                      bool quiet) {
    TRY_VOID(check_ports(capture.sacn_port, capture.artnet_port));
    ReadingBar bar("reading", path, quiet);
    TRY(dmx::Recording recording, dmx::read_recording(path, bar.options(capture)));
    for (const Error& problem : recording.problems) log_warning(problem.text());
    return recording;
}

Result<void> check_recording(const std::filesystem::path& path, const dmx::CaptureOptions& capture) {
    TRY_VOID(check_ports(capture.sacn_port, capture.artnet_port));
    bool any = false;
    const auto read = dmx::read_frames(
        path, {capture, {}}, {}, [](std::chrono::microseconds) {},
        [&](const dmx::RecordedFrame&) -> Result<void> {
            any = true;
            return Error{"enough", ""};
        });
    return any || read.ok() ? Result<void>() : read.error();
}

bool log_damage(const dmx::Player& player) {
    const std::vector<Error> damage = player.take_damage();
    for (const Error& problem : damage) log_warning(problem.text());
    return !damage.empty();
}

void log_kept(const dmx::Recorder& recorder) {
    if (!recorder.kept().empty())
        log_warning(recorder.kept().string() +
                    ": a recording of this name was not finished; it plays up to where it broke off");
}

Result<WrittenPart> write_part(const std::filesystem::path& path, const dmx::CaptureOptions& capture,
                               const dmx::PartOptions& options, const std::filesystem::path& out,
                               bool quiet) {
    std::error_code code;
    for (const char* const ending : {"", ".part"})
        if (std::filesystem::equivalent(path, out.string() + ending, code))
            return Error{"would be written over while it is read; name another output", path.string()};
    TRY(dmx::Recorder recorder, dmx::Recorder::create(out));
    log_kept(recorder);
    dmx::Part part(options, [&](const dmx::RecordedFrame& frame) { return recorder.append(frame); });
    Result<dmx::FramesEnd> end = dmx::FramesEnd{};
    {
        ReadingBar bar("writing", out, quiet);
        const auto began = [&](std::chrono::microseconds unix_time) {
            if (unix_time.count() > 0) recorder.began(unix_time + options.from);
        };
        end = dmx::read_frames(path, bar.options(capture), options, began,
                               [&](const dmx::RecordedFrame& frame) { return part.take(frame); });
    }
    const auto stop = [&](const Error& error) {
        recorder.discard();
        return error;
    };
    if (!end.ok()) return stop(end.error());
    for (const Error& problem : end->problems) log_warning(problem.text());
    const auto duration = part.finish(end->duration);
    if (!duration.ok()) return stop(duration.error());
    if (options.from > end->duration)
        return stop({"--from lies behind the end at " +
                         std::to_string(std::chrono::duration<double>(end->duration).count()) + " s",
                     path.string()});
    if (recorder.frames() == 0 && !end->problems.empty())
        return stop({"nothing of it can be read: it is damaged as a whole", path.string()});
    TRY_VOID(recorder.finish(*duration));
    return WrittenPart{std::chrono::duration<double>(*duration).count(), recorder.frames(), recorder.bytes(),
                       end->problems.size()};
}

} // namespace ghost::app
