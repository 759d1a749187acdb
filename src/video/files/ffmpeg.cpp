// SPDX-License-Identifier: Apache-2.0
#include "video/files/private/ffmpeg.h"

extern "C" {
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
}

namespace ghost::video {

Error ffmpeg_error(const std::string& action, int code, const std::filesystem::path& path) {
    char text[AV_ERROR_MAX_STRING_SIZE] = {};
    av_strerror(code, text, sizeof text);
    return Error{action + ": " + text, path.string()};
}

Result<void> open_plain_file(const std::filesystem::path& path, const std::string& expected,
                             AVFormatContext*& file) {
    std::error_code unreadable; // then FFmpeg says why
    if (std::filesystem::exists(path, unreadable) && !std::filesystem::is_regular_file(path, unreadable))
        return Error{"not a plain file", path.string()}; // a pipe would be waited for without an end
    av_log_set_level(AV_LOG_FATAL);                      // what it says names no file; we say it
    AVDictionary* options = nullptr;
    av_dict_set(&options, "protocol_whitelist", "file", 0);
    int code = avformat_open_input(&file, ("file:" + path.string()).c_str(), nullptr, &options);
    av_dict_free(&options);
    if (code < 0) return ffmpeg_error("cannot be opened as " + expected, code, path);
    code = avformat_find_stream_info(file, nullptr);
    if (code < 0) return ffmpeg_error("says nothing of what is in it", code, path);
    return {};
}

} // namespace ghost::video
