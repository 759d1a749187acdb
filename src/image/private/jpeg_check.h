#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whether the code tables of a JPEG fit where the decoder puts them: stb_image of 2022 (Debian 12) counts
// their codes without a limit and writes past its table. And whether it has more scans than any
// picture needs: a megabyte of them takes hours. Nothing is decoded. Pure, any thread.

#include "base/byte_reader.h"

#include <string>

namespace ghost::image {

// "" where nothing is wrong, or where this is no JPEG; else what is.
std::string fault_of_jpeg(Bytes bytes);

} // namespace ghost::image
