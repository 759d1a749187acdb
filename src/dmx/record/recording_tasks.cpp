// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/recording_tasks.h"

#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "dmx/record/recorder.h"

#include <chrono>

namespace ghost::dmx {

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

    ReadOptions options(const CaptureOptions& capture) {
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

Result<void> check_ports(std::uint16_t sacn_port, std::uint16_t artnet_port) {
    if (sacn_port != artnet_port) return {};
    return Error{"port " + std::to_string(sacn_port) + " is that of sACN and of Art-Net, expected two ports",
                 "--sacn-port/--artnet-port"};
}

Result<Recording> open_recording(const std::filesystem::path& path, const CaptureOptions& capture,
                                 bool quiet) {
    TRY_VOID(check_ports(capture.sacn_port, capture.artnet_port));
    ReadingBar bar("reading", path, quiet);
    TRY(Recording recording, read_recording(path, bar.options(capture)));
    for (const Error& problem : recording.problems) log_warning(problem.text());
    return recording;
}

Result<void> check_recording(const std::filesystem::path& path, const CaptureOptions& capture) {
    TRY_VOID(check_ports(capture.sacn_port, capture.artnet_port));
    bool any = false;
    const auto read = read_frames(
        path, {capture, {}}, {}, [](std::chrono::microseconds) {},
        [&](const RecordedFrame&) -> Result<void> {
            any = true;
            return Error{"enough", ""};
        });
    return any || read.ok() ? Result<void>() : read.error();
}

bool log_damage(Player& player) {
    const std::vector<Error> damage = player.take_damage();
    for (const Error& problem : damage) log_warning(problem.text());
    return !damage.empty();
}

void log_kept(const Recorder& recorder) {
    if (!recorder.kept().empty())
        log_warning(recorder.kept().string() +
                    ": a recording of this name was not finished; it plays up to where it broke off");
}

Result<WrittenPart> write_part(const std::filesystem::path& path, const CaptureOptions& capture,
                               const PartOptions& options, const std::filesystem::path& out, bool quiet) {
    std::error_code code;
    for (const char* const ending : {"", ".part"})
        if (std::filesystem::equivalent(path, out.string() + ending, code))
            return Error{"would be written over while it is read; name another output", path.string()};
    TRY(Recorder recorder, Recorder::create(out));
    log_kept(recorder);
    Part part(options, [&](const RecordedFrame& frame) { return recorder.append(frame); });
    Result<FramesEnd> end = FramesEnd{};
    {
        ReadingBar bar("writing", out, quiet);
        const auto began = [&](std::chrono::microseconds unix_time) {
            if (unix_time.count() > 0) recorder.began(unix_time + options.from);
        };
        end = read_frames(path, bar.options(capture), options, began,
                          [&](const RecordedFrame& frame) { return part.take(frame); });
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

} // namespace ghost::dmx
