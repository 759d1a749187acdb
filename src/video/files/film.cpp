// SPDX-License-Identifier: Apache-2.0
#include "video/files/film.h"

#include "base/zeroed_memory.h"
#include "video/files/private/ffmpeg.h"
#include "video/files/private/film_file.h"

#include <string>
#include <utility>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libswscale/swscale.h>
}

namespace ghost::video {

struct FilmWriter::Encoder {
    std::filesystem::path path;
    int source_width = 0;
    int source_height = 0;
    int fps = 0;
    long first_frame = 0;
    AVCodecContext* codec = nullptr; // of this block
    AVFrame* frame = nullptr;
    AVPacket* packet = nullptr;
    SwsContext* scaler = nullptr;
    std::unique_ptr<FilmFile> film;
    long count = 0;
    long block_at = 0; // the count at its first frame

    ~Encoder() {
        sws_freeContext(scaler);
        av_packet_free(&packet);
        av_frame_free(&frame);
        avcodec_free_context(&codec);
    }

    Result<void> open(FilmSound sound);
    Result<void> drain();
    Result<void> end_block();
};

Result<void> FilmWriter::Encoder::open(FilmSound sound) {
    const int width = source_width & ~1, height = source_height & ~1;
    TRY(codec, open_film_encoder(path, width, height, fps));
    TRY(film,
        FilmFile::create(path, *codec, {codec->extradata, static_cast<std::size_t>(codec->extradata_size)},
                         std::move(sound)));
    frame = av_frame_alloc();
    packet = av_packet_alloc();
    if (!frame || !packet) return Error{"out of memory", path.string()};
    frame->format = codec->pix_fmt;
    frame->width = width;
    frame->height = height;
    const int code = av_frame_get_buffer(frame, 0);
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
        const int code = avcodec_receive_packet(codec, packet);
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return {};
        if (code < 0) return ffmpeg_error("cannot encode", code, path);
        packet->pts += block_at;
        TRY_VOID(film->write(*packet));
    }
}

Result<void> FilmWriter::Encoder::end_block() {
    const int code = avcodec_send_frame(codec, nullptr);
    if (code < 0) return ffmpeg_error("cannot encode", code, path);
    return drain();
}

Result<std::unique_ptr<FilmWriter>> FilmWriter::create(const std::filesystem::path& path, int width,
                                                       int height, int fps, FilmSound sound,
                                                       long first_frame) {
    auto encoder = std::make_unique<Encoder>();
    encoder->path = path;
    encoder->source_width = width;
    encoder->source_height = height;
    encoder->fps = fps;
    encoder->first_frame = first_frame;
    const ZeroedMemory same_bytes;
    TRY_VOID(encoder->open(std::move(sound)));
    return std::unique_ptr<FilmWriter>(new FilmWriter(std::move(encoder)));
}

FilmWriter::FilmWriter(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
FilmWriter::~FilmWriter() = default;

int FilmWriter::frames() const {
    return static_cast<int>(encoder_->count);
}

std::string FilmWriter::sound_problem() const {
    return encoder_->film->sound_problem();
}

Result<void> FilmWriter::add(const std::uint8_t* rgba) {
    Encoder& e = *encoder_;
    const ZeroedMemory same_bytes; // x264 looks at what it was given
    if (e.count > 0 && (e.first_frame + e.count) % kFilmBlockFrames == 0) {
        TRY_VOID(e.end_block());
        avcodec_free_context(&e.codec);
        TRY(e.codec, open_film_encoder(e.path, e.frame->width, e.frame->height, e.fps));
        e.block_at = e.count;
    }
    int code = av_frame_make_writable(e.frame);
    if (code < 0) return ffmpeg_error("cannot make a frame", code, e.path);
    const int stride = e.source_width * 4;
    sws_scale(e.scaler, &rgba, &stride, 0, e.codec->height, e.frame->data, e.frame->linesize);
    e.frame->pts = e.count++ - e.block_at;
    code = avcodec_send_frame(e.codec, e.frame);
    if (code < 0) return ffmpeg_error("cannot encode", code, e.path);
    TRY_VOID(e.drain());
    return e.film->write_sound(e.count);
}

Result<void> FilmWriter::finish() {
    const ZeroedMemory same_bytes;
    TRY_VOID(encoder_->end_block());
    return encoder_->film->finish(encoder_->count);
}

} // namespace ghost::video
