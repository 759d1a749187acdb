// SPDX-License-Identifier: Apache-2.0
// Every part of a description.xml (GDTF 1.2) that a Type keeps, in small files; and the curves that read it.
#include "support/tiny_gdtf.h"

#include "fixture/attribute.h"
#include "fixture/curves.h"
#include "fixture/decode.h"
#include "fixture/power.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

std::string channel_of(const std::string& attribute, const std::string& inside,
                       const std::string& offset = "1") {
    return "<DMXChannel Offset='" + offset + "' Geometry='Beam'><LogicalChannel Attribute='" + attribute +
           "'>" + inside + "</LogicalChannel></DMXChannel>";
}

std::vector<ChannelReading> readings_of(const Type& type, const std::vector<std::uint8_t>& dmx) {
    const Patch patch{.name = "test", .type = &type, .mode = 0, .addresses = {{1, 1}}};
    Levels levels;
    levels.set(1, dmx);
    return read_channels(patch, levels);
}

TEST(whole_gdtf, attribute_definitions) {
    Description description;
    description.attributes = R"(<ActivationGroups><ActivationGroup Name="PanTilt"/></ActivationGroups>
<FeatureGroups><FeatureGroup Name="Position" Pretty="Pos"><Feature Name="PanTilt"/></FeatureGroup></FeatureGroups>
<Attributes><Attribute Name="PAN" Pretty="P" ActivationGroup="pantilt" Feature="Position.PanTilt" PhysicalUnit="Angle" Color="0.3,0.4,50"/>
<Attribute Name="PanRotate" MainAttribute="Pan" Feature="Position.Other" ActivationGroup="None">
<SubPhysicalUnit Type="Duration" PhysicalUnit="Time" PhysicalFrom="0.5" PhysicalTo="2"/></Attribute>
<Attribute Name="Lost" MainAttribute="Nowhere"/></Attributes>)";
    description.channels =
        channel_of("pan", "<ChannelFunction Attribute='pan' PhysicalFrom='-270' PhysicalTo='270'/>");
    const LoadedType file = loaded(description);
    ASSERT_EQ(file.type.definitions.size(), 3u);
    const AttributeDefinition& pan = file.type.definitions[0];
    EXPECT_EQ(pan.pretty, "P");
    EXPECT_EQ(pan.activation_group, "pantilt");
    EXPECT_EQ(pan.feature, "Position.PanTilt");
    EXPECT_EQ(pan.physical_unit, "Angle");
    EXPECT_TRUE(pan.has_color);
    EXPECT_EQ(pan.meaning.role, Role::pan);
    const AttributeDefinition& rotate = file.type.definitions[1];
    EXPECT_EQ(rotate.main_attribute, "Pan");
    ASSERT_EQ(rotate.sub_units.size(), 1u);
    EXPECT_EQ(rotate.sub_units[0].type, "Duration");
    EXPECT_EQ(rotate.sub_units[0].unit, "Time");
    EXPECT_EQ(rotate.sub_units[0].physical_from, 0.5f);
    EXPECT_EQ(file.type.modes.at(0).channels.at(0).functions.at(0).definition, 0)
        << "names compare without case";
    EXPECT_TRUE(says(file, {"feature 'Position.Other' is not defined"}));
    EXPECT_TRUE(says(file, {"activation group 'None' is not defined"}));
    EXPECT_TRUE(says(file, {"main attribute 'Nowhere' of 'Lost'"}));
    EXPECT_EQ(file.messages.size(), 3u);
}

TEST(whole_gdtf, emitters_and_filters_with_spectra) {
    Description description;
    description.physical =
        R"(<Emitters><Emitter Name="Red" Color="0.69,0.3,20" DominantWaveLength="630" DiodePart="XPE">
<Measurement Physical="50" LuminousIntensity="400" InterpolationTo="Linear"><MeasurementPoint WaveLength="600" Energy="1"/>
<MeasurementPoint WaveLength="640" Energy="3"/></Measurement>
<Measurement Physical="100" LuminousIntensity="1000"><MeasurementPoint WaveLength="600" Energy="2"/>
<MeasurementPoint WaveLength="640" Energy="8"/></Measurement></Emitter>
<Emitter Name="UV" DominantWaveLength="390"/></Emitters>
<Filters><Filter Name="Cyan" Color="0.2,0.3,30"><Measurement Physical="100" Transmission="25" InterpolationTo="Log">
<MeasurementPoint WaveLength="500" Energy="4"/><MeasurementPoint WaveLength="450" Energy="2"/></Measurement></Filter></Filters>)";
    const LoadedType file = loaded(description);
    const Emitter& red = file.type.emitters.at(0);
    EXPECT_EQ(red.diode_part, "XPE");
    ASSERT_EQ(red.measurements.size(), 2u);
    EXPECT_FLOAT_EQ(energy_at(red.measurements[1].spectrum, 610.0f), 3.5f);
    EXPECT_EQ(energy_at(red.measurements[1].spectrum, 599.0f), 0.0f);
    EXPECT_EQ(energy_at(red.measurements[1].spectrum, 641.0f), 0.0f);
    const Measurement middle = measured_at(red, 75.0f);
    EXPECT_FLOAT_EQ(middle.luminous_intensity_cd, 700.0f);
    EXPECT_FLOAT_EQ(energy_at(middle.spectrum, 640.0f), 5.5f);
    EXPECT_FLOAT_EQ(measured_at(red, 25.0f).luminous_intensity_cd, 200.0f) << "0 % gives nothing";
    EXPECT_FLOAT_EQ(energy_at(measured_at(red, 25.0f).spectrum, 640.0f), 1.5f);
    EXPECT_EQ(measured_at(red, 0.0f).luminous_intensity_cd, 0.0f);
    EXPECT_EQ(measured_at(red, 100.0f).luminous_intensity_cd, 1000.0f);

    const Emitter& ultraviolet = file.type.emitters.at(1);
    EXPECT_NEAR(ultraviolet.color.x, 0.17f, 0.02f) << "its colour comes from the wavelength";
    EXPECT_LT(ultraviolet.color.y, 0.04f);
    EXPECT_TRUE(measured_at(ultraviolet, 50.0f).spectrum.empty());

    const Filter& cyan = file.type.filters.at(0);
    ASSERT_EQ(cyan.measurements.size(), 1u);
    EXPECT_EQ(cyan.measurements[0].spectrum.at(0), glm::vec2(450.0f, 2.0f)) << "sorted";
    EXPECT_TRUE(says(file, {"wavelengths of a spectrum do not rise"}));
    EXPECT_FLOAT_EQ(measured_at(cyan, 0.0f).transmission, 100.0f);
    EXPECT_FLOAT_EQ(measured_at(cyan, 50.0f).transmission, 50.0f) << "logarithmic from 100 to 25";
    EXPECT_EQ(file.messages.size(), 1u);
}

TEST(whole_gdtf, steps_between_measurements) {
    Emitter emitter;
    emitter.measurements = {
        {.physical_percent = 50.0f, .luminous_intensity_cd = 10.0f},
        {.physical_percent = 100.0f, .luminous_intensity_cd = 30.0f, .from_previous = Interpolation::step}};
    EXPECT_EQ(measured_at(emitter, 99.0f).luminous_intensity_cd, 10.0f);
    EXPECT_EQ(measured_at(emitter, 100.0f).luminous_intensity_cd, 30.0f);
}

TEST(whole_gdtf, colours_of_wavelengths) {
    const ColorCie green = color_of_wavelength(520.0f);
    EXPECT_NEAR(green.x, 0.0743f, 0.02f);
    EXPECT_NEAR(green.y, 0.8338f, 0.02f);
    const ColorCie red = color_of_wavelength(650.0f);
    EXPECT_NEAR(red.x, 0.726f, 0.01f);
    EXPECT_NEAR(red.y, 0.274f, 0.01f);
    EXPECT_NEAR(color_of_wavelength(555.0f).Y, 100.0f, 2.0f);
}

TEST(whole_gdtf, colour_spaces_gamuts_profiles_rendering_connectors_properties) {
    Description description;
    description.physical = R"(<ColorSpace Mode="ANSI"/>
<AdditionalColorSpaces><ColorSpace Name="Mine" Mode="Custom" Red="0.7,0.3,25" Green="0.2,0.7,70" Blue="0.1,0.1,5" WhitePoint="0.31,0.33,100"/>
<ColorSpace Name="Odd" Mode="Adobe"/></AdditionalColorSpaces>
<Gamuts><Gamut Name="G" Points="{0.7,0.3,25}{0.2,0.7,70}{0.1,0.1,5}"/><Gamut Name="Bad" Points="0.1,0.2"/></Gamuts>
<DMXProfiles><DMXProfile Name="S"><Point DMXPercentage="50" CFC0="50" CFC1="200" CFC2="-200"/><Point CFC2="200"/></DMXProfile>
<DMXProfile Name="Empty"/></DMXProfiles>
<CRIs><CRIGroup ColorTemperature="3200"><CRI CES="CES07" ColorRenderingIndex="85"/><CRI CES="7"/></CRIGroup></CRIs>
<Connectors><Connector Name="In" Type="XLR5" DMXBreak="1" Gender="-1" Length="0.5"/></Connectors>
<Properties><OperatingTemperature Low="-10" High="45"/><Weight Value="22.7"/><LegHeight Value="0.02"/>
<PowerConsumption Value="900" Connector="In" PowerFactor="0.9" VoltageLow="100" VoltageHigh="120" FrequencyLow="50"/>
<PowerConsumption Value="850" Connector="In" VoltageLow="200" VoltageHigh="240"/></Properties>)";
    description.channels =
        channel_of("Dimmer", R"(<ChannelFunction Attribute="Dimmer" ColorSpace="mine" Gamut="G"
DMXProfile="S" Min="10" Max="20" CustomName="osc" OriginalAttribute="Intensity"/>
<ChannelFunction Attribute="Zoom" PhysicalFrom="10" PhysicalTo="20" DMXFrom="200/1" ColorSpace="Default"/>)");
    const LoadedType file = loaded(description);
    const Type& type = file.type;
    EXPECT_EQ(type.color_space.mode, "ANSI");
    EXPECT_EQ(type.color_space.white.x, 0.4254f);
    ASSERT_EQ(type.color_spaces.size(), 2u);
    EXPECT_EQ(type.color_spaces[0].green.y, 0.7f);
    EXPECT_EQ(type.color_spaces[1].mode, "sRGB");
    EXPECT_TRUE(says(file, {"Mode is 'Adobe', expected one of sRGB, ProPhoto, ANSI, Custom; taking sRGB"}));
    ASSERT_EQ(type.gamuts.at(0).points.size(), 3u);
    EXPECT_EQ(type.gamuts[0].points[1].Y, 70.0f);
    EXPECT_TRUE(says(file, {"gamut 'Bad'"}));
    // The S curve of the GDTF Builder's manual.
    const DmxProfile& profile = type.dmx_profiles.at(0);
    EXPECT_FLOAT_EQ(evaluate(profile, 0.0f), 0.0f);
    EXPECT_FLOAT_EQ(evaluate(profile, 25.0f), 12.5f);
    EXPECT_FLOAT_EQ(evaluate(profile, 50.0f), 50.0f);
    EXPECT_FLOAT_EQ(evaluate(profile, 75.0f), 87.5f);
    EXPECT_FLOAT_EQ(evaluate(profile, 100.0f), 100.0f);
    EXPECT_FLOAT_EQ(evaluate(type.dmx_profiles.at(1), 30.0f), 30.0f);
    EXPECT_TRUE(says(file, {"profile 'Empty' has no Point"}));
    EXPECT_EQ(evaluate({.name = "late", .points = {{50.0f, {7.0f, 0, 0, 0}}}}, 49.0f), 0.0f);
    ASSERT_EQ(type.cri_groups.at(0).samples.size(), 1u);
    EXPECT_EQ(type.cri_groups[0].samples[0], glm::ivec2(7, 85));
    EXPECT_TRUE(says(file, {"CES is '7'"}));
    EXPECT_EQ(type.connectors.at(0).gender, -1);
    EXPECT_EQ(type.connectors[0].type, "XLR5");
    EXPECT_EQ(type.properties.weight_kg, 22.7f);
    EXPECT_EQ(type.properties.leg_height_m, 0.02f);
    EXPECT_EQ(type.properties.power_w, 900.0f);
    EXPECT_EQ(type.properties.temperature_low_c, -10.0f);
    ASSERT_EQ(type.properties.power_inputs.size(), 1u) << "the other one is for another mains";
    EXPECT_EQ(type.properties.power_inputs[0].connector, "XLR5");
    EXPECT_EQ(type.properties.power_inputs[0].power_factor, 0.9f);
    EXPECT_TRUE(
        says(file, {"not used, as neither picture nor motion needs it: 1 values of PowerConsumption"}));
    const ChannelFunction& function = type.modes.at(0).channels.at(0).functions.at(0);
    EXPECT_EQ(function.color_space, 0);
    EXPECT_EQ(function.gamut, 0);
    EXPECT_EQ(function.dmx_profile, 0);
    EXPECT_EQ(function.custom_name, "osc");
    EXPECT_EQ(function.original_attribute, "Intensity");
    EXPECT_FLOAT_EQ(physical_at(type, function, 0), 10.0f);
    EXPECT_FLOAT_EQ(physical_at(type, function, 199), 20.0f);
    EXPECT_EQ(type.modes[0].channels[0].functions[1].color_space, -1) << "the fixture's own";
    EXPECT_EQ(file.messages.size(), 5u);
}

TEST(whole_gdtf, power_consumptions_have_an_end) {
    Description description;
    description.physical = "<Properties>";
    for (int k = 0; k <= 256; ++k)
        description.physical += R"(<PowerConsumption Value="1" VoltageLow="230"/>)";
    description.physical += "</Properties>";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.type.properties.power_inputs.size(), 256u);
    EXPECT_TRUE(says(file, {"256 power consumptions"}));
}

TEST(whole_gdtf, wiring_says_what_a_mode_takes) {
    Description description;
    description.physical = R"(<Properties><PowerConsumption Value="500"/></Properties>)";
    const std::string plug = R"(<WiringObject SignalType="Power" ConnectorType="NAC3FCA" CosPhi="0.95" )";
    description.geometries =
        R"(<Geometry Name="Base"><Beam Name="Beam"/>)" + plug +
        R"(Name="Power IN" ComponentType="Consumer" ElectricalPayLoad="1225" VoltageRangeMin="120" VoltageRangeMax="240"/>)" +
        plug + R"(Name="Power THRU" ComponentType="Output" ElectricalPayLoad="2000"/>
<WiringObject Name="DMX" SignalType="DMX512" ComponentType="Consumer" ElectricalPayLoad="3"/></Geometry>
<Geometry Name="Other">)" +
        plug + R"(Name="Power IN" ComponentType="Consumer" ElectricalPayLoad="77"/></Geometry>)";
    const LoadedType file = loaded(description);
    const auto inputs = power_inputs_of(file.type, file.type.modes.at(0));
    ASSERT_EQ(inputs.size(), 1u) << "of the mode's own tree";
    EXPECT_EQ(inputs[0].plug, "Power IN");
    EXPECT_EQ(inputs[0].connector, "NAC3FCA");
    EXPECT_EQ(inputs[0].power_factor, 0.95f);
    EXPECT_EQ(inputs[0].voltage_high_v, 240.0f);
    EXPECT_EQ(power_w_of(file.type, file.type.modes[0]), 1225.0f);
    description.geometries = Description{}.geometries;
    const LoadedType plain = loaded(description);
    EXPECT_EQ(power_w_of(plain.type, plain.type.modes.at(0)), 500.0f) << "of the file's Properties";
}

TEST(whole_gdtf, old_files_have_properties_directly_under_physical_descriptions) {
    Description description;
    description.physical =
        R"(<Weight Value="5"/><LegHeight Value="0.1"/><OperatingTemperature Low="1" High="2"/>)";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.type.properties.weight_kg, 5.0f);
    EXPECT_EQ(file.type.properties.leg_height_m, 0.1f);
    EXPECT_EQ(file.type.properties.temperature_high_c, 2.0f);
    EXPECT_TRUE(file.messages.empty());
}

TEST(whole_gdtf, animation_discs_and_prisms) {
    Description description;
    description.wheels =
        R"(<Wheel Name="A"><Slot Name="Open"/><Slot Name="Disc"><AnimationSystem P1="0.5,0.1" P2="0,0.2" P3="-0.5,0.1" Radius="0.3"/></Slot>
<Slot Name="Bad"><AnimationSystem P1="0.5" P2="0,0" P3="0,0" Radius="-1"/></Slot></Wheel>
<Wheel Name="P"><Slot Name="3"><Facet Color="0.3,0.3,100" Rotation="{1,0,0.5}{0,1,0}{0,0,1}"/><Facet Rotation="{1,0}{0,1}"/>
<Facet Rotation="{0,0,0}{0,0,0}{0,0,0}"/></Slot></Wheel>)";
    const LoadedType file = loaded(description);
    const Slot& disc = file.type.wheels.at(0).slots.at(1);
    ASSERT_TRUE(disc.animation);
    EXPECT_EQ(disc.animation->p1, glm::vec2(0.5f, 0.1f));
    EXPECT_EQ(disc.animation->p3, glm::vec2(-0.5f, 0.1f));
    EXPECT_EQ(disc.animation->radius, 0.3f);
    EXPECT_FALSE(file.type.wheels[0].slots[0].animation);
    EXPECT_TRUE(says(file, {"P1 is '0.5', expected 'x,y'"}));
    EXPECT_TRUE(says(file, {"Radius is '-1'"}));
    const std::vector<Facet>& facets = file.type.wheels.at(1).slots.at(0).facets;
    ASSERT_EQ(facets.size(), 3u);
    EXPECT_EQ(facets[0].rotation[2], 0.5f);
    EXPECT_EQ(facets[1].rotation[0], 1.0f);
    EXPECT_TRUE(says(file, {"Rotation is not a matrix of 3 x 3"}));
    EXPECT_EQ(facets[2].rotation[0], 1.0f);
    EXPECT_TRUE(says(file, {"Rotation has only zeros"}));
}

TEST(whole_gdtf, every_kind_of_geometry) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"><Axis Name="Yoke"><Axis Name="Head"><Beam Name="Beam"/>
<FilterBeam Name="fb"/><FilterColor Name="fc"/><FilterGobo Name="fg"/><FilterShaper Name="fs"/></Axis></Axis>
<MediaServerLayer Name="ml"/><MediaServerCamera Name="mc"/><MediaServerMaster Name="mm"/><Display Name="d" Texture="screen.png"/>
<Display Name="d2" Texture="none.png"/>
<Laser Name="l" ColorType="SingleWaveLength" Color="532" OutputStrength="2" BeamDiameter="0.004" BeamDivergenceMin="1" BeamDivergenceMax="2"
ScanAnglePan="60" ScanAngleTilt="40" ScanSpeed="30"><Protocol Name="ILDA"/></Laser>
<WiringObject Name="w" ConnectorType="XLR5"/><Inventory Name="i" Count="3"/><Structure Name="s"/><Support Name="u"/><Magnet Name="m"/>
<Gizmo Name="g"/></Geometry>)";
    const auto file =
        load_gdtf(make_zip({{"description.xml", description.xml()}, {"Screen.png", "x"}}), "kinds.gdtf");
    ASSERT_TRUE(file);
    const std::vector<GeometryKind> expected = {GeometryKind::geometry,
                                                GeometryKind::axis,
                                                GeometryKind::axis,
                                                GeometryKind::beam,
                                                GeometryKind::filter_beam,
                                                GeometryKind::filter_color,
                                                GeometryKind::filter_gobo,
                                                GeometryKind::filter_shaper,
                                                GeometryKind::media_server_layer,
                                                GeometryKind::media_server_camera,
                                                GeometryKind::media_server_master,
                                                GeometryKind::display,
                                                GeometryKind::display,
                                                GeometryKind::laser,
                                                GeometryKind::wiring,
                                                GeometryKind::inventory,
                                                GeometryKind::structure,
                                                GeometryKind::support,
                                                GeometryKind::magnet};
    ASSERT_EQ(file->type.geometries.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(file->type.geometries[i].kind, expected[i]) << i;
    EXPECT_EQ(file->type.geometries[11].texture, "Screen.png");
    EXPECT_TRUE(says(*file, {"the texture 'none.png' is not in the archive"}));
    const Laser& laser = file->type.geometries[13].laser.value();
    EXPECT_TRUE(laser.single_wavelength);
    EXPECT_EQ(laser.wavelength_nm, 532.0f);
    EXPECT_EQ(laser.scan_pan_deg, 60.0f);
    EXPECT_EQ(laser.protocols, std::vector<std::string>{"ILDA"});
    EXPECT_EQ(file->type.geometries[13].beam->luminous_flux_lm, 400.0f);
    EXPECT_NEAR(file->type.geometries[13].beam->beam_angle_deg, 0.1146f, 1e-4f);
    EXPECT_TRUE(says(*file, {"the element <Gizmo> is not in the standard, left out"}));
    EXPECT_TRUE(says(*file, {"1 values of Inventory"}));
    EXPECT_FALSE(says(*file, {"values of WiringObject"})) << "its connector is read";
    EXPECT_EQ(file->type.modes.at(0).beams.size(), 2u);
}

TEST(whole_gdtf, logical_channels_and_sub_channel_sets) {
    Description description;
    description.attributes =
        R"(<Attributes><Attribute Name="Shutter1Strobe"><SubPhysicalUnit Type="DutyCycle" PhysicalUnit="Percent"/></Attribute></Attributes>)";
    description.physical = "<DMXProfiles><DMXProfile Name='P'><Point CFC0='1'/></DMXProfile></DMXProfiles>";
    description.channels =
        R"(<DMXChannel Offset="1" Geometry="Beam" Highlight="255/1"><LogicalChannel Attribute="Shutter1" Snap="On" Master="Grand" MibFade="1.5" DMXChangeTimeLimit="0.25">
<ChannelFunction Attribute="Shutter1Strobe" Physicalfrom="1" PhysicalTo="20"><SubChannelSet Name="duty" PhysicalFrom="0.1" PhysicalTo="0.5" SubPhysicalUnit="Shutter1Strobe.DutyCycle" DMXProfile="P"/></ChannelFunction></LogicalChannel>
<LogicalChannel Attribute="Iris" Master="Everyone"><ChannelFunction Attribute="Iris" DMXFrom="200/1"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    const Channel& channel = file.type.modes.at(0).channels.at(0);
    EXPECT_TRUE(channel.has_highlight);
    EXPECT_EQ(channel.highlight, 255u);
    ASSERT_EQ(channel.logical.size(), 2u);
    EXPECT_TRUE(channel.logical[0].snap);
    EXPECT_EQ(channel.logical[0].master, "Grand");
    EXPECT_EQ(channel.logical[0].mib_fade_s, 1.5f);
    EXPECT_EQ(channel.logical[0].dmx_change_time_limit_s, 0.25f);
    EXPECT_EQ(channel.logical[1].master, "None");
    EXPECT_TRUE(says(file, {"Master is 'Everyone'"}));
    EXPECT_EQ(channel.functions[0].dmx_to, 199u) << "logical channels share the range";
    EXPECT_EQ(channel.functions[1].logical, 1);
    EXPECT_EQ(channel.functions[0].physical_from, 1.0f) << "XML attributes of the wrong case are read";
    ASSERT_EQ(channel.functions[0].sub_sets.size(), 1u);
    EXPECT_EQ(channel.functions[0].sub_sets[0].sub_unit, "DutyCycle");
    EXPECT_EQ(channel.functions[0].sub_sets[0].physical_to, 0.5f);
    EXPECT_EQ(channel.functions[0].sub_sets[0].dmx_profile, 0);
    EXPECT_EQ(file.messages.size(), 1u);
}

TEST(whole_gdtf, a_channel_of_32_bits) {
    Description description;
    description.channels = channel_of("Dimmer",
                                      "<ChannelFunction Attribute='Dimmer'/><ChannelFunction "
                                      "Attribute='Zoom' DMXFrom='128/1' PhysicalFrom='10' PhysicalTo='20'/>",
                                      "4,1,3,2");
    const LoadedType file = loaded(description);
    const Channel& channel = file.type.modes.at(0).channels.at(0);
    EXPECT_EQ(channel.max, 0xffffffffu);
    EXPECT_EQ(channel.functions[1].dmx_from, 0x80808080u);
    const ChannelReading reading = readings_of(file.type, {0x22, 0x44, 0x33, 0x11}).at(0);
    EXPECT_EQ(reading.raw, 0x11223344u);
    EXPECT_NEAR(reading.physical, 0x11223344p0f / 0x80808080p0f, 1e-5f);
    EXPECT_NEAR(readings_of(file.type, {0xff, 0xff, 0xff, 0xff}).at(0).physical, 20.0f, 1e-5f);
}

TEST(whole_gdtf, macros_of_a_mode_and_misplaced_ones) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"><Beam Name="Beam"/>
<GeometryReference Name="L" Geometry="Cell"><Break DMXOffset="1"/></GeometryReference>
<GeometryReference Name="R" Geometry="Cell"><Break DMXOffset="2"/></GeometryReference></Geometry><Geometry Name="Cell"/>)";
    description.channels = channel_of("Dimmer", "<ChannelFunction Attribute='Dimmer'/>") +
                           "<DMXChannel Offset='2,3' Geometry='Cell'><LogicalChannel Attribute='LampControl'>"
                           "<ChannelFunction Attribute='LampControl'/></LogicalChannel></DMXChannel>";
    const std::string macros =
        R"(<FTMacro Name="Lamp on"><MacroDMX><MacroDMXStep Duration="3.5"><MacroDMXValue Value="255/1" DMXChannel="Cell_LampControl"/>
<MacroDMXValue Value="128/1" DMXChannel="Beam_Dimmer"/></MacroDMXStep><MacroDMXStep/></MacroDMX></FTMacro>
<FTMacro Name="Other"><MacroDMX><MacroDMXStep><MacroDMXValue Value="1/1" DMXChannel="Beam_Pan"/></MacroDMXStep></MacroDMX></FTMacro>)";
    description.mode_end = "<FTMacros>" + macros + "</FTMacros>";
    const LoadedType placed = loaded(description);
    ASSERT_EQ(placed.type.modes.at(0).macros.size(), 2u);
    const Macro& macro = placed.type.modes[0].macros[0];
    EXPECT_EQ(macro.name, "Lamp on");
    ASSERT_EQ(macro.steps.size(), 2u);
    EXPECT_EQ(macro.steps[0].duration_s, 3.5f);
    EXPECT_EQ(macro.steps[1].duration_s, 1.0f);
    ASSERT_EQ(macro.steps[0].values.size(), 3u) << "one per instance";
    EXPECT_EQ(macro.steps[0].values[0].raw, 0xffffu);
    EXPECT_EQ(macro.steps[0].values[2].raw, 128u);
    EXPECT_TRUE(says(placed, {"the macro's channel 'Beam_Pan' does not exist"}));

    description.mode_end = "";
    description.end = "<FTMacros>" + macros + "</FTMacros>";
    const LoadedType misplaced = loaded(description);
    ASSERT_EQ(misplaced.type.modes.at(0).macros.size(), 1u);
    EXPECT_EQ(misplaced.type.modes[0].macros[0].steps.at(0).values.size(), 3u);
    EXPECT_TRUE(says(misplaced, {"FTMacros stands under FixtureType"}));
}

TEST(whole_gdtf, relations_of_both_kinds) {
    Description description;
    description.channels =
        channel_of("Dimmer", "<ChannelFunction Attribute='Dimmer'/>", "None") +
        channel_of("ColorAdd_R", "<ChannelFunction Name='Red' Attribute='ColorAdd_R'/>", "1");
    description.mode_end =
        R"(<Relations><Relation Name="a" Master="beam_dimmer" Follower="Beam_ColorAdd_R.ColorAdd_R.red" Type="Multiply"/>
<Relation Name="b" Master="Beam_Dimmer" Follower="Beam_ColorAdd_R" Type="Override"/><Relation Name="c" Master="x" Follower="y" Type="Multiply"/></Relations>)";
    const LoadedType file = loaded(description);
    const std::vector<Relation>& relations = file.type.modes.at(0).relations;
    ASSERT_EQ(relations.size(), 2u);
    EXPECT_EQ(relations[0].kind, Relation::Kind::multiply);
    EXPECT_EQ(relations[0].master_channel, 0);
    EXPECT_EQ(relations[0].follower_channel, 1);
    EXPECT_EQ(relations[0].follower_function, 0);
    EXPECT_EQ(relations[1].kind, Relation::Kind::override_value);
    EXPECT_EQ(relations[1].follower_function, -1);
    EXPECT_TRUE(says(file, {"master or follower does not exist"}));
}

TEST(whole_gdtf, initial_functions) {
    Description description;
    description.channels =
        R"(<DMXChannel Offset="1" Geometry="Beam" InitialFunction="Beam_Shutter1.Shutter1.open"><LogicalChannel Attribute="Shutter1">
<ChannelFunction Name="Closed" Attribute="Shutter1" Default="3/1"/><ChannelFunction Name="Open" Attribute="Shutter1" DMXFrom="10/1" Default="12/1"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="2" Geometry="Beam" InitialFunction="Beam_Zoom.Zoom.None"><LogicalChannel Attribute="Zoom"><ChannelFunction Name="Zoom" Attribute="Zoom" PhysicalFrom="10" PhysicalTo="20" Default="7/1"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.type.modes.at(0).channels.at(0).initial, 12u);
    EXPECT_EQ(file.type.modes[0].channels.at(1).initial, 7u);
    EXPECT_TRUE(says(file, {"InitialFunction 'Beam_Zoom.Zoom.None' does not exist"}));
    EXPECT_EQ(file.messages.size(), 1u);
}

TEST(whole_gdtf, links_may_differ_in_case) {
    Description description;
    description.physical = "<Emitters><Emitter Name='Deep Red' Color='0.7,0.29,10'/></Emitters>";
    description.mode_geometry = "Geometry='BASE'";
    description.channels =
        "<DMXChannel Offset='1' Geometry='bEAM'><LogicalChannel Attribute='COLORADD_R'>"
        "<ChannelFunction Attribute='COLORADD_R' Emitter='deep red'/></LogicalChannel></DMXChannel>";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(file.messages.empty());
    EXPECT_EQ(file.type.modes.at(0).channels.at(0).functions.at(0).emitter, 0);
    EXPECT_EQ(file.type.modes[0].channels[0].functions[0].meaning.role, Role::color_add);
}

// As files of SGM (a function "Open" with a set "Closed"), Robe (both words in the name) and ADB (a strobe
// that is called "Light Off") have it.
TEST(whole_gdtf, a_shutter_is_closed_where_a_name_says_so) {
    Description description;
    description.channels =
        channel_of("Shutter1",
                   "<ChannelFunction Name='Open' Attribute='Shutter1'>"
                   "<ChannelSet Name='Closed' DMXFrom='0/1'/><ChannelSet Name='Open' DMXFrom='5/1'/>"
                   "</ChannelFunction><ChannelFunction Attribute='Shutter1Strobe' DMXFrom='10/1' "
                   "PhysicalFrom='10' PhysicalTo='0.1'/>") +
        channel_of("Shutter1", "<ChannelFunction Name='Open/Closed' Attribute='Shutter1'/>", "2") +
        channel_of("Shutter1", "<ChannelFunction Name='Open' Attribute='Shutter1'/>", "3") +
        channel_of(
            "Shutter1",
            "<ChannelFunction Name='Light Off' Attribute='Shutter1Strobe' PhysicalFrom='0' PhysicalTo='0'/>"
            "<ChannelFunction Name='Strobe' Attribute='Shutter1Strobe' DMXFrom='4/1' PhysicalFrom='1' "
            "PhysicalTo='16'/><ChannelFunction Name='Light ON' Attribute='Shutter1Strobe' DMXFrom='104/1' "
            "PhysicalFrom='1' PhysicalTo='1'/>",
            "4");
    const LoadedType file = loaded(description);
    const auto physical = [&](std::size_t channel, int value) {
        std::vector<std::uint8_t> levels(4, 0);
        levels[channel] = static_cast<std::uint8_t>(value);
        return readings_of(file.type, levels).at(channel).physical;
    };
    for (const int value : {0, 2, 4}) EXPECT_EQ(physical(0, value), 0.0f) << value;
    for (const int value : {5, 7, 9}) EXPECT_EQ(physical(0, value), 1.0f) << value;
    EXPECT_EQ(physical(0, 10), 10.0f);
    EXPECT_EQ(physical(1, 0), 0.0f);
    EXPECT_EQ(physical(1, 255), 1.0f);
    for (const int value : {0, 255}) EXPECT_EQ(physical(2, value), 1.0f) << value;
    const std::vector<ChannelFunction>& strobe = file.type.modes.at(0).channels.at(3).functions;
    EXPECT_EQ(strobe.at(0).meaning.role, Role::shutter);
    EXPECT_EQ(strobe.at(1).meaning.role, Role::strobe);
    EXPECT_EQ(strobe.at(2).meaning.role, Role::shutter);
    EXPECT_EQ(physical(3, 2), 0.0f);
    EXPECT_EQ(physical(3, 200), 1.0f);
}

TEST(whole_gdtf, below_the_first_function_a_dimmer_is_dark_and_a_strobe_is_still) {
    Description description;
    description.channels =
        channel_of("Dimmer",
                   "<ChannelFunction Attribute='Dimmer' DMXFrom='10/1' PhysicalFrom='0' PhysicalTo='1'/>") +
        channel_of(
            "Shutter1",
            "<ChannelFunction Attribute='Shutter1Strobe' DMXFrom='10/1' PhysicalFrom='1' PhysicalTo='20'/>",
            "2") +
        channel_of("Frost1",
                   "<ChannelFunction Attribute='Frost1' DMXFrom='1/1'><ChannelSet DMXFrom='101/1' "
                   "PhysicalFrom='0.8' PhysicalTo='0.9'/></ChannelFunction>",
                   "3");
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"'Dimmer 1' starts at 10; below it holds its first value"}));
    EXPECT_TRUE(says(file, {"'Shutter1Strobe 1' starts at 10; below it the channel does nothing"}));
    const auto low = readings_of(file.type, {5, 5, 0});
    EXPECT_EQ(low.at(0).physical, 0.0f);
    EXPECT_EQ(low.at(1).function, -1);
    EXPECT_EQ(low.at(2).physical, 0.0f);
    const auto high = readings_of(file.type, {10, 10, 51});
    EXPECT_EQ(high.at(0).physical, 0.0f);
    EXPECT_EQ(high.at(1).physical, 1.0f);
    EXPECT_NEAR(high.at(2).physical, 50.0f / 254.0f, 1e-5f) << "the straight line keeps its place";
    EXPECT_FLOAT_EQ(readings_of(file.type, {255, 255, 255}).at(0).physical, 1.0f);
    EXPECT_FLOAT_EQ(readings_of(file.type, {255, 255, 101}).at(2).physical, 0.8f);
}

TEST(whole_gdtf, slots_without_a_wheel_take_the_one_of_their_attribute) {
    Description description;
    description.wheels = "<Wheel Name='color2'><Slot Name='a'/><Slot Name='b'/></Wheel><Wheel "
                         "Name='Prism'><Slot Name='3'/></Wheel>";
    description.channels = channel_of("Color2", "<ChannelFunction Attribute='Color2'><ChannelSet "
                                                "DMXFrom='0/1' WheelSlotIndex='2'/></ChannelFunction>") +
                           channel_of("Prism1",
                                      "<ChannelFunction Attribute='Prism1SelectSpin'><ChannelSet "
                                      "DMXFrom='0/1' WheelSlotIndex='1'/></ChannelFunction>",
                                      "2") +
                           channel_of("Gobo1",
                                      "<ChannelFunction Attribute='Gobo1'><ChannelSet DMXFrom='0/1' "
                                      "WheelSlotIndex='1'/></ChannelFunction>",
                                      "3");
    const LoadedType file = loaded(description);
    const std::vector<Channel>& channels = file.type.modes.at(0).channels;
    EXPECT_EQ(channels[0].functions.at(0).wheel, 0);
    EXPECT_EQ(channels[0].functions[0].sets.at(0).slot, 1);
    EXPECT_EQ(channels[1].functions.at(0).wheel, 1);
    EXPECT_EQ(channels[2].functions.at(0).wheel, -1);
    EXPECT_TRUE(says(file, {"slots without a Wheel, taking 'color2'"}));
    EXPECT_TRUE(says(file, {"WheelSlotIndex is '1', but the function names no wheel"}));
}

TEST(whole_gdtf, a_lamp_without_a_beam_gets_one_but_a_fan_does_not) {
    Description description;
    description.geometries =
        R"(<Geometry Name="Base"><Axis Name="Yoke"><Axis Name="Head"/></Axis></Geometry>)";
    description.channels = "<DMXChannel Offset='1' Geometry='Base'><LogicalChannel Attribute='Dimmer'>"
                           "<ChannelFunction Attribute='Dimmer'/></LogicalChannel></DMXChannel>";
    const LoadedType lamp = loaded(description);
    const Mode& mode = lamp.type.modes.at(0);
    ASSERT_EQ(mode.beams.size(), 1u);
    const Node& node = mode.nodes.at(static_cast<std::size_t>(mode.beams[0]));
    EXPECT_EQ(mode.nodes.at(static_cast<std::size_t>(node.parent)).name, "Head");
    EXPECT_TRUE(lamp.type.geometries.at(static_cast<std::size_t>(node.geometry)).beam->is_assumed);
    EXPECT_EQ(mode.channels.at(0).beams, std::vector<int>{0});
    EXPECT_TRUE(says(lamp, {"taking one of 10000 lm and 25 degrees at 'Head'"}));
    description.channels = "<DMXChannel Offset='1' Geometry='Base'><LogicalChannel Attribute='Fan1'>"
                           "<ChannelFunction Attribute='Fan1'/></LogicalChannel></DMXChannel>";
    const LoadedType fan = loaded(description);
    EXPECT_TRUE(fan.type.modes.at(0).beams.empty());
    EXPECT_TRUE(says(fan, {"it gives no light"}));
}

TEST(whole_gdtf, what_is_not_used_is_said_in_one_note) {
    Description description;
    description.end =
        R"(<Revisions><Revision Text="a"/><Revision Text="b"/></Revisions><FTPresets><FTPreset/></FTPresets>
<Protocols><FTRDM ManufacturerID="0x1"><SoftwareVersionID Value="1"/></FTRDM></Protocols><Strange a="b"/>)";
    description.models = "<Model Name='M' SVGOffsetX='12' SVGOffsetY='0.000000'/>";
    const LoadedType file = loaded(description);
    ASSERT_EQ(file.messages.size(), 2u);
    EXPECT_TRUE(says(file, {"needs it: 1 FTPreset, 1 FTRDM"}));
    EXPECT_TRUE(says(file, {"the element <Strange> is not in the standard, left out"}));
    EXPECT_EQ(file.messages[0].severity, Severity::note);
    Description empty;
    empty.end = "<Revisions/><FTPresets/><Protocols/>";
    EXPECT_TRUE(loaded(empty).messages.empty()) << "empty lists hold nothing";
}

TEST(whole_gdtf, fixture_type_itself) {
    std::string xml = Description{}.xml();
    xml.replace(xml.find("Name=\"Tiny\""), 11,
                "Name='Tiny' ShortName='T' LongName='Tiny Spot' Description='d' FixtureTypeID='A-B' "
                "Thumbnail='thumbnail' "
                "RefFT='C-D' CanHaveChildren='No'");
    xml.replace(xml.find("DataVersion=\"1.2\""), 17, "DataVersion=\"2.0\"");
    const auto file =
        load_gdtf(make_zip({{"description.xml", "\xef\xbb\xbf" + xml}, {"thumbnail.png", "x"}}), "t.gdtf");
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_EQ(file->type.long_name, "Tiny Spot");
    EXPECT_EQ(file->type.reference_type, "C-D");
    EXPECT_EQ(file->type.thumbnail, "thumbnail.png");
    EXPECT_FALSE(file->type.can_have_children);
    EXPECT_TRUE(says(*file, {"DataVersion is '2.0', expected 1.0, 1.1 or 1.2"}));
    EXPECT_EQ(file->messages.size(), 1u);
}

TEST(whole_gdtf, attributes_with_other_names) {
    EXPECT_EQ(attribute_from("Dim").role, Role::dimmer);
    EXPECT_EQ(attribute_from("Shutter").role, Role::shutter);
    EXPECT_EQ(attribute_from("ColorTINT").role, Role::tint);
    EXPECT_EQ(attribute_from("CCT").role, Role::cct);
    EXPECT_EQ(attribute_from("CTO").letter, 'O');
    EXPECT_EQ(attribute_from("Pan Rotate").role, Role::pan_rotate);
    const Attribute blade = attribute_from("Blade3B");
    EXPECT_EQ(blade.role, Role::blade_b);
    EXPECT_EQ(blade.number, 3);
    EXPECT_EQ(attribute_from("Prism2PosRotate").role, Role::prism_rotate);
    EXPECT_EQ(attribute_from("Shutter1StrobePulseOpen").letter, 'O');
    EXPECT_EQ(attribute_from("GoboWheel3MSpeed").letter, 'G');
    EXPECT_EQ(attribute_from("Effects1").role, Role::none);
}

} // namespace
} // namespace ghost::fixture
