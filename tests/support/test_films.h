#pragma once
// SPDX-License-Identifier: Apache-2.0
// Films whose every picture says its number, as ten black or white bars.

#include "image/pyramid.h"
#include "support/must.h"
#include "video/files/film.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
}

namespace ghost::video {

inline constexpr int kBits = 10;
inline constexpr int kBarWidth = 16;
inline constexpr int kTestHeight = 64;

inline std::vector<std::uint8_t> numbered(int number) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kTestHeight; ++y)
        for (int x = 0; x < kBits * kBarWidth; ++x) {
            const auto value = static_cast<std::uint8_t>((number >> (x / kBarWidth)) % 2 ? 255 : 0);
            rgba.insert(rgba.end(), {value, value, value, 255});
        }
    return rgba;
}

// -1: no such bars.
inline int number_of(const image::Pyramid& pyramid) {
    const int side = pyramid.side;
    int number = 0;
    for (int bit = 0; bit < kBits; ++bit) {
        const int x = (2 * bit + 1) * side / (2 * kBits);
        const std::uint8_t value =
            (*pyramid.levels)[0][4 * (static_cast<std::size_t>(side / 2) * static_cast<std::size_t>(side) +
                                      static_cast<std::size_t>(x))];
        if (value > 60 && value < 190) return -1;
        number |= value >= 190 ? 1 << bit : 0;
    }
    return number;
}

// A film of the pictures 0, 1, .. at these moments (milliseconds), by FFmpeg itself; of the kind that its
// name says.
inline void make_uneven(const std::filesystem::path& path, const std::vector<int>& at_ms, int last_ms) {
    AVFormatContext* file = nullptr;
    ASSERT_GE(avformat_alloc_output_context2(&file, nullptr, nullptr, path.c_str()), 0);
    AVStream* stream = avformat_new_stream(file, nullptr);
    AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_encoder(AV_CODEC_ID_MPEG4));
    codec->width = kBits * kBarWidth;
    codec->height = kTestHeight;
    codec->time_base = {1, 1000};
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->bit_rate = 4'000'000;
    codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    ASSERT_GE(avcodec_open2(codec, nullptr, nullptr), 0);
    avcodec_parameters_from_context(stream->codecpar, codec);
    stream->time_base = codec->time_base;
    ASSERT_GE(avio_open(&file->pb, path.c_str(), AVIO_FLAG_WRITE), 0);
    ASSERT_GE(avformat_write_header(file, nullptr), 0);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    frame->format = codec->pix_fmt;
    frame->width = codec->width;
    frame->height = codec->height;
    av_frame_get_buffer(frame, 0);
    const auto drain = [&] {
        while (avcodec_receive_packet(codec, packet) == 0) {
            const auto at = std::find(at_ms.begin(), at_ms.end(), static_cast<int>(packet->pts));
            packet->duration = (at + 1 < at_ms.end() ? *(at + 1) : last_ms) - *at;
            av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
            av_interleaved_write_frame(file, packet);
        }
    };
    for (std::size_t k = 0; k < at_ms.size(); ++k) {
        av_frame_make_writable(frame);
        for (int y = 0; y < codec->height; ++y)
            for (int x = 0; x < codec->width; ++x)
                frame->data[0][y * frame->linesize[0] + x] = (k >> (x / kBarWidth)) % 2 ? 235 : 16;
        for (int plane : {1, 2})
            for (int y = 0; y < codec->height / 2; ++y)
                std::fill_n(frame->data[plane] + y * frame->linesize[plane], codec->width / 2,
                            std::uint8_t{128});
        frame->pts = at_ms[k];
        avcodec_send_frame(codec, frame);
        drain();
    }
    avcodec_send_frame(codec, nullptr);
    drain();
    av_write_trailer(file);
    avio_closep(&file->pb);
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_free_context(file);
}

// One picture whose top left quarter is white, the rest black, as a file may have it.
struct OneOff {
    const char* muxer = "mp4";
    const char* encoder = "mpeg4";
    AVPixelFormat format = AV_PIX_FMT_YUV420P; // YUVA420P: its left half is transparent
    int clockwise_deg = 0;                     // that a player shall turn it
    bool has_duration = true;
};

inline void make_one_off(const std::filesystem::path& path, const OneOff& wanted) {
    AVFormatContext* file = nullptr;
    ASSERT_GE(avformat_alloc_output_context2(&file, nullptr, wanted.muxer, path.c_str()), 0);
    AVStream* stream = avformat_new_stream(file, nullptr);
    const AVCodec* encoder = avcodec_find_encoder_by_name(wanted.encoder);
    ASSERT_TRUE(encoder) << wanted.encoder;
    AVCodecContext* codec = avcodec_alloc_context3(encoder);
    codec->width = 64;
    codec->height = 32;
    codec->time_base = {1, 25};
    codec->pix_fmt = wanted.format;
    codec->bit_rate = 4'000'000;
    codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    ASSERT_GE(avcodec_open2(codec, encoder, nullptr), 0);
    avcodec_parameters_from_context(stream->codecpar, codec);
    stream->time_base = codec->time_base;
    if (wanted.clockwise_deg != 0) {
        constexpr std::size_t kMatrixBytes = 9 * sizeof(std::int32_t);
#if LIBAVCODEC_VERSION_INT >= AV_VERSION_INT(60, 31, 102) // FFmpeg 6.1
        void* const matrix =
            av_packet_side_data_new(&stream->codecpar->coded_side_data, &stream->codecpar->nb_coded_side_data,
                                    AV_PKT_DATA_DISPLAYMATRIX, kMatrixBytes, 0)
                ->data;
#else
        void* const matrix = av_stream_new_side_data(stream, AV_PKT_DATA_DISPLAYMATRIX, kMatrixBytes);
#endif
        av_display_rotation_set(static_cast<std::int32_t*>(matrix), wanted.clockwise_deg); // clockwise
    }
    ASSERT_GE(avio_open(&file->pb, path.c_str(), AVIO_FLAG_WRITE), 0);
    ASSERT_GE(avformat_write_header(file, nullptr), 0);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    frame->format = codec->pix_fmt;
    frame->width = codec->width;
    frame->height = codec->height;
    av_frame_get_buffer(frame, 0);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            frame->data[0][y * frame->linesize[0] + x] = x < 32 && y < 16 ? 235 : 16;
            if (wanted.format == AV_PIX_FMT_YUVA420P)
                frame->data[3][y * frame->linesize[3] + x] = x < 32 ? 0 : 255;
        }
    for (int plane : {1, 2})
        for (int y = 0; y < 16; ++y)
            std::fill_n(frame->data[plane] + y * frame->linesize[plane], 32, std::uint8_t{128});
    frame->pts = 0;
    avcodec_send_frame(codec, frame);
    avcodec_send_frame(codec, nullptr);
    while (avcodec_receive_packet(codec, packet) == 0) {
        packet->duration = wanted.has_duration ? 1 : 0;
        av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
        av_interleaved_write_frame(file, packet);
    }
    av_write_trailer(file);
    avio_closep(&file->pb);
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_free_context(file);
}

class WithFilms : public ::testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("ghost_films_" + std::to_string(::getpid()) + "_" +
                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder);
    }
    void TearDown() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }
    std::filesystem::path film(const std::string& name, int frames, int fps = 25, int first = 0) const {
        const std::filesystem::path path = folder / name;
        const auto writer = must(FilmWriter::create(path, kBits * kBarWidth, kTestHeight, fps));
        for (int k = 0; k < frames; ++k) EXPECT_TRUE(writer->add(numbered(first + k).data()).ok());
        EXPECT_TRUE(writer->finish().ok());
        return path;
    }
    std::filesystem::path folder;
};

} // namespace ghost::video
