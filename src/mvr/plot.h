#pragma once
// SPDX-License-Identifier: Apache-2.0
// Plot: what the General Scene Description of an MVR file says (MVR 1.4 to 1.6, DIN SPEC 15801:2023-12), as
// plain data; mvr/mvr_load.h reads it. World: right-handed, Z up, X right, Y into the stage, metres; glm
// matrices (column vectors: world = parent's world * local), where the file has millimetres and rows u, v, w,
// o. Scales and mirrors are kept: a matrix of negative determinant turns the winding. Doubles, because plots
// in survey coordinates lie hundreds of kilometres from their origin. Indices are -1 for none and checked by
// the reader, so users need no range checks. UUIDs stand as written: compare uuid_key()s. Any thread.

#include "fixture/patch.h"
#include "fixture/type.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ghost::scene {

enum class ObjectKind { scene_object, group, focus_point, fixture, support, truss, video_screen, projector };

const char* name_of(ObjectKind kind); // "scene object", "group", ...
const char* tag_of(ObjectKind kind);  // "SceneObject", "GroupObject", ...

// A mesh in the archive: every file is listed once, however often it is used.
struct PlotMesh {
    std::string file;      // as written (without an extension it is a .3ds)
    std::string member;    // its name in the archive; empty: not there
    std::string extension; // "3ds", "glb", "gltf": small letters, without the dot
    // 3DS counts in millimetres, Z up; glTF in metres, Y up. This takes the file's coordinates to metres, Z
    // up.
    glm::dmat4 to_metres{1.0};
};

// A Geometry3D (mesh >= 0) or a Symbol (symbol >= 0). Neither: what it names does not exist.
struct PlotGeometry {
    int mesh = -1;         // Plot::meshes
    int symbol = -1;       // Plot::symbols
    std::string uuid;      // of the Symbol
    glm::dmat4 local{1.0}; // in the frame of the object or symbol
};

struct PlotSymbol { // Symdef
    std::string uuid;
    std::string name;
    std::vector<PlotGeometry> geometries; // symbols in symbols; cycles are cut by the reader
    int line = 0;
};

struct PlotName { // Class, Position
    std::string uuid;
    std::string name;
    int line = 0;
};

struct PlotSource { // of a picture: for a screen, a projection, a mapping
    std::string linked_geometry;
    std::string type;   // "NDI", "File", "CITP", "CaptureDevice", or what else stands there
    std::string value;  // stream, file, stream or device
    std::string member; // type "File": its name in the archive; empty: not there
};

enum class PictureScale { keep_ratio, ignore_ratio, keep_size_centred };

struct PlotMappingDefinition {
    std::string uuid;
    std::string name;
    int size_x = 0; // pixels
    int size_y = 0;
    PlotSource source;
    PictureScale scale = PictureScale::keep_ratio;
    int line = 0;
};

struct PlotMapping { // where a fixture takes its pixels from
    std::string definition_uuid;
    int definition = -1; // Plot::mapping_definitions
    int ux = 0;          // pixels from the definition's left top corner
    int uy = 0;
    int ox = 0; // size in pixels
    int oy = 0;
    double rz_deg = 0; // anticlockwise about the middle
};

struct PlotProjection {
    std::vector<PlotSource> sources;
    PictureScale scale = PictureScale::keep_ratio;
};

struct PlotAddress {
    int dmx_break = 0;        // as written, from 0; see gdtf_break
    fixture::Address address; // universe 1-based; channel 0: not patched
    std::string written;      // "513" and "2.1" are the same place
    bool is_known = true;     // false: what is written is no address
};

int absolute_address(const fixture::Address& address); // 513 for universe 2 channel 1; 0: not patched

struct PlotNetwork {
    std::string geometry;
    std::string ipv4;
    std::string subnet_mask;
    std::string ipv6;
    std::string dhcp;
    std::string hostname;
};

struct PlotProtocol {
    std::string geometry = "NetworkInOut_1";
    std::string name;
    std::string type;
    std::string version;
    std::string transmission;
};

struct PlotAlignment { // which way a beam geometry looks in the device's frame
    std::string geometry;
    glm::dvec3 up{0, 0, 1};
    glm::dvec3 direction{0, 0, -1};
};

struct PlotCommand {
    std::string text;     // "Yoke_Pan.Pan.Pan 1,f 12.5"
    std::string function; // "Yoke_Pan.Pan.Pan 1": GDTF link of a channel function; empty: not of this form
    std::string unit;     // "f": physical value of the function
    std::optional<double> value; // 12.5
};

struct PlotOverwrite { // Universal.gdtt: this wheel slot, filter, emitter .. instead of that
    std::string universal;
    std::string target; // empty: removed
};

struct PlotConnection { // a cable
    std::string own;    // GDTF geometry (plug) of this object
    std::string other;  // of the other object
    std::string to_uuid;
    int to_object = -1; // Plot::objects
};

struct PlotGobo {
    std::string file;   // as written
    std::string member; // name in the archive; empty: not there
    double rotation_deg = 0;
};

// What an object says of itself as a device. Fixtures always have it; since MVR 1.6 scene objects, trusses,
// supports, screens and projectors may.
struct PlotDevice {
    std::string gdtf_spec; // as written; empty: no GDTF
    std::string gdtf_mode;
    int gdtf = -1; // Plot::gdtf_files
    std::vector<PlotAddress> addresses;
    bool has_stray_address = false; // one more, of a break that cannot be read
    std::string fixture_id;
    std::optional<int> fixture_id_numeric;
    std::optional<int> fixture_type_id; // until MVR 1.5
    std::optional<int> unit_number;
    int custom_id = 0;
    int custom_id_type =
        0; // 1 fixture, 2 channel, 4 house lights, 5 non-dim, 6 media, 7 fog, 8 effect, 9 pyro, 10 marker
    std::optional<bool> cast_shadow;
    bool invert_pan = false;
    bool invert_tilt = false;
    std::string focus_uuid;
    int focus = -1; // the focus point it is aimed at: Plot::objects
    std::string position_uuid;
    int position = -1; // hanging position: Plot::positions
    std::string function;
    std::string child_position; // dotted name of a geometry of the parent's GDTF that it hangs on
    std::string multipatch_uuid;
    int multipatch = -1; // Plot::objects: has the same channels as that one, whose addresses are meant
    std::optional<fixture::ColorCie> color; // xyY of a filter in the beam
    std::optional<PlotGobo> gobo;
    std::vector<PlotMapping> mappings;
    std::vector<PlotCommand> commands;
    std::vector<PlotOverwrite> overwrites;
    std::vector<PlotAlignment> alignments;
    std::vector<PlotConnection> connections;
    std::vector<PlotNetwork> networks;
    std::vector<PlotProtocol> protocols;
};

// Nobody: the plot's matrix cannot be used, and it stays at the origin of what it hangs on.
enum class PlacedBy { plot, nobody, change };

struct PlotObject {
    ObjectKind kind = ObjectKind::scene_object;
    std::string uuid;
    std::string name;
    int layer = -1;            // Plot::layers
    int parent = -1;           // Plot::objects; -1: stands directly in its layer
    std::vector<int> children; // Plot::objects
    glm::dmat4 local{1.0};     // in the frame of the parent (or layer), metres
    glm::dmat4 world{1.0};
    PlacedBy placed_by = PlacedBy::plot;
    PlacedBy turned_by = PlacedBy::plot;
    std::string class_uuid;
    int plot_class = -1; // Plot::classes
    std::vector<PlotGeometry> geometries;
    PlotDevice device;
    double chain_length = 0;                 // support; as written, the standard names no unit
    std::vector<PlotSource> sources;         // video screen
    std::vector<PlotProjection> projections; // projector
    bool hidden = false;                     // by a PlotChange; no file says so
    int line = 0;                            // in the description, for messages
    std::ptrdiff_t element = -1;             // where its element stands in the description, for the export
};

struct PlotLayer {
    std::string uuid;
    std::string name;
    glm::dmat4 local{1.0};
    PlacedBy placed_by = PlacedBy::plot;
    std::vector<int> objects; // the top ones: Plot::objects
    bool implied = false;     // the file has objects in no layer: they lie in this one
    int line = 0;
};

struct PlotUserData {
    std::string provider;
    std::string version;
    std::string xml; // the element as it stands, cut at 64 KiB (the export has all of it)
};

// A fixture file that the plot asks for.
struct PlotGdtf {
    std::string spec;   // as the first object wrote it
    std::string member; // name in the archive; empty: not there
    int objects = 0;    // how many use it
};

struct Plot {
    int version_major = 0;
    int version_minor = 0;
    std::string provider;
    std::string provider_version;
    std::vector<PlotUserData> user_data;
    std::vector<PlotLayer> layers;
    std::vector<PlotObject> objects; // reading order: a parent stands before its children
    std::vector<PlotSymbol> symbols;
    std::vector<PlotName> classes;
    std::vector<PlotName> positions;
    std::vector<PlotMappingDefinition> mapping_definitions;
    std::vector<PlotMesh> meshes;
    std::vector<PlotGdtf> gdtf_files;
};

// Small letters, without braces and blanks around: what two spellings of one UUID share.
std::string uuid_key(std::string_view uuid);

// The objects of a plot by UUID; of several of one, the first. For as long as none comes or goes.
class ObjectIndex {
public:
    explicit ObjectIndex(const Plot& plot);
    int find(std::string_view uuid) const; // -1: none

private:
    std::unordered_map<std::string, int> by_key_; // uuid_key
};

// The GDTF break (from 1) that an address of this device is for. MVR counts breaks from 0; a device whose
// lowest break is 1 or more was written by a program that counts as GDTF does.
int gdtf_break(const PlotDevice& device, const PlotAddress& address);

// Addresses for a fixture::Patch: [0] is break 1; breaks without an address are not patched. Follows
// multipatch.
std::vector<fixture::Address> patch_addresses(const Plot& plot, const PlotObject& object);
// False: one of these is written and cannot be read.
bool are_addresses_known(const Plot& plot, const PlotObject& object);

struct MeshInstance {
    int mesh = -1;            // Plot::meshes
    int object = -1;          // Plot::objects
    glm::dmat4 to_world{1.0}; // from metres, Z up; for the file's own coordinates * PlotMesh::to_metres
};

// Every mesh of one object (without its children), symbols taken apart. At most kMaxMeshInstances
// (mvr/mvr_load.h) for a whole plot that the reader made.
std::vector<MeshInstance> mesh_instances(const Plot& plot, int object);
std::vector<MeshInstance> mesh_instances(const Plot& plot);

// World matrices from the local ones: of all objects; of one and those above it.
void update_world(Plot& plot);
void update_world(Plot& plot, int object);

// What a user changed about an object, by UUID, so that it outlives the next version of the plot.
struct PlotChange {
    enum class What { address, mode, position, name, hidden };
    std::string uuid;
    What what = What::name;
    int dmx_break = 0;        // address
    fixture::Address address; // address; channel 0 takes the patch away
    std::string text;         // mode, name
    glm::dmat4 local{1.0};    // position, in the parent's frame, metres: it goes along when the truss moves
    bool hidden = true;       // hidden
};

// Of one object, whatever UUID the change names; its world matrix is left as it is (see update_world).
void apply_change(PlotObject& object, const PlotChange& change);

} // namespace ghost::scene
