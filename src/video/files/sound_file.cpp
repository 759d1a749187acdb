// SPDX-License-Identifier: Apache-2.0
#include "video/files/sound_file.h"

#include "video/files/private/ffmpeg.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswresample/swresample.h>
}

namespace ghost::video {
namespace {

constexpr int kLeastSoundRate_hz = 4000;
constexpr int kMostPacketSamples = 1 << 18;
constexpr std::int64_t kMostPairs = static_cast<std::int64_t>(kLongestSound_s) * kSoundRate_hz;
constexpr std::int64_t kGap = kSoundRate_hz / 50; // time stamps are rounded; more is a hole in the sound

} // namespace

struct SoundFile::Decoder {
    std::filesystem::path path;
    AVFormatContext* file = nullptr;
    AVCodecContext* codec = nullptr;
    AVStream* stream = nullptr;
    AVFrame* frame = nullptr;
    AVPacket* packet = nullptr;
    SwrContext* resampler = nullptr;
    int from_rate_hz = 0; // of the resampler
    int from_format = -1;
    AVChannelLayout from_channels{};
    std::vector<float> block; // decoded and not yet read
    std::size_t taken = 0;    // of it
    std::int64_t silence = 0; // pairs before it
    std::int64_t made = 0;    // pairs, silence too
    int damaged = 0;          // packets
    std::string broken;       // why it ends before its end
    bool is_flushed = false, is_at_end = false;

    ~Decoder() {
        swr_free(&resampler);
        av_channel_layout_uninit(&from_channels);
        av_packet_free(&packet);
        av_frame_free(&frame);
        avcodec_free_context(&codec);
        avformat_close_input(&file);
    }

    Result<void> open();
    void fill();
    bool feed();
    void take_frame();
    bool set_resampler();
    void append(const std::uint8_t** samples, int count);
};

Result<void> SoundFile::Decoder::open() {
    TRY_VOID(open_plain_file(path, "a sound", file));
    const int index = av_find_best_stream(file, AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
    if (index < 0) return Error{"has no sound in it", path.string()};
    stream = file->streams[index];
    for (unsigned k = 0; k < file->nb_streams; ++k)
        if (static_cast<int>(k) != index) file->streams[k]->discard = AVDISCARD_ALL;
    const AVCodecParameters& parameters = *stream->codecpar;
    const AVCodec* const decoder = avcodec_find_decoder(parameters.codec_id);
    if (!decoder)
        return Error{std::string("is coded as ") + avcodec_get_name(parameters.codec_id) +
                         ", which this FFmpeg cannot decode",
                     path.string()};
    const int channels = parameters.ch_layout.nb_channels;
    if (channels < 1 || channels > kMostSoundChannels || parameters.sample_rate < kLeastSoundRate_hz ||
        parameters.sample_rate > kMostSoundRate_hz)
        return Error{"has " + std::to_string(channels) + " channels of " +
                         std::to_string(parameters.sample_rate) + " samples a second, expected 1 to " +
                         std::to_string(kMostSoundChannels) + " of " + std::to_string(kLeastSoundRate_hz) +
                         " to " + std::to_string(kMostSoundRate_hz),
                     path.string()};
    if (file->duration != AV_NOPTS_VALUE &&
        static_cast<double>(file->duration) > kLongestSound_s * AV_TIME_BASE)
        return Error{"is longer than a day", path.string()};
    codec = avcodec_alloc_context3(decoder);
    frame = av_frame_alloc();
    packet = av_packet_alloc();
    if (!codec || !frame || !packet) return Error{"out of memory", path.string()};
    int code = avcodec_parameters_to_context(codec, &parameters);
    if (code < 0) return ffmpeg_error("cannot be decoded", code, path);
    codec->pkt_timebase = stream->time_base;
    codec->thread_count = 1;
    codec->max_samples = kMostPacketSamples;
    code = avcodec_open2(codec, decoder, nullptr);
    if (code < 0) return ffmpeg_error("cannot be decoded", code, path);
    fill();
    if (block.empty()) return Error{"nothing of its sound can be decoded", path.string()};
    return {};
}

// One packet into the decoder; false: there are no more.
bool SoundFile::Decoder::feed() {
    for (;;) {
        const int code = av_read_frame(file, packet);
        if (code < 0) {
            if (code != AVERROR_EOF && !(file->pb && avio_feof(file->pb)))
                broken = ffmpeg_error("cannot be read further", code, path).what;
            return false;
        }
        const bool ours = packet->stream_index == stream->index;
        const int sent = ours ? avcodec_send_packet(codec, packet) : 0;
        av_packet_unref(packet);
        if (sent < 0) ++damaged;
        if (ours) return true;
    }
}

// Makes the next block, if there is one.
void SoundFile::Decoder::fill() {
    block.clear();
    taken = 0;
    while (block.empty() && !is_at_end) {
        const int code = avcodec_receive_frame(codec, frame);
        if (code == 0) {
            take_frame();
            av_frame_unref(frame);
        } else if (code == AVERROR_EOF || (code != AVERROR(EAGAIN) && is_flushed)) {
            if (resampler) append(nullptr, 0);
            is_at_end = true;
        } else {
            if (code != AVERROR(EAGAIN)) ++damaged;
            if (!feed() && !std::exchange(is_flushed, true)) avcodec_send_packet(codec, nullptr);
        }
        is_at_end = is_at_end || made >= kMostPairs;
    }
}

bool SoundFile::Decoder::set_resampler() {
    if (resampler && from_rate_hz == frame->sample_rate && from_format == frame->format &&
        av_channel_layout_compare(&from_channels, &frame->ch_layout) == 0)
        return true;
    swr_free(&resampler);
    from_rate_hz = frame->sample_rate;
    from_format = frame->format;
    if (av_channel_layout_copy(&from_channels, &frame->ch_layout) < 0) return false;
    AVChannelLayout known{};
    if (from_channels.order == AV_CHANNEL_ORDER_UNSPEC)
        av_channel_layout_default(&known, from_channels.nb_channels);
    AVChannelLayout stereo = AV_CHANNEL_LAYOUT_STEREO;
    const bool is_set =
        from_rate_hz >= kLeastSoundRate_hz && from_rate_hz <= kMostSoundRate_hz &&
        swr_alloc_set_opts2(&resampler, &stereo, AV_SAMPLE_FMT_FLT, kSoundRate_hz,
                            known.nb_channels > 0 ? &known : &from_channels,
                            static_cast<AVSampleFormat>(from_format), from_rate_hz, 0, nullptr) == 0 &&
        swr_init(resampler) == 0;
    if (!is_set) swr_free(&resampler);
    av_channel_layout_uninit(&known);
    return is_set;
}

// samples: null at the end, for what the resampler still holds.
void SoundFile::Decoder::append(const std::uint8_t** samples, int count) {
    const int most = swr_get_out_samples(resampler, count);
    if (most <= 0) return;
    const std::size_t before = block.size();
    block.resize(before + 2 * static_cast<std::size_t>(most));
    auto* to = reinterpret_cast<std::uint8_t*>(block.data() + before);
    const int got = swr_convert(resampler, &to, most, samples, count);
    block.resize(before + 2 * static_cast<std::size_t>(std::max(got, 0)));
    made += std::max(got, 0);
    for (std::size_t k = before; k < block.size(); ++k) // files of floats may hold anything
        block[k] = std::isfinite(block[k]) ? std::clamp(block[k], -1.0f, 1.0f) : 0.0f;
}

void SoundFile::Decoder::take_frame() {
    if (!set_resampler()) {
        ++damaged;
        return;
    }
    const std::int64_t begin = file->start_time != AV_NOPTS_VALUE ? file->start_time : 0;
    const std::int64_t stamp = frame->best_effort_timestamp;
    if (stamp != AV_NOPTS_VALUE) {
        const double at_s = static_cast<double>(stamp) * av_q2d(stream->time_base) -
                            static_cast<double>(begin) / AV_TIME_BASE;
        const auto due =
            static_cast<std::int64_t>(std::llround(std::clamp(at_s, 0.0, kLongestSound_s) * kSoundRate_hz));
        if (due - made > (made == 0 ? 0 : kGap)) {
            silence += due - made;
            made = due;
        }
    }
    append(const_cast<const std::uint8_t**>(frame->extended_data), frame->nb_samples);
}

Result<std::unique_ptr<SoundFile>> SoundFile::open(const std::filesystem::path& path) {
    auto decoder = std::make_unique<Decoder>();
    decoder->path = path;
    TRY_VOID(decoder->open());
    return std::unique_ptr<SoundFile>(new SoundFile(std::move(decoder)));
}

SoundFile::SoundFile(std::unique_ptr<Decoder> decoder) : decoder_(std::move(decoder)) {}
SoundFile::~SoundFile() = default;

std::size_t SoundFile::read(float* pairs, std::size_t count) {
    Decoder& d = *decoder_;
    std::size_t done = 0;
    while (done < count) {
        const auto silent = std::min(count - done, static_cast<std::size_t>(d.silence));
        std::fill_n(pairs + 2 * done, 2 * silent, 0.0f);
        d.silence -= static_cast<std::int64_t>(silent);
        done += silent;
        const std::size_t sounding = std::min(count - done, d.block.size() / 2 - d.taken);
        std::copy_n(d.block.begin() + static_cast<std::ptrdiff_t>(2 * d.taken), 2 * sounding,
                    pairs + 2 * done);
        d.taken += sounding;
        done += sounding;
        if (done == count) break;
        if (d.is_at_end) break;
        d.fill();
    }
    return done;
}

void SoundFile::skip(double seconds) {
    constexpr std::size_t kBlock = 4096;
    std::vector<float> unheard(2 * kBlock);
    auto left =
        static_cast<std::int64_t>(std::llround(std::clamp(seconds, 0.0, kLongestSound_s) * kSoundRate_hz));
    while (left > 0) {
        const std::size_t got = read(unheard.data(), std::min(kBlock, static_cast<std::size_t>(left)));
        if (got == 0) return;
        left -= static_cast<std::int64_t>(got);
    }
}

std::string SoundFile::problem() const {
    if (!decoder_->broken.empty()) return decoder_->broken;
    if (decoder_->damaged > 0)
        return std::to_string(decoder_->damaged) + " pieces of its sound cannot be decoded and are silent";
    return {};
}

} // namespace ghost::video
