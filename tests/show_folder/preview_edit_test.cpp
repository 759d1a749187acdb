// SPDX-License-Identifier: Apache-2.0
// An edit is shown at once with the fixtures that the show has when it is opened anew: every member of
// [[change]], given and taken back.
#include "support/plot_files.h"

#include "light/beam_shape.h"

namespace ghost::scene {
namespace {

std::string address_xml(int first, int second) {
    return "<Addresses><Address break=\"0\">" + std::to_string(first) + "</Address><Address break=\"1\">" +
           std::to_string(second) + "</Address></Addresses>";
}

std::string screen_xml(int number) {
    return "<VideoScreen uuid=\"" + uuid(number) + "\" name=\"Wall\">" + matrix(kIdentity + "{0,4000,2000}") +
           "<Geometries><Geometry3D fileName=\"Sail.glb\"/></Geometries><Sources><Source type=\"File\">"
           "film.mp4</Source></Sources></VideoScreen>\n";
}

std::string projector_xml(int number) {
    return "<Projector uuid=\"" + uuid(number) + "\" name=\"Beamer\">" + matrix(kIdentity + "{0,0,5000}") +
           "<GDTFSpec>Head.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode><Projections><Projection><Source "
           "type=\"File\">other.mp4</Source></Projection></Projections></Projector>\n";
}

// Numbers of uuid(): 20 and 21 of one name and file, 22 of two modes, 30 a truss that carries 23 and 24, 25
// of a file that lies nowhere, 26 a screen, 27 a projector, 28 nowhere.
struct Folder {
    fs::path folder = scratch("preview");

    Folder() {
        const std::string below =
            "<ChildList>" + fixture_xml(23, "Left", kIdentity + "{-1000,0,0}", address_xml(9, 900)) +
            fixture_xml(24, "Right", kIdentity + "{1000,0,0}", address_xml(19, 901)) + "</ChildList>";
        write_mvr(
            folder / "plot.mvr",
            small_xml(
                fixture_xml(20, "Spot", kIdentity + "{1000,2000,6000}", address_xml(513, 1030)) +
                fixture_xml(21, "Spot", kIdentity + "{2000,2000,6000}", address_xml(523, 1031)) +
                fixture_xml(22, "Wash", kIdentity + "{3000,2000,6000}", address_xml(40, 41), "Two.gdtf") +
                object_xml(30, "Truss", kIdentity + "{0,0,7000}", "", below) +
                fixture_xml(25, "Unread", kIdentity + "{0,0,6000}", "", "Gone.gdtf") + screen_xml(26) +
                projector_xml(27) + fixture_xml(28, "Nowhere", "{nan,0,0}{0,1,0}{0,0,1}{0,0,0}", "")),
            {{"Two.gdtf", head_gdtf(R"(<DMXMode Name="Wide" Geometry="Base"/>)")}});
        std::ofstream(folder / "spot.ies")
            << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 100\n0 45 90\n0\n10 10 0\n";
    }

    Show read(const std::string& changes) const {
        Report report;
        auto show = load_show_text(folder / "show.toml", text(changes), true, report, {});
        EXPECT_TRUE(show.ok()) << show.error().text();
        return show.ok() ? std::move(*show) : Show{};
    }

    static std::string text(const std::string& changes) {
        return "[show]\nplot = \"plot.mvr\"\n[[camera]]\nname = \"a\"\nposition_m = [0, -5, 2]\n"
               "target_m = [0, 0, 2]\n[[circuit]]\nname = \"Dimmer 1\"\n"
               "[[photometry]]\nfor = \"Two.gdtf\"\nfile = \"spot.ies\"\n"
               "[[mover]]\nname = \"Lift\"\nkind = \"linear\"\nfixtures = [\"Left\", \"Own\"]\n"
               "[[mover.axis]]\nrange_m = [-5, 0]\n[[fixture]]\nname = \"Own\"\ngdtf = \"own.gdtf\"\naddress "
               "= 300\n"
               "position_m = [0, 0, 5]\n" +
               changes;
    }
};

std::string change(int number, const std::string& what) {
    return "[[change]]\nuuid = \"" + uuid(number) + "\"\n" + what + "\n";
}

void expect_same(const PatchedFixture& a, const PatchedFixture& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.gdtf, b.gdtf);
    EXPECT_EQ(a.type ? a.type->name : "none", b.type ? b.type->name : "none");
    EXPECT_EQ(a.mode, b.mode);
    EXPECT_EQ(a.is_mode_known, b.is_mode_known);
    EXPECT_EQ(a.is_place_known, b.is_place_known);
    EXPECT_EQ(a.is_rotation_known, b.is_rotation_known);
    EXPECT_EQ(a.is_address_known, b.is_address_known);
    EXPECT_EQ(a.universe, b.universe);
    EXPECT_EQ(a.address, b.address);
    ASSERT_EQ(a.more_addresses.size(), b.more_addresses.size());
    for (std::size_t k = 0; k < a.more_addresses.size(); ++k) {
        EXPECT_EQ(a.more_addresses[k].universe, b.more_addresses[k].universe);
        EXPECT_EQ(a.more_addresses[k].channel, b.more_addresses[k].channel);
    }
    EXPECT_EQ(a.invert_pan, b.invert_pan);
    EXPECT_EQ(a.invert_tilt, b.invert_tilt);
    EXPECT_EQ(a.position_m, b.position_m);
    EXPECT_EQ(a.rotation_deg, b.rotation_deg);
    ASSERT_EQ(a.projector.has_value(), b.projector.has_value());
    if (a.projector) {
        EXPECT_EQ(a.projector->media, b.projector->media);
    }
    ASSERT_EQ(a.wall.has_value(), b.wall.has_value());
    if (a.wall) {
        EXPECT_EQ(a.wall->media, b.wall->media);
        EXPECT_EQ(a.wall->size_m, b.wall->size_m);
    }
    ASSERT_EQ(a.shape == nullptr, b.shape == nullptr);
    if (a.shape) {
        EXPECT_EQ(a.shape->file, b.shape->file);
    }
    EXPECT_EQ(a.mover, b.mover);
    EXPECT_EQ(a.fixture_id, b.fixture_id);
    EXPECT_EQ(a.uuid, b.uuid);
    EXPECT_EQ(a.circuit, b.circuit);
}

void expect_same(const Show& a, const Show& b) {
    ASSERT_EQ(a.fixtures.size(), b.fixtures.size());
    for (std::size_t k = 0; k < a.fixtures.size(); ++k) {
        SCOPED_TRACE(b.fixtures[k].name);
        expect_same(a.fixtures[k], b.fixtures[k]);
    }
}

// From one to the other; who goes back sees what the plot says.
void expect_previews(const Folder& folder, const std::string& first, const std::string& second) {
    const Show before = folder.read(first), opened = folder.read(second);
    const auto there = preview_edit(before, Folder::text(second));
    ASSERT_TRUE(there.ok()) << there.error().text();
    expect_same(*there, opened);
    const auto back = preview_edit(*there, Folder::text(first));
    ASSERT_TRUE(back.ok()) << back.error().text();
    expect_same(*back, before);
}

TEST(PreviewEdit, HasTheFixturesOfTheShowOpenedAnew) {
    const Folder folder;
    const Show plain = folder.read("");
    ASSERT_EQ(plain.fixtures.size(), 10u);
    EXPECT_EQ(named(plain, "Spot #2").uuid, uuid(21));
    EXPECT_NE(named(plain, "Wash").shape, nullptr);
    EXPECT_TRUE(named(plain, "Wall").wall.has_value());
    EXPECT_TRUE(named(plain, "Beamer").projector.has_value());
    EXPECT_EQ(named(plain, "Left").mover, 0);
    EXPECT_EQ(named(plain, "Own").mover, 0);
    std::string spelt = uuid(20);
    for (char& c : spelt) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const std::string& edit :
         {change(20, "universe = 7\naddress = 100"),
          change(20, "universe = 7\naddress = 0"),
          change(20, "universe = 3\naddress = 8\nbreak = 2"),
          change(25, "address = 8"),
          change(22, "mode = \"Wide\""),
          change(22, "mode = \"wide\""),
          change(22, "mode = \"none such\""),
          change(22, "mode = \"\""),
          change(20, "name = \"Front\""),
          change(20, "name = \"Wash\""),
          change(20, "name = \"Own\""),
          change(20, "name = \" a\\tb \""),
          change(20, "name = \"\""),
          change(23, "name = \"Carried by nothing\""),
          change(20, "position_m = [1, 2.5, 3]"),
          change(28, "position_m = [1, 2.5, 3]"),
          change(28, "rotation_deg = [0, 30, 0]"),
          change(20, "rotation_deg = [180, 0, 180]"),
          change(20, "rotation_deg = [10, 100, 350]"),
          change(23, "position_m = [1, 2, 3]\nrotation_deg = [0, 90, 0]"),
          change(30, "position_m = [0, 1, 5]\nrotation_deg = [0, 0, 45]"),
          change(30, "position_m = [0, 1, 5]") + change(23, "rotation_deg = [0, 30, 0]"),
          change(26, "position_m = [1, 1, 1]\nname = \"Left\""),
          change(27, "rotation_deg = [90, 0, 0]"),
          change(20, "hidden = true"),
          change(30, "hidden = true"),
          change(20, "hidden = false"),
          change(20, "hidden = true") + change(20, "hidden = false"),
          change(20, "circuit = \"Dimmer 1\""),
          change(20, "circuit = \"Dimmer 1\"") + change(20, "name = \"Two entries\""),
          change(77, "address = 9"),
          "[[change]]\nuuid = \"{" + spelt +
              "}\"\nname = \"Spelt\"\naddress = 5\ncircuit = \"Dimmer 1\"\n"}) {
        SCOPED_TRACE(edit);
        expect_previews(folder, "", edit);
        expect_previews(folder,
                        change(20, "name = \"Else\"\naddress = 3\ncircuit = \"x\"\n"
                                   "position_m = [0, 0, 9]"),
                        edit);
    }
}

// Who chooses what stands in for a file waits for nothing.
TEST(PreviewEdit, ReadsWhatStandsIn) {
    const Folder folder;
    const auto head = head_gdtf(R"(<DMXMode Name="Narrow" Geometry="Base"/>)");
    ASSERT_TRUE(write_file_atomic(folder.folder / "stand_in.gdtf", head).ok());
    const std::string edit =
        "[[substitute]]\nfor = \"Gone.gdtf\"\ngdtf = \"stand_in.gdtf\"\nmode = \"Narrow\"\n";
    const auto there = preview_edit(folder.read(""), Folder::text(edit));
    ASSERT_TRUE(there.ok()) << there.error().text();
    expect_same(*there, folder.read(edit));
    ASSERT_NE(named(*there, "Unread").type, nullptr);
    EXPECT_EQ(named(*there, "Unread").patch().mode_of().name, "Narrow");
}

// What needs a file of the plot waits until the show is opened.
TEST(PreviewEdit, ReadsNoFileOfThePlot) {
    const Folder folder;
    const std::string hides = change(22, "hidden = true") + change(26, "hidden = true");
    const auto shown = preview_edit(folder.read(hides), Folder::text(""));
    ASSERT_TRUE(shown.ok()) << shown.error().text();
    EXPECT_EQ(named(*shown, "Wash").type, nullptr);
    EXPECT_EQ(named(*shown, "Wash").address, 40);
    EXPECT_EQ(shown->fixtures.size(), 9u) << "all but the screen";
}

} // namespace
} // namespace ghost::scene
