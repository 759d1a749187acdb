// SPDX-License-Identifier: Apache-2.0
#include "base/zeroed_memory.h"
#include "video/files/film.h"
#include "video/files/private/ffmpeg.h"
#include "video/files/private/film_file.h"

#include <algorithm>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace ghost::video {
namespace {

struct OpenPart {
    AVFormatContext* file = nullptr;
    AVPacket* packet = av_packet_alloc();
    const AVStream* stream = nullptr;

    OpenPart() = default;
    OpenPart(const OpenPart&) = delete;
    OpenPart& operator=(const OpenPart&) = delete;
    ~OpenPart() {
        av_packet_free(&packet);
        avformat_close_input(&file);
    }

    Result<void> open(const std::filesystem::path& path) {
        TRY_VOID(open_plain_file(path, "a part of a film", file));
        if (!packet || file->nb_streams != 1 || file->streams[0]->codecpar->codec_type != AVMEDIA_TYPE_VIDEO)
            return Error{"expected a film without sound", path.string()};
        stream = file->streams[0];
        return {};
    }
    const AVCodecParameters& codec() const { return *stream->codecpar; }
    std::span<const std::uint8_t> described() const {
        return {codec().extradata, static_cast<std::size_t>(codec().extradata_size)};
    }
};

// The first part stays open, for all others must be like it.
struct Joined {
    int fps = 0;
    OpenPart first;
    AVCodecContext* encoder = nullptr;
    std::unique_ptr<FilmFile> film;
    long count = 0;

    ~Joined() { avcodec_free_context(&encoder); }

    // name: of the first part.
    Result<void> begin(const std::filesystem::path& path, const std::string& name, FilmSound sound) {
        TRY(encoder, open_film_encoder(path, first.codec().width, first.codec().height, fps));
        if (first.codec().codec_id != encoder->codec_id)
            return Error{std::string("was encoded as ") + avcodec_get_name(first.codec().codec_id) +
                             ", which this machine does not",
                         name};
        TRY(film, FilmFile::create(path, *encoder, first.described(), std::move(sound)));
        return {};
    }

    Result<void> add(OpenPart& part, const FilmPart& expected) {
        const auto error = [&](const std::string& what) { return Error{what, expected.path.string()}; };
        if (part.codec().width != first.codec().width || part.codec().height != first.codec().height ||
            part.codec().codec_id != first.codec().codec_id ||
            !std::ranges::equal(part.described(), first.described()))
            return error("is of another size or encoder than the film's first part");
        long read = 0;
        for (int code; (code = av_read_frame(part.file, part.packet)) != AVERROR_EOF; ++read) {
            if (code < 0) return ffmpeg_error("cannot be read further", code, expected.path);
            if (part.packet->pts == AV_NOPTS_VALUE) return error("has a picture without a time");
            av_packet_rescale_ts(part.packet, part.stream->time_base, {1, fps});
            part.packet->pts += count;
            TRY_VOID(film->write(*part.packet));
        }
        if (read != expected.frames)
            return error("has " + std::to_string(read) + " pictures, expected " +
                         std::to_string(expected.frames));
        count += read;
        return film->write_sound(count);
    }
};

} // namespace

Result<std::string> join_films(const std::filesystem::path& path, const std::vector<FilmPart>& parts, int fps,
                               FilmSound sound) {
    if (parts.empty()) return Error{"no part is given, expected at least one", path.string()};
    const ZeroedMemory same_bytes;
    Joined joined;
    joined.fps = fps;
    TRY_VOID(joined.first.open(parts.front().path));
    TRY_VOID(joined.begin(path, parts.front().path.string(), std::move(sound)));
    TRY_VOID(joined.add(joined.first, parts.front()));
    for (std::size_t k = 1; k < parts.size(); ++k) {
        OpenPart part;
        TRY_VOID(part.open(parts[k].path));
        TRY_VOID(joined.add(part, parts[k]));
    }
    TRY_VOID(joined.film->finish(joined.count));
    return joined.film->sound_problem();
}

} // namespace ghost::video
