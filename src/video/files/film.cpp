// SPDX-License-Identifier: Apache-2.0
#include "video/files/film.h"

#include "base/zeroed_memory.h"
#include "disk/files.h"
#include "video/files/private/ffmpeg.h"
#include "video/files/private/film_sound.h"

#include <string>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace ghost::video {

struct FilmWriter::Encoder {
    std::filesystem::path path;
    std::filesystem::path temporary;
    int source_width = 0;
    int source_height = 0;
    AVFormatContext* file = nullptr;
    AVCodecContext* codec = nullptr;
    AVStream* stream = nullptr;
    AVFrame* frame = nullptr;
    AVPacket* packet = nullptr;
    SwsContext* scaler = nullptr;
    std::unique_ptr<FilmSoundTrack> sound; // null: none
    std::int64_t count = 0;
    bool finished = false;

    ~Encoder() {
        sws_freeContext(scaler);
        av_packet_free(&packet);
        av_frame_free(&frame);
        avcodec_free_context(&codec);
        if (file && file->pb) avio_closep(&file->pb);
        avformat_free_context(file);
        if (!finished) {
            std::error_code ignored;
            std::filesystem::remove(temporary, ignored);
        }
    }

    Result<void> open(int width, int height, int fps, FilmSound with_sound);
    Result<void> drain();
    double seconds() const { return static_cast<double>(count) * av_q2d(codec->time_base); }
};

Result<void> FilmWriter::Encoder::open(int width, int height, int fps, FilmSound with_sound) {
    av_log_set_level(AV_LOG_WARNING); // the encoder's figures would tear our progress bar
    const AVCodec* encoder = avcodec_find_encoder_by_name("libx264");
    if (!encoder) encoder = avcodec_find_encoder(AV_CODEC_ID_MPEG4);
    if (!encoder) return Error{"this FFmpeg has neither an H.264 nor an MPEG-4 encoder", path.string()};
    int code = avformat_alloc_output_context2(&file, nullptr, "mp4", temporary.c_str());
    if (code < 0) return ffmpeg_error("cannot make an MP4", code, path);
    stream = avformat_new_stream(file, nullptr);
    codec = avcodec_alloc_context3(encoder);
    if (!stream || !codec) return Error{"out of memory", path.string()};
    codec->width = width;
    codec->height = height;
    codec->time_base = {1, fps};
    codec->framerate = {fps, 1};
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->color_range = AVCOL_RANGE_MPEG;
    codec->colorspace = AVCOL_SPC_BT709;
    codec->color_primaries = AVCOL_PRI_BT709;
    codec->color_trc = AVCOL_TRC_IEC61966_2_1;
    codec->thread_count = 1; // the same bytes every time
    if (file->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (encoder->id == AV_CODEC_ID_H264) {
        av_opt_set(codec->priv_data, "preset", "veryfast", 0);
        av_opt_set(codec->priv_data, "crf", "18", 0);
    } else {
        codec->bit_rate = static_cast<std::int64_t>(width) * height * fps / 4;
    }
    code = avcodec_open2(codec, encoder, nullptr);
    if (code < 0) return ffmpeg_error("cannot start the encoder", code, path);
    code = avcodec_parameters_from_context(stream->codecpar, codec);
    if (code < 0) return ffmpeg_error("cannot describe the film", code, path);
    stream->time_base = codec->time_base;
    if (with_sound.file) {
        TRY(sound, FilmSoundTrack::create(std::move(with_sound), file, path));
        file->max_interleave_delta = 0; // a slow film's encoder holds more than ten seconds back
    }
    code = avio_open(&file->pb, temporary.c_str(), AVIO_FLAG_WRITE);
    if (code < 0) return ffmpeg_error("cannot create", code, path);
    code = avformat_write_header(file, nullptr);
    if (code < 0) return ffmpeg_error("cannot write", code, path);
    frame = av_frame_alloc();
    packet = av_packet_alloc();
    if (!frame || !packet) return Error{"out of memory", path.string()};
    frame->format = codec->pix_fmt;
    frame->width = width;
    frame->height = height;
    code = av_frame_get_buffer(frame, 0);
    if (code < 0) return ffmpeg_error("cannot make a frame", code, path);
    scaler = sws_getContext(width, height, AV_PIX_FMT_RGBA, width, height, AV_PIX_FMT_YUV420P, SWS_BICUBIC,
                            nullptr, nullptr, nullptr);
    if (!scaler) return Error{"cannot convert colours for the film", path.string()};
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler, bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
    return {};
}

// Moves finished packets from the encoder into the file.
Result<void> FilmWriter::Encoder::drain() {
    for (;;) {
        int code = avcodec_receive_packet(codec, packet);
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return {};
        if (code < 0) return ffmpeg_error("cannot encode", code, path);
        packet->duration = 1;
        av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
        packet->stream_index = stream->index;
        code = av_interleaved_write_frame(file, packet);
        if (code < 0) return ffmpeg_error("cannot write", code, path);
    }
}

Result<std::unique_ptr<FilmWriter>> FilmWriter::create(const std::filesystem::path& path, int width,
                                                       int height, int fps, FilmSound sound) {
    auto encoder = std::make_unique<Encoder>();
    encoder->path = path;
    encoder->temporary = temporary_beside(path);
    encoder->source_width = width;
    encoder->source_height = height;
    const ZeroedMemory same_bytes;
    TRY_VOID(encoder->open(width & ~1, height & ~1, fps, std::move(sound)));
    return std::unique_ptr<FilmWriter>(new FilmWriter(std::move(encoder)));
}

FilmWriter::FilmWriter(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
FilmWriter::~FilmWriter() = default;

int FilmWriter::frames() const {
    return static_cast<int>(encoder_->count);
}

std::string FilmWriter::sound_problem() const {
    return encoder_->sound ? encoder_->sound->problem() : std::string();
}

Result<void> FilmWriter::add(const std::uint8_t* rgba) {
    Encoder& e = *encoder_;
    const ZeroedMemory same_bytes; // x264 looks at what it was given
    int code = av_frame_make_writable(e.frame);
    if (code < 0) return ffmpeg_error("cannot make a frame", code, e.path);
    const int stride = e.source_width * 4;
    sws_scale(e.scaler, &rgba, &stride, 0, e.codec->height, e.frame->data, e.frame->linesize);
    e.frame->pts = e.count++;
    code = avcodec_send_frame(e.codec, e.frame);
    if (code < 0) return ffmpeg_error("cannot encode", code, e.path);
    TRY_VOID(e.drain());
    return e.sound ? e.sound->write_to(e.seconds()) : Result<void>{};
}

Result<void> FilmWriter::finish() {
    Encoder& e = *encoder_;
    const ZeroedMemory same_bytes;
    int code = avcodec_send_frame(e.codec, nullptr);
    if (code < 0) return ffmpeg_error("cannot encode", code, e.path);
    TRY_VOID(e.drain());
    if (e.sound) TRY_VOID(e.sound->finish(e.seconds()));
    code = av_write_trailer(e.file);
    if (code < 0) return ffmpeg_error("cannot write", code, e.path);
    code = avio_closep(&e.file->pb);
    if (code < 0) return ffmpeg_error("cannot write", code, e.path);
    TRY_VOID(commit_temporary(e.temporary, e.path));
    e.finished = true;
    return {};
}

} // namespace ghost::video
