// SPDX-License-Identifier: Apache-2.0
#include "render/relight/relighter.h"

#include "base/check.h"
#include "base/log.h"
#include "render/pixels/processor.h"
#include "shaders/develop.h"
#include "shaders/meter.h"
#include "shared/develop.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <span>
#include <string_view>
#include <utility>

namespace ghost::render {
namespace {

constexpr std::uint64_t kImageBytesPerPixel = 8; // six half floats for two pixels, and room
constexpr std::uint64_t kMaxLayers = 2048;       // of an image, on every device
constexpr std::uint32_t kFixedImages = 1;        // all that rests
constexpr std::uint64_t kFrameBytesPerPixel = 8; // four half floats

static_assert(static_cast<std::uint32_t>(image::Tone::agx) == shared::kToneAgx &&
              static_cast<std::uint32_t>(image::Tone::aces) == shared::kToneAces &&
              static_cast<std::uint32_t>(image::Tone::linear) == shared::kToneLinear);

std::uint32_t batch_size(const gpu::Device& device, const Settings& settings) {
    if (settings.lights_per_dispatch > 0)
        return settings.lights_per_dispatch == 1 ? 1 : shared::kLightsPerChunk;
    return device.is_cpu() ? 1 : shared::kLightsPerChunk;
}

// Where workers draw what moves, half of the tables are theirs.
std::uint32_t most_fans(const gpu::Device& device, const Settings& settings) {
    return settings.workers && !device.workers().empty() ? kKeptFans / 2 : kKeptFans;
}

bool same_faces(const std::vector<scene::LensFace>& a, const std::vector<scene::LensFace>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const scene::LensFace& one, const scene::LensFace& other) {
                          return one.glows == other.glows && one.split == other.split &&
                                 std::memcmp(&one.light, &other.light, sizeof one.light) == 0;
                      });
}

bool same_walls(const std::vector<shared::LedWall>& a, const std::vector<shared::LedWall>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const shared::LedWall& one, const shared::LedWall& other) {
                          return std::memcmp(&one, &other, sizeof one) == 0;
                      });
}

double ms_of(const std::vector<gpu::Span>& spans, std::span<const std::string_view> names) {
    double sum = 0;
    for (const gpu::Span& span : spans)
        if (std::find(names.begin(), names.end(), span.name) != names.end()) sum += span.ms;
    return sum;
}

} // namespace

double FrameStatistics::haze_ms() const {
    constexpr std::array<std::string_view, 8> kOfHaze{"haze",   "fan",       "gate",         "lonely",
                                                      "spread", "haze fill", "haze look-up", "haze left"};
    return ms_of(spans, kOfHaze);
}

double FrameStatistics::bounce_ms() const {
    constexpr std::array<std::string_view, 2> kOfBounce{"glow", "room light"};
    return ms_of(spans, kOfBounce);
}

int image_slots(std::uint64_t memory_bytes, int width, int height, int light_count) {
    const std::uint64_t image =
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * kImageBytesPerPixel;
    const auto full_tree = static_cast<std::uint64_t>(std::max(2 * light_count - 1, 1));
    return static_cast<int>(
        std::min({memory_bytes / std::max<std::uint64_t>(image, 1), full_tree, kMaxLayers - kFixedImages}));
}

Relighter::Relighter(const gpu::Device& device, const scene::Passes& passes, const shared::Gobos& gobos,
                     int light_count, const Settings& settings)
    : Relighter(device, make_pass_images(device, passes, settings.ambient, settings.haze), nullptr, nullptr,
                gobos, light_count, settings) {}

Relighter::Relighter(const gpu::Device& device, const GBuffer& g_buffer, const DistanceImages* distances,
                     const shared::Gobos& gobos, int light_count, const Settings& settings)
    : Relighter(device, PassImages{}, &g_buffer, distances, gobos, light_count, settings) {}

Relighter::Relighter(const gpu::Device& device, PassImages passes, const GBuffer* g_buffer,
                     const DistanceImages* distances, const shared::Gobos& gobos, int light_count,
                     const Settings& settings)
    : device_(device), settings_(settings), batch_size_(batch_size(device, settings)),
      light_count_(light_count), passes_(std::move(passes)), g_buffer_(g_buffer), distances_(distances),
      coarse_(settings.coarse ? std::make_unique<CoarseLight>(device, *g_buffer) : nullptr), slot_count_(0),
      tree_(light_count, slot_count_), units_(passes_.bounces.bytes() > 0), commands_(device),
      main_(device, painter_shape(most_fans(device, settings)), &commands_),
      meter_(device, shaders::kShader_meter), led_walls_(device), lens_(device, settings.lens),
      glare_(device, seen().width, seen().height, settings.glare) {
    CHECK(!settings.coarse || (settings.beams.beams == Beams::gate && !settings.illuminance));
    for (std::uint32_t tone = 0; tone < develop_.size(); ++tone)
        develop_[tone] = gpu::LateProgram(device, shaders::kShader_develop, std::vector{tone});
    if (g_buffer) dirty_tiles_ = std::make_unique<DirtyTiles>(fragments());
    // See LightPainter.
    const std::uint64_t draws = kMostDraws * static_cast<std::uint64_t>(light_count) + shared::kBeamClasses;
    if (g_buffer && distances && settings.visibility_bytes > 0)
        visibility_ = std::make_unique<Visibility>(device, fragments(), rooms(), distances->count(), draws,
                                                   settings.visibility_bytes);
    no_pages_ = gpu::Texture(device, {1, 1, 1, 1, VK_FORMAT_R16G16_UNORM, true, false});
    nothing_ = gpu::Buffer(device, LightPainter::kChunkAlign, gpu::Access::device);
    upload(gobos);
    make_images();
    if (lights_on_processor_) {
        beam_pictures_.layers = gobos.layers;
        std::copy(std::begin(gobos.texels), std::end(gobos.texels), std::begin(beam_pictures_.texels));
    }
    painter_of_.assign(static_cast<std::size_t>(light_count), ~std::size_t{0});
    // Their images are added by the processor's own vectors alone.
    if (!settings.workers || !on_processor_ || batch_size_ != 1) return;
    const std::size_t count = device.workers().size();
    for (const auto& painter : device.workers())
        painters_.push_back(std::make_unique<LightPainter>(
            *painter, painter_shape(kKeptFans / static_cast<std::uint32_t>(count)), nullptr));
}

PainterShape Relighter::painter_shape(std::uint32_t most_fans) const {
    return {.beams = settings_.beams,
            .fragments = fragments(),
            .distances = g_buffer_ ? distances_ : nullptr,
            .from_passes = !g_buffer_,
            .illuminance = settings_.illuminance,
            .air = settings_.air,
            .coarse = settings_.coarse,
            .batch_size = batch_size_,
            .light_count = static_cast<std::uint32_t>(light_count_),
            .most_fans = most_fans};
}

void Relighter::on_all(const std::function<void(LightPainter&)>& what) {
    what(main_);
    for (const auto& painter : painters_) what(*painter);
}

shared::Air even_air() {
    shared::Air air{};
    air.attenuation.quadratic = 1;
    air.per_m = 1;
    return air;
}

void Relighter::set_air(const shared::Air& air) {
    if (std::memcmp(&air, air_.mapped(), sizeof air) == 0) return;
    std::memcpy(air_.mapped(), &air, sizeof air);
    draw_anew();
}

void Relighter::set_room_light(std::shared_ptr<const scene::BounceVolumes> volumes) {
    if (volumes && !RoomLight::beyond_device(device_, *volumes).empty()) volumes = nullptr;
    if (!g_buffer_ || (!volumes && !room_light_)) return;
    if (!volumes)
        room_light_.reset();
    else {
        if (!room_light_) room_light_ = std::make_unique<RoomLight>(device_);
        room_light_->set(std::move(volumes), room_on_processor());
    }
    tree_.invalidate_frame(); // kept images know nothing of it
}

void Relighter::set_exposure(float ev100, bool automatic) {
    if (ev100 == settings_.ev100 && automatic == settings_.auto_exposure) return;
    settings_.ev100 = ev100;
    settings_.auto_exposure = automatic;
    tree_.invalidate_frame(); // kept images know no exposure
}

void Relighter::set_tone(image::Tone tone) {
    if (tone == settings_.tone) return;
    settings_.tone = tone;
    tree_.invalidate_frame(); // nor a tone curve
}

void Relighter::set_quality(const HazeQuality& quality) {
    CHECK(quality.wide_beam_step <= settings_.beams.most_wide_step);
    on_all([&](LightPainter& painter) {
        painter.haze.set_quality(quality);
        painter.wide_prepared = painter.wide_prepared && quality.wide_beam_step == wide_step_;
    });
    if (std::exchange(uses_grid_, quality.grid) && !quality.grid) draw_anew();
    wide_step_ = quality.wide_beam_step;
}

void Relighter::set_flies(bool flies) {
    flies_ = flies;
    on_all([&](LightPainter& painter) { painter.haze.set_flies(flies); });
}

void Relighter::forget() {
    draw_anew();
    if (coarse_) coarse_->forget();
    if (visibility_) visibility_->forget();
    on_all([](LightPainter& painter) { painter.haze.forget(); });
}

void Relighter::reset() {
    forget();
    on_all([](LightPainter& painter) { painter.haze.reset(); });
    tree_ = LightTree(light_count_, slot_count_);
    budget_ = {};
}

void Relighter::draw_anew() {
    tree_.invalidate_all();
    if (dirty_tiles_) dirty_tiles_->forget();
    on_all([](LightPainter& painter) { painter.forget_stage(); });
    units_.forget();
}

void Relighter::touch() {
    CHECK(g_buffer_);
    const std::vector<PixelRect> rects =
        coarse_ ? coarse_->touch(g_buffer_->changed()) : g_buffer_->changed();
    if (visibility_) visibility_->touch(rects, !coarse_ && g_buffer_->extras_moved());
    std::uint64_t pixels = 0;
    for (const PixelRect& rect : rects)
        pixels +=
            static_cast<std::uint64_t>(rect.x1 - rect.x0) * static_cast<std::uint64_t>(rect.y1 - rect.y0);
    // Where much of the picture changed, every light is drawn in most of it anyway.
    if (2 * pixels > std::uint64_t{fragments().width} * fragments().height) {
        draw_anew();
        return;
    }
    on_all([](LightPainter& painter) { painter.forget_stage(); });
    touched_ = touched_ || !rects.empty();
    tree_.invalidate_frame();
    if (!dirty_tiles_->touch(rects)) draw_anew();
}

Relighter::~Relighter() = default;

void Relighter::upload(const shared::Gobos& gobos) {
    using gpu::Access;
    using gpu::Buffer;
    using gpu::Texture;
    air_ = Buffer(device_, sizeof(shared::Air), Access::upload);
    std::memcpy(air_.mapped(), &settings_.air_field, sizeof settings_.air_field);
    work_read_ = Buffer(device_, sizeof(shared::FrameWork), Access::readback);
    exposure_ = Buffer(device_, sizeof(glm::vec4), Access::readback);
    const Fragments& whole = seen();
    pixels_ = Buffer(device_, std::uint64_t{4} * whole.width * whole.height, Access::readback);
    picture_ = Texture(device_, {whole.width, whole.height, 1, 1, VK_FORMAT_R8G8B8A8_UNORM, true, false});
    gobos_ = Texture(device_, {shared::kGoboSize, shared::kGoboSize, static_cast<std::uint32_t>(gobos.layers),
                               shared::kGoboLevels, VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, false, true});
    for (std::uint32_t level = 0; level < shared::kGoboLevels; ++level)
        gobos_.write(level, gobos.texels[level].data(), gobos.texels[level].size() * sizeof(std::uint32_t));
    make_slides(gobos.slides);
}

// A layer for each moving picture; where there is none, one that nothing reads.
void Relighter::make_slides(const std::vector<shared::SlidePicture>& slides) {
    gpu::TextureShape shape{1, 1, 1, 1, VK_FORMAT_R8G8B8A8_SRGB, false, true};
    if (!slides.empty()) {
        shape.width = shape.height = static_cast<std::uint32_t>(slides.front().side);
        shape.layers = static_cast<std::uint32_t>(slides.size());
        shape.levels = static_cast<std::uint32_t>(slides.front().levels->size());
    }
    slides_ = gpu::Texture(device_, shape);
    beam_pictures_.slides.assign(slides.size(), {});
    slide_bytes_ = 0;
    if (slides.empty()) return;
    for (const std::vector<std::uint8_t>& level : *slides.front().levels) slide_bytes_ += level.size();
    slides_upload_ = gpu::Buffer(device_, slide_bytes_ * slides.size(), gpu::Access::upload);
    set_slides(slides);
}

void Relighter::set_slides(const std::vector<shared::SlidePicture>& slides) {
    CHECK_EQ(slides.size(), beam_pictures_.slides.size());
    for (std::size_t k = 0; k < slides.size(); ++k) {
        if (beam_pictures_.slides[k].levels == slides[k].levels) continue;
        CHECK_EQ(static_cast<std::uint32_t>(slides[k].side), slides_.shape().width);
        CHECK_EQ(slides[k].levels->size(), slides_.shape().levels);
        auto* to = static_cast<std::uint8_t*>(slides_upload_.mapped()) + k * slide_bytes_;
        for (const std::vector<std::uint8_t>& level : *slides[k].levels)
            to = std::copy(level.begin(), level.end(), to);
        beam_pictures_.slides[k] = slides[k];
        if (std::find(new_slides_.begin(), new_slides_.end(), k) == new_slides_.end())
            new_slides_.push_back(k);
    }
}

// Last of all, in what memory is left.
void Relighter::make_images() {
    const Fragments& f = fragments();
    frame_ = gpu::Texture(device_,
                          {seen().width, seen().height, 1, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    // Two pixels a texel, or surface and haze of one point.
    const std::uint32_t across = coarse_ ? f.width : (f.width + 1) / 2;
    gpu::TextureShape shape{across, f.height, 1, 1, VK_FORMAT_R32G32B32A32_UINT, true, false};
    const std::uint64_t one = gpu::texture_bytes(device_, shape);
    const std::uint64_t share = share_of(Kept::images, device_); // else pictures that are read back, uploads
    const std::uint64_t room = (share - std::min(share, (kFixedImages + 1) * one)) / one;
    const int wanted = image_slots(settings_.image_memory_bytes, static_cast<int>(2 * across),
                                   static_cast<int>(f.height), light_count_);
    slot_count_ = static_cast<int>(std::min<std::uint64_t>(room, static_cast<std::uint64_t>(wanted)));
    tree_ = LightTree(light_count_, slot_count_);
    shape.layers = static_cast<std::uint32_t>(slot_count_) + kFixedImages;
    kept_ = gpu::Texture(device_, shape);

    // Of every format that the steps read and write.
    const std::array<const gpu::Texture*, 7> textures{
        &frame_, &kept_, &main_.drawn, &main_.haze_sources, &seen().places, &seen().edges, &seen().base};
    on_processor_ = settings_.pixels_on_processor && has_vectors() &&
                    std::all_of(textures.begin(), textures.end(),
                                [](const gpu::Texture* texture) { return texture->mapped() != nullptr; });
    std::vector<const gpu::Texture*> lit{&passes_.radiance};
    if (g_buffer_)
        lit = {&normals(), &(coarse_ ? coarse_->diffuse() : g_buffer_->diffuse()),
               &(coarse_ ? coarse_->specular() : g_buffer_->specular())};
    if (visibility_) lit.push_back(&visibility_->pages());
    lights_on_processor_ =
        on_processor_ && batch_size_ == 1 && settings_.surfaces && !settings_.illuminance &&
        main_.masks.mapped() && (!visibility_ || visibility_->entries().mapped()) &&
        std::all_of(lit.begin(), lit.end(),
                    [](const gpu::Texture* texture) { return texture->mapped() != nullptr; });

    std::vector<Shortage> shortages{
        main_.haze.shortage(),
        {Kept::images, static_cast<std::uint64_t>(slot_count_), static_cast<std::uint64_t>(wanted)}};
    if (visibility_) shortages.push_back(visibility_->shortage());
    if (distances_) shortages.push_back({Kept::maps, distances_->side(), distances_->wanted_side()});
    if (const std::string lowered = sentence_of(shortages); !lowered.empty())
        log_warning("memory of " + device_.name() + " is short for " + std::to_string(light_count_) +
                    " lights at " + std::to_string(f.width) + "x" + std::to_string(f.height) + ": " +
                    lowered);
}

FrameStatistics Relighter::draw(const std::vector<shared::Light>& lights) {
    scene::FrameLights lit{lights, {}, {}};
    for (const shared::Light& light : lights) lit.faces.push_back({light});
    return draw(lit);
}

FrameStatistics Relighter::draw(const scene::FrameLights& lit, const std::function<bool()>& stop) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<shared::Light>& lights = lit.lights;
    CHECK_EQ(static_cast<int>(lights.size()), light_count_);
    if (!settings_.reuse) draw_anew();
    const LightUnits::Changes changes = units_.look(budget_.choose(lights, most_lights_));
    if (settings_.lens.on && !same_faces(lit.faces, last_faces_)) {
        tree_.invalidate_frame();
        last_faces_ = lit.faces;
    }
    if (!same_walls(lit.walls, last_walls_)) {
        tree_.invalidate_frame();
        last_walls_ = lit.walls;
    }

    if (!budget_.is_short() && std::exchange(owes_, false)) tree_.invalidate_frame();

    using enum LightTree::Making;
    const Plan plan = tree_.plan(changes.changed, changes.dimmed,
                                 stop ? one_by_one : (budget_.is_short() ? by_branches : as_needed));
    FrameStatistics statistics;
    statistics.dimmed = static_cast<int>(changes.dimmed.size());
    statistics.changed = static_cast<int>(changes.changed.size()) + statistics.dimmed;
    statistics.drawn = plan.drawn;
    statistics.is_short = budget_.is_short();
    statistics.additions = plan.additions;
    if (!plan.sums.empty()) {
        on_all([](LightPainter& painter) { painter.begin_frame(); });
        commands_.begin();
        commands_.write(main_.work, std::vector<shared::FrameWork>(1));
        if (coarse_) coarse_->update(commands_);
        if (visibility_) visibility_->begin_frame(commands_, pages_full_);
        if (!new_slides_.empty()) commands_.begin_span("slides");
        for (const std::size_t k : new_slides_)
            commands_.copy(slides_upload_, k * slide_bytes_, slides_, static_cast<std::uint32_t>(k));
        new_slides_.clear();
        stop_ = stop;
        drawing_ = &statistics;
        if (make_images_of(plan, statistics)) {
            finish_frame(lit);
            run_commands(statistics);
        }
        stop_ = {};
        drawing_ = nullptr;
        touched_ = false;
        statistics.faces = lens_.drawn();
        pages_full_ = false;
        add_work(*static_cast<const shared::FrameWork*>(work_read_.mapped()), statistics);
        for (const auto& painter : painters_)
            if (painter->has_drawn)
                add_work(*static_cast<const shared::FrameWork*>(painter->work.mapped()), statistics);
    }
    statistics.draw_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

void Relighter::add_work(const shared::FrameWork& work, FrameStatistics& statistics) {
    statistics.haze_tiles += static_cast<int>(work.haze_tiles);
    statistics.surface_tiles += static_cast<int>(work.surface_tiles);
    statistics.made_units += static_cast<int>(work.made_units);
    statistics.direct_units += static_cast<int>(work.direct_units);
    pages_full_ = pages_full_ || work.units_without_page > 0;
}

// False: it was stopped, and nothing is recorded.
bool Relighter::make_images_of(const Plan& plan, FrameStatistics& statistics) {
    for (std::size_t k = 0; k < plan.sums.size(); ++k) {
        const ImageSum& sum = plan.sums[k];
        // While something moves an image that was mended would be stale in the next frame, too. Where time is
        // short most images are made again soon, and the others wait as long.
        const bool patches = dirty_tiles_ && touched_ && !stop_ && sum.target < 0 && !budget_.is_short();
        if (!patches)
            for (const Addend& addend : sum.addends) {
                const bool waits = budget_.is_short() && dirty_tiles_ &&
                                   dirty_tiles_->is_stale(addend.slot) &&
                                   !dirty_tiles_->is_stale_since(addend.slot, LightBudget::kOldest);
                if (waits)
                    owes_ = true;
                else
                    statistics.mended += mend(addend.slot);
            }
        if (patches && on_processor_)
            statistics.mended += draw_with_patch(sum);
        else
            draw_sum(sum);
        if (patches && !on_processor_) statistics.mended += patch(sum);
        if (statistics.stopped) {
            tree_.unmake(std::span(plan.sums).subspan(k));
            return false;
        }
        if (dirty_tiles_) dirty_tiles_->made(sum);
    }
    return true;
}

void Relighter::run_commands(FrameStatistics& statistics) {
    commands_.submit_and_wait();
    statistics.spans.insert(statistics.spans.end(), commands_.spans().begin(), commands_.spans().end());
}

void Relighter::record_on(LightPainter& painter) {
    if (&painter == &main_) {
        run_workers();
        return;
    }
    if (painter.is_recording) return;
    run_commands(*drawing_);
    commands_.begin();
    painter.commands.begin();
    painter.is_recording = true;
    if (!std::exchange(painter.has_drawn, true))
        painter.commands.write(painter.work, std::vector<shared::FrameWork>(1));
}

// Side by side.
void Relighter::run_workers() {
    for (const auto& painter : painters_)
        if (painter->is_recording) painter->commands.submit();
    for (const auto& painter : painters_) {
        if (!std::exchange(painter->is_recording, false)) continue;
        painter->commands.wait();
        const std::vector<gpu::Span>& spans = painter->commands.spans();
        drawing_->spans.insert(drawing_->spans.end(), spans.begin(), spans.end());
    }
}

// Between two lights: does what was recorded, and asks.
bool Relighter::wants_stop(LightPainter& painter) {
    if (!stop_ || painter.mended_tiles > 0) return false;
    run_commands(*drawing_);
    drawing_->stopped = stop_();
    if (!drawing_->stopped) commands_.begin();
    painter.begin_lights(); // those before are drawn
    return drawing_->stopped;
}

// Draws an image again in these tiles: by one painter, for there is little to do.
void Relighter::draw_tiles(const ImageSum& sum, const TileSet& tiles) {
    LightPainter* painter = &main_;
    if (uses_workers()) {
        const std::size_t known =
            sum.lights.empty() ? ~std::size_t{0} : painter_of_[static_cast<std::size_t>(sum.lights[0])];
        painter = painters_[known < painters_.size() ? known : next_painter_++ % painters_.size()].get();
    }
    record_on(*painter);
    painter->mended_tiles = painter->mending->record(painter->commands, rooms(), tiles);
    draw_part(*painter, sum);
    painter->mended_tiles = 0;
}

// Draws an image again where it is stale.
int Relighter::mend(int slot) {
    if (!dirty_tiles_ || !dirty_tiles_->is_stale(slot)) return 0;
    const ImageSum sum = dirty_tiles_->mend(slot, units_.lights());
    draw_tiles(sum, dirty_tiles_->take_stale(slot));
    return static_cast<int>(sum.lights.size());
}

// Draws the frame, lights that rest where the images of these are stale.
int Relighter::draw_with_patch(const ImageSum& sum) {
    TileSet tiles;
    const ImageSum patch = dirty_tiles_->patch(sum, units_.lights(), tiles, DirtyTiles::Lights::resting);
    int mended = 0;
    if (tiles.count() > TileLists::kMostTiles) {
        for (const Addend& addend : sum.addends) mended += mend(addend.slot);
        draw_sum(sum);
        return mended;
    }
    draw_patched(sum, patch, tiles);
    return static_cast<int>(patch.lights.size());
}

// Draws the frame again where images are stale that it was summed from.
int Relighter::patch(const ImageSum& sum) {
    TileSet tiles;
    const ImageSum patch = dirty_tiles_->patch(sum, units_.lights(), tiles, DirtyTiles::Lights::all);
    if (tiles.empty()) return 0;
    if (tiles.count() > TileLists::kMostTiles) {
        int mended = 0;
        for (const Addend& addend : sum.addends) mended += mend(addend.slot);
        draw_sum(sum);
        return mended;
    }
    draw_tiles(patch, tiles);
    return static_cast<int>(patch.lights.size() - sum.lights.size());
}

image::Image8 Relighter::picture() const {
    image::Image8 result(width(), height(), 4);
    copy_picture(result);
    return result;
}

image::ImageF Relighter::frame() {
    image::ImageF result(width(), height(), 3);
    const gpu::Buffer buffer(device_, std::uint64_t{seen().width} * seen().height * kFrameBytesPerPixel,
                             gpu::Access::readback);
    commands_.begin();
    if (!saw_) glare_.see(commands_, frame_);
    commands_.copy(glare_.seen(frame_), buffer);
    commands_.submit_and_wait();
    const auto* halves = static_cast<const std::uint16_t*>(buffer.mapped());
    for (std::size_t i = 0; i < result.samples.size() / 3; ++i) {
        const float times = 1.0f + glm::unpackHalf1x16(halves[i * 4 + 3]); // light_of_frame
        for (std::size_t c = 0; c < 3; ++c)
            result.samples[i * 3 + c] = times * glm::unpackHalf1x16(halves[i * 4 + c]);
    }
    return result;
}

float Relighter::ev100_used() const {
    return static_cast<const glm::vec4*>(exposure_.mapped())->y;
}

std::uint64_t Relighter::memory_bytes() const {
    std::uint64_t sum =
        picture_bytes() + main_.memory_bytes() + gobos_.bytes() + slides_.bytes() + slides_upload_.bytes();
    for (const auto& painter : painters_) sum += painter->memory_bytes();
    if (distances_) sum += distances_->bytes();
    for (const gpu::Buffer* buffer : {&work_read_, &exposure_}) sum += buffer->bytes();
    return sum;
}

std::uint64_t Relighter::picture_bytes() const {
    std::uint64_t sum = lens_.memory_bytes() + glare_.memory_bytes() + main_.picture_bytes() +
                        (visibility_ ? visibility_->memory_bytes() : 0) +
                        (room_light_ ? room_light_->memory_bytes() : 0) +
                        (coarse_ ? coarse_->memory_bytes() : 0);
    for (const auto& painter : painters_) sum += painter->picture_bytes();
    sum += pixels_.bytes();
    for (const gpu::Texture* texture : {&frame_, &kept_, &picture_}) sum += texture->bytes();
    if (g_buffer_) return sum + g_buffer_->memory_bytes();
    const Fragments& f = fragments();
    for (const gpu::Texture* texture : {&passes_.radiance, &passes_.bounces, &f.places, &f.edges, &f.base})
        sum += texture->bytes();
    return sum + f.view.bytes() + f.tile_bounds.bytes();
}

} // namespace ghost::render
