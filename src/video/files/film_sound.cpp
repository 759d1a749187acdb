// SPDX-License-Identifier: Apache-2.0
#include "video/files/private/film_sound.h"

#include "video/files/private/ffmpeg.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace ghost::video {
namespace {

constexpr int kBitsPerSecond = 192'000;

std::int64_t pairs_of(double seconds) {
    return std::llround(seconds * kSoundRate_hz);
}

} // namespace

struct FilmSoundTrack::Encoder {
    std::filesystem::path film;
    FilmSound sound;
    AVFormatContext* file = nullptr; // the film's
    AVStream* stream = nullptr;
    AVCodecContext* codec = nullptr;
    AVFrame* frame = nullptr;
    AVPacket* packet = nullptr;
    std::vector<float> pairs;
    std::int64_t silence = 0; // before the sound begins
    std::int64_t count = 0;   // pairs given to the encoder

    ~Encoder() {
        av_packet_free(&packet);
        av_frame_free(&frame);
        avcodec_free_context(&codec);
    }

    Result<void> open();
    Result<void> encode(int many);
    Result<void> drain();
};

Result<void> FilmSoundTrack::Encoder::open() {
    const AVCodec* const encoder = avcodec_find_encoder(AV_CODEC_ID_AAC);
    if (!encoder) return Error{"this FFmpeg has no AAC encoder for the film's sound", film.string()};
    stream = avformat_new_stream(file, nullptr);
    codec = avcodec_alloc_context3(encoder);
    frame = av_frame_alloc();
    packet = av_packet_alloc();
    if (!stream || !codec || !frame || !packet) return Error{"out of memory", film.string()};
    codec->sample_rate = kSoundRate_hz;
    codec->ch_layout = AV_CHANNEL_LAYOUT_STEREO;
    codec->sample_fmt = AV_SAMPLE_FMT_FLTP;
    codec->bit_rate = kBitsPerSecond;
    codec->time_base = {1, kSoundRate_hz};
    codec->thread_count = 1; // the same bytes every time
    if (file->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    int code = avcodec_open2(codec, encoder, nullptr);
    if (code < 0) return ffmpeg_error("cannot start the encoder of its sound", code, film);
    code = avcodec_parameters_from_context(stream->codecpar, codec);
    if (code < 0) return ffmpeg_error("cannot describe its sound", code, film);
    stream->time_base = codec->time_base;
    pairs.resize(2 * static_cast<std::size_t>(codec->frame_size));
    frame->format = codec->sample_fmt;
    frame->sample_rate = codec->sample_rate;
    frame->nb_samples = codec->frame_size;
    code = av_channel_layout_copy(&frame->ch_layout, &codec->ch_layout);
    if (code >= 0) code = av_frame_get_buffer(frame, 0);
    if (code < 0) return ffmpeg_error("cannot make its sound", code, film);
    silence = std::max<std::int64_t>(pairs_of(-sound.begin_s), 0);
    sound.file->skip(sound.begin_s);
    return {};
}

// The next so many pairs, at most a packet.
Result<void> FilmSoundTrack::Encoder::encode(int many) {
    const int silent = static_cast<int>(std::min<std::int64_t>(silence, many));
    silence -= silent;
    std::fill(pairs.begin(), pairs.end(), 0.0f);
    sound.file->read(pairs.data() + 2 * static_cast<std::size_t>(silent),
                     static_cast<std::size_t>(many - silent));
    int code = av_frame_make_writable(frame);
    if (code < 0) return ffmpeg_error("cannot make its sound", code, film);
    frame->nb_samples = many;
    for (int side = 0; side < 2; ++side) {
        auto* const to = reinterpret_cast<float*>(frame->data[side]);
        for (int k = 0; k < many; ++k) to[k] = pairs[static_cast<std::size_t>(2 * k + side)];
    }
    frame->pts = count;
    count += many;
    code = avcodec_send_frame(codec, frame);
    if (code < 0) return ffmpeg_error("cannot encode its sound", code, film);
    return drain();
}

Result<void> FilmSoundTrack::Encoder::drain() {
    for (;;) {
        int code = avcodec_receive_packet(codec, packet);
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return {};
        if (code < 0) return ffmpeg_error("cannot encode its sound", code, film);
        av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
        packet->stream_index = stream->index;
        code = av_interleaved_write_frame(file, packet);
        if (code < 0) return ffmpeg_error("cannot write", code, film);
    }
}

Result<std::unique_ptr<FilmSoundTrack>> FilmSoundTrack::create(FilmSound sound, AVFormatContext* file,
                                                               const std::filesystem::path& film) {
    auto encoder = std::make_unique<Encoder>();
    encoder->film = film;
    encoder->sound = std::move(sound);
    encoder->file = file;
    TRY_VOID(encoder->open());
    return std::unique_ptr<FilmSoundTrack>(new FilmSoundTrack(std::move(encoder)));
}

FilmSoundTrack::FilmSoundTrack(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
FilmSoundTrack::~FilmSoundTrack() = default;

Result<void> FilmSoundTrack::write_to(double film_s) {
    Encoder& e = *encoder_;
    while (e.count + e.codec->frame_size <= pairs_of(film_s)) TRY_VOID(e.encode(e.codec->frame_size));
    return {};
}

Result<void> FilmSoundTrack::finish(double film_s) {
    Encoder& e = *encoder_;
    TRY_VOID(write_to(film_s));
    if (const auto rest = static_cast<int>(pairs_of(film_s) - e.count); rest > 0) TRY_VOID(e.encode(rest));
    const int code = avcodec_send_frame(e.codec, nullptr);
    if (code < 0) return ffmpeg_error("cannot encode its sound", code, e.film);
    return e.drain();
}

std::string FilmSoundTrack::problem() const {
    return encoder_->sound.file->problem();
}

} // namespace ghost::video
