// SPDX-License-Identifier: Apache-2.0
#include "show/movers.h"

#include "json_xml_toml/toml_reader.h"
#include "show/mover_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostCarried = 10'000;
constexpr std::size_t kMostCarriedOfAll = 20'000;
constexpr std::size_t kMostKeys = 10'000;
constexpr std::size_t kMostPathPoints = 1000;
constexpr double kLatestKey_s = 366.0 * 86400.0;
constexpr double kMostTurn_deg = 36'000;
constexpr double kFastest = 1000;
constexpr int kLastTrackerId = 65535;
constexpr int kLastUniverse = 63999;
constexpr float kSamePlace_m = 1e-3f;
constexpr std::array<const char*, 5> kKinds{"hoists", "linear", "revolve", "path", "flown"};
constexpr std::array<const char*, 6> kDegrees{"x", "y", "z", "turn_x", "turn_y", "turn_z"};

template <std::size_t Count>
std::optional<std::size_t> one_of(const std::array<const char*, Count>& words, const std::string& text) {
    for (std::size_t k = 0; k < Count; ++k)
        if (text == words[k]) return k;
    return std::nullopt;
}

std::string numbers_text(float a, float b) {
    char text[64];
    std::snprintf(text, sizeof text, "[%g, %g]", static_cast<double>(a), static_cast<double>(b));
    return text;
}

std::optional<std::pair<float, float>> pair_of(TableReader& reader, const std::string& key, double limit) {
    const auto both = reader.numbers(key, 2, -limit, limit);
    if (!both) return std::nullopt;
    return std::pair{static_cast<float>((*both)[0]), static_cast<float>((*both)[1])};
}

void read_range(TableReader& reader, const Mover& mover, MoverAxis& axis) {
    const std::string unit = axis.is_angle ? "deg" : "m";
    const double limit = axis.is_angle ? kMostTurn_deg : kFarthestMove_m;
    const std::string range = "range_" + unit, limits = "limits_" + unit;
    const auto span = pair_of(reader, range, limit);
    if (span && span->first == span->second)
        reader.problem(Severity::error, range,
                       "is empty " + numbers_text(span->first, span->second) +
                           ", expected what its channel spans, [at 0, at full]; '" + axis.name +
                           "' stays where it is");
    if (span)
        std::tie(axis.from, axis.to) = *span;
    else if (mover.kind == MoverKind::path)
        axis.to = static_cast<float>(length_m(mover.path_m));
    else if (mover.kind == MoverKind::revolve)
        axis.to = 360;
    else if (!reader.has("fixture") && !reader.has(range))
        reader.missing(range, "what its channel spans, [at 0, at full]");
    axis.low = std::min(axis.from, axis.to);
    axis.high = std::max(axis.from, axis.to);
    if (const auto stops = pair_of(reader, limits, limit)) {
        axis.low = std::min(stops->first, stops->second);
        axis.high = std::max(stops->first, stops->second);
        if (stops->first > stops->second)
            reader.problem(Severity::warning, limits,
                           "is reversed " + numbers_text(stops->first, stops->second) +
                               ", expected [lowest, highest]; they are swapped");
    } else if (mover.has_tracker() || !mover.keys.empty()) {
        // Neither knows of a channel's range.
        if (!span && mover.kind != MoverKind::path) {
            axis.low = static_cast<float>(-limit);
            axis.high = static_cast<float>(limit);
        }
    }
    const std::string per_s = unit + "_s";
    axis.speed = static_cast<float>(reader.number("speed_" + per_s, 1e-4, kFastest).value_or(0));
    axis.acceleration =
        static_cast<float>(reader.number("acceleration_" + per_s + "2", 1e-4, kFastest).value_or(0));
}

void read_channel(TableReader& reader, MoverAxis& axis) {
    axis.fixture = reader.text("fixture").value_or("");
    axis.attribute = reader.text("attribute").value_or("");
    if (axis.fixture.empty() != axis.attribute.empty())
        reader.missing(axis.fixture.empty() ? "fixture" : "attribute",
                       "fixture = a name and attribute = one of its channels, like \"XYZ_Z\"");
    const auto universe = reader.integer("universe", 1, kLastUniverse);
    const auto address = reader.integer("address", 1, 512);
    const int bits = reader.integer("bits", 8, 24).value_or(16);
    if (address && universe) {
        const int bytes = bits / 8;
        if (bits % 8 != 0 || *address + bytes - 1 > 512) {
            reader.problem(Severity::error, bits % 8 != 0 ? "bits" : "address",
                           "has no room for '" + axis.name +
                               "', expected 8, 16 or 24 bits that end at address 512; no channel drives it");
            return;
        }
        for (int k = 0; k < bytes; ++k) axis.levels.push_back({*universe, *address + k});
    } else if (address || universe) {
        reader.missing(address ? "universe" : "address", "both, universe and address of its channel");
    }
}

void read_axes(TableReader& reader, Mover& mover, const std::string& file, Report& report) {
    const std::vector<const toml::table*> tables = reader.tables("axis", kMostMoverAxes);
    for (const toml::table* table : tables) {
        MoverAxis axis;
        const std::string number = std::to_string(mover.axes.size() + 1);
        TableReader own(*table, "[[mover]] '" + mover.name + "' axis " + number, file, report);
        axis.where = file_line(file, own.line());
        const bool is_flown = mover.kind == MoverKind::flown;
        bool is_good = true;
        std::string called = mover.kind == MoverKind::hoists ? "hoist " + number
                                                             : kKinds[static_cast<std::size_t>(mover.kind)];
        if (is_flown) {
            const auto text = own.text("degree");
            const auto degree = text ? one_of(kDegrees, *text) : std::nullopt;
            is_good = degree.has_value();
            if (!is_good)
                own.problem(Severity::error, "degree",
                            "is missing or unknown, expected x, y, z, turn_x, turn_y or turn_z; the axis "
                            "does nothing");
            axis.degree = static_cast<Degree>(degree.value_or(0));
            called = kDegrees[degree.value_or(0)];
            const bool taken = std::any_of(mover.axes.begin(), mover.axes.end(), [&](const MoverAxis& other) {
                return other.degree == axis.degree;
            });
            if (is_good && taken) {
                own.problem(Severity::error, "degree", "is that of another axis; the first one is taken");
                is_good = false;
            }
        }
        axis.is_angle = mover.kind == MoverKind::revolve || (is_flown && axis.degree >= Degree::turn_x);
        axis.name = own.text("name").value_or(called);
        if (mover.kind == MoverKind::hoists) {
            if (const auto point = own.vec3("point_m", kFarthestMove_m))
                axis.point_m = *point;
            else {
                is_good = false;
                if (!own.has("point_m"))
                    own.missing("point_m", "where it holds the truss, [x, y, z]; the hoist does nothing");
            }
        }
        read_range(own, mover, axis);
        read_channel(own, axis);
        own.finish();
        if (is_good) mover.axes.push_back(std::move(axis));
    }
    const bool has_one =
        mover.kind == MoverKind::linear || mover.kind == MoverKind::revolve || mover.kind == MoverKind::path;
    if (mover.axes.empty())
        reader.missing("axis", "what drives it, [[mover.axis]]; it stands still");
    else if (has_one && mover.axes.size() > 1) {
        reader.problem(Severity::error, "axis",
                       "are " + std::to_string(mover.axes.size()) + ", expected one; the first is taken");
        mover.axes.resize(1);
    }
}

// After the axes: a key has a value for each.
void read_keys(TableReader& reader, Mover& mover, const std::string& file, Report& report) {
    for (const toml::table* table : reader.tables("key", kMostKeys)) {
        TableReader own(*table, "[[mover]] '" + mover.name + "' key", file, report);
        MoverKey key;
        const auto at_s = own.number("at_s", 0, kLatestKey_s);
        if (!own.has("at_s")) own.missing("at_s", "second of the recording or of time code");
        const auto values = own.numbers("values", mover.axes.size(), -kMostTurn_deg, kMostTurn_deg);
        if (!own.has("values")) own.missing("values", "a number for each axis, in metres or degrees");
        own.finish();
        if (!at_s || !values) continue;
        key.at_s = *at_s;
        for (const double value : *values) key.values.push_back(static_cast<float>(value));
        mover.keys.push_back(std::move(key));
    }
    const auto later = [](const MoverKey& a, const MoverKey& b) { return a.at_s < b.at_s; };
    if (!std::is_sorted(mover.keys.begin(), mover.keys.end(), later))
        reader.problem(Severity::warning, "key", "are not in the order of at_s; they are sorted");
    std::stable_sort(mover.keys.begin(), mover.keys.end(), later);
    const auto same = [](const MoverKey& a, const MoverKey& b) { return a.at_s == b.at_s; };
    const auto twice = std::unique(mover.keys.begin(), mover.keys.end(), same);
    if (twice != mover.keys.end())
        reader.problem(Severity::error, "key", "has two at the same second; the first is taken");
    mover.keys.erase(twice, mover.keys.end());
}

void read_way(TableReader& reader, Mover& mover) {
    if (mover.kind == MoverKind::revolve || mover.kind == MoverKind::flown) {
        if (const auto centre = reader.vec3("centre_m", kFarthestMove_m)) mover.centre_m = *centre;
        if (!reader.has("centre_m"))
            reader.missing("centre_m", "about what it turns, [x, y, z]; it is the origin");
    }
    if (mover.kind == MoverKind::linear || mover.kind == MoverKind::revolve) {
        if (const auto way = reader.vec3("direction", kFarthestMove_m)) {
            if (glm::length(*way) < 1e-6f)
                reader.problem(Severity::error, "direction",
                               "is no direction, expected one like [0, 0, 1]; it is up");
            else
                mover.direction = glm::normalize(*way);
        }
    }
    if (mover.kind != MoverKind::path) return;
    if (auto points = reader.vec3_list("path_m", 2, kMostPathPoints, kFarthestMove_m))
        for (const glm::vec3& point : *points)
            if (mover.path_m.empty() || glm::distance(mover.path_m.back(), point) > kSamePlace_m)
                mover.path_m.push_back(point);
    if (mover.path_m.size() < 2) {
        reader.missing("path_m", "two or more places on its way, [[x, y, z], ...]; it stands still");
        mover.path_m = {glm::vec3(0), glm::vec3(1, 0, 0)};
    }
    mover.wheelbase_m = static_cast<float>(reader.number("wheelbase_m", 0, 100).value_or(0));
}

void read_tracker(TableReader& reader, Mover& mover) {
    if (!reader.has("tracker")) return;
    const bool can =
        mover.kind == MoverKind::flown || mover.kind == MoverKind::linear || mover.kind == MoverKind::path;
    if (reader.is_number("tracker"))
        mover.tracker_id = reader.integer("tracker", 0, kLastTrackerId).value_or(-1);
    else
        mover.tracker = reader.text("tracker").value_or("");
    if (!can) {
        reader.problem(Severity::error, "tracker", "moves kinds linear, path and flown only; it is left out");
        mover.tracker_id = -1;
        mover.tracker.clear();
    }
    if (const auto home = reader.vec3("home_m", kFarthestMove_m)) mover.home_m = *home;
    if (!reader.has("home_m"))
        reader.missing("home_m", "where the tracker is while all stands as it is drawn, [x, y, z]");
}

// Each once; left: how many the movers together may still have.
std::vector<std::string> read_carried(TableReader& reader, const std::string& key, std::size_t& left) {
    std::vector<std::string> names;
    std::set<std::string> known;
    for (std::string& name : reader.texts(key, kMostCarried).value_or(std::vector<std::string>{})) {
        if (!known.insert(name).second) continue;
        if (names.size() == left) {
            reader.problem(Severity::error, key,
                           "is more than the " + std::to_string(kMostCarriedOfAll) +
                               " names that all movers together may carry; the rest is left out");
            break;
        }
        names.push_back(std::move(name));
    }
    left -= names.size();
    return names;
}

} // namespace

std::vector<Mover> read_movers(TableReader& top, const std::string& file, Report& report) {
    std::vector<Mover> movers;
    std::size_t left = kMostCarriedOfAll;
    for (const toml::table* table : top.tables("mover", kMostMovers)) {
        TableReader naming(*table, "[[mover]]", file, report);
        Mover mover;
        mover.where = file_line(file, naming.line());
        mover.name = naming.text("name").value_or("");
        if (mover.name.empty()) {
            naming.missing("name", "what it is called by; it is left out");
            continue;
        }
        const bool taken = std::any_of(movers.begin(), movers.end(),
                                       [&](const Mover& other) { return other.name == mover.name; });
        if (taken) {
            naming.problem(Severity::error, "name",
                           "'" + mover.name.substr(0, 60) +
                               "' is that of another mover; this one is left out");
            continue;
        }
        TableReader reader(*table, "[[mover]] '" + mover.name.substr(0, 60) + "'", file, report);
        reader.has("name");
        const std::string kind = reader.text("kind").value_or("");
        const auto known = one_of(kKinds, kind);
        if (!known) {
            reader.problem(Severity::error, "kind",
                           "is '" + kind.substr(0, 40) +
                               "', expected hoists, linear, revolve, path or flown; the mover is left out");
            continue;
        }
        mover.kind = static_cast<MoverKind>(*known);
        mover.parent_name = reader.text("parent").value_or("");
        mover.fixtures = read_carried(reader, "fixtures", left);
        mover.objects = read_carried(reader, "objects", left);
        mover.cameras = read_carried(reader, "cameras", left);
        read_way(reader, mover);
        read_tracker(reader, mover);
        read_axes(reader, mover, file, report);
        read_keys(reader, mover, file, report);
        reader.finish();
        movers.push_back(std::move(mover));
    }
    return movers;
}

std::vector<std::size_t> parents_first(const std::vector<Mover>& movers) {
    std::vector<std::size_t> order;
    std::vector<char> done(movers.size(), 0);
    for (std::size_t k = 0; k < movers.size(); ++k) {
        std::vector<std::size_t> chain;
        for (int m = static_cast<int>(k); m != kNoMover && done[static_cast<std::size_t>(m)] == 0;
             m = movers[static_cast<std::size_t>(m)].parent) {
            done[static_cast<std::size_t>(m)] = 1;
            chain.push_back(static_cast<std::size_t>(m));
        }
        order.insert(order.end(), chain.rbegin(), chain.rend());
    }
    return order;
}

} // namespace ghost::scene
