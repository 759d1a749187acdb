// SPDX-License-Identifier: Apache-2.0
// Sounds are files that the test writes; films with sound are read back by the reader of sounds and of films.
#include "video/files/sound_file.h"

#include "support/must.h"
#include "support/test_films.h"
#include "support/test_sounds.h"
#include "video/files/film.h"
#include "video/files/movie.h"

#include <gtest/gtest.h>
#include <limits>

namespace ghost::video {
namespace {

constexpr std::size_t kPacket = 1024; // of AAC; the last one is decoded whole

using Sounds = WithFilms;

std::vector<float> all_of(SoundFile& sound, std::size_t at_once = 1000) {
    std::vector<float> pairs, block(2 * at_once);
    for (;;) {
        const std::size_t got = sound.read(block.data(), at_once);
        pairs.insert(pairs.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(2 * got));
        if (got < at_once) return pairs;
    }
}

TEST_F(Sounds, every_rate_and_width_is_heard_at_its_time) {
    for (const int rate_hz : {8000, 44100, 48000, 96000})
        for (const int channels : {1, 2, 6}) {
            const auto path =
                write_bytes(folder / "a.wav", wav(clap(0.5, 1, rate_hz, channels), rate_hz, channels));
            const auto sound = must(SoundFile::open(path));
            const std::vector<float> pairs = all_of(*sound);
            EXPECT_NEAR(static_cast<double>(pairs.size()) / 2, kSoundRate_hz, 4) << rate_hz;
            // A filter rings a little before it.
            EXPECT_NEAR(static_cast<double>(loud_from(pairs)), 24000, rate_hz == 8000 ? 12 : 3)
                << rate_hz << " " << channels;
            EXPECT_EQ(sound->problem(), "");
        }
}

TEST_F(Sounds, skipping_is_exact) {
    const auto path = write_bytes(folder / "a.wav", wav(clap(0.5, 1, 48000, 2), 48000, 2));
    const auto sound = must(SoundFile::open(path));
    sound->skip(0.4);
    EXPECT_EQ(loud_from(all_of(*sound)), 4800);
    sound->skip(100); // beyond its end
    EXPECT_TRUE(all_of(*sound).empty());
}

TEST_F(Sounds, what_is_no_number_is_silent_and_what_is_too_loud_is_cut) {
    std::vector<float> samples(2000, 0.0f);
    samples[100] = std::numeric_limits<float>::quiet_NaN();
    samples[200] = std::numeric_limits<float>::infinity();
    samples[300] = 1e20f;
    const auto sound = must(SoundFile::open(write_bytes(folder / "a.wav", wav(samples, 48000, 2))));
    const std::vector<float> pairs = all_of(*sound);
    ASSERT_EQ(pairs.size(), 2000u);
    EXPECT_EQ(pairs[100], 0.0f);
    EXPECT_EQ(pairs[300], 1.0f);
}

TEST_F(Sounds, hostile_files_are_one_sentence_that_names_them) {
    const std::string good = wav(clap(0.5, 1, 48000, 2), 48000, 2);
    std::string huge_rate = good, many_channels = good, no_format = good;
    huge_rate.replace(24, 4, little(2'000'000, 4));
    many_channels.replace(22, 2, little(200, 2));
    no_format.replace(20, 2, little(0x7777, 2));
    for (const auto& [bytes, says] :
         std::vector<std::pair<std::string, std::string>>{{"", "cannot be opened as a sound"},
                                                          {"no sound at all", "cannot be opened as a sound"},
                                                          {"#EXTM3U\nhttp://127.0.0.1/x.mp3\n", ""},
                                                          {huge_rate, "2000000 samples a second, expected"},
                                                          {many_channels, ""},
                                                          {no_format, ""},
                                                          {good.substr(0, 44), ""}}) {
        const auto sound = SoundFile::open(write_bytes(folder / "hostile.wav", bytes));
        ASSERT_FALSE(sound.ok()) << says;
        EXPECT_NE(sound.error().text().find("hostile.wav"), std::string::npos) << sound.error().text();
        EXPECT_NE(sound.error().text().find(says), std::string::npos) << sound.error().text();
    }
    EXPECT_FALSE(SoundFile::open(folder / "missing.wav").ok());
    EXPECT_NE(SoundFile::open(folder).error().text().find("not a plain file"), std::string::npos);
    const auto silent = SoundFile::open(film("silent.mp4", 5));
    ASSERT_FALSE(silent.ok());
    EXPECT_NE(silent.error().text().find("has no sound in it"), std::string::npos) << silent.error().text();
    for (std::size_t bytes = 45; bytes < good.size(); bytes += 9973) { // cut short
        const auto sound = SoundFile::open(write_bytes(folder / "cut.wav", good.substr(0, bytes)));
        if (sound.ok()) {
            EXPECT_LE(all_of(**sound).size(), 2 * 48000u);
        }
    }
}

// A film in which the picture turns white at the moment of the clap.
std::filesystem::path clapped_film(const std::filesystem::path& folder, const std::string& name, int fps,
                                   double begin_s, double flash_s) {
    const auto path = write_bytes(folder / "clap.wav", wav(clap(1.0, 2, 44100, 2), 44100, 2));
    FilmSound sound;
    sound.file = must(SoundFile::open(path));
    sound.begin_s = begin_s;
    const auto film = must(FilmWriter::create(folder / name, 64, 48, fps, std::move(sound)));
    for (int frame = 0; frame < 2 * fps; ++frame)
        EXPECT_TRUE(
            film->add(std::vector<std::uint8_t>(64 * 48 * 4, frame >= flash_s * fps - 1e-6 ? 255 : 0).data())
                .ok());
    EXPECT_TRUE(film->finish().ok());
    EXPECT_EQ(film->sound_problem(), "");
    return folder / name;
}

TEST_F(Sounds, a_films_clap_is_heard_when_it_is_seen) {
    for (const int fps : {1, 24, 25, 30, 60})
        for (const double begin_s : {0.0, 0.5, -0.4}) {
            const double flash_s = std::round((1.0 - begin_s) * fps) / fps;
            const auto path = clapped_film(folder, "clap.mp4", fps, begin_s, flash_s);
            const std::vector<float> pairs = all_of(*must(SoundFile::open(path)));
            EXPECT_GE(pairs.size(), 4u * kSoundRate_hz);
            EXPECT_LT(pairs.size(), 4u * kSoundRate_hz + 2 * kPacket);
            EXPECT_NEAR(static_cast<double>(loud_from(pairs)) / kSoundRate_hz, 1.0 - begin_s, 0.002)
                << fps << " " << begin_s;
            const auto movie = must(Movie::open(path));
            double seen_s = -1;
            while (const auto at_s = must(movie->next())) {
                if (seen_s < 0 && *must(movie->picture(Movie::Which::newest, 8, 8)).at(4, 4) > 128)
                    seen_s = *at_s;
            }
            EXPECT_NEAR(seen_s, flash_s, 1e-3) << fps;
        }
}

TEST_F(Sounds, a_film_is_silent_where_its_sound_has_ended_and_before_it_begins) {
    const auto path = clapped_film(folder, "late.mp4", 25, -10, 0);
    const std::vector<float> pairs = all_of(*must(SoundFile::open(path)));
    EXPECT_GE(pairs.size(), 4u * kSoundRate_hz);
    EXPECT_EQ(loud_from(pairs), -1);
    EXPECT_EQ(loud_from(all_of(*must(SoundFile::open(clapped_film(folder, "over.mp4", 25, 5, 0))))), -1);
}

TEST_F(Sounds, same_pictures_and_sound_same_bytes) {
    const auto bytes_of = [](const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string one = bytes_of(clapped_film(folder, "one.mp4", 30, 0, 1));
    EXPECT_EQ(one, bytes_of(clapped_film(folder, "two.mp4", 30, 0, 1)));
    EXPECT_GT(one.size(), 2000u);
}

TEST_F(Sounds, are_a_day_long_at_most) {
    constexpr std::uint32_t kRate = 4000, kDay = static_cast<std::uint32_t>(kLongestSound_s) * kRate;
    const auto day_and = [&](std::uint32_t more) {
        const std::uint32_t size = kDay + more;
        const auto path = write_bytes(folder / "day.wav",
                                      "RIFF" + little(36 + size, 4) + "WAVEfmt " + little(16, 4) +
                                          little(1, 2) + little(1, 2) + little(kRate, 4) + little(kRate, 4) +
                                          little(1, 2) + little(8, 2) + "data" + little(size, 4));
        std::filesystem::resize_file(path, 44 + size); // nothing of it is on the disk
        return SoundFile::open(path);
    };
    EXPECT_TRUE(day_and(0).ok());
    const auto longer = day_and(kRate);
    ASSERT_FALSE(longer.ok());
    EXPECT_TRUE(longer.error().text().ends_with("day.wav: is longer than a day")) << longer.error().text();
}

// One packet, which in this format is 256 / 245 seconds.
void make_tta(const std::filesystem::path& path, int rate_hz) {
    AVFormatContext* file = nullptr;
    ASSERT_GE(avformat_alloc_output_context2(&file, nullptr, "tta", path.c_str()), 0);
    AVStream* const stream = avformat_new_stream(file, nullptr);
    const AVCodec* const encoder = avcodec_find_encoder(AV_CODEC_ID_TTA);
    ASSERT_TRUE(encoder);
    AVCodecContext* codec = avcodec_alloc_context3(encoder);
    codec->sample_rate = rate_hz;
    codec->sample_fmt = AV_SAMPLE_FMT_S16;
    av_channel_layout_default(&codec->ch_layout, 1);
    codec->time_base = {1, rate_hz};
    ASSERT_GE(avcodec_open2(codec, encoder, nullptr), 0);
    avcodec_parameters_from_context(stream->codecpar, codec);
    stream->time_base = codec->time_base;
    ASSERT_GE(avio_open(&file->pb, path.c_str(), AVIO_FLAG_WRITE), 0);
    ASSERT_GE(avformat_write_header(file, nullptr), 0);
    AVFrame* frame = av_frame_alloc();
    AVPacket* packet = av_packet_alloc();
    frame->format = codec->sample_fmt;
    frame->nb_samples = codec->frame_size;
    frame->sample_rate = rate_hz;
    av_channel_layout_copy(&frame->ch_layout, &codec->ch_layout);
    ASSERT_GE(av_frame_get_buffer(frame, 0), 0);
    std::fill_n(frame->data[0], 2 * frame->nb_samples, std::uint8_t{0});
    frame->pts = 0;
    for (const AVFrame* next : {static_cast<const AVFrame*>(frame), static_cast<const AVFrame*>(nullptr)}) {
        avcodec_send_frame(codec, next);
        while (avcodec_receive_packet(codec, packet) == 0) av_interleaved_write_frame(file, packet);
    }
    av_write_trailer(file);
    avio_closep(&file->pb);
    av_packet_free(&packet);
    av_frame_free(&frame);
    avcodec_free_context(&codec);
    avformat_free_context(file);
}

TEST_F(Sounds, a_packet_has_so_many_samples_and_no_more) {
    make_tta(folder / "most.tta", 250'880); // 262,144 samples
    const auto most = SoundFile::open(folder / "most.tta");
    ASSERT_TRUE(most.ok()) << most.error().text();
    EXPECT_NEAR(static_cast<double>(all_of(**most).size() / 2), 48'000.0 * 256 / 245, 50);
    make_tta(folder / "more.tta", 250'881);
    const auto more = SoundFile::open(folder / "more.tta");
    ASSERT_FALSE(more.ok());
    EXPECT_TRUE(more.error().text().ends_with("more.tta: nothing of its sound can be decoded"))
        << more.error().text();
}

} // namespace
} // namespace ghost::video
