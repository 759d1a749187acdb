#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests: an MVR 1.6 file that has every element of the standard, and ways to make small ones.

#include "mvr/mvr_load.h"
#include "support/must.h"
#include "support/tiny_gdtf.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {

using Members = std::vector<std::pair<std::string, std::string>>;

inline std::vector<std::uint8_t> mvr_bytes(const std::string& xml, Members members = {}) {
    members.insert(members.begin(), {"GeneralSceneDescription.xml", xml});
    return fixture::make_zip(members);
}

inline Result<LoadedPlot> load_description(const std::string& xml, Members members = {}) {
    return load_mvr(mvr_bytes(xml, std::move(members)), "tiny.mvr");
}

// A description around the content of one layer and of AUXData.
inline std::string small_xml(const std::string& objects, const std::string& auxiliary = "") {
    return "<?xml version=\"1.0\"?>\n<GeneralSceneDescription verMajor=\"1\" "
           "verMinor=\"6\"><Scene>\n<AUXData>" +
           auxiliary + "</AUXData>\n<Layers><Layer name=\"L\" uuid=\"1\"><ChildList>\n" + objects +
           "\n</ChildList></Layer></Layers></Scene></GeneralSceneDescription>";
}

inline bool says(const Report& report, const std::vector<std::string>& words) {
    for (const Message& message : report.messages) {
        const std::string text = message.where + ": " + message.what;
        bool all = true;
        for (const std::string& word : words) all = all && text.find(word) != std::string::npos;
        if (all) return true;
    }
    return false;
}

inline std::string messages_of(const Report& report) {
    std::string text;
    for (const Message& message : report.messages) text += message.where + ": " + message.what + "\n";
    return text;
}

inline std::string uuid(int number) {
    const std::string digits = std::to_string(100000 + number);
    return "8BF13DD7-CBF4-415B-99E4-625FE4" + digits;
}

inline Members full_members() {
    return {{"Truss.3ds", "3ds"},    {"Deck.glb", "glb"},        {"Spot.gdtf", "gdtf"},
            {"Screen.gdtf", "gdtf"}, {"Hoist.gdtf", "gdtf"},     {"film.mov", "film"},
            {"leaves.png", "png"},   {"Universal.gdtt", "gdtt"}, {"notes.xyz", "what else"},
            {"Beamer.gdtf", "gdtf"}};
}

// Numbers of uuid(): 1 layer, 2 class, 3 and 4 symbols, 5 position, 6 mapping definition, 10 .. objects.
inline std::string full_xml() {
    return R"(<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<!-- made by hand: every element of MVR 1.6 -->
<GeneralSceneDescription verMajor="1" verMinor="6" provider="Ghost &amp; Light" providerVersion="6.1">
  <UserData><Data provider="Somebody" ver="2"><Key a='5" nail'>&lt;kept&gt;</Key></Data></UserData>
  <Scene>
    <AUXData>
      <Class uuid=")" +
           uuid(2) + R"(" name="Lighting"/>
      <Symdef uuid=")" +
           uuid(3) + R"(" name="Bay"><ChildList>
        <Symbol uuid=")" +
           uuid(30) + R"(" symdef=")" + uuid(4) +
           R"("><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,500}</Matrix></Symbol>
        <Geometry3D fileName="Deck.glb"/>
      </ChildList></Symdef>
      <Symdef uuid=")" +
           uuid(4) + R"(" name="Truss"><ChildList>
        <Geometry3D fileName="Truss"><Matrix>{2,0,0}{0,2,0}{0,0,2}{0,100,0}</Matrix></Geometry3D>
      </ChildList></Symdef>
      <Position uuid=")" +
           uuid(5) + R"(" name="LX1"/>
      <MappingDefinition uuid=")" +
           uuid(6) + R"(" name="Wall">
        <SizeX>1920</SizeX><SizeY>1080</SizeY>
        <Source linkedGeometry="Display" type="File">film.mov</Source>
        <ScaleHandeling Enum="KeepSizeCenter"/>
      </MappingDefinition>
    </AUXData>
    <Layers>
      <Layer uuid=")" +
           uuid(1) + R"(" name="Stage">
        <Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,1000}</Matrix>
        <ChildList>
          <SceneObject uuid=")" +
           uuid(10) + R"(" name="Deck &quot;A&quot;">
            <Matrix>{-1,0,0}{0,1,0}{0,0,1}{2000,-3000,0}</Matrix>
            <Classing>)" +
           uuid(2) + R"(</Classing>
            <Geometries><Geometry3D fileName="Deck.glb"/><Symbol uuid=")" +
           uuid(31) + R"(" symdef=")" + uuid(3) + R"("/></Geometries>
            <CastShadow>true</CastShadow><ChildList/>
          </SceneObject>
          <GroupObject uuid=")" +
           uuid(11) + R"(" name="Front">
            <Matrix>{0,1,0}{-1,0,0}{0,0,1}{1000,0,6000}</Matrix>
            <ChildList>
              <FocusPoint uuid=")" +
           uuid(12) +
           R"(" name="Singer"><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,-4500}</Matrix><Geometries/></FocusPoint>
              <Truss uuid=")" +
           uuid(13) + R"(" name="LX1" >
                <Position>)" +
           uuid(5) + R"(</Position>
                <Geometries><Symbol uuid=")" +
           uuid(32) + R"(" symdef=")" + uuid(4) + R"("/></Geometries>
                <Function>carries</Function>
                <ChildList>
                  <Fixture uuid=")" +
           uuid(14) + R"(" name="Spot 1">
                    <Matrix>{1,0,0}{0,1,0}{0,0,1}{250,0,-300}</Matrix>
                    <Classing>)" +
           uuid(2) + R"(</Classing>
                    <GDTFSpec>Spot</GDTFSpec><GDTFMode>Standard</GDTFMode>
                    <Focus>)" +
           uuid(12) + R"(</Focus>
                    <CastShadow>false</CastShadow>
                    <DMXInvertPan>true</DMXInvertPan><DMXInvertTilt>false</DMXInvertTilt>
                    <Position>)" +
           uuid(5) + R"(</Position>
                    <Function>Key</Function>
                    <FixtureID>101a</FixtureID><FixtureIDNumeric>101</FixtureIDNumeric><FixtureTypeId>7</FixtureTypeId>
                    <UnitNumber>3</UnitNumber>
                    <Addresses>
                      <Address break="0">513</Address><Address break="1">3.17</Address>
                      <Network geometry="NetworkInOut_1" ipv4="10.0.0.5" subnetmask="255.0.0.0" ipv6="fe80::1" dhcp="off" hostname="spot1"/>
                    </Addresses>
                    <Protocols><Protocol geometry="NetworkInOut_1" name="sACN" type="DMX" version="1.0" transmission="Multicast"/></Protocols>
                    <Alignments><Alignment geometry="Beam" up="0,1,0" direction="0,0,-1"/></Alignments>
                    <CustomCommands><CustomCommand>Yoke_Pan.Pan.Pan 1,f -12.5</CustomCommand><CustomCommand>Lamp on</CustomCommand></CustomCommands>
                    <Overwrites><Overwrite universal="Universal Wheel 1.Slot 1" target="Gobo.Slot 3"/><Overwrite universal="Universal Emitter 1"/></Overwrites>
                    <Connections><Connection own="Output1" other="IN" toObject=")" +
           uuid(15) + R"("/></Connections>
                    <Color>0.3127,0.3290,80</Color>
                    <CustomIdType>4</CustomIdType><CustomId>12</CustomId>
                    <Mappings><Mapping linkedDef=")" +
           uuid(6) + R"("><ux>10</ux><uy>20</uy><ox>5</ox><oy>6</oy><rz>45.5</rz></Mapping></Mappings>
                    <Gobo rotation="32.5">leaves</Gobo>
                    <ChildList>
                      <Fixture uuid=")" +
           uuid(15) + R"(" name="Scroller" multipatch=")" + uuid(14) + R"(">
                        <Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,-50}</Matrix>
                        <GDTFSpec>Spot.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode>
                        <FixtureID>102</FixtureID><UnitNumber>4</UnitNumber>
                        <ChildPosition>Base.Yoke.Head</ChildPosition>
                        <Addresses><Address>0</Address></Addresses>
                        <ChildList/>
                      </Fixture>
                    </ChildList>
                  </Fixture>
                </ChildList>
                <FixtureID/>
              </Truss>
            </ChildList>
          </GroupObject>
          <Support uuid=")" +
           uuid(16) + R"(" name="Hoist">
            <Geometries/><ChainLength>12.5</ChainLength><GDTFSpec>Hoist.gdtf</GDTFSpec><GDTFMode>Default</GDTFMode>
            <FixtureID>1</FixtureID><UnitNumber>1</UnitNumber><ChildList/>
          </Support>
          <VideoScreen uuid=")" +
           uuid(17) + R"(" name="Wall">
            <Geometries><Geometry3D fileName="Deck.glb"/></Geometries>
            <Sources><Source linkedGeometry="Display" type="NDI">cam 1</Source><Source linkedGeometry="D2" type="File">film.mov</Source></Sources>
            <GDTFSpec>Screen.gdtf</GDTFSpec><GDTFMode>Wide</GDTFMode>
            <Addresses><Address break="1">1</Address></Addresses>
            <ChildList/><FixtureID>25</FixtureID>
          </VideoScreen>
          <Projector uuid=")" +
           uuid(18) + R"(" name="Beamer">
            <Geometries/>
            <Projections><Projection><Source linkedGeometry="Beam" type="CITP">server/1</Source><ScaleHandeling>ScaleIgnoreRatio</ScaleHandeling></Projection></Projections>
            <GDTFSpec>Beamer.gdtf</GDTFSpec><GDTFMode>Default</GDTFMode><ChildList/><FixtureID>26</FixtureID>
          </Projector>
          <Wormhole uuid="x"><To>elsewhere</To></Wormhole>
        </ChildList>
      </Layer>
    </Layers>
  </Scene>
</GeneralSceneDescription>
)";
}

inline LoadedPlot full_plot() {
    return must(load_description(full_xml(), full_members()));
}

inline int find_object(const Plot& plot, std::string_view uuid) {
    return ObjectIndex(plot).find(uuid);
}

inline const PlotObject& object_of(const Plot& plot, int number) {
    return plot.objects.at(static_cast<std::size_t>(find_object(plot, uuid(number))));
}

} // namespace ghost::scene
