// SPDX-License-Identifier: Apache-2.0
#include "stage/model_reader.h"

#include "base/helper_process.h"
#include "base/text.h"
#include "disk/files.h"
#include "stage/model_wire.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{512} << 20;
constexpr std::size_t kMaxCompanions = 4096; // what one model may ask for
constexpr std::size_t kMaxNameBytes = 4096;
constexpr std::size_t kMaxMemoryBytes = std::size_t{8} << 30;
constexpr std::uint64_t kMaxHelperCpu_s = 3600; // ends one whose program was killed while it ran wild
constexpr double kCpu_s = 10.0, kCpuPerMiB_s = 1.0;
constexpr double kWaitPerCpu = 30.0;          // a machine may have much else to do
constexpr std::size_t kKeptBytes = 64u << 20; // after more, its memory is given back with it

enum Answer : std::uint64_t { kAsksFor = 1, kModel = 2 };

bool in_this_process = false;

SendBytes sender(HelperStream& stream) {
    return [&stream](Bytes bytes) { return stream.send(bytes); };
}

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// One that waits for work is kept for the next model.
std::mutex idle_mutex;
std::optional<HelperProcess>& idle() {
    static std::optional<HelperProcess> one;
    return one;
}

Result<HelperProcess> take_helper() {
    const std::lock_guard lock(idle_mutex);
    if (!idle()) return HelperProcess::start(kReadModels);
    HelperProcess taken = std::move(*idle());
    idle().reset();
    return taken;
}

void give_back(HelperProcess helper) {
    const std::lock_guard lock(idle_mutex);
    if (!idle()) idle().emplace(std::move(helper));
}

// One model's conversation with a helper.
class Reading {
public:
    Reading(HelperProcess helper, const ReadCompanion& read_companion)
        : helper_(std::move(helper)), read_companion_(read_companion), cpu_before_s_(helper_.cpu_s()),
          start_s_(now_s()) {}

    Result<ReceivedModel> read(Bytes bytes, const std::string& extension, const std::string& name) {
        const SendBytes send = sender(helper_.stream());
        exchanged_ = bytes.size();
        send_text(send, extension);
        send_text(send, name);
        send_number(send, bytes.size());
        send(bytes);
        Result<ReceivedModel> answer = conversation();
        if (!answer.ok()) {
            if (late_) {
                helper_.end();
                return Error{"reading it takes more than " + std::to_string(static_cast<int>(allowed_s())) +
                                 " s of the processor; it is given up",
                             name};
            }
            return Error{"the process that read it " + answer.error().what + " (" + helper_.end() +
                             "), as damaged files make it; it is given up",
                         name};
        }
        if (exchanged_ < kKeptBytes) give_back(std::move(helper_));
        return answer;
    }

private:
    double allowed_s() const {
        return kCpu_s + kCpuPerMiB_s * static_cast<double>(exchanged_) / static_cast<double>(1 << 20);
    }

    bool receive(std::span<std::uint8_t> bytes) {
        constexpr int kLook_ms = 200;
        HelperStream& stream = helper_.stream();
        if (!stream.flush()) return false;
        while (!stream.wait(kLook_ms)) {
            late_ = helper_.cpu_s() - cpu_before_s_ > allowed_s() ||
                    now_s() - start_s_ > kWaitPerCpu * allowed_s();
            if (late_) return false;
        }
        exchanged_ += bytes.size();
        return stream.receive(bytes);
    }

    Result<ReceivedModel> conversation() {
        const ReceiveBytes receive = [this](std::span<std::uint8_t> bytes) { return this->receive(bytes); };
        for (std::size_t asked = 0; asked <= kMaxCompanions; ++asked) {
            TRY(const std::uint64_t kind, receive_number(receive, kModel));
            if (kind == kModel) return receive_model(receive);
            TRY(const std::string name, receive_text(receive, kMaxNameBytes));
            const auto found = read_companion_(name);
            const SendBytes send = sender(helper_.stream());
            send_number(send, found.ok() ? 1 : 0);
            send_text(send, found.ok() ? "" : found.error().what);
            send_text(send, found.ok() ? "" : found.error().where);
            send_number(send, found.ok() ? found->size() : 0);
            if (found.ok()) send(*found);
            exchanged_ += found.ok() ? found->size() : 0;
        }
        return Error{"asked for more than 4096 other files", ""};
    }

    HelperProcess helper_;
    const ReadCompanion& read_companion_;
    double cpu_before_s_;
    double start_s_;
    std::size_t exchanged_ = 0;
    bool late_ = false;
};

// In the process apart: asks the other end.
Result<std::vector<std::uint8_t>> ask_for(HelperStream& stream, const std::string& name) {
    if (name.size() > kMaxNameBytes) return Error{"has a name of more than 4096 bytes", name.substr(0, 64)};
    const SendBytes send = sender(stream);
    const ReceiveBytes receive = [&stream](std::span<std::uint8_t> bytes) { return stream.receive(bytes); };
    send_number(send, kAsksFor);
    send_text(send, name);
    TRY(const std::uint64_t found, receive_number(receive, 1));
    Error error;
    TRY(error.what, receive_text(receive, kMaxFileBytes));
    TRY(error.where, receive_text(receive, kMaxFileBytes));
    TRY(auto bytes, receive_bytes(receive, kMaxFileBytes));
    if (!found) return error;
    return bytes;
}

// A file in one of the folders or below them, wherever links lead.
Result<std::vector<std::uint8_t>> read_inside(const std::filesystem::path& start,
                                              const std::vector<std::filesystem::path>& folders,
                                              const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::path file = start / name;
    const fs::path real = fs::weakly_canonical(file, code);
    for (const fs::path& folder : folders) {
        const fs::path inside = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, code);
        if (std::mismatch(inside.begin(), inside.end(), real.begin(), real.end()).first == inside.end())
            return read_file(file, kMaxFileBytes);
    }
    return Error{"lies outside of the show's folder, where nothing is read", file.string()};
}

} // namespace

Result<Stage> load_model(Bytes bytes, const std::string& extension, const std::string& name,
                         ModelSource source, Report& report, const ReadCompanion& read_companion) {
    const std::string format = lower(extension);
    const bool of_folder = source == ModelSource::folder;
    if (format != "glb" && format != "gltf" && format != "3ds" && !(of_folder && format == "obj"))
        return Error{"is a model of the kind ." + format.substr(0, 32) +
                         (of_folder ? ", expected .glb, .gltf, .3ds or .obj"
                                    : ", expected .glb, .gltf or .3ds in an archive"),
                     name};
    if (bytes.size() > kMaxFileBytes) return Error{"is larger than the limit of 512 MiB", name};
    if (in_this_process) return read_model(bytes, format, name, report, read_companion);
    TRY(HelperProcess helper, take_helper());
    TRY(ReceivedModel received, Reading(std::move(helper), read_companion).read(bytes, format, name));
    for (Message& message : received.report.messages) report.messages.push_back(std::move(message));
    return std::move(received.model);
}

Result<Stage> load_model(Bytes bytes, const std::string& extension, const std::string& name,
                         ModelSource source, Report& report) {
    return load_model(bytes, extension, name, source, report,
                      [](const std::string& companion) -> Result<std::vector<std::uint8_t>> {
                          return Error{"nothing lies beside this model", companion};
                      });
}

Result<Stage> load_stage_file(const std::filesystem::path& path, const std::filesystem::path& home,
                              Report& report) {
    TRY(const auto bytes, read_file(path, kMaxFileBytes));
    const std::string extension = path.extension().string();
    if (extension.size() < 2) return Error{"has no extension, expected a model such as .glb", path.string()};
    return load_model(bytes, extension.substr(1), path.string(), ModelSource::folder, report,
                      [&](const std::string& name) {
                          return read_inside(path.parent_path(), {path.parent_path(), home}, name);
                      });
}

Result<Stage> load_stage_file(const std::filesystem::path& path, Report& report) {
    return load_stage_file(path, path.parent_path(), report);
}

int serve_models(const ReadModel& read) {
    HelperStream stream = confine_helper(kMaxMemoryBytes, kMaxHelperCpu_s);
    const SendBytes send = sender(stream);
    const ReceiveBytes receive = [&stream](std::span<std::uint8_t> bytes) { return stream.receive(bytes); };
    while (true) {
        const auto extension = receive_text(receive, kMaxFileBytes);
        const auto name = receive_text(receive, kMaxFileBytes);
        const auto bytes = receive_bytes(receive, kMaxFileBytes);
        if (!extension.ok() || !name.ok() || !bytes.ok()) return 0;
        Report report;
        const Result<Stage> model =
            read(*bytes, *extension, *name, report,
                 [&stream](const std::string& file) { return ask_for(stream, file); });
        send_number(send, kModel);
        send_model(send, model, report);
    }
}

void read_models_in_this_process() {
    in_this_process = true;
}

} // namespace ghost::scene
