#pragma once
// SPDX-License-Identifier: Apache-2.0
// Opens a .ghostdmx recording and unpacks its blocks, one at a time, in any order. A recording without its
// index (a crash, a cut, one that is still being written) is found out block by block. Whatever is damaged is
// said, with how much was lost; the rest plays. Memory: the index and what a block needs. One thread.

#include "archives/byte_source.h"
#include "dmx/record/ghostdmx_block.h"

#include <string>

namespace ghost::dmx {

class GhostdmxReader {
public:
    // name: for messages. Error: not such a file, of another version, no frame in it.
    static Result<GhostdmxReader> open(ByteSource source, const std::string& name);
    static bool recognises(Bytes first_bytes);

    const ghostdmx::Header& header() const { return header_; }
    const ghostdmx::Index& index() const { return index_; }
    // What was lost, as far as opening shows it.
    const std::vector<Error>& problems() const { return problems_; }

    struct Block {
        ghostdmx::BlockCursor cursor;
        std::optional<Error> damage; // where it ends early, or is empty
    };
    Block block(std::size_t number);

private:
    GhostdmxReader(ByteSource source, std::string name)
        : source_(std::move(source)), name_(std::move(name)) {}

    std::vector<std::uint8_t> bytes_at(std::uint64_t offset, std::size_t count);
    bool read_index(std::uint64_t offset);
    bool find_index();
    void scan();
    bool begins_block_at(std::uint64_t offset);
    std::uint64_t next_block_after(std::uint64_t offset);
    bool check_blocks() const;

    ByteSource source_;
    std::string name_;
    ghostdmx::Header header_;
    ghostdmx::Index index_;
    std::uint64_t end_of_blocks_ = 0;  // offset
    std::uint64_t search_effort_ = 0;  // bytes, of all searches
    std::vector<std::uint8_t> window_; // of the search before
    std::uint64_t window_at_ = 0;
    std::vector<Error> problems_;
};

} // namespace ghost::dmx
