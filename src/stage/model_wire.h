#pragma once
// SPDX-License-Identifier: Apache-2.0
// A model that was read in another process, as bytes: in the order of memory of this machine, for both ends
// are one program. The end that receives believes nothing: every count has a limit, every index is looked at.
// Pure but for what `send` and `receive` do.

#include "base/byte_reader.h"
#include "base/report.h"
#include "base/result.h"
#include "stage/stage.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

// Both return false where the other end is gone.
using SendBytes = std::function<bool(Bytes)>;
using ReceiveBytes = std::function<bool(std::span<std::uint8_t>)>;

void send_number(const SendBytes& send, std::uint64_t number);
void send_text(const SendBytes& send, std::string_view text);
void send_model(const SendBytes& send, const Result<Stage>& model, const Report& report);

// Error: gone, or over the limit. The model's own error is inside of what is received.
Result<std::uint64_t> receive_number(const ReceiveBytes& receive, std::uint64_t most);
Result<std::string> receive_text(const ReceiveBytes& receive, std::size_t most_bytes);
Result<std::vector<std::uint8_t>> receive_bytes(const ReceiveBytes& receive, std::size_t most_bytes);

struct ReceivedModel {
    Result<Stage> model = Stage{};
    Report report;
};
// A Stage that comes in holds what load_model() promises: arrays of one length, indices of what is there, and
// numbers that are some. At most 8 GiB, 100,000 messages.
Result<ReceivedModel> receive_model(const ReceiveBytes& receive);

} // namespace ghost::scene
