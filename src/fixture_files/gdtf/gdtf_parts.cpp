// SPDX-License-Identifier: Apache-2.0
// Wheels with their pictures, models with their meshes.
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include "base/text.h"
#include "fixture/values.h"
#include "fixture_files/common/gobo_files.h"
#include "fixture_files/common/mesh_check.h"
#include "image/ldr.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxSlots = 4096; // per wheel; the library's largest real wheel has 60
constexpr std::size_t kMaxWheels = 256;
constexpr std::size_t kMaxFacets = 256;
constexpr std::size_t kMaxModels = 4096;

// The size that a PNG claims, before anything is decoded; 0 where it is no PNG.
glm::uvec2 png_size(Bytes png) {
    constexpr std::uint8_t kMagic[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    ByteReader reader(png);
    const Bytes magic = reader.take(8);
    if (magic.empty() || !std::equal(magic.begin(), magic.end(), kMagic)) return {0, 0};
    reader.skip(8); // length and "IHDR"
    const std::uint32_t width = reader.u32_be();
    const std::uint32_t height = reader.u32_be();
    return reader.ok() ? glm::uvec2(width, height) : glm::uvec2(0, 0);
}

// A MediaFileName has neither folder nor extension, but real files write both, and folders of the maker's own
// computer ("Clay Paky/00591401").
std::string find_media(const Archive& archive, const std::string& file) {
    const std::string base = file.substr(file.find_last_of("/\\") + 1);
    for (const std::string& path : {"wheels/" + file + ".png", "wheels/" + file, file + ".png", file,
                                    "wheels/" + base + ".png", "wheels/" + base})
        if (std::string entry = archive.find(path); !entry.empty()) return entry;
    return "";
}

int read_media(GdtfReader& reader, pugi::xml_node slot, const std::string& file) {
    if (const auto known = reader.media.find(file); known != reader.media.end()) return known->second;
    reader.media[file] = -1;
    const std::string entry = find_media(reader.archive, file);
    if (entry.empty()) {
        reader.say(Severity::error, slot, "the picture wheels/" + file + ".png is not in the archive");
        return -1;
    }
    Result<std::vector<std::uint8_t>> png = reader.archive.read(entry);
    if (!png) {
        reader.say_at(Severity::error, png.error().where, png.error().what);
        return -1;
    }
    const std::string where = reader.name + ": " + entry;
    const glm::uvec2 size = png_size(*png);
    if (size.x == 0 || size.y == 0 || size.x > kMaxPicture_px || size.y > kMaxPicture_px) {
        reader.say_at(Severity::error, where, "expected a PNG of at most 4096 x 4096 pixels");
        return -1;
    }
    reader.pixels_decoded += std::size_t{size.x} * size.y;
    if (reader.pixels_decoded > kMaxPicturePixels) {
        reader.say_at(Severity::error, where, "the file's pictures have more than 96 million pixels in all");
        return -1;
    }
    std::string damage;
    Result<image::Image8> pixels = image::decode_ldr(*png, where, {}, &damage);
    if (!pixels) {
        reader.say_at(Severity::error, pixels.error().where, pixels.error().what);
        return -1;
    }
    if (!damage.empty()) reader.say_at(Severity::warning, where, damage);
    Media media;
    media.file = entry;
    media.png = std::move(*png);
    media.width = pixels->width;
    media.height = pixels->height;
    media.rgba = std::move(pixels->samples);
    reader.type().media.push_back(std::move(media));
    return reader.media[file] = static_cast<int>(reader.type().media.size()) - 1;
}

// "{a,b,c}{d,e,f}{g,h,i}"; identity where it is something else.
std::array<float, 9> read_rotation(GdtfReader& reader, pugi::xml_node node) {
    const Facet identity;
    std::array<float, 9> result = identity.rotation;
    const std::string text = reader.text(node, "Rotation");
    if (text.empty()) return result;
    std::string flat = text;
    std::replace(flat.begin(), flat.end(), '{', ',');
    std::replace(flat.begin(), flat.end(), '}', ',');
    std::size_t count = 0;
    for (const std::string_view part : split(flat, ',')) {
        if (trimmed(part).empty()) continue;
        const std::optional<float> number = parse_float(part);
        if (!number || count == 9) {
            count = 0;
            break;
        }
        result[count++] = *number;
    }
    const bool nothing = std::all_of(result.begin(), result.end(), [](float number) { return number == 0; });
    if (count == 9 && !nothing) return result;
    reader.say(Severity::warning, node,
               count == 9 ? "Rotation has only zeros, taking identity"
                          : "Rotation is not a matrix of 3 x 3 numbers, taking identity");
    return identity.rotation;
}

AnimationSystem read_animation(GdtfReader& reader, pugi::xml_node node) {
    const auto point = [&](const char* name) {
        const std::string text = reader.text(node, name);
        const std::vector<std::string_view> parts = split(text, ',');
        const auto x = parse_float(parts[0]);
        const auto y = parts.size() == 2 ? parse_float(parts[1]) : std::nullopt;
        if (x && y) return glm::vec2(*x, *y);
        reader.say(Severity::warning, node,
                   std::string(name) + " is '" + text + "', expected 'x,y', taking the middle");
        return glm::vec2(0.0f);
    };
    AnimationSystem system;
    system.p1 = point("P1");
    system.p2 = point("P2");
    system.p3 = point("P3");
    system.radius = reader.number(node, "Radius", 0.0f, 0.0f, 1e6f);
    return system;
}

Slot read_slot(GdtfReader& reader, pugi::xml_node node) {
    Slot slot;
    slot.name = reader.text(node, "Name");
    slot.color = reader.color(node, "Color");
    slot.filter = reader.link(node, "Filter", reader.filters);
    if (slot.filter >= 0 && !node.attribute("Color"))
        slot.color = reader.type().filters[static_cast<std::size_t>(slot.filter)].color;
    slot.media_file = reader.text(node, "MediaFileName");
    if (!slot.media_file.empty()) slot.media = read_media(reader, node, slot.media_file);
    for (const pugi::xml_node facet : node.children("Facet")) {
        if (reader.is_full(facet, slot.facets.size(), kMaxFacets, "facets")) break;
        slot.facets.push_back({reader.color(facet, "Color"), read_rotation(reader, facet)});
    }
    if (const pugi::xml_node animation = node.child("AnimationSystem"))
        slot.animation = read_animation(reader, animation);
    return slot;
}

// The mesh of a model, the detailed folders first, glTF before 3DS.
void read_mesh(GdtfReader& reader, pugi::xml_node node, Model& model, const std::string& file) {
    constexpr const char* kFolders[] = {"gltf", "3ds", "gltf_high", "3ds_high", "gltf_low", "3ds_low"};
    bool found = false;
    for (const std::string folder : kFolders) {
        const std::string extension = folder.starts_with("gltf") ? "glb" : "3ds";
        const std::string entry = reader.archive.find("models/" + folder + "/" + file + "." + extension);
        if (entry.empty()) continue;
        found = true;
        Result<std::vector<std::uint8_t>> mesh = reader.archive.read(entry);
        if (!mesh) {
            reader.say_at(Severity::error, mesh.error().where, mesh.error().what);
            continue;
        }
        if (const std::string fault = fault_of_mesh(*mesh, extension); !fault.empty()) {
            reader.say_at(Severity::error, reader.name + ": " + entry, fault + "; the mesh is left out");
            continue;
        }
        model.mesh_file = entry;
        model.mesh_extension = extension;
        model.mesh = std::move(*mesh);
        return;
    }
    if (!found)
        reader.say(Severity::error, node,
                   "no mesh '" + file + "' (.glb or .3ds) in models/, taking the primitive");
}

} // namespace

void read_wheels(GdtfReader& reader, pugi::xml_node fixture_type) {
    for (const pugi::xml_node node : fixture_type.child("Wheels").children("Wheel")) {
        if (reader.is_full(node, reader.type().wheels.size(), kMaxWheels, "wheels")) break;
        Wheel wheel;
        wheel.name = reader.text(node, "Name");
        for (const pugi::xml_node slot : node.children("Slot")) {
            if (reader.is_full(slot, wheel.slots.size(), kMaxSlots, "slots on a wheel")) break;
            wheel.slots.push_back(read_slot(reader, slot));
        }
        if (wheel.slots.empty())
            reader.say(Severity::note, node, "the wheel '" + wheel.name + "' has no slots");
        reader.add_name(reader.wheels, node, "wheel", wheel.name,
                        static_cast<int>(reader.type().wheels.size()));
        reader.type().wheels.push_back(std::move(wheel));
    }
}

void read_models(GdtfReader& reader, pugi::xml_node fixture_type) {
    for (const pugi::xml_node node : fixture_type.child("Models").children("Model")) {
        if (reader.is_full(node, reader.type().models.size(), kMaxModels, "models")) break;
        Model model;
        model.name = reader.text(node, "Name");
        model.size_m = {reader.number(node, "Length", 0.0f, 0.0f, 1000.0f),
                        reader.number(node, "Width", 0.0f, 0.0f, 1000.0f),
                        reader.number(node, "Height", 0.0f, 0.0f, 1000.0f)};
        model.primitive =
            reader.choice(node, "PrimitiveType",
                          {"Undefined", "Cube", "Cylinder", "Sphere", "Base", "Yoke", "Head", "Scanner",
                           "Conventional", "Pigtail", "Base1_1", "Scanner1_1", "Conventional1_1"});
        const std::string file = reader.text(node, "File");
        if (!file.empty()) read_mesh(reader, node, model, file);
        reader.add_name(reader.models, node, "model", model.name,
                        static_cast<int>(reader.type().models.size()));
        reader.type().models.push_back(std::move(model));
    }
}

} // namespace ghost::fixture
