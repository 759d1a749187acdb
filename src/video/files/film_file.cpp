// SPDX-License-Identifier: Apache-2.0
#include "video/files/private/film_file.h"

#include "disk/files.h"
#include "video/files/private/ffmpeg.h"

#include <cstring>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/avutil.h>
#include <libavutil/mem.h>
#include <libavutil/opt.h>
}

namespace ghost::video {
namespace {

const AVCodec* best_encoder() {
    const AVCodec* const encoder = avcodec_find_encoder_by_name("libx264");
    return encoder ? encoder : avcodec_find_encoder(AV_CODEC_ID_MPEG4);
}

} // namespace

std::string film_encoder() {
    const AVCodec* const encoder = best_encoder();
    return std::string(encoder ? encoder->name : "none") + ", FFmpeg " + av_version_info();
}

Result<AVCodecContext*> open_film_encoder(const std::filesystem::path& film, int width, int height, int fps) {
    av_log_set_level(AV_LOG_WARNING); // the encoder's figures would tear our progress bar
    const AVCodec* const encoder = best_encoder();
    if (!encoder) return Error{"this FFmpeg has neither an H.264 nor an MPEG-4 encoder", film.string()};
    AVCodecContext* codec = avcodec_alloc_context3(encoder);
    if (!codec) return Error{"out of memory", film.string()};
    codec->width = width;
    codec->height = height;
    codec->time_base = {1, fps};
    codec->framerate = {fps, 1};
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->color_range = AVCOL_RANGE_MPEG;
    codec->colorspace = AVCOL_SPC_BT709;
    codec->color_primaries = AVCOL_PRI_BT709;
    codec->color_trc = AVCOL_TRC_IEC61966_2_1;
    codec->thread_count = 1;                     // the same bytes every time
    codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER; // as MP4 asks
    if (encoder->id == AV_CODEC_ID_H264) {
        av_opt_set(codec->priv_data, "preset", "veryfast", 0);
        av_opt_set(codec->priv_data, "crf", "18", 0);
    } else {
        codec->bit_rate = static_cast<std::int64_t>(width) * height * fps / 4;
    }
    const int code = avcodec_open2(codec, encoder, nullptr);
    if (code >= 0) return codec;
    avcodec_free_context(&codec);
    return ffmpeg_error("cannot start the encoder", code, film);
}

Result<std::unique_ptr<FilmFile>> FilmFile::create(const std::filesystem::path& path,
                                                   const AVCodecContext& encoder,
                                                   std::span<const std::uint8_t> described, FilmSound sound) {
    std::unique_ptr<FilmFile> film(new FilmFile);
    film->path_ = path;
    film->temporary_ = temporary_beside(path);
    TRY_VOID(film->open(encoder, described, std::move(sound)));
    return film;
}

Result<void> FilmFile::open(const AVCodecContext& encoder, std::span<const std::uint8_t> described,
                            FilmSound sound) {
    fps_ = encoder.time_base.den;
    delay_ = encoder.has_b_frames;
    int code = avformat_alloc_output_context2(&file_, nullptr, "mp4", temporary_.c_str());
    if (code < 0) return ffmpeg_error("cannot make an MP4", code, path_);
    stream_ = avformat_new_stream(file_, nullptr);
    if (!stream_) return Error{"out of memory", path_.string()};
    code = avcodec_parameters_from_context(stream_->codecpar, &encoder);
    if (code < 0) return ffmpeg_error("cannot describe the film", code, path_);
    if (described.data() != encoder.extradata) {
        av_freep(&stream_->codecpar->extradata);
        stream_->codecpar->extradata =
            static_cast<std::uint8_t*>(av_mallocz(described.size() + AV_INPUT_BUFFER_PADDING_SIZE));
        if (!stream_->codecpar->extradata) return Error{"out of memory", path_.string()};
        std::memcpy(stream_->codecpar->extradata, described.data(), described.size());
        stream_->codecpar->extradata_size = static_cast<int>(described.size());
    }
    stream_->time_base = encoder.time_base;
    if (sound.file) {
        TRY(sound_, FilmSoundTrack::create(std::move(sound), file_, path_));
        file_->max_interleave_delta = 0; // a slow film's encoder holds more than ten seconds back
    }
    code = avio_open(&file_->pb, temporary_.c_str(), AVIO_FLAG_WRITE);
    if (code < 0) return ffmpeg_error("cannot create", code, path_);
    code = avformat_write_header(file_, nullptr);
    if (code < 0) return ffmpeg_error("cannot write", code, path_);
    return {};
}

FilmFile::~FilmFile() {
    if (file_ && file_->pb) avio_closep(&file_->pb);
    avformat_free_context(file_);
    if (finished_) return;
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

Result<void> FilmFile::write(AVPacket& packet) {
    packet.duration = 1;
    packet.dts = written_++ - delay_; // x264's own is another one in blocks of one or two pictures
    av_packet_rescale_ts(&packet, {1, fps_}, stream_->time_base);
    packet.stream_index = stream_->index;
    const int code = av_interleaved_write_frame(file_, &packet);
    if (code < 0) return ffmpeg_error("cannot write", code, path_);
    return {};
}

Result<void> FilmFile::write_sound(long frames) {
    return sound_ ? sound_->write_to(static_cast<double>(frames) / fps_) : Result<void>{};
}

Result<void> FilmFile::finish(long frames) {
    if (sound_) TRY_VOID(sound_->finish(static_cast<double>(frames) / fps_));
    int code = av_write_trailer(file_);
    if (code < 0) return ffmpeg_error("cannot write", code, path_);
    code = avio_closep(&file_->pb);
    if (code < 0) return ffmpeg_error("cannot write", code, path_);
    TRY_VOID(commit_temporary(temporary_, path_));
    finished_ = true;
    return {};
}

} // namespace ghost::video
