// SPDX-License-Identifier: Apache-2.0
#include "show/plot_entries.h"

#include "dmx/wire/universes.h"
#include "json_xml_toml/toml_reader.h"
#include "show/limits.h"
#include "show/show.h"

namespace ghost::scene {
ChangeEntry read_change(TableReader& reader) {
    ChangeEntry entry;
    entry.uuid = reader.text("uuid").value_or("");
    entry.where = reader.where("uuid");
    if (!reader.has("uuid")) reader.missing("uuid", "that of an object of the plot; the change is left out");
    const auto universe = reader.integer("universe", 1, dmx::kMaxUniverse);
    const auto address = reader.integer("address", 0, 512);
    if (address)
        entry.address = fixture::Address{universe.value_or(1), *address};
    else if (universe)
        reader.problem(Severity::error, "universe", "says nothing without an address (0: not patched)");
    entry.dmx_break = reader.integer("break", 1, int{kMaxBreaks}).value_or(1);
    entry.mode = reader.text("mode");
    entry.name = reader.text("name");
    entry.position_m = reader.vec3("position_m", kMaxCoordinate_m);
    entry.rotation_deg = reader.vec3("rotation_deg", 360);
    entry.hidden = reader.boolean("hidden");
    entry.circuit = reader.text("circuit");
    if (!entry.uuid.empty() && !entry.address && !entry.mode && !entry.name && !entry.position_m &&
        !entry.rotation_deg && !entry.hidden && !entry.circuit)
        reader.problem(Severity::warning, "uuid",
                       "changes nothing, expected universe and address, mode, name, position_m, "
                       "rotation_deg, circuit or hidden");
    reader.finish();
    return entry;
}

SubstituteEntry read_substitute(TableReader& reader) {
    SubstituteEntry entry;
    entry.spec = reader.text("for").value_or("");
    entry.where = reader.where("for");
    entry.gdtf = reader.text("gdtf").value_or("");
    entry.mode = reader.text("mode").value_or("");
    if (!reader.has("for")) reader.missing("for", "the name of a fixture file of the plot, with * and ?");
    if (!reader.has("gdtf")) reader.missing("gdtf", "the name of a fixture file in the show's folder");
    reader.finish();
    return entry;
}

PhotometryEntry read_photometry(TableReader& reader) {
    PhotometryEntry entry;
    entry.spec = reader.text("for").value_or("");
    entry.where = reader.where("for");
    entry.file = reader.text("file").value_or("");
    if (!reader.has("for")) reader.missing("for", "the name of a fixture file, with * and ?");
    if (!reader.has("file")) reader.missing("file", "the name of an .ies or .ldt file in the show's folder");
    reader.finish();
    return entry;
}

} // namespace ghost::scene
