#pragma once
// SPDX-License-Identifier: Apache-2.0
// Relighter: draws one camera of a show, live, from its passes (Screen Space Re-Rendering) or from a
// G-buffer. Surfaces by pass x beam, haze by the gate, cone or march integrator, images of resting lights
// kept in a binary tree. Lights in, HDR frame and display picture out. Light number i means the same fixture
// in every draw. Where the device's memory runs short it keeps fewer images, and one line of warning says
// what was lowered. Main thread; the device must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "image/image.h"
#include "image/tone.h"
#include "light/frame_lights.h"
#include "passes/passes.h"
#include "render/geometry/g_buffer.h"
#include "render/geometry/pass_images.h"
#include "render/haze/distance_images.h"
#include "render/haze/haze_pass.h"
#include "render/haze/visibility.h"
#include "render/pixels/plane.h"
#include "render/pixels/surfaces.h"
#include "render/relight/coarse_light.h"
#include "render/relight/dirty_tiles.h"
#include "render/relight/glare_pass.h"
#include "render/relight/led_wall_pass.h"
#include "render/relight/lens_pass.h"
#include "render/relight/light_budget.h"
#include "render/relight/light_painter.h"
#include "render/relight/light_tree.h"
#include "render/relight/light_units.h"
#include "render/relight/room_light.h"
#include "shared/air.h"
#include "shared/gobos.h"
#include "shared/optics.h"
#include "shared/push.h"
#include "shared/types.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ghost::render {

// The same everywhere, the inverse square.
shared::Air even_air();

struct Settings {
    shared::Haze haze{};
    shared::Air air_field = even_air();
    glm::vec3 ambient{0}; // even light: colour times lux
    HazeIntegrator beams;
    LensSettings lens{.on = false};
    GlareSettings glare{.strength = 0};
    float ev100 = 6;
    bool auto_exposure = false;
    image::Tone tone = image::Tone::agx;
    bool surfaces = true; // both on but for measurements
    bool air = true;
    bool illuminance =
        false; // of a G-buffer: lux on its surfaces instead of cd/m^2, and nothing without lights
    std::uint64_t image_memory_bytes = std::uint64_t{1} << 30; // for kept images of the light tree
    // For kept visibility (render/haze/visibility.h). Which of it is made when hangs on which workgroup comes
    // first: 0, none, where two runs are to give the same bytes.
    std::uint64_t visibility_bytes = std::uint64_t{256} << 20;
    std::uint32_t most_groups = 0;         // of a dispatch of many lights; 0: what the device has
    std::uint32_t lights_per_dispatch = 0; // 0: what suits the device; 1 or kLightsPerChunk (shared/push.h)
    bool reuse = true;                     // false: every light is drawn in every frame
    // Where the device is a processor with the vectors for it: render/pixels instead of shaders.
    bool pixels_on_processor = true;
    bool coarse = false; // of a G-buffer, gate: lights at half its sides (render/relight/coarse_light.h)
    // Use those of the device (gpu/workers.h). Sums are rounded in another order then.
    bool workers = false;
};

struct FrameStatistics {
    int changed = 0;       // lights that differ from the last frame
    int dimmed = 0;        // of them, those that do in nothing but their weight
    bool is_short = false; // of time: some lights are shown as they were (render/relight/light_budget.h)
    int drawn = 0;         // lights drawn, the changed ones and those without a kept image
    int mended = 0;        // lights drawn again in the parts of kept images where something moved
    int additions = 0;     // of two images
    int haze_tiles = 0;    // of shared::kTilePixels, whose haze was drawn: once for each light
    int surface_tiles = 0; // the same for surfaces; blocks of extra fragments count as tiles
    int made_units = 0;    // of surface_tiles: visibility was made, to be kept
    int direct_units = 0;  // likewise: worked out just where light falls
    int faces = 0;         // lenses drawn
    bool stopped = false;  // there is no new picture
    double draw_ms = 0;    // whole draw(), waiting included
    std::vector<gpu::Span> spans; // GPU time; of workers side by side that of each

    double haze_ms() const;   // of that
    double bounce_ms() const; // likewise, to add bounced light
};

class Relighter {
public:
    // passes: copied to the device; its pictures are not needed afterwards. light_count: lights given to each
    // draw.
    Relighter(const gpu::Device& device, const scene::Passes& passes, const shared::Gobos& gobos,
              int light_count, const Settings& settings);
    // A free camera: materials from its G-buffer, shadows from distance maps (null: none). Both must outlive
    // this.
    Relighter(const gpu::Device& device, const GBuffer& g_buffer, const DistanceImages* distances,
              const shared::Gobos& gobos, int light_count, const Settings& settings);
    ~Relighter();

    // The faces that the camera sees may be other than the lights, and more. stop: asked after each light;
    // where it says so the picture before stays, and what was made of this one is kept for the next draw.
    FrameStatistics draw(const scene::FrameLights& lit, const std::function<bool()>& stop = {});
    // Each light has its own face.
    FrameStatistics draw(const std::vector<shared::Light>& lights);
    // The camera moved, or shadows changed: the G-buffer was drawn again.
    void forget();
    // What is drawn next depends on nothing that was drawn before: films are cut there.
    void reset();
    // Images of resting lights are drawn again, at the quality there is now.
    void draw_anew();
    // Something moved before the camera (GBuffer::update): kept images are mended where it did.
    void touch();
    // Of haze by gate, from the next frame on; at most HazeIntegrator::most_wide_step. Images of resting
    // lights stay as they were drawn, but for those from the grid when it is left.
    void set_quality(const HazeQuality& quality);
    // Lights that may turn from a frame to the next one, 0: all (render/relight/light_budget.h).
    void set_most_lights(int most) { most_lights_ = most; }
    // The camera flies: each frame sees others. What surfaces see of lamps is not kept
    // (render/haze/visibility.h), for most of them lie in no beam, and tables of the haze are plain.
    void set_flies(bool flies);
    // From the next frame on; automatic: measured, and ev100 is not used.
    void set_exposure(float ev100, bool automatic);
    // Likewise.
    void set_tone(image::Tone tone);
    // The moving pictures now, as many and as large as those of the gobos that this was made with. Lights
    // that show another one have another Slide::moment.
    void set_slides(const std::vector<shared::SlidePicture>& slides);
    // Bounced light of a free camera, from the next frame on; null, or beyond the device's limits
    // (RoomLight::beyond_device): none. Its glow is of an eye.
    void set_room_light(std::shared_ptr<const scene::BounceVolumes> volumes);
    // The haze moved. Cheap where it is even.
    void set_air(const shared::Air& air);

    int width() const { return static_cast<int>(seen().width); }
    int height() const { return static_cast<int>(seen().height); }
    bool is_coarse() const { return coarse_ != nullptr; }
    image::Image8 picture() const;              // RGBA, sRGB: the developed frame
    void copy_picture(image::Image8& to) const; // of that size
    // False: pictures stay on the device from the next one on, and picture() and copy_picture() fetch them.
    void set_reads_back(bool reads_back) { reads_back_ = reads_back; }
    // The same, for what shows it, into RGBA8 or, as light whose white is 1 (shared/present.h), RGBA16F of
    // that size; a peak above 1 goes with the latter. Where the device is a processor nothing may use `to`
    // meanwhile.
    void put_picture(gpu::Commands& commands, const gpu::Texture& to) const;
    void put_light(gpu::Commands& commands, const gpu::Texture& to, float peak);
    image::ImageF frame(); // RGB, linear Rec.2020, cd/m^2, glare included: read back
    float ev100_used() const;
    image::Tone tone() const { return settings_.tone; }
    std::uint64_t memory_bytes() const; // on the device
    // Of that, what a picture of another size has more or less of; with the G-buffer.
    std::uint64_t picture_bytes() const;

private:
    Relighter(const gpu::Device& device, PassImages passes, const GBuffer* g_buffer,
              const DistanceImages* distances, const shared::Gobos& gobos, int light_count,
              const Settings& settings);
    void upload(const shared::Gobos& gobos);
    void make_slides(const std::vector<shared::SlidePicture>& slides);
    void make_images();
    // Lights that a painter draws: whole, and where the frame is patched.
    struct Share {
        LightPainter* painter;
        std::vector<int> lights, resting;
        double work;
    };
    bool uses_workers() const { return !painters_.empty() && !stop_; }
    std::vector<Share> shares_of(const std::vector<int>& lights, const std::vector<int>& resting);
    double work_of(int light) const;
    // What follows is recorded there, after all that was recorded elsewhere.
    void record_on(LightPainter& painter);
    void run_workers();
    void clear_drawn(LightPainter& painter);
    void find_silhouettes(LightPainter& painter);
    void draw_sum(const ImageSum& sum);
    void draw_patched(const ImageSum& sum, const ImageSum& patch, const TileSet& tiles);
    bool draw_share(LightPainter& painter, const ImageSum& sum, const std::vector<int>& lights);
    void draw_part(LightPainter& painter, const ImageSum& sum);
    void add_images(LightPainter& painter, const ImageSum& sum);
    std::uint32_t most_made(const LightPainter& painter) const;
    glm::vec3 weight_of(const Addend& addend) const {
        return addend.light >= 0 ? units_.weight(addend.light) : glm::vec3(1.0f);
    }
    // What it draws is folded and added by render/pixels: all but images that are mended.
    bool adds_on_processor(const LightPainter& painter) const {
        return on_processor_ && (painter.mended_tiles == 0 || painter.into == &painter.patch);
    }
    // Surfaces are lit by render/pixels, all lights of a sum at once.
    bool leaves_surfaces(const LightPainter& painter) const;
    void light_on_processor(bool patches, const Plane& drawn);
    SurfacePlanes surface_planes() const;
    PassSurfaces pass_surfaces() const;
    LiveSurfaces live_surfaces() const;
    shared::Light light_of(const ImageSum& sum, int index) const {
        return sum.at_unit ? units_.at_unit(index) : units_.lights()[static_cast<std::size_t>(index)];
    }
    // tiles: null: all.
    void fold_on_processor(const LightPainter& painter, std::vector<DrawnLights> drawn, const TileSet* tiles);
    void add_on_processor(const ImageSum& sum, const std::vector<DrawnLights>& drawn,
                          const std::vector<PixelRect>& parts);
    void spread_on_processor();
    void develop_on_processor();
    // Does what was recorded, then a step of render/pixels, as a span.
    void step_on_processor(const char* span, const std::function<void()>& step);
    int mend(int slot);
    int draw_with_patch(const ImageSum& sum);
    int patch(const ImageSum& sum);
    void draw_tiles(const ImageSum& sum, const TileSet& tiles);
    void add_work(const shared::FrameWork& work, FrameStatistics& statistics);
    bool make_images_of(const Plan& plan, FrameStatistics& statistics);
    void run_commands(FrameStatistics& statistics);
    bool wants_stop(LightPainter& painter);
    // Both: false where it was stopped.
    // indices: of the lights, where their surfaces are left to render/pixels; empty: they are not.
    bool draw_lights(LightPainter& painter, const std::vector<shared::Light>& lights,
                     const std::vector<int>& indices, std::uint32_t beam_class, bool wide);
    void record_bounces(LightPainter& painter, const LightChunk& chunk);
    // listed: all but those whose visibility is not kept; else none but these.
    void record_surfaces(LightPainter& painter, const LightChunk& chunk, std::uint64_t keeps_offset,
                         bool listed);
    PainterShape painter_shape(std::uint32_t most_fans) const;
    void on_all(const std::function<void(LightPainter&)>& what);
    void finish_frame(const scene::FrameLights& lit);
    void add_to_frame(const scene::FrameLights& lit);
    bool room_on_processor() const; // of a free camera
    void add_room_light();
    void develop();
    const Fragments& seen() const { return g_buffer_ ? g_buffer_->fragments() : passes_.fragments; }
    const Fragments& fragments() const { return coarse_ ? coarse_->fragments() : seen(); } // lights fall on
    // Of a G-buffer: where the extra fragments of tiles lie that lights fall on, and normals.
    const gpu::Buffer& rooms() const { return coarse_ ? coarse_->rooms() : g_buffer_->rooms(); }
    const gpu::Texture& normals() const { return coarse_ ? coarse_->normals() : g_buffer_->normals(); }

    const gpu::Device& device_;
    Settings settings_;
    std::uint32_t batch_size_; // lights of one dispatch, see shared/push.h
    int light_count_;
    PassImages passes_; // one of these two
    const GBuffer* g_buffer_;
    const DistanceImages* distances_;
    std::unique_ptr<CoarseLight> coarse_; // or null
    int slot_count_;
    LightTree tree_;
    std::unique_ptr<Visibility> visibility_; // null: from passes, without shadows, or none is kept
    bool pages_full_ = false;
    bool on_processor_ = false;        // sum of the frame, spread, glare, tone curve
    bool lights_on_processor_ = false; // surfaces, but of lights whose visibility is not kept
    bool flies_ = false;
    bool owes_ = false; // the last frame has parts that are stale
    // Not of a picture at rest, whose lights are drawn once each, nor of one of a moment; where more lights
    // turn than there is time for, the next ones are others.
    bool keeps_visibility() const { return visibility_ && !flies_ && !stop_ && !budget_.is_short(); }
    // Nor of an image that is mended while other workers draw: its lights may have the places of theirs.
    bool keeps_visibility(const LightPainter& painter) const {
        const bool mends = painter.mended_tiles > 0 && painter.into == &painter.drawn;
        return keeps_visibility() && !(uses_workers() && mends);
    }
    std::unique_ptr<DirtyTiles> dirty_tiles_; // null: from passes, in which nothing moves
    bool touched_ = false;                    // since the last draw
    LightUnits units_;
    LightBudget budget_;
    int most_lights_ = 0;
    std::function<bool()> stop_;         // of the draw that runs
    FrameStatistics* drawing_ = nullptr; // likewise
    std::vector<scene::LensFace> last_faces_;
    std::vector<shared::LedWall> last_walls_;

    gpu::Commands commands_;
    LightPainter main_; // on the device, with commands_
    std::vector<std::unique_ptr<LightPainter>> painters_;
    std::vector<std::size_t> painter_of_; // lights: which drew it last; beyond all: none
    std::size_t next_painter_ = 0;
    gpu::LateProgram meter_;
    std::array<gpu::LateProgram, shared::kToneCount> develop_;
    std::uint32_t wide_step_ = 1;
    bool uses_grid_ = false;
    bool saw_ = true; // glare_ has made what is seen of the frame
    std::unique_ptr<RoomLight> room_light_; // null: none
    LedWallPass led_walls_;
    LensPass lens_;
    GlarePass glare_;
    gpu::Buffer air_, work_read_, exposure_, pixels_, nothing_;
    gpu::Texture gobos_, slides_, frame_, kept_, picture_, no_pages_;
    gpu::Buffer slides_upload_;
    shared::Gobos
        beam_pictures_; // its slides: what is in slides_, or on its way there; its texels: on_processor_
    std::vector<std::size_t> new_slides_;       // those on their way
    std::uint64_t slide_bytes_ = 0;             // of one, all levels
    std::unique_ptr<gpu::Program> shown_light_; // made where a display wants it
    bool reads_back_ = true;
    mutable bool has_pixels_ = true; // pixels_ has the picture
};

// Images that fit into a memory budget, at most what a full tree needs.
int image_slots(std::uint64_t memory_bytes, int width, int height, int light_count);

} // namespace ghost::render
