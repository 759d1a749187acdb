#pragma once
// SPDX-License-Identifier: Apache-2.0
// Palettes: values of one kind under a name, to be given to whatever heads are selected: [[palette]] of
// show.toml. Some heads may have values of their own in it, as those that all point at one place have.
// Degrees; colours linear Rec.2020. Plain values.

#include "base/report.h"
#include "base/result.h"

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

class TableReader; // json_xml_toml/toml_reader.h
struct Show;       // show/show.h

enum class PaletteKind { position, colour, beam, gobo };
inline constexpr std::array<const char*, 4> kPaletteKinds{"position", "colour", "beam", "gobo"};
Result<PaletteKind> palette_kind_of(const std::string& word);

// Of one head; each kind of palette has those that are its own.
struct PaletteValues {
    std::optional<float> pan_deg;
    std::optional<float> tilt_deg;
    std::optional<glm::vec3> colour; // largest component 1
    std::optional<float> zoom_deg;
    std::optional<int> gobo;                 // slot of the first wheel
    std::map<std::string, float> attributes; // as GDTF names them: fraction of their channels' range

    bool is_empty() const { return *this == PaletteValues{}; }
    bool operator==(const PaletteValues&) const = default;
};

struct Palette {
    std::string name;
    PaletteKind kind = PaletteKind::position;
    PaletteValues values;                          // of any head
    std::map<std::string, PaletteValues> fixtures; // by name: in the place of values
    std::string where;                             // file:line
};

std::vector<Palette> read_palettes(TableReader& top, const std::string& file, Report& report);
// Names of fixtures that the show does not have.
void check_palettes(const Show& show, Report& report);

// Index of that palette; the error lists a near name.
Result<std::size_t> find_palette(const std::vector<Palette>& palettes, const std::string& name);

} // namespace ghost::scene
