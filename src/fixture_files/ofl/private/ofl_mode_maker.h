#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_ofl: OflModeMaker makes one mode. Its parts: the list of channels and their bytes
// (ofl_mode.cpp), channels that switch (ofl_switching.cpp), heads and body (ofl_body.cpp), several lights in
// one fixture without a matrix (ofl_layers.cpp).

#include "fixture_files/ofl/private/ofl_keys.h"

namespace ghost::fixture {

class OflModeMaker {
public:
    OflModeMaker(OflReader& reader, TypeBuilder& builder, const OflKeys& keys, const Json& json,
                 std::string pointer)
        : reader_(reader), builder_(builder), keys_(keys), json_(json), pointer_(std::move(pointer)),
          physical_(reader.physical) {}

    // Channels in the mode, for the limit over all modes.
    std::size_t run(std::size_t room);

private:
    struct Place {
        OflKeys::Found found;
        int draft = -1;
    };

    void read_physical();

    // The list of keys; "" is an unused byte.
    void push(const Json& key, const std::string& pixel, std::size_t limit, const std::string& pointer);
    void insert_matrix(const Json& insert, std::size_t limit, const std::string& pointer);
    void list_keys(std::size_t limit);
    void resolve();

    std::vector<int> offsets_of(const OflEntry& entry, const std::string& pixel, std::size_t coarse) const;
    void set_numbers(std::vector<ChannelFunction>& functions);
    void make_channel(std::size_t place);
    const OflChannelSketch& sketch_of(const OflEntry& entry);
    void link_turns();

    // Switching channels.
    bool is_switching(std::size_t place) const {
        const OflEntry* entry = places_[place].found.entry;
        return entry && entry->kind == OflEntry::Kind::switching;
    }
    // What the capability puts in the place of the alias; no entry: nothing, with its key in wanted.
    OflKeys::Found target_of(std::size_t place, const Json& capability, std::string& wanted) const;
    void make_switched(std::size_t place);
    void link_switches();
    void link_switch(std::size_t place);
    void add_target(std::size_t place, const OflKeys::Found& target, const std::string& name,
                    const ChannelFunction& condition);
    void find_strobes();

    // Heads and body.
    void find_cells();
    bool names_pixel(std::size_t place) const;
    std::vector<int> cells_of(const std::string& pixel) const;
    void find_groups();
    void split_masters(std::vector<std::size_t>& axis);
    void make_body();

    // Several lights in one fixture.
    void find_layers();
    void spread_layers(const std::vector<std::string>& layers);
    void keep_layer(const std::vector<std::string>& layers, std::size_t kept);

    OflReader& reader_;
    TypeBuilder& builder_;
    const OflKeys& keys_;
    const Json& json_;
    std::string pointer_;
    OflPhysical physical_;
    ModeDraft draft_;
    std::vector<std::string> names_; // of each draft, as the channel is called that it stands for
    std::vector<std::string> list_;
    std::vector<std::string> pointers_;
    std::vector<Place> places_;
    std::map<std::string, std::size_t> place_of_;
    std::map<std::string, OflChannelSketch> sketches_;  // by pointer
    std::map<std::string, std::map<int, int>> numbers_; // prefix -> wheel -> number
    std::set<const Json*> strobe_rates_;                // channels of the mode that set a strobe's rate ...
    std::set<const Json*> strobe_kinds_;                // ... and those that choose a strobe without a rate
    std::vector<std::size_t> presets_;
    std::size_t functions_made_ = 0;
    bool full_ = false;
    bool has_pixels_ = false;
    bool has_gobos_ = false;
};

// A value or range of a channel with that many bytes, in another resolution.
std::uint32_t ofl_scaled(std::uint32_t value, int from_bytes, int to_bytes);
// Functions in the resolution that the mode gives the channel.
std::vector<ChannelFunction> ofl_fitted(const OflChannelSketch& sketch, int bytes);

} // namespace ghost::fixture
