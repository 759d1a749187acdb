// SPDX-License-Identifier: Apache-2.0
#include "video/files/movie.h"

#include "disk/files.h"
#include "support/test_films.h"
#include "video/private/camera.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ghost::video {
namespace {

using MovieTest = WithFilms;

int newest_number(const Movie& movie, Movie::Which which = Movie::Which::newest) {
    const glm::ivec2 size = image::fitted(movie.width(), movie.height(), 128);
    const auto picture = movie.picture(which, size.x, size.y);
    EXPECT_TRUE(picture.ok());
    return picture.ok() ? number_of(image::make_pyramid(*picture, 128)) : -2;
}

TEST_F(MovieTest, EveryPictureAtItsTime) {
    const auto movie = Movie::open(film("film.mp4", 60));
    ASSERT_TRUE(movie.ok()) << movie.error().text();
    EXPECT_NEAR((*movie)->duration_s(), 60.0 / 25, 1e-6);
    EXPECT_EQ((*movie)->width(), 160);
    for (int k = 0; k < 60; ++k) {
        const auto at_s = (*movie)->next();
        ASSERT_TRUE(at_s.ok() && at_s->has_value()) << k;
        EXPECT_NEAR(**at_s, k / 25.0, 1e-6);
        EXPECT_EQ(newest_number(**movie), k);
        if (k > 0) {
            EXPECT_EQ(newest_number(**movie, Movie::Which::before), k - 1);
        }
    }
    EXPECT_FALSE((*movie)->next()->has_value());
    EXPECT_EQ((*movie)->damaged(), 0);
}

TEST_F(MovieTest, SearchesBackAndForth) {
    const auto movie = Movie::open(film("film.mp4", 250));
    ASSERT_TRUE(movie.ok());
    for (const double at_s : {9.5, 0.0, 3.3, 3.2, 9.9, 1.0}) {
        ASSERT_TRUE((*movie)->seek(at_s).ok());
        std::optional<double> last;
        for (;;) {
            const auto next = (*movie)->next();
            ASSERT_TRUE(next.ok() && next->has_value());
            if (!last) {
                EXPECT_LE(**next, at_s + 1e-6); // one at this moment or before
            }
            last = **next;
            if (*last + 1 / 25.0 > at_s + 1e-6) break;
        }
        EXPECT_EQ(newest_number(**movie), static_cast<int>(at_s * 25 + 1e-3)) << at_s;
    }
}

TEST_F(MovieTest, UnevenTimesAreTheFiles) {
    const std::vector<int> at_ms{0, 100, 150, 1000, 1020, 2500};
    make_uneven(folder / "uneven.mkv", at_ms, 3000);
    const auto movie = Movie::open(folder / "uneven.mkv");
    ASSERT_TRUE(movie.ok()) << movie.error().text();
    EXPECT_NEAR((*movie)->duration_s(), 3.0, 0.02);
    for (std::size_t k = 0; k < at_ms.size(); ++k) {
        const auto at_s = (*movie)->next();
        ASSERT_TRUE(at_s.ok() && at_s->has_value());
        EXPECT_NEAR(**at_s, at_ms[k] / 1000.0, 1e-6);
        EXPECT_EQ(newest_number(**movie), static_cast<int>(k));
    }
}

// Each is an error that names the file; none of them hangs or crashes.
image::Image8 one_off(const std::filesystem::path& path, const OneOff& wanted) {
    make_one_off(path, wanted);
    const auto movie = Movie::open(path);
    EXPECT_TRUE(movie.ok()) << movie.error().text();
    if (!movie.ok()) return {};
    const auto at_s = (*movie)->next();
    EXPECT_TRUE(at_s.ok() && at_s->has_value()) << "no picture in it";
    EXPECT_FALSE((*movie)->drops_alpha());
    auto picture = (*movie)->picture(Movie::Which::newest, (*movie)->width(), (*movie)->height());
    EXPECT_TRUE(picture.ok());
    return picture.ok() ? std::move(*picture) : image::Image8{};
}

TEST_F(MovieTest, APictureWithoutAnyLengthIsShown) {
    const image::Image8 picture = one_off(folder / "one.mp4", {.has_duration = false});
    ASSERT_EQ(picture.width, 64);
    EXPECT_GT(picture.at(8, 8)[0], 200);
}

TEST_F(MovieTest, TelephonesFilmsStandUpright) {
    for (const int deg : {0, 90, 180, 270}) {
        SCOPED_TRACE(deg);
        const image::Image8 picture = one_off(folder / "turned.mp4", {.clockwise_deg = deg});
        ASSERT_EQ(picture.width, deg % 180 == 0 ? 64 : 32);
        ASSERT_EQ(picture.height, deg % 180 == 0 ? 32 : 64);
        const bool right = deg == 90 || deg == 180, low = deg == 180 || deg == 270;
        for (const bool x : {false, true})
            for (const bool y : {false, true}) {
                const int value =
                    picture.at(picture.width * (x ? 3 : 1) / 4, picture.height * (y ? 3 : 1) / 4)[0];
                EXPECT_EQ(value > 128, x == right && y == low) << x << y << ": " << value;
            }
    }
}

TEST_F(MovieTest, WebmKeepsItsAlpha) {
    const image::Image8 picture = one_off(
        folder / "alpha.webm", {.muxer = "webm", .encoder = "libvpx-vp9", .format = AV_PIX_FMT_YUVA420P});
    ASSERT_EQ(picture.width, 64);
    EXPECT_LT(picture.at(16, 24)[3], 10);
    EXPECT_GT(picture.at(48, 24)[3], 245);
}

TEST_F(MovieTest, WhatIsNoFilmIsSaid) {
    const auto expect_error = [&](const std::string& name, std::string_view part) {
        const auto movie = Movie::open(folder / name);
        ASSERT_FALSE(movie.ok()) << name;
        EXPECT_NE(movie.error().text().find(name), std::string::npos) << movie.error().text();
        EXPECT_NE(movie.error().text().find(part), std::string::npos) << movie.error().text();
    };
    expect_error("missing.mp4", "No such file");
    ASSERT_TRUE(std::filesystem::create_directory(folder / "folder.mp4"));
    expect_error("folder.mp4", "not a plain file");
    ASSERT_TRUE(write_file_atomic(folder / "empty.mp4", std::string()).ok());
    expect_error("empty.mp4", "cannot be opened");
    ASSERT_TRUE(write_file_atomic(folder / "text.mp4", std::string(5000, 'x')).ok());
    expect_error("text.mp4", "cannot be opened");
    // A list of addresses: not followed.
    ASSERT_TRUE(
        write_file_atomic(folder / "list.m3u8", std::string("#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\n"
                                                            "http://127.0.0.1:9/a.ts\n#EXT-X-ENDLIST\n"))
            .ok());
    EXPECT_FALSE(Movie::open(folder / "list.m3u8").ok());
    // A codec that nobody has.
    const auto bytes = read_file(film("good.mp4", 10), 1 << 24);
    ASSERT_TRUE(bytes.ok());
    std::string odd(bytes->begin(), bytes->end());
    for (const std::string_view code : {"avc1", "mp4v"})
        for (std::size_t at = odd.find(code, 64); at != std::string::npos; at = odd.find(code, at + 1))
            odd.replace(at, 4, "qqqq");
    ASSERT_TRUE(write_file_atomic(folder / "odd.mp4", odd).ok());
    expect_error("odd.mp4", "cannot");
    // No picture at all.
    auto none = FilmWriter::create(folder / "none.mp4", 64, 64, 25);
    ASSERT_TRUE(none.ok());
    if ((*none)->finish().ok()) expect_error("none.mp4", "none.mp4");
}

// Cut anywhere, or with garbage in its middle: an error, or the pictures that are left.
TEST_F(MovieTest, DamagedFilmsEnd) {
    const auto bytes = read_file(film("good.mp4", 50), 1 << 24);
    ASSERT_TRUE(bytes.ok());
    const std::string whole(bytes->begin(), bytes->end());
    int opened = 0, shown = 0;
    for (int part = 1; part < 40; ++part) {
        std::string bad = whole;
        const std::size_t at = whole.size() * static_cast<std::size_t>(part) / 40;
        if (part % 2)
            bad.resize(at);
        else
            for (std::size_t k = at; k < std::min(at + 300, bad.size()); ++k)
                bad[k] = static_cast<char>(k * 37);
        ASSERT_TRUE(write_file_atomic(folder / "bad.mp4", bad).ok());
        const auto movie = Movie::open(folder / "bad.mp4");
        if (!movie.ok()) continue;
        ++opened;
        for (int k = 0; k < 200; ++k) {
            const auto next = (*movie)->next();
            if (!next.ok() || !next->has_value()) break;
            EXPECT_LT(k, 199);
            shown += (*movie)->picture(Movie::Which::newest, 64, 32).ok() ? 1 : 0;
        }
    }
    EXPECT_GT(opened, 5);
    EXPECT_GT(shown, 100);
}

TEST_F(MovieTest, CameraPictures) {
    // Two pixels: white and black, then red (ITU-R BT.601, 8 bit).
    const std::array<std::uint8_t, 8> bytes{235, 128, 16, 128, 81, 90, 81, 240};
    const auto picture = picture_from_yuyv(bytes.data(), bytes.size(), 4, 1, 8);
    ASSERT_TRUE(picture.ok());
    EXPECT_EQ(picture->at(0, 0)[1], 255);
    EXPECT_EQ(picture->at(1, 0)[1], 0);
    EXPECT_NEAR(picture->at(2, 0)[0], 254, 2);
    EXPECT_NEAR(picture->at(2, 0)[1], 0, 2);
    EXPECT_FALSE(picture_from_yuyv(bytes.data(), 7, 4, 1, 8).ok());
    EXPECT_FALSE(picture_from_yuyv(bytes.data(), 8, 3, 1, 8).ok());
    for (const char* device : {"/dev/null", "/dev/no_such_camera"}) {
        const auto camera = Camera::open(device);
        ASSERT_FALSE(camera.ok());
        EXPECT_NE(camera.error().text().find(device), std::string::npos);
    }
}

// One white picture of that size, one bit a pixel.
void make_large(const std::filesystem::path& path, int width, int height) {
    AVFormatContext* file = nullptr;
    ASSERT_GE(avformat_alloc_output_context2(&file, nullptr, "matroska", path.c_str()), 0);
    AVStream* const stream = avformat_new_stream(file, nullptr);
    const AVCodec* const encoder = avcodec_find_encoder(AV_CODEC_ID_PNG);
    ASSERT_TRUE(encoder);
    AVCodecContext* codec = avcodec_alloc_context3(encoder);
    codec->width = width;
    codec->height = height;
    codec->time_base = {1, 25};
    codec->pix_fmt = AV_PIX_FMT_MONOBLACK;
    ASSERT_GE(avcodec_open2(codec, encoder, nullptr), 0);
    avcodec_parameters_from_context(stream->codecpar, codec);
    stream->time_base = codec->time_base;
    ASSERT_GE(avio_open(&file->pb, path.c_str(), AVIO_FLAG_WRITE), 0);
    ASSERT_GE(avformat_write_header(file, nullptr), 0);
    AVFrame* frame = av_frame_alloc();
    AVPacket* packet = av_packet_alloc();
    frame->format = codec->pix_fmt;
    frame->width = width;
    frame->height = height;
    ASSERT_GE(av_frame_get_buffer(frame, 0), 0);
    std::fill_n(frame->data[0], frame->linesize[0] * height, std::uint8_t{255});
    frame->pts = 0;
    for (const AVFrame* next : {static_cast<const AVFrame*>(frame), static_cast<const AVFrame*>(nullptr)}) {
        avcodec_send_frame(codec, next);
        while (avcodec_receive_packet(codec, packet) == 0) {
            packet->duration = 1;
            av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
            av_interleaved_write_frame(file, packet);
        }
    }
    av_write_trailer(file);
    avio_closep(&file->pb);
    av_packet_free(&packet);
    av_frame_free(&frame);
    avcodec_free_context(&codec);
    avformat_free_context(file);
}

TEST_F(MovieTest, APictureHasSoManyPixelsAndNoMore) {
    make_large(folder / "most.mkv", 8192, kMostMoviePixels / 8192);
    const auto movie = must(Movie::open(folder / "most.mkv"));
    ASSERT_TRUE(must(movie->next()));
    EXPECT_GT(*must(movie->picture(Movie::Which::newest, 8, 8)).at(4, 4), 250);
    make_large(folder / "more.mkv", 8193, kMostMoviePixels / 8192);
    const auto more = Movie::open(folder / "more.mkv");
    ASSERT_FALSE(more.ok());
    EXPECT_TRUE(
        more.error().text().ends_with("more.mkv: has pictures of 8193x8192, expected 1 to 67 million pixels"))
        << more.error().text();
}

} // namespace
} // namespace ghost::video
