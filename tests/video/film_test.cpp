// SPDX-License-Identifier: Apache-2.0
// Films are read back with the same libraries that players use.
#include "video/files/film.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/log.h>
}

namespace ghost::video {
namespace {

namespace fs = std::filesystem;

class Film : public ::testing::Test {
protected:
    void SetUp() override {
        av_log_set_level(AV_LOG_QUIET);
        folder = fs::temp_directory_path() / ("ghost_film_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
    }
    fs::path folder;
};

std::vector<std::uint8_t> grey(int width, int height, int level) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4,
                                   static_cast<std::uint8_t>(level));
    return rgba;
}

struct ReadBack {
    int width = 0;
    int height = 0;
    double fps = 0;
    std::vector<int> luma; // of the middle pixel of every frame
    AVColorSpace matrix = AVCOL_SPC_UNSPECIFIED;
};

ReadBack read_back(const fs::path& path) {
    ReadBack result;
    AVFormatContext* file = nullptr;
    EXPECT_EQ(avformat_open_input(&file, path.c_str(), nullptr, nullptr), 0);
    if (!file) return result;
    EXPECT_GE(avformat_find_stream_info(file, nullptr), 0);
    EXPECT_EQ(file->nb_streams, 1u);
    const AVStream* stream = file->streams[0];
    result.width = stream->codecpar->width;
    result.height = stream->codecpar->height;
    result.fps = av_q2d(stream->avg_frame_rate);
    result.matrix = stream->codecpar->color_space;
    AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder(stream->codecpar->codec_id));
    avcodec_parameters_to_context(codec, stream->codecpar);
    EXPECT_EQ(avcodec_open2(codec, nullptr, nullptr), 0);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    const auto drain = [&] {
        while (avcodec_receive_frame(codec, frame) == 0)
            result.luma.push_back(
                frame->data[0][frame->linesize[0] * (frame->height / 2) + frame->width / 2]);
    };
    while (av_read_frame(file, packet) == 0) {
        avcodec_send_packet(codec, packet);
        av_packet_unref(packet);
        drain();
    }
    avcodec_send_packet(codec, nullptr);
    drain();
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_close_input(&file);
    return result;
}

TEST_F(Film, HoldsEveryFrame) {
    const fs::path path = folder / "a.mp4";
    auto film = FilmWriter::create(path, 64, 48, 25);
    ASSERT_TRUE(film.ok()) << film.error().text();
    for (int frame = 0; frame < 30; ++frame) {
        const auto done = (*film)->add(grey(64, 48, frame < 15 ? 40 : 200).data());
        ASSERT_TRUE(done.ok()) << done.error().text();
    }
    EXPECT_EQ((*film)->frames(), 30);
    EXPECT_FALSE(fs::exists(path)) << "appears only when it is whole";
    ASSERT_TRUE((*film)->finish().ok());
    const ReadBack film_read = read_back(path);
    EXPECT_EQ(film_read.width, 64);
    EXPECT_EQ(film_read.height, 48);
    EXPECT_NEAR(film_read.fps, 25.0, 0.01);
    EXPECT_EQ(film_read.matrix, AVCOL_SPC_BT709);
    ASSERT_EQ(film_read.luma.size(), 30u);
    // 16 + 219 v / 255.
    EXPECT_NEAR(film_read.luma.front(), 50, 3);
    EXPECT_NEAR(film_read.luma.back(), 188, 3);
    EXPECT_EQ(files(), 1u);
}

TEST_F(Film, OddSizesAreCutToEvenOnes) {
    const fs::path path = folder / "odd.mp4";
    auto film = FilmWriter::create(path, 101, 37, 30);
    ASSERT_TRUE(film.ok()) << film.error().text();
    for (int frame = 0; frame < 3; ++frame) ASSERT_TRUE((*film)->add(grey(101, 37, 128).data()).ok());
    ASSERT_TRUE((*film)->finish().ok());
    const ReadBack film_read = read_back(path);
    EXPECT_EQ(film_read.width, 100);
    EXPECT_EQ(film_read.height, 36);
    EXPECT_EQ(film_read.luma.size(), 3u);
}

TEST_F(Film, OneFrameIsAFilm) {
    auto film = FilmWriter::create(folder / "one.mp4", 16, 16, 30);
    ASSERT_TRUE(film.ok()) << film.error().text();
    ASSERT_TRUE((*film)->add(grey(16, 16, 90).data()).ok());
    ASSERT_TRUE((*film)->finish().ok());
    EXPECT_EQ(read_back(folder / "one.mp4").luma.size(), 1u);
}

TEST_F(Film, AbandonedLeavesNothingBehind) {
    {
        auto film = FilmWriter::create(folder / "left.mp4", 32, 32, 30);
        ASSERT_TRUE(film.ok());
        ASSERT_TRUE((*film)->add(grey(32, 32, 10).data()).ok());
    }
    EXPECT_EQ(files(), 0u);
}

TEST_F(Film, KeepsTheOldFilmUntilTheNewOneIsWhole) {
    const fs::path path = folder / "old.mp4";
    std::ofstream(path) << "the film of yesterday";
    {
        auto film = FilmWriter::create(path, 32, 32, 30);
        ASSERT_TRUE(film.ok());
        ASSERT_TRUE((*film)->add(grey(32, 32, 10).data()).ok());
    }
    EXPECT_EQ(fs::file_size(path), 21u);
    EXPECT_EQ(files(), 1u);
}

TEST_F(Film, AFolderThatDoesNotExistIsAnError) {
    const fs::path path = folder / "nowhere" / "film.mp4";
    const auto film = FilmWriter::create(path, 32, 32, 30);
    ASSERT_FALSE(film.ok());
    EXPECT_NE(film.error().text().find("film.mp4"), std::string::npos) << film.error().text();
    EXPECT_NE(film.error().text().find("No such file"), std::string::npos) << film.error().text();
    EXPECT_EQ(files(), 0u);
}

TEST_F(Film, APlaceTakenByAFolderIsAnError) {
    const fs::path path = folder / "taken.mp4";
    fs::create_directories(path / "inside");
    auto film = FilmWriter::create(path, 32, 32, 30);
    if (film.ok()) {
        ASSERT_TRUE((*film)->add(grey(32, 32, 10).data()).ok());
        const auto done = (*film)->finish();
        ASSERT_FALSE(done.ok());
        EXPECT_NE(done.error().text().find("taken.mp4"), std::string::npos) << done.error().text();
    }
    film = Error{"", ""};
    EXPECT_EQ(files(), 1u);
}

TEST_F(Film, ImpossibleSizesAreErrors) {
    for (const auto& [width, height] : {std::pair{0, 0}, {1, 1}, {-4, 10}, {1 << 20, 1 << 20}}) {
        EXPECT_FALSE(FilmWriter::create(folder / "size.mp4", width, height, 30).ok())
            << width << "x" << height;
        EXPECT_EQ(files(), 0u);
    }
}

TEST_F(Film, SamePicturesSameBytes) {
    std::string bytes[2];
    for (int run = 0; run < 2; ++run) {
        const fs::path path = folder / ("run" + std::to_string(run) + ".mp4");
        auto film = FilmWriter::create(path, 48, 32, 30);
        ASSERT_TRUE(film.ok());
        for (int frame = 0; frame < 10; ++frame)
            ASSERT_TRUE((*film)->add(grey(48, 32, 20 * frame).data()).ok());
        ASSERT_TRUE((*film)->finish().ok());
        std::ifstream file(path, std::ios::binary);
        bytes[run] = std::string(std::istreambuf_iterator<char>(file), {});
    }
    EXPECT_GT(bytes[0].size(), 500u);
    EXPECT_EQ(bytes[0], bytes[1]);
}

} // namespace
} // namespace ghost::video
