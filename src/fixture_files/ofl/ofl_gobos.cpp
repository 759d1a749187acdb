// SPDX-License-Identifier: Apache-2.0
// Gobo pictures: in the file, as exports with embedded resources have them; beside it; or in the library's
// own folder, "fixtures/maker/thing.json" beside "resources/gobos/10-circles.svg", also by an alias.
#include "base/base64.h"
#include "disk/files.h"
#include "fixture_files/ofl/private/ofl_reader.h"

#include <system_error>

namespace ghost::fixture {
namespace {

constexpr std::uintmax_t kMaxAliasBytes = 1u << 20;
constexpr std::size_t kMaxAliasFiles = 64;
constexpr std::string_view kAliases = "gobos/aliases/";

GoboFiles::Found embedded(OflReader& reader, const Json& image, const std::string& key) {
    const Json& data = member(image, "data");
    const std::string encoding = text_at(image, "encoding");
    if (!data.is_string() || (encoding != "base64" && encoding != "utf8"))
        return {-1, "the picture in the file has no data, or is neither base64 nor utf8"};
    const std::string& text = data.get_ref<const std::string&>();
    const std::string name = key + "." + text_at(image, "extension");
    if (encoding == "utf8")
        return reader.gobos.decode(reader.loaded.type, name,
                                   std::vector<std::uint8_t>(text.begin(), text.end()));
    std::optional<std::vector<std::uint8_t>> bytes = from_base64(text);
    if (!bytes) return {-1, "the picture in the file is no base64"};
    return reader.gobos.decode(reader.loaded.type, name, std::move(*bytes));
}

// "gobos/aliases/qlcplus/Others/gobo00039.svg" -> "gobos/biohazard"; other keys stay, nothing: not known.
std::string resolved(OflReader& reader, const std::string& key) {
    if (!key.starts_with(kAliases)) return key;
    const std::size_t slash = key.find('/', kAliases.size());
    if (slash == std::string::npos) return "";
    const std::string file = key.substr(kAliases.size(), slash - kAliases.size());
    if (file.empty() || file == ".." || file.size() > 128 || file.find('\0') != std::string::npos) return "";
    if (!reader.gobo_aliases.count(file)) {
        if (reader.gobo_aliases.size() == kMaxAliasFiles) return "";
        Json& aliases = reader.gobo_aliases[file];
        const std::filesystem::path path = reader.resources / kAliases / (file + ".json");
        std::error_code code;
        if (reader.resources.empty() || !std::filesystem::is_regular_file(path, code)) return "";
        const Result<std::vector<std::uint8_t>> bytes = read_file(path, kMaxAliasBytes);
        Result<Json> parsed =
            bytes ? parse_ofl_json(*bytes, path.filename().string()) : Result<Json>(bytes.error());
        if (!parsed) {
            reader.say(Severity::error, "/wheels", parsed.error().text());
            return "";
        }
        aliases = std::move(*parsed);
    }
    const std::string gobo = text_at(reader.gobo_aliases[file], key.substr(slash + 1));
    return gobo.empty() ? "" : "gobos/" + gobo;
}

} // namespace

void read_ofl_gobo(OflReader& reader, const Json& resource, const std::string& pointer, Slot& slot) {
    const std::string stated =
        resource.is_string() ? resource.get_ref<const std::string&>() : text_at(resource, "key");
    slot.media_file = stated.substr(0, 256);
    GoboFiles::Found found;
    if (const Json& image = member(resource, "image"); image.is_object()) {
        found = embedded(reader, image, slot.media_file);
    } else if (const std::string key = resolved(reader, stated); key.empty()) {
        found.problem =
            "gobo pictures by an alias need the library's folder resources/gobos, the slots stay open";
    } else {
        const std::string name = std::filesystem::path(key).filename().string();
        const bool is_named = name.find('.') != std::string::npos;
        found = reader.gobos.find(reader.loaded.type, is_named ? key : key + ".png");
        if (found.media < 0 && !is_named)
            if (GoboFiles::Found drawn = reader.gobos.find(reader.loaded.type, key + ".svg");
                drawn.media >= 0)
                found = std::move(drawn);
    }
    slot.media = found.media;
    if (!found.problem.empty()) reader.say(Severity::error, pointer, found.problem);
}

} // namespace ghost::fixture
