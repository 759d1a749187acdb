// SPDX-License-Identifier: Apache-2.0
#include "cli/render/channel_sheet.h"

#include "base/interrupt.h"
#include "fixture/sweep.h"
#include "fixture_files/load_type.h"
#include "image/ldr.h"
#include "live/session/caption.h"
#include "live/session/made_session.h"
#include "live/session/settle.h"

#include "base/log.h"
#include "base/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace ghost::app {
namespace {

using glm::vec3;

constexpr int kTitle_px = 11;
constexpr int kColumns = 8;
constexpr std::size_t kMostTrials = 2 * kColumns;
constexpr float kDarker_ev = 2.5f;
constexpr float kDarkerFace_ev = 1.0f;
constexpr std::uint8_t kAlike = 6; // of 255: nobody sees it
constexpr vec3 kLens_m{0.0f, 0.0f, 3.0f};
constexpr double kArrived_s = 5; // so late nothing moves any more

scene::Mesh quad(const vec3& corner, const vec3& right, const vec3& up) {
    scene::Mesh mesh;
    mesh.positions = {corner, corner + right, corner + right + up, corner + up};
    mesh.normals.assign(4, glm::normalize(glm::cross(right, up)));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

// A floor and a wall.
scene::Stage hall() {
    scene::Stage stage;
    scene::Material grey;
    grey.base_colour = vec3(0.5f);
    scene::Material dark = grey;
    dark.base_colour = vec3(0.12f);
    stage.materials = {grey, dark};
    scene::Mesh wall = quad({-8, fixture::kSweepWall_m, 0}, {16, 0, 0}, {0, 0, 7});
    wall.name = "wall";
    scene::Mesh floor = quad({-8, -4, 0}, {16, 0, 0}, {0, 12, 0});
    floor.name = "floor";
    floor.material = 1;
    stage.meshes = {wall, floor};
    for (int k = 0; k < 2; ++k) {
        scene::Instance instance;
        instance.name = stage.meshes[static_cast<std::size_t>(k)].name;
        instance.mesh = k;
        stage.instances.push_back(instance);
    }
    return stage;
}

// As it hangs so that its first beam, at rest, leaves kLens_m straight towards the wall, with its up upwards;
// returns how far its beams lie apart.
float hang(const fixture::Patch& patch, const std::vector<std::uint8_t>& rest, scene::PatchedFixture& hung) {
    fixture::State state = fixture::make_state(patch);
    fixture::step(state, patch, fixture::decode_levels(patch, rest), kArrived_s,
                  fixture::Motion::as_commanded);
    vec3 low(1e9f), high(-1e9f);
    for (const fixture::BeamState& beam : state.beams) {
        low = glm::min(low, vec3(beam.to_fixture[3]));
        high = glm::max(high, vec3(beam.to_fixture[3]));
    }
    const glm::mat3 beam(state.beams.front().to_fixture);
    const glm::mat3 frame(glm::normalize(beam[0]), glm::normalize(beam[1]), glm::normalize(beam[2]));
    const glm::mat3 turn = glm::mat3(vec3(1, 0, 0), vec3(0, 0, 1), vec3(0, -1, 0)) * glm::transpose(frame);
    // Rz Ry Rx; columns first.
    hung.rotation_deg =
        glm::degrees(vec3(std::atan2(turn[1][2], turn[2][2]), -std::asin(std::clamp(turn[0][2], -1.0f, 1.0f)),
                          std::atan2(turn[0][1], turn[0][0])));
    hung.position_m = kLens_m - turn * (0.5f * (low + high));
    return glm::length(high - low);
}

std::vector<scene::Camera> cameras(const ChannelSheetOptions& options, float across_m) {
    scene::Camera side;
    side.name = "side";
    side.position_m = {-4.2f, 2.0f, 3.5f};
    side.target_m = {-0.1f, 6.2f, 3.0f};
    side.fov_y_deg = 42;
    scene::Camera wall;
    wall.name = "wall";
    wall.position_m = {0, 0.8f, 2.2f};
    wall.target_m = {0, fixture::kSweepWall_m, 3.2f};
    wall.fov_y_deg = 40;
    scene::Camera face;
    face.name = "face";
    const float away_m = 1.0f + 1.5f * across_m;
    face.position_m = kLens_m + away_m * vec3(-0.5f, 0.85f, 0.25f);
    face.target_m = kLens_m;
    face.fov_y_deg = 42;
    std::vector<scene::Camera> all{side, wall, face};
    for (scene::Camera& camera : all) {
        camera.width = options.width;
        camera.height = options.height;
        camera.auto_exposure = true;
    }
    return all;
}

void put(const image::Image8& picture, int x, int y, image::Image8& sheet) {
    for (int row = 0; row < picture.height; ++row)
        std::copy_n(picture.at(0, row), 4 * picture.width, sheet.at(x, y + row));
}

image::Image8 ground(std::int64_t width, std::int64_t height) {
    image::Image8 picture(static_cast<int>(width), static_cast<int>(height), 4);
    std::fill(picture.samples.begin(), picture.samples.end(), kSheetGround);
    for (std::size_t i = 3; i < picture.samples.size(); i += 4) picture.samples[i] = 255;
    return picture;
}

bool are_alike(const image::Image8& a, const image::Image8& b) {
    for (std::size_t i = 0; i < a.samples.size(); ++i)
        if (std::abs(a.samples[i] - b.samples[i]) > kAlike) return false;
    return true;
}

int lines_of(const fixture::ChannelSweep& channel) {
    return (static_cast<int>(channel.trials.size()) + kColumns - 1) / kColumns;
}

} // namespace

Result<void> draw_channel_sheet(const ChannelSheetOptions& options) {
    TRY(fixture::LoadedType loaded, fixture::load_type(options.file));
    scene::Show show;
    show.file = options.file;
    show.name = loaded.type.name;
    show.motion = fixture::Motion::as_commanded;
    show.stage = hall();
    show.haze.extinction_per_m = 0.05f;
    show.ambient_lux = 0.3f;
    scene::PatchedFixture hung;
    hung.name = loaded.type.name;
    hung.gdtf = options.file;
    hung.type = std::make_shared<const fixture::Type>(std::move(loaded.type));
    if (hung.type->modes.empty()) return Error{"has no DMX mode", options.file};
    const Result<int> mode = fixture::find_mode(*hung.type, options.mode);
    if (!mode.ok()) return Error{mode.error().what, options.file};
    hung.mode = *mode;
    const fixture::Patch patch = hung.patch();
    if (patch.mode_of().beams.empty())
        return Error{"mode '" + patch.mode_of().name + "' has nothing that shines", options.file};
    const fixture::Sweep sweep = fixture::sweep_of(patch, kMostTrials);
    show.cameras = cameras(options, hang(patch, sweep.rest, hung));
    show.fixtures.push_back(hung);

    const std::int64_t width = kSheetGap_px + std::int64_t{kColumns} * (options.width + kSheetGap_px);
    std::int64_t height = kSheetGap_px;
    int count = 0;
    for (const fixture::ChannelSweep& channel : sweep.channels) {
        height +=
            kTitle_px + kSheetGap_px + std::int64_t{lines_of(channel)} * (options.height + kSheetGap_px);
        count += static_cast<int>(channel.trials.size());
    }
    if (width * height > kMostSheetPixels)
        return Error{std::to_string(sweep.channels.size()) + " channels are " + std::to_string(width) + "x" +
                         std::to_string(height) + " pixels, at most " + std::to_string(kMostSheetPixels) +
                         " are possible",
                     "--size"};

    SessionOptions session_options;
    session_options.live = true;
    session_options.shadows = false; // nothing stands in the way, and maps of it would be kept
    session_options.device = options.device;
    session_options.quiet = options.quiet;
    session_options.tone = options.tone;
    session_options.view = !options.view.empty()              ? options.view
                           : patch.mode_of().beams.size() > 1 ? "face"
                                                              : "side";
    TRY(const std::unique_ptr<Session> session, open_session(session_options, std::move(show), {}));
    catch_interrupts();
    const auto now_s = [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    Progress progress("contact sheet", options.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      now_s());
    const auto draw = [&](const std::vector<std::uint8_t>& levels) {
        fixture::Programmer programmer;
        programmer.levels = levels;
        settle(*session->rig, {}, {{0, programmer}});
        session->draw();
        return session->relighter->picture();
    };
    // Exposed for the fixture at rest, all pictures alike; before the wall so that its light is not white.
    draw(sweep.rest);
    session->relighter->set_exposure(session->relighter->ev100_used() +
                                         (session_options.view == "face" ? kDarkerFace_ev : kDarker_ev),
                                     false);
    const image::Image8 at_rest = draw(sweep.rest);

    image::Image8 sheet = ground(width, height);
    int top = kSheetGap_px, drawn = 0;
    for (const fixture::ChannelSweep& channel : sweep.channels) {
        bool changes = channel.trials.empty();
        int place = 0;
        image::Image8 first;
        for (const fixture::Trial& trial : channel.trials) {
            if (interrupted()) return Error{"interrupted: nothing is written", options.out};
            image::Image8 picture = draw(trial.levels);
            if (first.empty()) first = picture;
            // What a single trial does shows beside the fixture at rest only.
            changes = changes || !are_alike(picture, first) ||
                      (channel.trials.size() == 1 && !are_alike(picture, at_rest));
            draw_caption(picture, trial.caption);
            put(picture, kSheetGap_px + place % kColumns * (options.width + kSheetGap_px),
                top + kTitle_px + kSheetGap_px + place / kColumns * (options.height + kSheetGap_px), sheet);
            ++place;
            progress.update(static_cast<double>(++drawn) / count, now_s(), channel.title);
        }
        image::Image8 title = ground(width - 2 * kSheetGap_px, kTitle_px);
        draw_caption(title, channel.title + (changes ? "" : " - changes nothing here"));
        put(title, kSheetGap_px, top, sheet);
        if (!changes) log_warning("channel " + channel.title + " changes nothing in these pictures");
        top += kTitle_px + kSheetGap_px + lines_of(channel) * (options.height + kSheetGap_px);
    }
    progress.finish();
    TRY_VOID(image::write_png(options.out, sheet));
    log_info("wrote " + options.out + ": " + std::to_string(sweep.channels.size()) + " channels, " +
             std::to_string(count) + " pictures");
    return {};
}

} // namespace ghost::app
