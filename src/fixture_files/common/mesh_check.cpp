// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/mesh_check.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ghost::fixture {
namespace {

constexpr std::size_t kHeader3ds = 6; // u16 identifier, u32 length with the header

std::uint32_t u32_at(Bytes bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

std::uint32_t u16_at(Bytes bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8;
}

std::string at_byte(std::size_t at) {
    return " at byte " + std::to_string(at);
}

// The arrays that loaders take by their own count: vertices, faces, texture coordinates.
std::string fault_of_array(Bytes bytes, std::uint32_t identifier, std::size_t at, std::size_t end) {
    std::size_t item = 0;
    if (identifier == 0x4110) item = 12;
    if (identifier == 0x4120) item = 8;
    if (identifier == 0x4140) item = 8;
    if (item == 0) return "";
    if (end - at < 2) return "an empty list" + at_byte(at);
    const std::size_t count = u16_at(bytes, at);
    if (count * item > end - at - 2)
        return "a list of " + std::to_string(count) + " items runs past the end of its chunk" + at_byte(at);
    return "";
}

// Tracks of the keyframer: 10 bytes, u32 count, keys. Assimp makes room for as many as it says.
std::string fault_of_track(Bytes bytes, std::uint32_t identifier, std::size_t at, std::size_t end) {
    constexpr std::size_t kBefore = 10, kLeastKey = 6; // number of the frame and flags
    if (identifier < 0xb020 || identifier > 0xb029) return "";
    if (end - at < kBefore + 4) return "a track of keys without their number" + at_byte(at);
    const std::size_t count = u32_at(bytes, at + kBefore);
    if (count > (end - at - kBefore - 4) / kLeastKey)
        return "a track of " + std::to_string(count) + " keys runs past the end of its chunk" + at_byte(at);
    return "";
}

// How deep the keyframer's nodes lie in each other. Assimp goes down by recursion, and takes a node for a
// child of the one before where its parent's number says so; else it goes up to the last one with the same
// parent.
class NodeDepth {
public:
    // A node's name (0xb010): text, two words of flags, i16 number of the parent.
    std::string fault_of(Bytes bytes, std::size_t at, std::size_t end) {
        constexpr std::size_t kMaxDepth = 1000;
        std::size_t text = at;
        while (text < end && bytes[text] != 0) ++text;
        if (end - text < 7) return "a node without its place in the tree" + at_byte(at);
        const std::size_t parent = (u16_at(bytes, text + 5) + 1) & 0xffffu; // from 1, 0 for none
        if (parent + 1 < nodes_++ || path_.empty()) {
            while (!path_.empty() && path_.back() != parent) path_.pop_back();
            if (path_.empty()) path_.push_back(parent);
        } else if (path_.back() != parent) {
            path_.push_back(parent);
        }
        return path_.size() > kMaxDepth
                   ? "nodes more than " + std::to_string(kMaxDepth) + " deep in each other" + at_byte(at)
                   : "";
    }

private:
    std::vector<std::size_t> path_; // parents' numbers from the root to the last node
    std::size_t nodes_ = 0;
};

// Main, editor, mesh, keyframer and its nodes. (An object holds them after its name.)
bool holds_3ds_chunks(std::uint32_t identifier) {
    return identifier == 0x4d4d || identifier == 0x3d3d || identifier == 0x4100 ||
           (identifier >= 0xb000 && identifier <= 0xb007);
}

// Chunks from at to end.
std::string fault_of_chunks(Bytes bytes, std::size_t at, std::size_t end, int depth, NodeDepth& nodes) {
    while (at < end) {
        if (end - at < kHeader3ds) {
            // Exporters pad the end of the file.
            const bool padding = depth == 0 || std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                                                           bytes.begin() + static_cast<std::ptrdiff_t>(end),
                                                           [](std::uint8_t byte) { return byte == 0; });
            return padding ? "" : "half a chunk" + at_byte(at);
        }
        const std::uint32_t identifier = u16_at(bytes, at);
        const std::size_t length = u32_at(bytes, at + 2);
        if (length < kHeader3ds || length > end - at)
            return "a 3DS chunk of " + std::to_string(length) + " bytes where " + std::to_string(end - at) +
                   " are left" + at_byte(at);
        std::size_t inside = at + kHeader3ds;
        const std::size_t next = at + length;
        bool holds_chunks = holds_3ds_chunks(identifier);
        if (identifier == 0x4000) {
            while (inside < next && bytes[inside] != 0) ++inside;
            if (inside == next) return "an object's name without an end" + at_byte(at);
            ++inside;
            holds_chunks = true;
        }
        if (std::string fault = fault_of_array(bytes, identifier, inside, next); !fault.empty()) return fault;
        if (std::string fault = fault_of_track(bytes, identifier, inside, next); !fault.empty()) return fault;
        if (identifier == 0xb010)
            if (std::string fault = nodes.fault_of(bytes, inside, next); !fault.empty()) return fault;
        if (holds_chunks && depth < 8)
            if (std::string fault = fault_of_chunks(bytes, inside, next, depth + 1, nodes); !fault.empty())
                return fault;
        at = next;
    }
    return "";
}

// Calls found(identifier, begin, end) for each chunk directly inside [at, end).
template <typename Found>
void each_chunk(Bytes bytes, std::size_t at, std::size_t end, Found&& found) {
    while (end - at >= kHeader3ds) {
        const std::size_t length = u32_at(bytes, at + 2);
        if (length < kHeader3ds || length > end - at) return;
        found(u16_at(bytes, at), at + kHeader3ds, at + length);
        at += length;
    }
}

std::size_t count_beyond(Bytes bytes, std::size_t mesh, std::size_t mesh_end) {
    std::size_t vertices = 0;
    std::size_t beyond = 0;
    each_chunk(bytes, mesh, mesh_end, [&](std::uint32_t identifier, std::size_t at, std::size_t end) {
        if (identifier == 0x4110 && end - at >= 2) vertices = u16_at(bytes, at);
    });
    each_chunk(bytes, mesh, mesh_end, [&](std::uint32_t identifier, std::size_t at, std::size_t end) {
        if (identifier != 0x4120 || end - at < 2) return;
        const std::size_t count = std::min<std::size_t>(u16_at(bytes, at), (end - at - 2) / 8);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t triangle = at + 2 + 8 * i;
            beyond += std::max({u16_at(bytes, triangle), u16_at(bytes, triangle + 2),
                                u16_at(bytes, triangle + 4)}) >= vertices;
        }
    });
    return beyond;
}

std::string fault_of_glb(Bytes bytes) {
    if (bytes.size() < 20 || u32_at(bytes, 0) != 0x46546c67) return "no glTF binary file";
    if (u32_at(bytes, 4) != 2) return "glTF version " + std::to_string(u32_at(bytes, 4)) + ", expected 2";
    const std::size_t size = u32_at(bytes, 8);
    if (size > bytes.size())
        return "cut short: " + std::to_string(bytes.size()) + " of " + std::to_string(size) + " bytes";
    for (std::size_t at = 12; at + 8 <= size;) {
        const std::size_t length = u32_at(bytes, at);
        if (length > size - at - 8)
            return "a glTF chunk of " + std::to_string(length) + " bytes where " +
                   std::to_string(size - at - 8) + " are left" + at_byte(at);
        at += 8 + length;
    }
    return "";
}

} // namespace

std::string fault_of_mesh(Bytes bytes, std::string_view extension) {
    if (extension == "glb") return fault_of_glb(bytes);
    if (bytes.size() < kHeader3ds || u16_at(bytes, 0) != 0x4d4d) return "no 3DS file";
    NodeDepth nodes;
    return fault_of_chunks(bytes, 0, bytes.size(), 0, nodes);
}

std::size_t count_triangles_beyond_3ds(Bytes bytes) {
    std::size_t beyond = 0;
    // main > editor > object > mesh
    const auto editor = [&](std::uint32_t identifier, std::size_t at, std::size_t end) {
        if (identifier != 0x4000) return;
        while (at < end && bytes[at] != 0) ++at;
        each_chunk(bytes, std::min(at + 1, end), end,
                   [&](std::uint32_t inner, std::size_t mesh, std::size_t mesh_end) {
                       if (inner == 0x4100) beyond += count_beyond(bytes, mesh, mesh_end);
                   });
    };
    each_chunk(bytes, 0, bytes.size(), [&](std::uint32_t, std::size_t main, std::size_t main_end) {
        each_chunk(bytes, main, main_end, [&](std::uint32_t identifier, std::size_t at, std::size_t end) {
            if (identifier == 0x3d3d) each_chunk(bytes, at, end, editor);
        });
    });
    return beyond;
}

} // namespace ghost::fixture
