// SPDX-License-Identifier: Apache-2.0
// What stations say to each other: joining, commits, and the files themselves.
#include "xchange/private/xchange_loop.h"

#include "disk/files.h"
#include "disk/user_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ghost::app {

namespace {

constexpr std::size_t kMostServed = 64; // connections of others
constexpr std::size_t kMostJoining = 16;
constexpr std::size_t kMostNames = 256;
constexpr std::size_t kMostFetching = 4;
constexpr std::size_t kMostWanted = 256;
constexpr std::size_t kMostTakenFiles = 1000; // that are taken in one session
constexpr int kMostTries = 30;
constexpr double kLookAgain_s = 1;
constexpr double kAgain_s = 5; // after something failed, longer each time
constexpr double kJoinPatience_s = 10;
constexpr double kFetchSilence_s = 20;
constexpr double kLongestFetch_s = 1800;
constexpr double kFetchAlone_s = 10;          // however slow, while others wait
constexpr double kLeastFetchRate = 64u << 10; // bytes per second, while others wait
constexpr double kLeavePatience_s = 0.7;
constexpr int kMostSameNames = 10'000;

// Puts the file into place as "name.mvr", or as "name (2).mvr" where that is taken.
Result<std::filesystem::path> commit_beside(const std::filesystem::path& temporary,
                                            const std::filesystem::path& wanted) {
    for (int number = 1; number <= kMostSameNames; ++number) {
        std::filesystem::path path = wanted;
        if (number > 1)
            path.replace_filename(wanted.stem().string() + " (" + std::to_string(number) + ").mvr");
        TRY(const bool done, commit_new(temporary, path));
        if (done) return path;
    }
    return Error{"too many files have this name", wanted.string()};
}

} // namespace

Xchange::Loop::Message Xchange::Loop::message_of(const char* type) const {
    Message message;
    message.type = type;
    message.provider = "Ghostlight";
    message.station_name = options_.station;
    message.station_uuid = uuid_;
    for (const Shared& shared : shared_) message.commits.push_back(shared.commit);
    return message;
}

void Xchange::Loop::accept() {
    while (auto stream = listener_->accept()) {
        const auto served =
            std::count_if(connections_.begin(), connections_.end(),
                          [](const Connection& one) { return one.purpose == Purpose::serves; });
        // Who was silent longest makes room: programs keep connections that they no longer need.
        if (static_cast<std::size_t>(served) >= kMostServed) {
            auto oldest = connections_.end();
            for (auto one = connections_.begin(); one != connections_.end(); ++one)
                if (one->purpose == Purpose::serves &&
                    (oldest == connections_.end() || one->peer->heard_s() < oldest->peer->heard_s()))
                    oldest = one;
            connections_.erase(oldest);
        }
        Connection connection;
        connection.name = dmx::address_text(stream->peer());
        connection.peer = std::make_unique<XchangePeer>(std::move(stream), now_s());
        connection.begun_s = now_s();
        connections_.push_back(std::move(connection));
    }
}

Result<Xchange::Loop::Connection*> Xchange::Loop::begin_connection(const std::string& key, Purpose purpose) {
    const Known& known = known_.at(key);
    TRY(auto stream,
        dmx::TcpStream::connect(known.station.address, known.station.port, known.interface_index));
    Connection connection;
    connection.purpose = purpose;
    connection.key = key;
    connection.name = known.station.name;
    connection.peer = std::make_unique<XchangePeer>(std::move(stream), now_s());
    connection.begun_s = now_s();
    connections_.push_back(std::move(connection));
    return &connections_.back();
}

// Said once; it is tried again and again.
void Xchange::Loop::join_failed(const std::string& key, const std::string& why) {
    const auto place = known_.find(key);
    if (place == known_.end() || place->second.joined || std::exchange(place->second.told, true)) return;
    tell(XchangeEvent::Kind::trouble, place->second.station.name,
         "cannot be joined: " + why + "; it is tried again");
}

void Xchange::Loop::join_known() {
    auto joining = static_cast<std::size_t>(
        std::count_if(connections_.begin(), connections_.end(),
                      [](const Connection& connection) { return connection.purpose == Purpose::joins; }));
    for (auto& [key, known] : known_) {
        if (known.joined || now_s() < known.next_join_s || joining >= kMostJoining) continue;
        ++known.tries;
        known.next_join_s = now_s() + kJoinPatience_s + kAgain_s * known.tries;
        const Result<Connection*> connection = begin_connection(key, Purpose::joins);
        if (!connection.ok()) {
            join_failed(key, connection.error().text());
            continue;
        }
        (*connection)->peer->say(message_of("MVR_JOIN"));
        ++joining;
    }
}

std::string Xchange::Loop::key_of(const std::string& uuid) const {
    for (const auto& [key, known] : known_)
        if (!uuid.empty() && known.station.uuid == uuid) return key;
    return "";
}

void Xchange::Loop::note_commits(const Message& message, const Connection& connection) {
    if (message.commits.empty()) return;
    const Commit& newest = message.commits.back();
    // By whom it says it is, else by whom we asked.
    std::string key = key_of(message.station_uuid);
    if (key.empty()) key = key_of(newest.station_uuid);
    if (key.empty()) key = connection.key;
    std::string text = newest.file_name.empty() ? "a plot" : newest.file_name;
    if (!newest.comment.empty()) text += ": " + newest.comment;
    if (message.commits.size() > 1) text += " (the newest of " + std::to_string(message.commits.size()) + ")";
    tell(XchangeEvent::Kind::offered, connection.name, text);
    want(newest, key);
}

void Xchange::Loop::want(const Commit& commit, const std::string& key) {
    if (options_.save.empty() || had_.contains(commit.file_uuid)) return;
    const auto& stations = commit.for_stations;
    if (!stations.empty() && std::find(stations.begin(), stations.end(), uuid_) == stations.end()) return;
    if (taken_files_ >= kMostTakenFiles || wanted_.size() >= kMostWanted) {
        if (spoken_of_.insert("plots").second)
            tell(XchangeEvent::Kind::trouble, "", "more plots at once than are taken; some are left out");
        return;
    }
    if (!commit.file_uuid.empty()) had_.insert(commit.file_uuid);
    ++taken_files_;
    wanted_.push_back({commit, key});
}

void Xchange::Loop::fetch_wanted() {
    for (std::size_t i = 0; i < wanted_.size();) {
        Wanted& wanted = wanted_[i];
        const auto fetching =
            std::count_if(connections_.begin(), connections_.end(),
                          [](const Connection& one) { return one.purpose == Purpose::fetches; });
        if (static_cast<std::size_t>(fetching) >= kMostFetching) return end_slowest_fetch();
        if (now_s() < wanted.not_before_s) {
            ++i;
            continue;
        }
        // Told by a station that mDNS may show only later.
        if (wanted.key.empty()) wanted.key = key_of(wanted.commit.station_uuid);
        Connection* connection = nullptr;
        if (known_.contains(wanted.key))
            if (const auto begun = begin_connection(wanted.key, Purpose::fetches); begun.ok())
                connection = *begun;
        if (!connection && ++wanted.tries < kMostTries) {
            wanted.not_before_s = now_s() + kLookAgain_s;
            ++i;
            continue;
        }
        if (connection) {
            Message request;
            request.type = "MVR_REQUEST";
            request.file_uuid = wanted.commit.asked_as;
            const std::string& station = known_.at(wanted.key).station.uuid;
            request.station_uuid =
                wanted.commit.station_uuid == station ? wanted.commit.station_asked_as : station;
            connection->peer->say(request);
            Fetch fetch;
            fetch.commit = wanted.commit;
            fetch.station = connection->name;
            connection->fetch = std::move(fetch);
        } else {
            had_.erase(wanted.commit.file_uuid); // its station may come
            --taken_files_;
            tell(XchangeEvent::Kind::trouble, "",
                 "a plot was offered by a station that cannot be reached (" + wanted.commit.file_name + ")");
        }
        wanted_.erase(wanted_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

// All places are taken and others wait: the one that brings next to nothing gives its place up.
void Xchange::Loop::end_slowest_fetch() {
    const auto rate = [this](const Connection& one) {
        return static_cast<double>(one.fetch->bytes) / std::max(1.0, now_s() - one.begun_s);
    };
    Connection* slowest = nullptr;
    for (Connection& one : connections_)
        if (one.fetch && (!slowest || rate(one) < rate(*slowest))) slowest = &one;
    if (slowest && now_s() - slowest->begun_s > kFetchAlone_s && rate(*slowest) < kLeastFetchRate)
        slowest->fetch->too_slow = true;
}

void Xchange::Loop::fetch_failed(Connection& connection, const std::string& why) {
    if (!connection.fetch) return;
    connection.fetch->out.close();
    std::error_code ignored;
    if (!connection.fetch->temporary.empty()) std::filesystem::remove(connection.fetch->temporary, ignored);
    had_.erase(connection.fetch->commit.file_uuid); // the next commit may ask again
    taken_files_ -= taken_files_ > 0 ? 1 : 0;
    tell(XchangeEvent::Kind::trouble, connection.fetch->station, "its plot did not come: " + why);
    connection.fetch.reset();
}

void Xchange::Loop::turn(Connection& connection) {
    const XchangePeer::Sink sink{[&](const Message& message) { answer(connection, message); },
                                 [&](Bytes piece, bool last) { return take_piece(connection, piece, last); }};
    const Result<void> turned = connection.peer->turn(now_s(), sink);
    const double age_s = now_s() - connection.begun_s;
    const double silent_s = now_s() - connection.peer->heard_s();
    if (!turned.ok()) {
        const std::string& why = turned.error().what;
        fetch_failed(connection, why.empty() ? "the station closed the connection" : turned.error().text());
        if (!why.empty() && connection.purpose != Purpose::fetches)
            tell(XchangeEvent::Kind::trouble, connection.name, turned.error().text());
        else if (connection.purpose == Purpose::joins && !connection.done)
            join_failed(connection.key, connection.peer->problem().empty() ? "it closed the connection"
                                                                           : connection.peer->problem());
        connection.done = true;
    } else if (connection.purpose == Purpose::joins) {
        if (!connection.done && age_s > kJoinPatience_s) {
            join_failed(connection.key, "it does not answer");
            connection.done = true;
        }
    } else if (connection.purpose == Purpose::fetches) {
        if (connection.fetch && connection.fetch->too_slow)
            fetch_failed(connection, "it came too slowly while others waited");
        if (connection.fetch && (silent_s > kFetchSilence_s || age_s > kLongestFetch_s))
            fetch_failed(connection, "nothing came for too long");
        connection.done = !connection.fetch;
    }
}

void Xchange::Loop::answer(Connection& connection, const Message& message) {
    // Who does not say its name may have said it before.
    if (!message.station_name.empty() && !message.station_uuid.empty() &&
        (names_.size() < kMostNames || names_.contains(message.station_uuid)))
        names_[message.station_uuid] = message.station_name;
    if (!message.station_name.empty())
        connection.name = message.station_name;
    else if (const auto name = names_.find(message.station_uuid); name != names_.end())
        connection.name = name->second;
    const auto reply = [&](bool ok, const std::string& text) {
        Message result = message_of("");
        result.type = message.type + "_RET";
        result.ok = ok;
        result.text = text;
        connection.peer->say(result);
    };
    if (message.type == "MVR_JOIN" && message.station_uuid.empty()) {
        reply(false, "MVR_JOIN without a StationUUID");
        tell(XchangeEvent::Kind::trouble, connection.name, "wants to join without a StationUUID");
    } else if (message.type == "MVR_JOIN") {
        reply(true, "");
        tell(XchangeEvent::Kind::joined, connection.name, "joined us");
        note_commits(message, connection);
    } else if (message.type == "MVR_JOIN_RET" && connection.purpose == Purpose::joins) {
        const auto place = known_.find(connection.key);
        if (place == known_.end()) return;
        Known& known = place->second;
        if (!message.ok) {
            tell(XchangeEvent::Kind::trouble, connection.name, "does not let us join: " + message.text);
            known.next_join_s = now_s() + 10 * kAgain_s;
            connection.done = true;
            return;
        }
        known.joined = true;
        known.told = false;
        known.tries = 0;
        if (!message.station_name.empty()) known.station.name = message.station_name;
        if (!message.station_uuid.empty()) known.station.uuid = message.station_uuid;
        tell(XchangeEvent::Kind::joined, connection.name,
             message.provider.empty() ? "we joined it" : "we joined it (" + message.provider + ")");
        note_commits(message, connection);
        connection.done = true;
    } else if (message.type == "MVR_LEAVE") {
        reply(true, "");
        tell(XchangeEvent::Kind::left, connection.name, "left the group");
    } else if (message.type == "MVR_COMMIT" && message.commits.front().file_uuid.empty()) {
        reply(false, "MVR_COMMIT without a FileUUID");
        tell(XchangeEvent::Kind::trouble, connection.name, "offers a file without a FileUUID");
    } else if (message.type == "MVR_COMMIT") {
        reply(true, "");
        note_commits(message, connection);
    } else if (message.type == "MVR_REQUEST") {
        const auto same = [&](const Shared& shared) {
            return message.file_uuid.empty() || shared.commit.file_uuid == message.file_uuid;
        };
        const auto found = std::find_if(shared_.rbegin(), shared_.rend(), same);
        if (found == shared_.rend()) return reply(false, "The MVR is not available on this client");
        const Result<void> sent = connection.peer->send_file(found->file);
        if (!sent.ok()) return reply(false, sent.error().what);
        tell(XchangeEvent::Kind::sent, connection.name, found->file.filename().string());
    } else if (message.type == "MVR_REQUEST_RET") {
        fetch_failed(connection, message.text.empty() ? "the station does not have it" : message.text);
    } else if (message.type == "MVR_SET_NAME") {
        reply(true, "");
    } else if (message.type == "MVR_NEW_SESSION_HOST") {
        reply(false, "Ghostlight takes part in TCP mode only, in the group that it was told");
    } else if (!message.is_answer()) {
        reply(false, "Ghostlight does not know this message");
    }
}

Result<void> Xchange::Loop::take_piece(Connection& connection, Bytes piece, bool last) {
    if (!connection.fetch) return Error{"sent a file that nobody asked for", ""};
    Fetch& fetch = *connection.fetch;
    if (fetch.temporary.empty()) {
        const std::string name = scene::plot_file_name(
            fetch.commit.file_name.empty() ? fetch.commit.comment : fetch.commit.file_name);
        fetch.temporary = temporary_beside(options_.save / name);
        fetch.out.open(fetch.temporary, std::ios::binary);
    }
    fetch.bytes += piece.size();
    received_bytes_ += piece.size();
    if (received_bytes_ > options_.most_bytes)
        return Error{"the plots of this session have more than " + std::to_string(options_.most_bytes) +
                         " bytes; start again to go on",
                     ""};
    fetch.out.write(reinterpret_cast<const char*>(piece.data()), static_cast<std::streamsize>(piece.size()));
    if (!fetch.out) return Error{"cannot be written; is the disk full?", options_.save.string()};
    return last ? finish_file(connection) : Result<void>();
}

Result<void> Xchange::Loop::finish_file(Connection& connection) {
    Fetch& fetch = *connection.fetch;
    fetch.out.close();
    if (!fetch.out) return Error{"cannot be written; is the disk full?", options_.save.string()};
    constexpr std::uint8_t kZip[] = {'P', 'K', 3, 4};
    std::ifstream in(fetch.temporary, std::ios::binary);
    char first[sizeof kZip] = {};
    in.read(first, sizeof first);
    if (!std::equal(std::begin(kZip), std::end(kZip), first,
                    [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }))
        return Error{"what came is no .mvr (no zip archive)", ""};
    const std::string wanted =
        scene::plot_file_name(fetch.commit.file_name.empty() ? fetch.commit.comment : fetch.commit.file_name);
    TRY(const std::filesystem::path path, commit_beside(fetch.temporary, options_.save / wanted));
    fetch.temporary.clear();
    std::string text = path.filename().string() + ", " + std::to_string(fetch.bytes) + " bytes";
    if (fetch.commit.file_size > 0 && fetch.commit.file_size != fetch.bytes)
        text += " (" + std::to_string(fetch.commit.file_size) + " were announced)";
    tell(XchangeEvent::Kind::received, fetch.station, text, path, fetch.commit.comment);
    connection.fetch.reset();
    return {};
}

// At the end: others stop telling us of their commits.
void Xchange::Loop::leave() {
    if (mdns_) ask_and_announce(true);
    for (Connection& connection : connections_) fetch_failed(connection, "we stop");
    connections_.clear();
    for (const auto& [key, known] : known_)
        if (known.joined && connections_.size() < kMostJoining)
            if (const auto connection = begin_connection(key, Purpose::joins); connection.ok())
                (*connection)->peer->say(message_of("MVR_LEAVE"));
    const double end_s = now_s() + kLeavePatience_s;
    const XchangePeer::Sink heard{[](const Message&) {},
                                  [](Bytes, bool) -> Result<void> {
                                      return Error{"too late", ""};
                                  }};
    while (!connections_.empty() && now_s() < end_s) {
        std::vector<dmx::WaitFor> streams;
        for (const Connection& connection : connections_)
            streams.push_back({connection.peer->handle(), connection.peer->has_to_send()});
        dmx::wait_for_streams(streams, std::chrono::milliseconds(50));
        for (Connection& connection : connections_) {
            const double heard_s = connection.peer->heard_s();
            connection.done =
                !connection.peer->turn(now_s(), heard).ok() || connection.peer->heard_s() > heard_s;
        }
        std::erase_if(connections_, [](const Connection& connection) { return connection.done; });
    }
}

} // namespace ghost::app
