// SPDX-License-Identifier: Apache-2.0
// Archives made to hurt: each ends in a clear message, with little memory, and what is sound is kept. The
// limits stand in docs/reference/gdtf.md.
#include "support/tiny_gdtf.h"

#include "archives/archive.h"
#include "base/message_cap.h"
#include "fixture/decode.h"
#include "fixture_files/common/mesh_check.h"

#include <algorithm>
#include <set>

namespace ghost::fixture {
namespace {

// size spaces, deflated 1032 to 1: two bits for each 258 (RFC 1951, one dynamic block).
std::string deflated_spaces(std::size_t size) {
    std::string out;
    std::uint32_t buffer = 0;
    int filled = 0;
    const auto bits = [&](std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i) {
            buffer |= ((value >> i) & 1u) << filled;
            if (++filled == 8) {
                out.push_back(static_cast<char>(buffer));
                buffer = 0;
                filled = 0;
            }
        }
    };
    bits(1, 1);  // last block
    bits(2, 2);  // dynamic
    bits(29, 5); // 286 literals and lengths
    bits(0, 5);  // one distance
    bits(14, 4); // 18 lengths of the code for lengths, in RFC 1951's order: 18 has 1 bit, 2 and 1 have 2
    for (const std::uint32_t length :
         {0u, 0u, 1u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 2u, 0u, 2u})
        bits(length, 3);
    const auto zeros = [&](std::uint32_t count) {
        bits(0, 1);
        bits(count - 11, 7);
    };
    const auto two = [&] { bits(3, 2); };
    zeros(32);
    two(); // ' '
    zeros(138);
    zeros(85);
    two(); // end of block
    zeros(28);
    bits(1, 2); // 285: 258 bytes, one bit: code 10 read from its high bit
    bits(1, 2); // the distance: one bit
    bits(1, 2); // ' ': code 10
    for (std::size_t done = 1; done + 258 <= size; done += 258) bits(0, 2);
    for (std::size_t rest = (size - 1) % 258; rest > 0; --rest) bits(1, 2);
    bits(3, 2); // end: code 11
    if (filled) out.push_back(static_cast<char>(buffer));
    return out;
}

// One entry whose unpacked size is what we say.
std::vector<std::uint8_t> deflated_zip(const std::string& name, const std::string& packed,
                                       std::uint32_t claimed) {
    std::vector<std::uint8_t> zip = make_zip({{name, packed}}, 8);
    const std::string signature("PK\x01\x02", 4);
    const auto record = std::search(zip.begin(), zip.end(), signature.begin(), signature.end());
    for (int i = 0; i < 4; ++i) {
        zip[static_cast<std::size_t>(22 + i)] = static_cast<std::uint8_t>(claimed >> (8 * i));
        *(record + 24 + i) = static_cast<std::uint8_t>(claimed >> (8 * i));
    }
    return zip;
}

std::string error_of(const std::vector<std::uint8_t>& zip) {
    const auto result = load_gdtf(zip, "bomb.gdtf");
    return result ? "" : result.error().text();
}

std::string repeat(const std::string& text, std::size_t times) {
    std::string result;
    result.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
}

TEST(hostile_zip, the_test_s_own_deflate_unpacks) {
    const std::string spaces(1000, ' ');
    std::vector<std::uint8_t> zip = make_zip({{"a", deflated_spaces(1000)}}, 8);
    const std::string signature("PK\x01\x02", 4);
    const auto record = std::search(zip.begin(), zip.end(), signature.begin(), signature.end());
    const std::uint32_t crc = crc_of(spaces);
    for (int i = 0; i < 4; ++i) {
        *(record + 16 + i) = zip[static_cast<std::size_t>(14 + i)] =
            static_cast<std::uint8_t>(crc >> (8 * i));
        *(record + 24 + i) = zip[static_cast<std::size_t>(22 + i)] =
            static_cast<std::uint8_t>(1000u >> (8 * i));
    }
    auto archive = Archive::open(zip, "a.zip");
    ASSERT_TRUE(archive) << archive.error().text();
    const auto bytes = archive->read("a");
    ASSERT_TRUE(bytes) << bytes.error().text();
    EXPECT_EQ(std::string(bytes->begin(), bytes->end()), spaces);
}

TEST(hostile_zip, xml_of_200_megabytes_is_refused_by_its_size) {
    const std::string packed = deflated_spaces(200u << 20);
    EXPECT_LT(packed.size(), 300000u);
    EXPECT_NE(error_of(deflated_zip("description.xml", packed, 200u << 20))
                  .find("description.xml: unpacks to 209715200 bytes, at most 33554432 are allowed"),
              std::string::npos);
}

TEST(hostile_zip, a_ratio_of_a_thousand_is_a_bomb) {
    const std::string error =
        error_of(deflated_zip("description.xml", deflated_spaces(20u << 20), 20u << 20));
    EXPECT_NE(error.find("taken for a zip bomb"), std::string::npos) << error;
}

TEST(hostile_zip, an_entry_that_is_longer_than_it_claims_is_damaged) {
    const std::string error = error_of(deflated_zip("description.xml", deflated_spaces(20u << 20), 1000));
    EXPECT_NE(error.find("damaged or cut short"), std::string::npos) << error;
}

TEST(hostile_zip, the_sum_of_what_is_read_is_limited) {
    const std::string data(600, 'x');
    const std::vector<std::uint8_t> zip = make_zip({{"a", data}, {"b", data}});
    auto archive = Archive::open(zip, "a.zip", {.total_bytes = 1000});
    ASSERT_TRUE(archive);
    EXPECT_TRUE(archive->read("a"));
    const auto second = archive->read("b");
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().text().find("more than the 1000 bytes"), std::string::npos);
}

TEST(hostile_zip, too_many_entries) {
    std::vector<std::pair<std::string, std::string>> files{{"description.xml", Description{}.xml()}};
    for (int i = 0; i < 5000; ++i) files.emplace_back("f" + std::to_string(i), "");
    EXPECT_NE(error_of(make_zip(files)).find("5001 entries, at most 4096"), std::string::npos);
}

TEST(hostile_zip, paths_that_climb_out_and_names_that_come_twice) {
    Description description;
    description.wheels = R"(<Wheel Name="W"><Slot Name="A" MediaFileName="../../evil"/></Wheel>)";
    const std::vector<std::uint8_t> zip = make_zip({{"description.xml", description.xml()},
                                                    {"wheels/../../evil.png", "x"},
                                                    {"..\\up.png", "x"},
                                                    {"/etc/passwd", "x"},
                                                    {"C:/windows", "x"},
                                                    {"description.xml", "<GDTF/>"}});
    const auto file = load_gdtf(zip, "climb.gdtf");
    ASSERT_TRUE(file) << file.error().text();
    for (const char* name : {"wheels/../../evil.png", "..\\up.png", "/etc/passwd", "C:/windows"})
        EXPECT_TRUE(says(*file, {name, "leaves the archive"})) << name;
    EXPECT_TRUE(says(*file, {"a second entry 'description.xml'"}));
    EXPECT_TRUE(says(*file, {"wheels/../../evil.png is not in the archive"}));
    EXPECT_EQ(file->type.name, "Tiny");
    EXPECT_EQ(file->type.modes.size(), 1u);
}

TEST(hostile_zip, a_bzip2_picture_costs_only_the_picture) {
    Description description;
    description.wheels = R"(<Wheel Name="W"><Slot Name="A" MediaFileName="a"/></Wheel>)";
    std::vector<std::uint8_t> zip =
        make_zip({{"description.xml", description.xml()}, {"wheels/a.png", "BZh9"}});
    const std::string signature("PK\x01\x02", 4);
    const auto first = std::search(zip.begin(), zip.end(), signature.begin(), signature.end());
    const auto second = std::search(first + 4, zip.end(), signature.begin(), signature.end());
    ASSERT_NE(second, zip.end());
    *(second + 10) = 12;
    const auto file = load_gdtf(zip, "bz.gdtf");
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_TRUE(says(*file, {"bz.gdtf: wheels/a.png", "zip method 12 is not supported"}));
    EXPECT_EQ(file->type.wheels.at(0).slots.at(0).media, -1);
}

TEST(hostile_picture, of_60000_pixels_is_refused_before_it_is_decoded) {
    Description description;
    description.wheels = R"(<Wheel Name="W"><Slot Name="A" MediaFileName="big"/></Wheel>)";
    const std::string big("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\xea\x60\0\0\xea\x60\x08\6\0\0\0", 29);
    const auto file =
        load_gdtf(make_zip({{"description.xml", description.xml()}, {"wheels/big.png", big}}), "big.gdtf");
    ASSERT_TRUE(file);
    EXPECT_TRUE(says(*file, {"big.gdtf: wheels/big.png", "at most 4096 x 4096 pixels"}));
    EXPECT_EQ(file->type.modes.size(), 1u);
}

TEST(hostile_xml, entities_are_not_expanded) {
    std::string doctype = "<!DOCTYPE lolz [<!ENTITY lol \"lol\">";
    for (int i = 1; i < 10; ++i) {
        const std::string inner = i == 1 ? "&lol;" : "&lol" + std::to_string(i - 1) + ";";
        doctype += "<!ENTITY lol" + std::to_string(i) + " \"" + repeat(inner, 10) + "\">";
    }
    std::string xml = Description{}.xml();
    xml.insert(xml.find("<GDTF"), doctype + "]>");
    xml.replace(xml.find("Name=\"Tiny\""), 11, "Name=\"&lol9;\"");
    const auto file = load_xml(xml);
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_EQ(file->type.name, "&lol9;") << "a billion laughs stay six characters";
    EXPECT_TRUE(
        says(*file, {"description.xml", "entities of the document type are left as they are written"}));
}

TEST(hostile_xml, too_many_elements_are_counted_before_they_are_kept) {
    const auto file = load_xml("<GDTF>" + repeat("<a/>", 4300000) + "</GDTF>");
    ASSERT_FALSE(file);
    EXPECT_NE(file.error().text().find("more than 4194304 elements"), std::string::npos);
}

TEST(hostile_xml, numbers_that_are_none) {
    for (const std::string bad : {"nan", "-nan(ind)", "inf", "-INF", "1e999", "0x10", "1,5", ""}) {
        Description description;
        description.physical = "<Emitters><Emitter Name='E' Color='" + bad + ",1,1' DominantWaveLength='" +
                               bad + "'/></Emitters><DMXProfiles><DMXProfile Name='P'><Point CFC0='" + bad +
                               "'/></DMXProfile></DMXProfiles>";
        description.models = "<Model Name='M' Length='" + bad + "'/>";
        description.geometries = "<Geometry Name='Base' Position='{1,0,0," + bad +
                                 "}{0,1,0,0}{0,0,1,0}{0,0,0,1}'><Beam Name='Beam' LuminousFlux='" + bad +
                                 "'/></Geometry>";
        description.channels = "<DMXChannel Offset='1' Geometry='Beam'><LogicalChannel Attribute='Iris'>"
                               "<ChannelFunction Attribute='Iris' PhysicalFrom='" +
                               bad + "' PhysicalTo='" + bad + "'/></LogicalChannel></DMXChannel>";
        const LoadedType file = loaded(description);
        EXPECT_GE(file.messages.size(), 7u) << bad;
        const Type& type = file.type;
        EXPECT_EQ(type.emitters.at(0).color.x, ColorCie{}.x);
        EXPECT_EQ(type.dmx_profiles.at(0).points.at(0).coefficients[0], 0.0f);
        EXPECT_EQ(type.models.at(0).size_m.x, 0.0f);
        EXPECT_EQ(type.geometries.at(0).local, glm::mat4(1.0f));
        EXPECT_EQ(type.geometries.at(1).beam->luminous_flux_lm, 10000.0f);
        EXPECT_EQ(type.modes.at(0).channels.at(0).functions.at(0).physical_to, 1.0f);
    }
}

TEST(hostile_xml, matrices_that_flatten_or_throw_away) {
    for (const char* position :
         {"{0,0,0,0}{0,0,0,0}{0,0,0,0}{0,0,0,1}", "{1,0,0,0}{1,0,0,0}{0,0,1,0}{0,0,0,1}",
          "{1,0,0,1e30}{0,1,0,0}{0,0,1,0}{0,0,0,1}"}) {
        Description description;
        description.geometries =
            std::string("<Geometry Name='Base' Position='") + position + "'><Beam Name='Beam'/></Geometry>";
        const LoadedType file = loaded(description);
        EXPECT_TRUE(says(file, {"flattens or throws away"})) << position;
        EXPECT_EQ(file.type.geometries.at(0).local, glm::mat4(1.0f));
    }
}

TEST(hostile_references, direct_and_mutual_cycles_keep_the_rest) {
    Description description;
    description.geometries =
        R"(<Geometry Name="Base"><GeometryReference Name="ToA" Geometry="A"><Break/></GeometryReference>
<Beam Name="Beam"/></Geometry>
<Geometry Name="A"><Beam Name="BeamA"/><GeometryReference Name="ToB" Geometry="B"/></Geometry>
<Geometry Name="B"><Beam Name="BeamB"/><GeometryReference Name="BackToA" Geometry="A"/>
<GeometryReference Name="ToSelf" Geometry="B"/></Geometry>)";
    const LoadedType file = loaded(description);
    const Mode& mode = file.type.modes.at(0);
    EXPECT_EQ(mode.beams.size(), 3u);
    EXPECT_TRUE(says(file, {"'BackToA' leads back to 'A'"}));
    EXPECT_TRUE(says(file, {"'ToSelf' leads back to 'B'"}));
    EXPECT_EQ(file.messages.size(), 2u);
}

TEST(hostile_references, long_chains_end) {
    Description description;
    description.geometries =
        R"(<Geometry Name="Base"><Beam Name="Beam"/><GeometryReference Name="R" Geometry="G0"/></Geometry>)";
    for (int i = 0; i < 1000; ++i)
        description.geometries += "<Geometry Name='G" + std::to_string(i) + "'><GeometryReference Name='R" +
                                  std::to_string(i) + "' Geometry='G" + std::to_string(i + 1) +
                                  "'/></Geometry>";
    description.geometries += "<Geometry Name='G1000'/>";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"nest deeper than 64"}));
    EXPECT_EQ(file.type.modes.at(0).beams.size(), 1u);
    EXPECT_EQ(file.type.modes[0].channels.size(), 1u);
}

TEST(hostile_references, doubling_is_limited_in_all_modes_together) {
    Description description;
    description.geometries =
        R"(<Geometry Name="Base"><Beam Name="Beam"/><GeometryReference Name="R" Geometry="G0"/></Geometry>)";
    for (int i = 0; i < 30; ++i) {
        const std::string next = "Geometry='G" + std::to_string(i + 1) + "'/>";
        description.geometries += "<Geometry Name='G" + std::to_string(i) + "'><GeometryReference Name='A' " +
                                  next + "<GeometryReference Name='B' " + next + "</Geometry>";
    }
    description.geometries += "<Geometry Name='G30'/>";
    std::string xml = description.xml();
    const std::size_t begin = xml.find("<DMXMode ");
    const std::size_t end = xml.find("</DMXModes>");
    const std::string mode = xml.substr(begin, end - begin);
    for (int i = 0; i < 20; ++i) xml.insert(begin, mode);
    const auto file = load_xml(xml);
    ASSERT_TRUE(file);
    std::size_t nodes = 0;
    for (const Mode& each : file->type.modes) {
        EXPECT_LE(each.nodes.size(), 8192u);
        nodes += each.nodes.size();
    }
    EXPECT_LE(nodes, 65536u);
    EXPECT_TRUE(says(*file, {"more than 8192 (65536 in all modes)"}));
}

// 4096 sets in a channel of a geometry that stands 8000 times: 33 million sets if all were kept.
TEST(hostile_references, what_references_multiply_is_limited) {
    Description description;
    description.geometries = "<Geometry Name='Base'>";
    for (int i = 0; i < 8000; ++i)
        description.geometries += "<GeometryReference Name='R" + std::to_string(i) +
                                  "' Geometry='Cell'><Break/></GeometryReference>";
    description.geometries += "</Geometry><Beam Name='Cell'/>";
    std::string sets;
    for (int i = 0; i < 4096; ++i)
        sets +=
            "<ChannelSet Name='" + std::string(100, 'n') + "' DMXFrom='" + std::to_string(i * 16) + "/2'/>";
    description.channels = "<DMXChannel Offset='1,2' Geometry='Cell'><LogicalChannel Attribute='Dimmer'>"
                           "<ChannelFunction Attribute='Dimmer'>" +
                           sets + "</ChannelFunction></LogicalChannel></DMXChannel>";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"too many channels once references are expanded"}));
    EXPECT_GT(file.type.modes.at(0).channels.size(), 10u);
    EXPECT_LT(file.type.modes[0].channels.size(), 400u);
    EXPECT_EQ(file.type.modes[0].beams.size(), 8000u);
}

TEST(hostile_modes, ten_thousand_are_cut_to_1024) {
    std::string xml = Description{}.xml();
    const std::size_t begin = xml.find("<DMXMode ");
    const std::size_t end = xml.find("</DMXModes>");
    xml.insert(begin, repeat(xml.substr(begin, end - begin), 9999));
    const auto file = load_xml(xml);
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_EQ(file->type.modes.size(), 1024u);
    EXPECT_TRUE(std::any_of(file->messages.begin(), file->messages.end(), [](const Message& message) {
        return message.what.find("more messages") != std::string::npos;
    })) << "a thousand modes of one name";
    EXPECT_LE(file->messages.size(), kMaxMessages + 8);
    EXPECT_TRUE(says(*file, {"more than 1024 modes"})) << "the limit is not drowned by them";
}

TEST(hostile_names, duplicates_are_said_and_the_first_counts) {
    Description description;
    description.attributes = "<Attributes><Attribute Name='Dimmer'/><Attribute Name='Dimmer'/></Attributes>";
    description.physical = "<Emitters><Emitter Name='E' Color='0.6,0.3,10'/><Emitter Name='E'/></Emitters>"
                           "<Filters><Filter Name='F'/><Filter Name='F'/></Filters>";
    description.wheels = "<Wheel Name='W'><Slot/></Wheel><Wheel Name='W'><Slot/><Slot/></Wheel>";
    description.models = "<Model Name='M' Length='1'/><Model Name='M' Length='2'/>";
    description.geometries = R"(<Geometry Name="Base" Model="M"><Geometry Name="X"/><Geometry Name="X"/>
<Geometry Name="Base"/><Beam Name="Beam"/></Geometry>)";
    description.channels = R"(<DMXChannel Offset="1" Geometry="X"><LogicalChannel Attribute="Color1">
<ChannelFunction Attribute="Color1" Wheel="W" Emitter="E"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="2" Geometry="X"><LogicalChannel Attribute="Color1"><ChannelFunction/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    for (const char* kind : {"attribute named 'Dimmer'", "emitter named 'E'", "filter named 'F'",
                             "wheel named 'W'", "model named 'M'"})
        EXPECT_TRUE(says(file, {"a second " + std::string(kind) + ", links mean the first"})) << kind;
    EXPECT_TRUE(says(file, {"a second geometry named 'X'"}));
    EXPECT_TRUE(says(file, {"a second geometry named 'Base'"}));
    EXPECT_TRUE(says(file, {"1 channels have the name of another ('X_Color1')"}));
    const Mode& mode = file.type.modes.at(0);
    std::set<std::string> names;
    for (const Node& node : mode.nodes) names.insert(node.name);
    EXPECT_EQ(names.size(), mode.nodes.size());
    EXPECT_TRUE(names.contains("X (in Base)"));
    EXPECT_EQ(mode.channels.at(0).node, 1) << "the first X";
    EXPECT_EQ(mode.channels[0].functions.at(0).wheel, 0);
    EXPECT_EQ(mode.channels[0].functions[0].emitter, 0);
    EXPECT_EQ(file.type.geometries.at(0).model, 0);
}

std::string u32_text(std::size_t value) {
    std::string text;
    for (int i = 0; i < 4; ++i) text.push_back(static_cast<char>(value >> (8 * i)));
    return text;
}

std::string chunk(std::uint32_t identifier, const std::string& inside) {
    std::string text;
    text.push_back(static_cast<char>(identifier & 0xff));
    text.push_back(static_cast<char>(identifier >> 8));
    return text + u32_text(inside.size() + 6) + inside;
}

// One triangle.
std::string small_3ds() {
    const std::string vertices = std::string("\3\0", 2) + std::string(36, '\1');
    const std::string faces = std::string("\1\0", 2) + std::string("\0\0\1\0\2\0\0\0", 8);
    const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
    return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("body\0", 5) + mesh)));
}

Bytes bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(hostile_mesh, broken_3ds_and_glb_leave_the_primitive) {
    const std::string good = small_3ds();
    ASSERT_EQ(fault_of_mesh(bytes_of(good), "3ds"), "");
    std::string long_list = good;
    long_list[long_list.find(std::string("\3\0", 2) + "\1")] = '\x7f';
    const std::string glb = "glTF" + u32_text(2) + u32_text(24) + u32_text(4) + "JSON{}  ";
    ASSERT_EQ(fault_of_mesh(bytes_of(glb), "glb"), "");
    const std::vector<std::pair<std::string, std::string>> bad = {
        {"cut.3ds", good.substr(0, good.size() - 5)},
        {"list.3ds", long_list},
        {"text.3ds", "no mesh at all"},
        {"empty.3ds", ""},
        {"cut.glb", glb.substr(0, 20)},
        {"old.glb", "glTF" + u32_text(1) + u32_text(24) + u32_text(4) + "JSON{}  "},
        {"chunk.glb", "glTF" + u32_text(2) + u32_text(24) + u32_text(4000) + "JSON{}  "},
    };
    Description description;
    std::vector<std::pair<std::string, std::string>> files{{"", ""}};
    for (const auto& [name, data] : bad) {
        const std::string extension = name.substr(name.size() - 3);
        files.emplace_back("models/" + (extension == "glb" ? std::string("gltf/") : "3ds/") + name, data);
        description.models += "<Model Name='" + name + "' Length='1' PrimitiveType='Cube' File='" +
                              name.substr(0, name.size() - 4) + "'/>";
    }
    description.models += "<Model Name='good' File='good'/>";
    files.emplace_back("models/3ds/good.3ds", good);
    files[0] = {"description.xml", description.xml()};
    const auto file = load_gdtf(make_zip(files), "mesh.gdtf");
    ASSERT_TRUE(file) << file.error().text();
    for (std::size_t i = 0; i < bad.size(); ++i) {
        EXPECT_TRUE(says(*file, {"mesh.gdtf: models/", bad[i].first, "the mesh is left out"}))
            << bad[i].first;
        EXPECT_EQ(file->type.models.at(i).primitive, "Cube");
    }
    EXPECT_TRUE(file->type.models[2].mesh.empty());
    EXPECT_EQ(file->type.models.back().mesh.size(), good.size());
}

// Assimp would make room for them all: 24 bytes each.
TEST(hostile_mesh, tracks_of_more_keys_than_there_are_bytes) {
    const auto animated = [](std::size_t keys) {
        const std::string track =
            chunk(0xb020, std::string(10, '\0') + u32_text(keys) + std::string(18, '\0'));
        return chunk(0x4d4d, chunk(0xb000, chunk(0xb002, track)));
    };
    EXPECT_EQ(fault_of_mesh(bytes_of(animated(1)), "3ds"), "");
    EXPECT_EQ(fault_of_mesh(bytes_of(animated(3'000'000'000)), "3ds"),
              "a track of 3000000000 keys runs past the end of its chunk at byte 24");
}

TEST(hostile_mesh, every_truncation_is_found_and_no_flipped_byte_crashes) {
    std::string mesh = small_3ds();
    for (std::size_t size = 0; size < mesh.size(); ++size)
        EXPECT_NE(fault_of_mesh(bytes_of(mesh.substr(0, size)), "3ds"), "") << size;
    std::size_t faults = 0;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        mesh[i] = static_cast<char>(mesh[i] ^ 0x55);
        faults += !fault_of_mesh(bytes_of(mesh), "3ds").empty();
        mesh[i] = static_cast<char>(mesh[i] ^ 0x55);
    }
    EXPECT_GT(faults, 20u);
}

TEST(hostile_zip, every_prefix_of_a_file_with_everything_is_refused) {
    Description description;
    description.models = "<Model Name='M' File='m'/>";
    const std::vector<std::uint8_t> zip =
        make_zip({{"description.xml", description.xml()}, {"models/3ds/m.3ds", small_3ds()}});
    ASSERT_TRUE(load_gdtf(zip, "whole.gdtf"));
    for (std::size_t size = 0; size < zip.size(); ++size) {
        const auto result = load_gdtf(Bytes(zip.data(), size), "cut.gdtf");
        ASSERT_FALSE(result) << size;
        EXPECT_NE(result.error().text().find("cut.gdtf"), std::string::npos);
    }
}

} // namespace
} // namespace ghost::fixture
