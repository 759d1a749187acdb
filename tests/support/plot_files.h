#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests: small plots with a head of two DMX breaks (Head.gdtf) and a mesh (Sail.glb), opened as shows.

#include "show_folder/load_show.h"
#include "support/mvr_files.h"
#include "support/tiny_glb.h"

#include "show/show.h"

#include <filesystem>
#include <fstream>
#include <string_view>

namespace ghost::scene {

namespace fs = std::filesystem;

inline std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

// A head with pan and tilt and two breaks; the lamp is 0.2 m below the pivot.
inline std::string head_gdtf(const std::string& more_modes = "") {
    fixture::Description description;
    description.geometries = R"(<Geometry Name="Base"><Axis Name="Yoke">
        <Axis Name="Head" Position="{1,0,0,0}{0,1,0,0}{0,0,1,-0.3}{0,0,0,1}">
        <Beam Name="Lamp" Position="{1,0,0,0}{0,1,0,0}{0,0,1,-0.2}{0,0,0,1}"/></Axis></Axis></Geometry>)";
    const auto channel = [](const std::string& place, const std::string& geometry,
                            const std::string& attribute, const std::string& physical) {
        return "<DMXChannel " + place + " Geometry=\"" + geometry + "\"><LogicalChannel Attribute=\"" +
               attribute + "\"><ChannelFunction Name=\"" + attribute + "\" Attribute=\"" + attribute + "\" " +
               physical + "/></LogicalChannel></DMXChannel>\n";
    };
    description.channels =
        channel("DMXBreak=\"1\" Offset=\"1,2\"", "Yoke", "Pan", "PhysicalFrom=\"-270\" PhysicalTo=\"270\"") +
        channel("DMXBreak=\"1\" Offset=\"3,4\"", "Head", "Tilt", "PhysicalFrom=\"-135\" PhysicalTo=\"135\"") +
        channel("DMXBreak=\"2\" Offset=\"1\"", "Lamp", "Dimmer", "");
    std::string xml = description.xml();
    const std::string end = "</DMXModes>";
    xml.insert(xml.find(end), more_modes);
    return text_of(fixture::make_zip({{"description.xml", xml}}));
}

inline std::string matrix(const std::string& rows) {
    return "<Matrix>" + rows + "</Matrix>";
}

inline const std::string kIdentity = "{1,0,0}{0,1,0}{0,0,1}";

inline std::string fixture_xml(int number, const std::string& name, const std::string& rows,
                               const std::string& rest, const std::string& gdtf = "Head.gdtf",
                               const std::string& mode = "Standard", const std::string& attributes = "") {
    return "<Fixture uuid=\"" + uuid(number) + "\" name=\"" + name + "\"" + attributes + ">" + matrix(rows) +
           "<GDTFSpec>" + gdtf + "</GDTFSpec><GDTFMode>" + mode + "</GDTFMode><FixtureID>" +
           std::to_string(number) + "</FixtureID>" + rest + "</Fixture>\n";
}

inline std::string object_xml(int number, const std::string& name, const std::string& rows,
                              const std::string& geometries, const std::string& rest = "") {
    return "<SceneObject uuid=\"" + uuid(number) + "\" name=\"" + name + "\">" + matrix(rows) + rest +
           "<Geometries>" + geometries + "</Geometries></SceneObject>\n";
}

inline fs::path scratch(const std::string& name) {
    const fs::path folder = fs::path(::testing::TempDir()) / ("plot_show_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

inline void write_mvr(const fs::path& path, const std::string& xml, Members members = {}) {
    members.push_back({"Head.gdtf", head_gdtf()});
    members.push_back({"Sail.glb", text_of(TinyGlb{}.bytes())});
    const std::vector<std::uint8_t> bytes = mvr_bytes(xml, std::move(members));
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline Show opened(const fs::path& path, Report& report) {
    auto show = load_show(path, true, report);
    EXPECT_TRUE(show.ok()) << show.error().text();
    return show.ok() ? std::move(*show) : Show{};
}

inline Show opened_xml(const std::string& name, const std::string& xml, Report& report,
                       Members members = {}) {
    const fs::path path = scratch(name) / "plot.mvr";
    write_mvr(path, xml, std::move(members));
    return opened(path, report);
}

inline const PatchedFixture& named(const Show& show, std::string_view name) {
    for (const PatchedFixture& fixture : show.fixtures)
        if (fixture.name == name) return fixture;
    ADD_FAILURE() << "no fixture " << name;
    static const PatchedFixture none;
    return none;
}

inline void expect_near(const glm::vec3& value, const glm::vec3& expected, float tolerance = 1e-4f) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
}

} // namespace ghost::scene
