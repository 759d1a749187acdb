// SPDX-License-Identifier: Apache-2.0
#include "plots/private/plot_movers.h"

#include "base/name_index.h"
#include "base/print.h"
#include "base/text.h"
#include "disk/files.h"
#include "disk/user_file.h"
#include "json_xml_toml/toml_keys.h"
#include "json_xml_toml/toml_reader.h"
#include "mvr/mvr_load.h"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr std::size_t kMostCarried = 20'000;

// An object of the plot as the show calls it.
struct Named {
    std::string name;
    std::string uuid;
    bool is_fixture = false;
};

// "Spot", "Spot #2", as fixtures of a plot are called in the show.
std::vector<Named> named_objects(const Plot& plot) {
    std::vector<Named> all;
    std::map<std::string, int> counts;
    for (const PlotObject& object : plot.objects) {
        const bool is_bare =
            object.kind != ObjectKind::focus_point && object.device.gdtf >= 0 && object.geometries.empty();
        Named one{object.name, object.uuid, object.kind == ObjectKind::fixture || is_bare};
        if (one.is_fixture)
            if (const int count = ++counts[object.name]; count > 1) one.name += " #" + std::to_string(count);
        all.push_back(std::move(one));
    }
    return all;
}

std::vector<std::string> names_in(const toml::table& mover, const char* key) {
    std::vector<std::string> names;
    if (const toml::array* const list = mover[key].as_array())
        for (const toml::node& node : *list)
            if (const auto name = node.value<std::string>()) names.push_back(*name);
    return names;
}

// What was called so when the movers were written is called otherwise now.
std::map<std::string, std::string> new_names(const toml::table& root, const Show& opened,
                                             const std::string& file, Report& report) {
    std::map<std::string, std::string> by_uuid;
    for (const Named& object : named_objects(opened.plot->plot))
        if (!object.uuid.empty()) by_uuid[uuid_key(object.uuid)] = object.name;
    for (const PatchedFixture& fixture : opened.fixtures)
        if (!fixture.uuid.empty()) by_uuid[uuid_key(fixture.uuid)] = fixture.name;
    std::map<std::string, std::string> renamed;
    std::vector<std::string> gone;
    TableReader top(root, "the file", file, report);
    for (const toml::table* table : top.tables("carried", kMostCarried)) {
        TableReader reader(*table, "[[carried]]", file, report);
        const std::string name = reader.text("name").value_or("");
        const std::string uuid = reader.text("uuid").value_or("");
        reader.finish();
        const auto found = by_uuid.find(uuid_key(uuid));
        if (found == by_uuid.end())
            gone.push_back(name);
        else if (found->second != name)
            renamed[name] = found->second;
    }
    if (!gone.empty())
        report.add(Severity::warning, file,
                   "the plot has no more of what its movers carry: " + name_list(gone));
    return renamed;
}

} // namespace

fs::path movers_file(const fs::path& plot_file) {
    fs::path file = plot_file;
    return file.replace_extension(".movers.toml");
}

Result<std::size_t> export_movers(const std::string& show_toml, const Plot& plot, const fs::path& plot_file,
                                  Report& report) {
    TRY(const TomlText document, TomlText::parse(show_toml));
    const std::vector<Named> objects = named_objects(plot);
    NameIndex fixture_names, object_names;
    for (std::size_t k = 0; k < objects.size(); ++k)
        if (!objects[k].uuid.empty())
            (objects[k].is_fixture ? fixture_names : object_names).add(objects[k].name, k);
    std::uint64_t steps = kMostMatchSteps;
    std::string movers, carried;
    std::size_t count = 0;
    std::set<std::string> said;
    for (const toml::table* const mover : document.tables("mover")) {
        if (!mover) continue;
        TRY(const TomlText::Span span, document.span_of(*mover, "mover"));
        ++count;
        std::string block = document.text().substr(span.begin, span.end - span.begin);
        if (block.empty() || block.back() != '\n') block += '\n';
        movers += "\n" + block;
        for (const auto& [key, names] :
             {std::pair{"fixtures", &fixture_names}, std::pair{"objects", &object_names}})
            for (const std::string& pattern : names_in(*mover, key))
                for (const std::size_t k : names->find(pattern, steps))
                    if (said.insert(uuid_key(objects[k].uuid)).second)
                        carried += "\n" + block_of("[[carried]]",
                                                   {{"name", toml_text(objects[k].name)},
                                                    {"uuid", toml_text(objects[k].uuid)}},
                                                   "\n");
    }
    if (count == 0) return count;
    if (steps == 0)
        report.add(Severity::error, plot_file.string(), std::string("[[mover]] ") + kMatchStepsSpent);
    const fs::path file = movers_file(plot_file);
    const std::string text =
        "# Movers of " + one_line(plot_file.filename().string()) +
        ", for which MVR has no place (docs/guide/kinetic.md). Keep it beside that file: "
        "import reads it.\n" +
        movers + carried;
    TRY_VOID(write_user_file(file, text));
    report.add(Severity::note, plot_file.string(),
               std::to_string(count) + " [[mover]] of the show have no place in MVR and are kept in " +
                   file.string());
    return count;
}

Result<std::string> imported_movers(const Show& opened, const fs::path& plot_file, Report& report) {
    const fs::path file = movers_file(plot_file);
    std::error_code code;
    if (!fs::exists(file, code)) return std::string();
    TRY(const std::string text, read_text_file(file, kMostBytes));
    auto parsed = TomlText::parse(text);
    if (!parsed.ok()) return Error{parsed.error().what, file.string()};
    TomlText& document = *parsed;
    const std::map<std::string, std::string> renamed =
        new_names(document.root(), opened, file.string(), report);
    std::size_t count = 0;
    for (const toml::table* const mover : document.tables("mover")) {
        if (!mover) continue;
        ++count;
        for (const char* const key : {"fixtures", "objects"}) {
            std::vector<std::string> names = names_in(*mover, key);
            bool is_other = false;
            for (std::string& name : names)
                if (const auto now = renamed.find(name); now != renamed.end()) {
                    name = now->second;
                    is_other = true;
                }
            if (is_other) TRY_VOID(document.set(*mover, key, toml_text(names)));
        }
    }
    if (count == 0) return std::string();
    TRY(const TomlText changed, TomlText::parse(document.cut()));
    std::string movers;
    for (const toml::table* const mover : changed.tables("mover")) {
        if (!mover) continue;
        TRY(const TomlText::Span span, changed.span_of(*mover, "mover"));
        movers += "\n" + changed.text().substr(span.begin, span.end - span.begin);
        if (movers.back() != '\n') movers += '\n';
    }
    report.add(Severity::note, file.string(), std::to_string(count) + " [[mover]] taken into the show");
    return movers;
}

} // namespace ghost::scene
