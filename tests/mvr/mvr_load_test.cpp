// SPDX-License-Identifier: Apache-2.0
#include "mvr/private/mvr_values.h"
#include "support/mvr_files.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>

namespace ghost::scene {
namespace {

glm::dvec3 at(const glm::dmat4& matrix, const glm::dvec3& point = {0, 0, 0}) {
    return matrix * glm::dvec4(point, 1.0);
}

#define EXPECT_PLACE(value, X, Y, Z)                                                                         \
    do {                                                                                                     \
        const glm::dvec3 place_ = (value);                                                                   \
        EXPECT_NEAR(place_.x, X, 1e-9);                                                                      \
        EXPECT_NEAR(place_.y, Y, 1e-9);                                                                      \
        EXPECT_NEAR(place_.z, Z, 1e-9);                                                                      \
    } while (false)

TEST(mvr_load, head_and_auxiliary_data) {
    const LoadedPlot loaded = full_plot();
    const Plot& plot = loaded.plot;
    EXPECT_EQ(plot.version_major, 1);
    EXPECT_EQ(plot.version_minor, 6);
    EXPECT_EQ(plot.provider, "Ghost & Light");
    EXPECT_EQ(plot.provider_version, "6.1");
    ASSERT_EQ(plot.user_data.size(), 1u);
    EXPECT_EQ(plot.user_data[0].provider, "Somebody");
    EXPECT_EQ(plot.user_data[0].version, "2");
    EXPECT_NE(plot.user_data[0].xml.find("&lt;kept&gt;"), std::string::npos);
    ASSERT_EQ(plot.classes.size(), 1u);
    EXPECT_EQ(plot.classes[0].name, "Lighting");
    ASSERT_EQ(plot.positions.size(), 1u);
    EXPECT_EQ(plot.positions[0].name, "LX1");
    ASSERT_EQ(plot.mapping_definitions.size(), 1u);
    const PlotMappingDefinition& mapping = plot.mapping_definitions[0];
    EXPECT_EQ(mapping.size_x, 1920);
    EXPECT_EQ(mapping.size_y, 1080);
    EXPECT_EQ(mapping.scale, PictureScale::keep_size_centred);
    EXPECT_EQ(mapping.source.member, "film.mov");
    EXPECT_EQ(mapping.source.linked_geometry, "Display");
    ASSERT_EQ(plot.layers.size(), 1u);
    EXPECT_EQ(plot.layers[0].name, "Stage");
    EXPECT_EQ(plot.layers[0].objects.size(), 5u);
    ASSERT_EQ(plot.objects.size(), 9u);
    // Only the wormhole is odd, and the second mesh named without its extension is not.
    ASSERT_EQ(loaded.report.messages.size(), 1u) << messages_of(loaded.report);
    EXPECT_TRUE(
        says(loaded.report, {"tiny.mvr: GeneralSceneDescription.xml:", "Layer 'Stage'/Wormhole", "kept"}));
}

TEST(mvr_load, tree_and_world_matrices) {
    const LoadedPlot loaded = full_plot();
    const Plot& plot = loaded.plot;
    const PlotObject& deck = object_of(plot, 10);
    EXPECT_EQ(deck.name, "Deck \"A\"");
    EXPECT_EQ(deck.kind, ObjectKind::scene_object);
    EXPECT_EQ(deck.plot_class, 0);
    EXPECT_EQ(deck.device.cast_shadow, true);
    const std::string xml = full_xml();
    EXPECT_EQ(deck.line,
              1 + std::count(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(xml.find("<SceneObject")),
                             '\n'));
    // The layer is lifted by 1 m; the mirror stays.
    EXPECT_PLACE(at(deck.world), 2, -3, 1);
    EXPECT_PLACE(at(deck.world, {1, 0, 0}), 1, -3, 1);
    EXPECT_LT(glm::determinant(deck.world), 0);
    // The group is turned by 90 degrees: its X axis looks to the world's Y.
    EXPECT_PLACE(at(object_of(plot, 11).world, {1, 0, 0}), 1, 1, 7);
    const PlotObject& truss = object_of(plot, 13);
    EXPECT_EQ(truss.kind, ObjectKind::truss);
    EXPECT_EQ(truss.device.function, "carries");
    EXPECT_EQ(truss.device.position, 0);
    const PlotObject& spot = object_of(plot, 14);
    EXPECT_EQ(plot.objects[static_cast<std::size_t>(spot.parent)].uuid, truss.uuid);
    EXPECT_PLACE(at(spot.world), 1, 0.25, 6.7);
    const PlotObject& scroller = object_of(plot, 15);
    EXPECT_PLACE(at(scroller.world), 1, 0.25, 6.65);
    EXPECT_EQ(scroller.device.child_position, "Base.Yoke.Head");
    ASSERT_EQ(spot.children.size(), 1u);
    EXPECT_EQ(plot.objects[static_cast<std::size_t>(spot.children[0])].uuid, scroller.uuid);
    EXPECT_EQ(object_of(plot, 12).kind, ObjectKind::focus_point);
    for (const PlotObject& object : plot.objects) EXPECT_EQ(object.layer, 0);
}

TEST(mvr_load, fixture) {
    const LoadedPlot loaded = full_plot();
    const Plot& plot = loaded.plot;
    const PlotObject& spot = object_of(plot, 14);
    const PlotDevice& device = spot.device;
    EXPECT_EQ(spot.kind, ObjectKind::fixture);
    EXPECT_EQ(device.gdtf_spec, "Spot");
    EXPECT_EQ(device.gdtf_mode, "Standard");
    const PlotGdtf& gdtf = plot.gdtf_files[static_cast<std::size_t>(device.gdtf)];
    EXPECT_EQ(gdtf.member, "Spot.gdtf");
    EXPECT_EQ(gdtf.objects, 2); // "Spot" and "Spot.gdtf" are one file
    EXPECT_EQ(plot.objects[static_cast<std::size_t>(device.focus)].name, "Singer");
    EXPECT_EQ(device.cast_shadow, false);
    EXPECT_TRUE(device.invert_pan);
    EXPECT_FALSE(device.invert_tilt);
    EXPECT_EQ(device.position, 0);
    EXPECT_EQ(device.function, "Key");
    EXPECT_EQ(device.fixture_id, "101a");
    EXPECT_EQ(device.fixture_id_numeric, 101);
    EXPECT_EQ(device.fixture_type_id, 7);
    EXPECT_EQ(device.unit_number, 3);
    EXPECT_EQ(device.custom_id_type, 4);
    EXPECT_EQ(device.custom_id, 12);
    ASSERT_EQ(device.addresses.size(), 2u);
    EXPECT_EQ(device.addresses[0].address.universe, 2);
    EXPECT_EQ(device.addresses[0].address.channel, 1);
    EXPECT_EQ(absolute_address(device.addresses[1].address), 2 * 512 + 17);
    EXPECT_EQ(device.addresses[1].dmx_break, 1);
    EXPECT_EQ(gdtf_break(device, device.addresses[1]), 2);
    ASSERT_EQ(device.networks.size(), 1u);
    EXPECT_EQ(device.networks[0].ipv4, "10.0.0.5");
    EXPECT_EQ(device.networks[0].subnet_mask, "255.0.0.0");
    EXPECT_EQ(device.networks[0].ipv6, "fe80::1");
    EXPECT_EQ(device.networks[0].dhcp, "off");
    EXPECT_EQ(device.networks[0].hostname, "spot1");
    ASSERT_EQ(device.protocols.size(), 1u);
    EXPECT_EQ(device.protocols[0].name, "sACN");
    EXPECT_EQ(device.protocols[0].transmission, "Multicast");
    ASSERT_EQ(device.alignments.size(), 1u);
    EXPECT_EQ(device.alignments[0].geometry, "Beam");
    EXPECT_EQ(device.alignments[0].up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(device.alignments[0].direction, glm::dvec3(0, 0, -1));
    ASSERT_EQ(device.commands.size(), 2u);
    EXPECT_EQ(device.commands[0].function, "Yoke_Pan.Pan.Pan 1");
    EXPECT_EQ(device.commands[0].unit, "f");
    EXPECT_EQ(device.commands[0].value, -12.5);
    EXPECT_EQ(device.commands[1].text, "Lamp on");
    EXPECT_FALSE(device.commands[1].value.has_value());
    ASSERT_EQ(device.overwrites.size(), 2u);
    EXPECT_EQ(device.overwrites[0].universal, "Universal Wheel 1.Slot 1");
    EXPECT_EQ(device.overwrites[0].target, "Gobo.Slot 3");
    EXPECT_EQ(device.overwrites[1].target, "");
    ASSERT_EQ(device.connections.size(), 1u);
    EXPECT_EQ(device.connections[0].own, "Output1");
    EXPECT_EQ(device.connections[0].other, "IN");
    EXPECT_EQ(plot.objects[static_cast<std::size_t>(device.connections[0].to_object)].name, "Scroller");
    ASSERT_TRUE(device.color.has_value());
    EXPECT_FLOAT_EQ(device.color->Y, 80.0f);
    ASSERT_EQ(device.mappings.size(), 1u);
    EXPECT_EQ(device.mappings[0].definition, 0);
    EXPECT_EQ(device.mappings[0].ux, 10);
    EXPECT_EQ(device.mappings[0].uy, 20);
    EXPECT_EQ(device.mappings[0].ox, 5);
    EXPECT_EQ(device.mappings[0].oy, 6);
    EXPECT_EQ(device.mappings[0].rz_deg, 45.5);
    ASSERT_TRUE(device.gobo.has_value());
    EXPECT_EQ(device.gobo->member, "leaves.png");
    EXPECT_EQ(device.gobo->rotation_deg, 32.5);
    // The scroller shares the spot's channels.
    const auto patch = patch_addresses(plot, object_of(plot, 15));
    ASSERT_EQ(patch.size(), 2u);
    EXPECT_EQ(patch[0].universe, 2);
    EXPECT_EQ(patch[1].channel, 17);
}

TEST(mvr_load, supports_screens_and_projectors) {
    const LoadedPlot loaded = full_plot();
    const Plot& plot = loaded.plot;
    const PlotObject& hoist = object_of(plot, 16);
    EXPECT_EQ(hoist.kind, ObjectKind::support);
    EXPECT_EQ(hoist.chain_length, 12.5);
    EXPECT_EQ(plot.gdtf_files[static_cast<std::size_t>(hoist.device.gdtf)].member, "Hoist.gdtf");
    const PlotObject& wall = object_of(plot, 17);
    EXPECT_EQ(wall.kind, ObjectKind::video_screen);
    ASSERT_EQ(wall.sources.size(), 2u);
    EXPECT_EQ(wall.sources[0].type, "NDI");
    EXPECT_EQ(wall.sources[0].value, "cam 1");
    EXPECT_EQ(wall.sources[1].member, "film.mov");
    EXPECT_EQ(wall.device.fixture_id, "25");
    // Its only break is 1, as GDTF counts.
    EXPECT_EQ(patch_addresses(plot, wall).size(), 1u);
    EXPECT_EQ(patch_addresses(plot, wall)[0].channel, 1);
    const PlotObject& beamer = object_of(plot, 18);
    EXPECT_EQ(beamer.kind, ObjectKind::projector);
    ASSERT_EQ(beamer.projections.size(), 1u);
    EXPECT_EQ(beamer.projections[0].scale, PictureScale::ignore_ratio);
    ASSERT_EQ(beamer.projections[0].sources.size(), 1u);
    EXPECT_EQ(beamer.projections[0].sources[0].value, "server/1");
}

TEST(mvr_load, meshes_and_nested_symbols) {
    LoadedPlot loaded = full_plot();
    const Plot& plot = loaded.plot;
    ASSERT_EQ(plot.meshes.size(), 2u);
    const int deck = find_object(plot, uuid(10));
    const auto instances = mesh_instances(plot, deck);
    // Its own mesh, and of the symbol "Bay" the truss in it (half a metre up, twice as large) and the deck.
    ASSERT_EQ(instances.size(), 3u);
    const PlotMesh& glb = plot.meshes[static_cast<std::size_t>(instances[0].mesh)];
    EXPECT_EQ(glb.member, "Deck.glb");
    EXPECT_EQ(glb.extension, "glb");
    EXPECT_PLACE(at(glb.to_metres, {1, 2, 3}), 1, -3, 2); // glTF: Y up
    EXPECT_PLACE(at(instances[0].to_world, {1, 1, 0}), 1, -2, 1);
    const PlotMesh& truss = plot.meshes[static_cast<std::size_t>(instances[1].mesh)];
    EXPECT_EQ(truss.member, "Truss.3ds");
    EXPECT_EQ(truss.extension, "3ds");
    EXPECT_PLACE(at(truss.to_metres, {1000, 2000, 3000}), 1, 2, 3);
    EXPECT_PLACE(at(instances[1].to_world, {1, 0, 0}), 0, -2.9, 1.5);
    EXPECT_EQ(mesh_instances(plot).size(), 5u);
    const auto bytes = loaded.archive.read(truss.member);
    ASSERT_TRUE(bytes.ok());
    EXPECT_EQ(std::string(bytes->begin(), bytes->end()), "3ds");
}

TEST(mvr_load, values) {
    EXPECT_EQ(absolute_address(*parse_mvr_address("513")), 513);
    EXPECT_EQ(absolute_address(*parse_mvr_address(" 2.1 ")), 513);
    EXPECT_EQ(parse_mvr_address("512")->universe, 1);
    EXPECT_EQ(parse_mvr_address("31275")->universe, 62);
    for (const char* none : {"0", "-1", "0.0", "1.0"}) EXPECT_EQ(parse_mvr_address(none)->channel, 0) << none;
    for (const char* bad :
         {"", "x", "1.513", "1.-1", "-2", "2.", "99999999", "999999999999", "70000.1", "1.1.1"})
        EXPECT_FALSE(parse_mvr_address(bad).has_value()) << bad;
    EXPECT_TRUE(parse_mvr_matrix("{1,0,0} {0,1e0,0}\n{-8.5e-08,0,1}{1.5,2,+3}").has_value());
    for (const char* bad :
         {"", "{1,0,0}{0,1,0}{0,0,1}", "{nan,0,0}{0,1,0}{0,0,1}{0,0,0}", "{1,0,0}{0,1,0}{0,0,1}{inf,0,0}",
          "{1,0,0}{0,1,0}{0,0,1}{1e300,0,0}", "{1,0,0}{0,1,0}{0,0,1}{0,0,0}x", "{1,0}{0,1,0}{0,0,1}{0,0,0}",
          "{-nan(ind),0,0}{0,1,0}{0,0,1}{0,0,0}", "{1e999,0,0}{0,1,0}{0,0,1}{0,0,0}", "{1,0,0"})
        EXPECT_FALSE(parse_mvr_matrix(bad).has_value()) << bad;
    const std::string text = "{0.5,-0.25,0}{0,1,0}{0,0,-1}{5200,-1.25,0.1}";
    EXPECT_EQ(mvr_matrix_text(*parse_mvr_matrix(text)), text);
    EXPECT_EQ(uuid_key(" {8BF13DD7-CBF4-415B-99E4-625FE4D2DAF6} "),
              uuid_key("8bf13dd7 cbf4415b99e4625fe4d2daf6"));
    EXPECT_EQ(uuid_key("Layer 1"), "layer 1");
}

TEST(mvr_load, gdtf_specs_by_name_case_and_fixture) {
    const auto fixture = [](const std::string& spec) {
        return "<Fixture uuid='" + spec + "'><GDTFSpec>" + spec + "</GDTFSpec></Fixture>";
    };
    const auto loaded = load_description(
        small_xml(fixture("Acme@Spot") + fixture("Acme@Spot.gdtf") + fixture("ACME@spot.GDTF") +
                  fixture("Wash") + fixture("Gone") + fixture("Twice") + "<Fixture uuid='7'/>"),
        {{"Acme@Spot.gdtf", ""}, {"Acme@Wash.gdtf", ""}, {"A@Twice.gdtf", ""}, {"B@Twice.gdtf", ""}});
    ASSERT_TRUE(loaded.ok());
    const Plot& plot = loaded->plot;
    const auto member = [&](std::size_t i) {
        return plot.gdtf_files[static_cast<std::size_t>(plot.objects[i].device.gdtf)].member;
    };
    EXPECT_EQ(member(0), "Acme@Spot.gdtf");
    EXPECT_EQ(member(1), "Acme@Spot.gdtf");
    EXPECT_EQ(member(2), "Acme@Spot.gdtf");
    EXPECT_EQ(member(3), "Acme@Wash.gdtf");
    EXPECT_EQ(member(4), "");
    EXPECT_EQ(member(5), "");
    EXPECT_EQ(plot.objects[6].device.gdtf, -1);
    EXPECT_FALSE(says(loaded->report, {"'Acme@Spot'"}));
    EXPECT_TRUE(says(loaded->report, {"'ACME@spot.GDTF'", "taken is 'Acme@Spot.gdtf'"}));
    EXPECT_TRUE(says(loaded->report, {"'Wash'", "taken is 'Acme@Wash.gdtf'"}));
    EXPECT_TRUE(says(loaded->report, {"'Gone' is not in the archive", "1 fixture needs it"}));
    EXPECT_TRUE(says(loaded->report, {"without a GDTFSpec"}));
}

TEST(mvr_load, objects_without_a_layer_and_symbols_without_a_list) {
    const auto loaded = load_description(R"(<GeneralSceneDescription verMajor="1" verMinor="5"><Scene>
        <Layers><ChildList><SceneObject uuid="a"><Geometries><Symbol symdef="s"/></Geometries></SceneObject></ChildList>
        </Layers><AUXData><Symdef uuid="s"><Geometry3D fileName="m.3ds"/></Symdef></AUXData>
        </Scene></GeneralSceneDescription>)",
                                         {{"m.3ds", ""}});
    ASSERT_TRUE(loaded.ok());
    ASSERT_EQ(loaded->plot.layers.size(), 1u);
    EXPECT_TRUE(loaded->plot.layers[0].implied);
    EXPECT_EQ(mesh_instances(loaded->plot).size(), 1u);
    EXPECT_TRUE(says(loaded->report, {":2:", "in no Layer"}));
    EXPECT_TRUE(says(loaded->report, {"Symdef", "without a ChildList"}));
}

TEST(mvr_load, progress_and_cancelling) {
    std::vector<double> shares;
    const MvrLoading watched{.progress = [&](double share, std::string_view) { shares.push_back(share); },
                             .cancel = nullptr};
    ASSERT_TRUE(load_mvr(mvr_bytes(full_xml(), full_members()), "full.mvr", watched).ok());
    ASSERT_GE(shares.size(), 4u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);

    std::atomic<bool> cancel = false;
    std::string objects;
    for (int i = 0; i < 5000; ++i) objects += "<SceneObject uuid='" + std::to_string(i) + "'/>";
    const MvrLoading stopped{.progress =
                                 [&](double share, std::string_view what) {
                                     if (what == "objects" && share > 0.5) cancel = true;
                                 },
                             .cancel = &cancel};
    const auto loaded = load_mvr(mvr_bytes(small_xml(objects)), "long.mvr", stopped);
    ASSERT_FALSE(loaded.ok());
    EXPECT_EQ(loaded.error().what, "cancelled");
}

TEST(mvr_load, from_a_file_on_demand) {
    const char* folder = std::getenv("TEST_TMPDIR");
    const std::filesystem::path path = std::filesystem::path(folder ? folder : "/tmp") / "mvr_load_test.mvr";
    const auto bytes = mvr_bytes(full_xml(), full_members());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    auto loaded = load_mvr(path);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    EXPECT_EQ(loaded->plot.objects.size(), 9u);
    EXPECT_EQ(loaded->bytes, nullptr);
    // Kept open: the file's name may be taken by another version meanwhile.
    std::filesystem::remove(path);
    const auto film = loaded->archive.read("film.mov");
    ASSERT_TRUE(film.ok());
    EXPECT_EQ(std::string(film->begin(), film->end()), "film");
#if !defined(_WIN32) // where a name goes with the last who has the file open
    const auto gone = load_mvr(path);
    ASSERT_FALSE(gone.ok());
    EXPECT_NE(gone.error().text().find("no such file"), std::string::npos);
#endif
}

#undef EXPECT_PLACE

} // namespace
} // namespace ghost::scene
