// SPDX-License-Identifier: Apache-2.0
// The part of Relighter that makes a picture of a sum of lights, by shaders or, where the device is this
// processor, by itself.
#include "base/check.h"
#include "render/pixels/develop.h"
#include "render/pixels/fold.h"
#include "render/pixels/room_light.h"
#include "render/pixels/spread.h"
#include "render/pixels/sum.h"
#include "render/pixels/surfaces.h"
#include "render/relight/planes.h"
#include "render/relight/relighter.h"
#include "shaders/develop.h"
#include "shaders/meter.h"
#include "shaders/shown_light.h"
#include "shared/coarse.h"
#include "shared/develop.h"
#include "shared/g_buffer.h"
#include "shared/present.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <utility>

namespace ghost::render {

void Relighter::step_on_processor(const char* span, const std::function<void()>& step) {
    run_workers();
    run_commands(*drawing_);
    const auto start = std::chrono::steady_clock::now();
    step();
    const auto took = std::chrono::steady_clock::now() - start;
    drawing_->spans.push_back({span, std::chrono::duration<double, std::milli>(took).count()});
    commands_.begin();
}

// patches: of the lights that rest.
void Relighter::light_on_processor(bool patches, const Plane& drawn) {
    struct OfPainter {
        const LightPainter* painter;
        const LightPainter::Left* left;
    };
    std::vector<OfPainter> all;
    on_all([&](const LightPainter& painter) {
        for (const LightPainter::Left& left : painter.left)
            if (left.to_patch == patches) all.push_back({&painter, &left});
    });
    if (all.empty()) return;
    std::sort(all.begin(), all.end(),
              [](const OfPainter& a, const OfPainter& b) { return a.left->light < b.left->light; });
    std::vector<MarkedLight> lights;
    for (const auto& [painter, left] : all) {
        MarkedLight& light = lights.emplace_back();
        light.light = left->shown;
        light.marks = static_cast<const std::uint32_t*>(painter->masks.mapped()) + left->marks;
        if (left->place > 0) light.entries = visibility_->entries_of(left->place);
    }
    step_on_processor("surfaces", [&] {
        if (g_buffer_)
            light_stage(live_surfaces(), lights, drawn);
        else
            light_passes(pass_surfaces(), lights, drawn);
    });
}

SurfacePlanes Relighter::surface_planes() const {
    const Fragments& f = fragments();
    return {.view = f.camera,
            .attenuation = static_cast<const shared::Air*>(air_.mapped())->attenuation,
            .tiles_x = static_cast<int>(f.tiles_x),
            .tiles = static_cast<int>(f.tiles_x * f.tiles_y),
            .blocks = static_cast<int>(f.blocks),
            .places = plane_of(f.places),
            .gobos = &beam_pictures_};
}

PassSurfaces Relighter::pass_surfaces() const {
    PassSurfaces surfaces{surface_planes(), {}};
    for (std::uint32_t layer = 0; layer < passes_.radiance.shape().layers; ++layer)
        surfaces.passes.push_back(plane_of(passes_.radiance, layer));
    return surfaces;
}

LiveSurfaces Relighter::live_surfaces() const {
    LiveSurfaces surfaces{surface_planes(),
                          plane_of(normals()),
                          plane_of(coarse_ ? coarse_->diffuse() : g_buffer_->diffuse()),
                          plane_of(coarse_ ? coarse_->specular() : g_buffer_->specular()),
                          {}};
    for (std::uint32_t layer = 0; visibility_ && layer < visibility_->pages().shape().layers; ++layer)
        surfaces.pages.push_back(plane_of(visibility_->pages(), layer));
    return surfaces;
}

void Relighter::fold_on_processor(const LightPainter& painter, std::vector<DrawnLights> drawn,
                                  const TileSet* tiles) {
    if (!settings_.air)
        for (DrawnLights& lights : drawn) lights.haze = {};
    const Fragments& f = fragments();
    FragmentPlanes planes{.width = static_cast<int>(f.width),
                          .height = static_cast<int>(f.height),
                          .drawn = drawn,
                          .places = plane_of(f.places),
                          .edges = plane_of(f.edges),
                          .sources = plane_of(painter.haze_sources),
                          .edge_count = f.edge_count,
                          .corners = settings_.beams.beams != Beams::gate};
    step_on_processor("fold", [&] {
        if (tiles) {
            const auto* room = static_cast<const shared::TileRoom*>(rooms().mapped());
            for (const std::uint32_t tile : tiles->list())
                if (room[tile].edges > 0) planes.parts.push_back({room[tile].first_edge, room[tile].edges});
            if (planes.parts.empty()) return;
        }
        fold_fragments(planes);
    });
}

void Relighter::add_on_processor(const ImageSum& sum, const std::vector<DrawnLights>& drawn,
                                 const std::vector<PixelRect>& parts) {
    ImageAddition images;
    for (const Addend& addend : sum.addends) {
        const glm::vec3 weight = weight_of(addend);
        if (weight == glm::vec3(0.0f)) continue;
        images.kept.push_back({kept_.mapped(static_cast<std::uint32_t>(addend.slot)), weight});
    }
    images.kept_row_bytes = kept_.row_bytes();
    images.corners = settings_.beams.beams != Beams::gate;
    const Fragments& f = fragments();
    images.drawn = drawn;
    for (DrawnLights& lights : images.drawn)
        for (Plane* plane : {&lights.surfaces, &lights.haze}) // extra fragments lie below the picture
            plane->height = static_cast<int>(f.height);
    for (const PixelRect& part : parts) images.parts.push_back({part.x0, part.y0, part.x1, part.y1});
    const Plane base = sum.base && !settings_.illuminance ? plane_of(f.base) : Plane{};
    const bool to_frame = sum.target < 0;
    const Plane kept = to_frame ? Plane{} : plane_of(kept_, static_cast<std::uint32_t>(sum.target));
    step_on_processor("add", [&] {
        if (coarse_ && to_frame)
            add_points(images, plane_of(coarse_->sums(), shared::kCoarseWhite),
                       plane_of(coarse_->sums(), shared::kCoarseLight));
        else if (coarse_)
            add_points(images, {}, kept);
        else if (to_frame)
            add_pixels(images, base, plane_of(frame_));
        else
            keep_pixels(images, base, static_cast<int>(f.width), kept);
    });
}

void Relighter::spread_on_processor() {
    const CoarsePlanes coarse = coarse_->planes();
    step_on_processor("light spread",
                      [&] { spread_points(coarse, plane_of(seen().base), plane_of(frame_)); });
    if (coarse.edge_count > 0) step_on_processor("fold", [&] { fold_extras(coarse, plane_of(frame_)); });
}

void Relighter::develop_on_processor() {
    SeenFrame seen_frame;
    step_on_processor("glare", [&] {
        seen_frame = glare_.on_processor(plane_of(frame_), lens_.brightest() + led_walls_.brightest(),
                                         seen().pixels_per_rad);
    });
    saw_ = false; // frame() makes it
    step_on_processor("develop", [&] {
        const float ev100 = settings_.auto_exposure ? metered_ev100(seen_frame) : settings_.ev100;
        const float exposure = shared::exposure_of(ev100);
        *static_cast<glm::vec4*>(exposure_.mapped()) = {exposure, ev100, 0, 0};
        const Plane picture{static_cast<std::uint8_t*>(pixels_.mapped()), std::size_t{4} * seen().width,
                            static_cast<int>(seen().width), static_cast<int>(seen().height)};
        ghost::render::develop(seen_frame, exposure, static_cast<std::uint32_t>(settings_.tone), picture);
    });
}

void Relighter::finish_frame(const scene::FrameLights& lit) {
    run_workers();
    if (on_processor_ && coarse_)
        spread_on_processor();
    else if (coarse_)
        coarse_->spread(commands_, frame_);
    add_to_frame(lit);
    commands_.copy(main_.work, work_read_, sizeof(shared::FrameWork));
    if (on_processor_)
        develop_on_processor();
    else
        develop();
}

bool Relighter::room_on_processor() const {
    const std::array<const gpu::Texture*, 3> surfaces{&g_buffer_->normals(), &g_buffer_->diffuse(),
                                                      &g_buffer_->specular()};
    return on_processor_ && std::all_of(surfaces.begin(), surfaces.end(), [](const gpu::Texture* texture) {
               return texture->mapped() != nullptr;
           });
}

void Relighter::add_room_light() {
    if (!room_on_processor()) {
        room_light_->record(commands_, *g_buffer_, settings_.illuminance, frame_);
        return;
    }
    const RoomPlanes planes = room_light_->planes(*g_buffer_, settings_.illuminance);
    if (!settings_.illuminance) step_on_processor("glow", [&] { sum_glow(planes, room_light_->glow()); });
    step_on_processor("room light",
                      [&] { ghost::render::add_room_light(planes, room_light_->glow(), plane_of(frame_)); });
}

void Relighter::add_to_frame(const scene::FrameLights& lit) {
    const Fragments& f = seen();
    if (room_light_) add_room_light();
    // Illuminance is what falls on a surface.
    if (!lit.walls.empty() && !settings_.illuminance) {
        commands_.begin_span("walls");
        led_walls_.record(commands_, f, lit.walls, gobos_, slides_, frame_);
    }
    if (settings_.lens.on) {
        commands_.begin_span("lenses");
        lens_.record(commands_, f, f.camera, lit.faces, gobos_, slides_, frame_);
    }
}

void Relighter::develop() {
    const Fragments& f = seen();
    if (glare_.on()) {
        commands_.begin_span("glare");
        glare_.record(commands_, frame_, lens_.brightest() + led_walls_.brightest(), f.pixels_per_rad);
    }
    // Measured by what is seen; where it is not measured nothing else wants that (frame() makes it).
    const bool sees = settings_.auto_exposure || !glare_.on();
    if (sees) glare_.see(commands_, frame_);
    saw_ = sees;
    const gpu::Texture& seen = glare_.seen(frame_);
    const shared::MeterPush meter{f.width, f.height, settings_.ev100, settings_.auto_exposure ? 1u : 0u};
    commands_.begin_span("meter");
    commands_.dispatch(
        meter_.get(), meter,
        shaders::MeterBindings{.frame = gpu::stored(seen), .exposure = gpu::storage(exposure_)}, 1);
    commands_.barrier();
    commands_.begin_span("develop");
    const auto tone = static_cast<std::uint32_t>(settings_.tone);
    if (sees) {
        commands_.dispatch(develop_[tone].get(), 0u,
                           shaders::DevelopBindings{.frame = gpu::stored(seen),
                                                    .exposure = gpu::uniform(exposure_),
                                                    .picture = gpu::stored(picture_)},
                           f.tiles_x, f.tiles_y);
        commands_.barrier();
    } else {
        glare_.develop(commands_, frame_, exposure_, picture_, tone);
    }
    has_pixels_ = reads_back_;
    if (!reads_back_) return;
    commands_.begin_span("read back");
    commands_.copy(picture_, pixels_);
}

void Relighter::copy_picture(image::Image8& to) const {
    CHECK(to.width == width() && to.height == height() && to.channels == 4);
    if (!std::exchange(has_pixels_, true)) {
        gpu::Commands fetch(device_);
        fetch.begin();
        fetch.copy(picture_, pixels_);
        fetch.submit_and_wait();
    }
    std::memcpy(to.samples.data(), pixels_.mapped(), to.samples.size());
}

void Relighter::put_picture(gpu::Commands& commands, const gpu::Texture& to) const {
    CHECK(to.shape().width == seen().width && to.shape().height == seen().height);
    if (!on_processor_) {
        commands.copy(picture_, to, {VkRect2D{{0, 0}, {seen().width, seen().height}}});
        return;
    }
    CHECK(to.mapped());
    const std::size_t row = std::size_t{4} * seen().width;
    const auto* from = static_cast<const std::uint8_t*>(pixels_.mapped());
    for (std::uint32_t y = 0; y < seen().height; ++y)
        std::memcpy(to.mapped() + y * to.row_bytes(), from + y * row, row);
}

void Relighter::put_light(gpu::Commands& commands, const gpu::Texture& to, float peak) {
    CHECK(to.shape().width == seen().width && to.shape().height == seen().height);
    if (!std::exchange(saw_, true)) glare_.see(commands, frame_);
    if (!shown_light_) shown_light_ = std::make_unique<gpu::Program>(device_, shaders::kShader_shown_light);
    commands.dispatch(*shown_light_, shared::ShownLightPush{static_cast<std::uint32_t>(settings_.tone), peak},
                      shaders::ShownLightBindings{.frame = gpu::stored(glare_.seen(frame_)),
                                                  .exposure = gpu::uniform(exposure_),
                                                  .picture = gpu::stored(to)},
                      seen().tiles_x, seen().tiles_y);
    commands.barrier();
}

} // namespace ghost::render
