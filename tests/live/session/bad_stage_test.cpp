// SPDX-License-Identifier: Apache-2.0
// What bad input gets, through the real path: a show folder with a GLB and a GDTF that are wrong in one way,
// opened as the free camera opens it, stepped by DMX and drawn. Each gives a finite picture with light in it,
// and a message that names the object.
#include "live/session/session.h"

#include "support/tiny_gdtf.h"
#include "support/tiny_glb.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

// A box of 1 m about the origin, in a glTF file (Y up).
scene::TinyGlb box() {
    scene::TinyGlb glb;
    glb.with_normals = false;
    glb.positions.clear();
    for (int k = 0; k < 8; ++k)
        for (const int axis : {1, 2, 4}) glb.positions.push_back((k & axis) ? 0.5f : -0.5f);
    glb.uvs.assign(16, 0.0f);
    glb.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return glb;
}

// Floor, back wall and what else a test wants: nodes of a glTF file, all of the one mesh.
void put_nodes(scene::TinyGlb& glb, const std::vector<std::string>& more) {
    std::vector<std::string> nodes{
        R"({"name":"floor","mesh":0,"translation":[0,-0.1,0],"scale":[20,0.2,20]})",
        R"({"name":"back wall","mesh":0,"translation":[0,4,-6],"scale":[20,8,0.5]})"};
    nodes.insert(nodes.end(), more.begin(), more.end());
    glb.nodes = "[";
    glb.roots = "[";
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        glb.nodes += (k ? "," : "") + nodes[k];
        glb.roots += (k ? "," : "") + std::to_string(k);
    }
    glb.nodes += "]";
    glb.roots += "]";
}

constexpr const char* kOurSpot = "../fixtures/Vari-Lite@VL2500_Spot.gdtf";

// A folder of its own for each test, away when it is over.
class ShowFolder {
public:
    explicit ShowFolder(const std::string& name)
        : folder_(fs::temp_directory_path() / ("ghost_bad_" + std::to_string(::getpid()) + "_" + name)) {
        fs::create_directories(folder_ / "show");
        fs::create_directory_symlink(fs::absolute("assets/fixtures"), folder_ / "fixtures");
    }
    ~ShowFolder() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    ShowFolder(const ShowFolder&) = delete;
    ShowFolder& operator=(const ShowFolder&) = delete;

    fs::path show() const { return folder_ / "show"; }
    void put(const char* file, Bytes bytes) const {
        EXPECT_TRUE(write_file_atomic(show() / file, bytes).ok());
    }

    std::string gdtf = kOurSpot;
    std::string camera = "position_m = [0, -8, 2]\ntarget_m = [0, 2, 2]\n";
    std::string light = "position_m = [0, 1, 5]\n";
    std::string more; // further sections

    void write_toml() const {
        const std::string text =
            "[show]\nname = \"Bad\"\nstage = \"stage.glb\"\nambient_lux = 1\n" + more +
            "\n[shadows]\nmap_size = 128\n[[camera]]\nname = \"eye\"\nsize = [96, 54]\n" + camera +
            "[[fixture]]\nname = \"lamp\"\ngdtf = \"" + gdtf + "\"\naddress = 1\n" + light;
        EXPECT_TRUE(write_file_atomic(show() / "show.toml", text).ok());
    }

private:
    fs::path folder_;
};

struct Drawn {
    std::unique_ptr<Session> session;
    image::ImageF picture;

    bool says(const std::vector<std::string>& words) const {
        for (const Message& message : session->report.messages) {
            const std::string text = message.where + ": " + message.what;
            bool all = true;
            for (const std::string& word : words) all = all && text.find(word) != std::string::npos;
            if (all) return true;
        }
        return false;
    }
    std::string all_messages() const {
        std::string text;
        for (const Message& message : session->report.messages)
            text += message.where + ": " + message.what + "\n";
        return text;
    }
    float brightest() const { return *std::max_element(picture.samples.begin(), picture.samples.end()); }
};

// All channels that make light at full; second: the value of channel 2.
Drawn draw(const ShowFolder& folder, int second = 128) {
    folder.write_toml();
    SessionOptions options;
    options.show = folder.show().string();
    options.live = true;
    options.quiet = true;
    options.validation = true;
    auto session = open_session(options);
    EXPECT_TRUE(session.ok()) << session.error().text();
    if (!session.ok()) return {};
    Drawn drawn{std::move(*session), {}};
    dmx::Levels levels{};
    levels[0] = 255;
    levels[1] = static_cast<std::uint8_t>(second);
    levels[3] = 128;  // tilt
    levels[11] = 200; // zoom
    levels[16] = 255; // iris
    dmx::Universes universes;
    universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
    drawn.session->rig->step(universes, 1.0 / 30);
    drawn.session->draw();
    drawn.picture = drawn.session->relighter->frame();
    EXPECT_EQ(drawn.session->device->validation_errors(), 0u);
    std::size_t bad = 0, negative = 0;
    for (const float value : drawn.picture.samples) {
        bad += std::isfinite(value) ? 0 : 1;
        negative += value < -1e-4f ? 1 : 0;
    }
    EXPECT_EQ(bad, 0u) << "samples that are not finite";
    EXPECT_EQ(negative, 0u) << "samples below zero";
    return drawn;
}

TEST(bad_stage, NothingWrongIsNotComplainedAbout) {
    ShowFolder folder("good");
    scene::TinyGlb glb = box();
    put_nodes(glb, {R"({"name":"crate","mesh":0,"translation":[2,0.5,0]})"});
    folder.put("stage.glb", glb.bytes());
    const Drawn drawn = draw(folder);
    for (const Message& message : drawn.session->report.messages)
        EXPECT_EQ(message.severity, Severity::note) << message.what;
    EXPECT_GT(drawn.brightest(), 1.0f);
}

TEST(bad_stage, CameraInsideAWall) {
    ShowFolder folder("camera");
    scene::TinyGlb glb = box();
    put_nodes(glb, {});
    folder.put("stage.glb", glb.bytes());
    folder.camera = "position_m = [0, 6.1, 2]\ntarget_m = [0, 0, 2]\n";
    const Drawn drawn = draw(folder);
    EXPECT_TRUE(drawn.says({"camera 'eye'", "inside 'back wall'"})) << drawn.all_messages();
    EXPECT_FALSE(drawn.says({"inside 'floor'"})) << drawn.all_messages();
}

TEST(bad_stage, LightInsideAMesh) {
    ShowFolder folder("light");
    scene::TinyGlb glb = box();
    put_nodes(glb, {R"({"name":"crate","mesh":0,"translation":[0,5,-1],"scale":[1.5,2,1.5]})"});
    folder.put("stage.glb", glb.bytes());
    const Drawn drawn = draw(folder);
    EXPECT_TRUE(drawn.says({"fixture 'lamp'", "inside 'crate'"})) << drawn.all_messages();
    // Its light stays in there; even light shows the stage.
    EXPECT_GT(drawn.brightest(), 0.0f);
}

// Open below, as a lampshade is.
TEST(bad_stage, LightInsideAnOpenShade) {
    ShowFolder folder("shade");
    scene::TinyGlb glb = box();
    put_nodes(glb, {R"({"name":"crate","mesh":0,"translation":[0,5,-1],"scale":[1.5,2,1.5]})"});
    // Without the face that looks down: y in the file is up.
    for (std::size_t k = 0; k + 2 < glb.indices.size();) {
        const auto y = [&](std::size_t at) { return glb.positions[std::size_t{3} * glb.indices[at] + 1]; };
        const bool below = y(k) < 0 && y(k + 1) < 0 && y(k + 2) < 0;
        if (below)
            glb.indices.erase(glb.indices.begin() + static_cast<std::ptrdiff_t>(k),
                              glb.indices.begin() + static_cast<std::ptrdiff_t>(k) + 3);
        else
            k += 3;
    }
    folder.put("stage.glb", glb.bytes());
    const Drawn open = draw(folder);
    EXPECT_TRUE(open.says({"fixture 'lamp'", "inside 'crate'", "which is open"})) << open.all_messages();
}

std::vector<std::uint8_t> gdtf_with(const std::string& beam, const std::string& zoom) {
    fixture::Description description;
    description.geometries = R"(<Geometry Name="Base"><Beam Name="Bulb" )" + beam + "/></Geometry>";
    description.channels = R"(<DMXChannel Offset="1" Geometry="Bulb"><LogicalChannel Attribute="Dimmer">
        <ChannelFunction Name="Dimmer" Attribute="Dimmer"/></LogicalChannel></DMXChannel>)" +
                           zoom;
    return fixture::make_zip({{"description.xml", description.xml()}});
}

TEST(bad_stage, LensWithoutSize) {
    for (const char* kind : {"Spot", "Wash"}) {
        ShowFolder folder("lens");
        scene::TinyGlb glb = box();
        put_nodes(glb, {});
        folder.put("stage.glb", glb.bytes());
        folder.put(
            "bulb.gdtf",
            gdtf_with(std::string(R"(BeamRadius="0" FieldAngle="30" BeamAngle="25" BeamType=")") + kind + '"',
                      ""));
        folder.gdtf = "bulb.gdtf";
        // Also from a place that looks straight into it.
        folder.camera = "position_m = [0, 1, 2]\ntarget_m = [0, 1.01, 5]\n";
        const Drawn drawn = draw(folder);
        EXPECT_TRUE(drawn.says({"fixture 'lamp'", "lens of 'Bulb'", "no size"})) << drawn.all_messages();
        EXPECT_GT(drawn.brightest(), 1.0f);
    }
}

TEST(bad_stage, ZoomOfNothingAndOfAHalfSphere) {
    const std::string zoom = R"(<DMXChannel Offset="2" Geometry="Bulb"><LogicalChannel Attribute="Zoom">
        <ChannelFunction Name="Zoomer" Attribute="Zoom" PhysicalFrom="0" PhysicalTo="180"/></LogicalChannel></DMXChannel>)";
    for (const char* kind : {"Spot", "Wash"})
        for (const int level : {0, 255}) {
            SCOPED_TRACE(std::string(kind) + " " + std::to_string(level));
            ShowFolder folder("zoom");
            scene::TinyGlb glb = box();
            put_nodes(glb, {});
            folder.put("stage.glb", glb.bytes());
            folder.put(
                "bulb.gdtf",
                gdtf_with(std::string(R"(FieldAngle="180" BeamAngle="180" BeamType=")") + kind + '"', zoom));
            folder.gdtf = "bulb.gdtf";
            const Drawn drawn = draw(folder, level);
            EXPECT_TRUE(drawn.says({"fixture 'lamp'", "zoom 'Zoomer'", "0 to 180"})) << drawn.all_messages();
            EXPECT_TRUE(drawn.says({"fixture 'lamp'", "field of 'Bulb'", "180"})) << drawn.all_messages();
            EXPECT_GT(drawn.brightest(), 0.1f);
        }
}

TEST(bad_stage, DensityOfNothingAndAbsurd) {
    scene::TinyGlb glb = box();
    put_nodes(glb, {});
    struct Case {
        const char* haze;
        std::vector<std::string> words; // of the warning, none: it is allowed
        bool lit;
    };
    const Case cases[] = {
        {"[haze]\nextinction_per_m = 0\n", {}, true},
        {"[haze]\nextinction_per_m = 10\n", {"show.toml:6", "denser than any fog", "after 7 cm"}, false},
        {"[haze]\nextinction_per_m = 1e12\n", {"show.toml:6", "extinction_per_m"}, true},
        {"[haze]\nextinction_per_m = nan\n", {"show.toml:6", "extinction_per_m"}, true},
        {"[haze]\nintensity = 10\nextinction_per_m = 9\nforward_g = 0.99\nback_g = -0.99\nunevenness = "
         "1\n[[hazer]]\nposition_m = [0, 0, "
         "0]\nrate = "
         "1000\nspread_deg = 180\n",
         {"denser than any fog"},
         false},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.haze);
        ShowFolder folder("density");
        folder.put("stage.glb", glb.bytes());
        folder.more = one.haze;
        const Drawn drawn = draw(folder);
        EXPECT_TRUE(one.words.empty() || drawn.says(one.words)) << drawn.all_messages();
        EXPECT_GT(drawn.brightest(), one.lit ? 0.1f : -1e-4f);
    }
}

TEST(bad_stage, MatrixThatIsNoNumber) {
    ShowFolder folder("matrix");
    scene::TinyGlb glb = box();
    put_nodes(glb, {R"({"name":"no crate","mesh":0,"translation":[NaN,0,-Infinity]})",
                    R"({"name":"endless crate","mesh":0,"scale":[1e39,1,1]})",
                    R"({"name":"huge crate","mesh":0,"matrix":[1e38,0,0,0,0,1e38,0,0,0,0,1e38,0,0,0,0,1]})",
                    R"({"name":"flat crate","mesh":0,"scale":[1,0,1]})"});
    folder.put("stage.glb", glb.bytes());
    const Drawn drawn = draw(folder);
    EXPECT_TRUE(drawn.says({"'no crate'", "'endless crate'", "'huge crate'", "'flat crate'"}))
        << drawn.all_messages();
    EXPECT_TRUE(drawn.says({"2 numbers in it are NaN or Infinity"})) << drawn.all_messages();
    EXPECT_GT(drawn.brightest(), 1.0f);

    ShowFolder turned("turned");
    turned.put("stage.glb", glb.bytes());
    turned.light += "rotation_deg = [nan, 0, 0]\n";
    const Drawn lamp = draw(turned);
    EXPECT_TRUE(lamp.says({"rotation_deg", "lamp"}) || lamp.says({"rotation_deg", "show.toml:"}))
        << lamp.all_messages();
    EXPECT_GT(lamp.brightest(), 1.0f);
}

TEST(bad_stage, EdgesOfManyTrianglesAndTrianglesWithoutArea) {
    ShowFolder folder("edges");
    scene::TinyGlb glb = box();
    const auto first = static_cast<std::uint32_t>(glb.positions.size() / 3);
    // A fin on an edge of the box, a triangle that is a line, one that is a point.
    glb.positions.insert(glb.positions.end(), {0.9f, 0.9f, 0.0f});
    glb.uvs.insert(glb.uvs.end(), {0.0f, 0.0f});
    for (const std::uint32_t index : {3u, 7u, first, 0u, 1u, 1u, 5u, 5u, 5u}) glb.indices.push_back(index);
    put_nodes(glb, {R"({"name":"crate","mesh":0,"translation":[2,0.5,0]})"});
    folder.put("stage.glb", glb.bytes());
    const Drawn drawn = draw(folder);
    EXPECT_TRUE(drawn.says({"stage.glb", "more than two triangles", "'floor'"})) << drawn.all_messages();
    EXPECT_TRUE(drawn.says({"stage.glb", "no area", "'floor'"})) << drawn.all_messages();
    EXPECT_GT(drawn.brightest(), 1.0f);
}

// A mirrored object looks like the same object made the other way round.
TEST(bad_stage, MirroredIsDrawnAsItsTwin) {
    image::ImageF pictures[2];
    for (const bool mirrored : {false, true}) {
        ShowFolder folder(mirrored ? "mirrored" : "plain");
        scene::TinyGlb glb = box();
        glb.positions[0] = -0.8f; // not the same on both sides
        if (!mirrored) {
            for (std::size_t k = 0; k < glb.positions.size(); k += 3) glb.positions[k] = -glb.positions[k];
            for (std::size_t k = 0; k < glb.indices.size(); k += 3)
                std::swap(glb.indices[k], glb.indices[k + 1]);
        }
        const std::string scale = mirrored ? "[-1,1,1]" : "[1,1,1]";
        const std::string wide = mirrored ? "[-20,0.2,20]" : "[20,0.2,20]";
        glb.nodes = R"([{"name":"floor","mesh":0,"translation":[0,-0.1,0],"scale":)" + wide +
                    R"(},{"name":"crate","mesh":0,"translation":[1,0.5,-1],"scale":)" + scale + "}]";
        glb.roots = "[0,1]";
        folder.put("stage.glb", glb.bytes());
        const Drawn drawn = draw(folder);
        EXPECT_EQ(drawn.says({"mirrored", "'floor'", "'crate'"}), mirrored) << drawn.all_messages();
        pictures[mirrored ? 1 : 0] = drawn.picture;
    }
    double worst = 0, most = 0;
    for (std::size_t k = 0; k < pictures[0].samples.size(); ++k) {
        const double a = pictures[0].samples[k], b = pictures[1].samples[k];
        worst = std::max(worst, std::abs(a - b));
        most = std::max(most, a);
    }
    EXPECT_GT(most, 1.0);
    EXPECT_LE(worst, 0.002 * most);
}

TEST(bad_stage, TwoMillionTriangles) {
    const auto start = std::chrono::steady_clock::now();
    ShowFolder folder("large");
    constexpr std::uint32_t kSide = 1001;
    scene::TinyGlb glb;
    glb.positions.clear();
    glb.uvs.clear();
    glb.indices.clear();
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const float u = static_cast<float>(x) / (kSide - 1) - 0.5f;
            const float v = static_cast<float>(y) / (kSide - 1) - 0.5f;
            glb.positions.insert(glb.positions.end(),
                                 {20 * u, 0.2f * std::sin(60 * u) * std::cos(50 * v), 20 * v});
            glb.uvs.insert(glb.uvs.end(), {u, v});
        }
    for (std::uint32_t y = 0; y + 1 < kSide; ++y)
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t a = y * kSide + x;
            glb.indices.insert(glb.indices.end(), {a, a + kSide, a + 1, a + 1, a + kSide, a + kSide + 1});
        }
    glb.nodes = R"([{"name":"hills","mesh":0}])";
    folder.put("stage.glb", glb.bytes());
    const Drawn drawn = draw(folder);
    EXPECT_EQ(drawn.session->live->stage().meshes[0].indices.size(), 6'000'000u);
    EXPECT_TRUE(drawn.says({"more than a million triangles", "'hills'"})) << drawn.all_messages();
    EXPECT_GT(drawn.brightest(), 1.0f);
    std::printf("two million triangles: opened and drawn in %.1f s\n",
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

} // namespace
} // namespace ghost::app
