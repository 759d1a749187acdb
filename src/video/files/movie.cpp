// SPDX-License-Identifier: Apache-2.0
#include "video/files/movie.h"

#include "video/files/private/ffmpeg.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libavutil/display.h>
#include <libavutil/imgutils.h>
#include <libswscale/swscale.h>
}

namespace ghost::video {
namespace {

constexpr int kMostPackets = 4'000'000; // looked at where a file does not say how long it is
constexpr int kThreads = 2;
constexpr int kLargePicture = 1920 * 1088; // beyond, more threads decode
constexpr int kThreadsLarge = 4;

// Matrix of the file's colours; where it does not say, as players guess.
const int* matrix_of(const AVFrame& frame) {
    switch (frame.colorspace) {
    case AVCOL_SPC_BT709:
        return sws_getCoefficients(SWS_CS_ITU709);
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
        return sws_getCoefficients(SWS_CS_BT2020);
    case AVCOL_SPC_BT470BG:
    case AVCOL_SPC_SMPTE170M:
        return sws_getCoefficients(SWS_CS_ITU601);
    case AVCOL_SPC_SMPTE240M:
        return sws_getCoefficients(SWS_CS_SMPTE240M);
    default:
        return sws_getCoefficients(frame.height >= 720 ? SWS_CS_ITU709 : SWS_CS_ITU601);
    }
}

// FFmpeg's own decoders of VP8 and VP9 leave the alpha channel out.
const AVCodec* decoder_of(const AVStream& stream, bool& drops_alpha) {
    const AVCodecID id = stream.codecpar->codec_id;
    const AVDictionaryEntry* alpha = av_dict_get(stream.metadata, "alpha_mode", nullptr, 0);
    const bool has_alpha =
        (id == AV_CODEC_ID_VP8 || id == AV_CODEC_ID_VP9) && alpha && std::string(alpha->value) == "1";
    const AVCodec* with_alpha =
        has_alpha ? avcodec_find_decoder_by_name(id == AV_CODEC_ID_VP9 ? "libvpx-vp9" : "libvpx") : nullptr;
    drops_alpha = has_alpha && !with_alpha;
    return with_alpha ? with_alpha : avcodec_find_decoder(id);
}

// Quarter turns, clockwise, that a player makes: telephones film as they are held.
int quarter_turns_of(const AVStream& stream) {
    std::size_t bytes = 0;
#if LIBAVCODEC_VERSION_INT >= AV_VERSION_INT(60, 31, 102) // FFmpeg 6.1; Debian 12 has 5.1
    const AVPacketSideData* const data = av_packet_side_data_get(
        stream.codecpar->coded_side_data, stream.codecpar->nb_coded_side_data, AV_PKT_DATA_DISPLAYMATRIX);
    const std::uint8_t* const matrix = data ? data->data : nullptr;
    if (data) bytes = data->size;
#else
    const std::uint8_t* const matrix = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &bytes);
#endif
    if (!matrix || bytes < 9 * sizeof(std::int32_t)) return 0;
    std::int32_t values[9];
    std::memcpy(values, matrix, sizeof values);
    const double anticlockwise_deg = av_display_rotation_get(values);
    return std::isfinite(anticlockwise_deg) ? static_cast<int>(std::lround(-anticlockwise_deg / 90)) & 3 : 0;
}

// rows: RGBA, `stride` bytes each; the picture has their size, turned.
void copy_turned(const std::vector<std::uint8_t>& rows, int stride, int turns, image::Image8& picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int column = turns == 1 ? y : turns == 2 ? picture.width - 1 - x : picture.height - 1 - y;
            const int row = turns == 1 ? picture.width - 1 - x : turns == 2 ? picture.height - 1 - y : x;
            std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(row) * stride + column * 4, 4,
                        picture.at(x, y));
        }
}

} // namespace

struct Movie::Decoder {
    std::filesystem::path path;
    AVFormatContext* file = nullptr;
    AVCodecContext* codec = nullptr;
    AVStream* stream = nullptr;
    AVFrame* fresh = nullptr;
    AVFrame* frame = nullptr;  // Which::newest
    AVFrame* before = nullptr; // Which::before
    AVPacket* packet = nullptr;
    SwsContext* scaler = nullptr;
    double begin_s = 0; // time stamp of the first picture
    double length_s = 0;
    double frame_s = 0.04;
    double last_s = -1;
    double read_to_s = 0;
    int damaged = 0;
    int quarter_turns = 0; // clockwise, as it is shown
    bool drops_alpha = false;
    bool flushed = false;

    ~Decoder() {
        sws_freeContext(scaler);
        av_packet_free(&packet);
        for (AVFrame** one : {&fresh, &frame, &before}) av_frame_free(one);
        avcodec_free_context(&codec);
        avformat_close_input(&file);
    }

    Result<void> open();
    Result<void> open_codec();
    Result<void> find_length();
    double seconds(std::int64_t stamp) const {
        return static_cast<double>(stamp) * av_q2d(stream->time_base);
    }
    int stretched_width() const;
    Result<bool> feed();
    Result<void> seek(double at_s);
    Result<std::optional<double>> next();
};

Result<void> Movie::Decoder::open() {
    TRY_VOID(open_plain_file(path, "a film", file));
    const int index = av_find_best_stream(file, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (index < 0) return Error{"has no pictures, expected a film", path.string()};
    stream = file->streams[index];
    for (unsigned k = 0; k < file->nb_streams; ++k)
        if (static_cast<int>(k) != index) file->streams[k]->discard = AVDISCARD_ALL;
    quarter_turns = quarter_turns_of(*stream);
    TRY_VOID(open_codec());
    if (stream->avg_frame_rate.num > 0 && stream->avg_frame_rate.den > 0)
        frame_s = std::clamp(1.0 / av_q2d(stream->avg_frame_rate), 1e-3, 3600.0);
    return find_length();
}

Result<void> Movie::Decoder::open_codec() {
    const AVCodecParameters& parameters = *stream->codecpar;
    const AVCodec* decoder = decoder_of(*stream, drops_alpha);
    if (!decoder)
        return Error{std::string("is coded as ") + avcodec_get_name(parameters.codec_id) +
                         ", which this FFmpeg cannot decode",
                     path.string()};
    if (parameters.width < 1 || parameters.height < 1 ||
        static_cast<std::int64_t>(parameters.width) * parameters.height > kMostMoviePixels)
        return Error{"has pictures of " + std::to_string(parameters.width) + "x" +
                         std::to_string(parameters.height) + ", expected 1 to 67 million pixels",
                     path.string()};
    codec = avcodec_alloc_context3(decoder);
    for (AVFrame** one : {&fresh, &frame, &before}) *one = av_frame_alloc();
    packet = av_packet_alloc();
    if (!codec || !fresh || !frame || !before || !packet) return Error{"out of memory", path.string()};
    int code = avcodec_parameters_to_context(codec, &parameters);
    if (code < 0) return ffmpeg_error("cannot be decoded", code, path);
    codec->thread_count = parameters.width * parameters.height > kLargePicture ? kThreadsLarge : kThreads;
    codec->max_pixels = kMostMoviePixels;
    code = avcodec_open2(codec, decoder, nullptr);
    if (code < 0) return ffmpeg_error("cannot be decoded", code, path);
    return {};
}

// The file's word for it, else the last time stamp of all.
Result<void> Movie::Decoder::find_length() {
    if (stream->start_time != AV_NOPTS_VALUE) begin_s = seconds(stream->start_time);
    if (stream->duration != AV_NOPTS_VALUE && stream->duration > 0) length_s = seconds(stream->duration);
    if (length_s <= 0 && file->duration != AV_NOPTS_VALUE && file->duration > 0)
        length_s = static_cast<double>(file->duration) / AV_TIME_BASE;
    if (length_s <= 0) {
        double first = 1e300, end = -1e300;
        for (int k = 0; k < kMostPackets && av_read_frame(file, packet) >= 0; ++k) {
            const std::int64_t stamp = packet->pts != AV_NOPTS_VALUE ? packet->pts : packet->dts;
            if (packet->stream_index == stream->index && stamp != AV_NOPTS_VALUE) {
                first = std::min(first, seconds(stamp));
                end = std::max(end,
                               seconds(stamp) + (packet->duration > 0 ? seconds(packet->duration) : frame_s));
            }
            av_packet_unref(packet);
        }
        if (end > first) {
            begin_s = first;
            length_s = end - first;
        }
        TRY_VOID(seek(0));
    }
    if (!(length_s > 0) || !std::isfinite(length_s))
        return Error{"has no length: no picture in it has a time", path.string()};
    return {};
}

int Movie::Decoder::stretched_width() const {
    const AVRational pixel = av_guess_sample_aspect_ratio(file, stream, nullptr);
    const double stretch = pixel.num > 0 && pixel.den > 0 ? std::clamp(av_q2d(pixel), 0.1, 10.0) : 1.0;
    return std::max(static_cast<int>(std::lround(stretch * stream->codecpar->width)), 1);
}

// One packet into the decoder; false: there are no more.
Result<bool> Movie::Decoder::feed() {
    for (;;) {
        const int code = av_read_frame(file, packet);
        if (code == AVERROR_EOF || (code < 0 && file->pb && avio_feof(file->pb))) return false;
        if (code < 0) return ffmpeg_error("cannot be read further", code, path);
        const bool ours = packet->stream_index == stream->index;
        // The list of what to show of a film that states no length would leave nothing of it.
        if (stream->duration == 0) packet->flags &= ~AV_PKT_FLAG_DISCARD;
        if (ours && packet->pts != AV_NOPTS_VALUE)
            read_to_s = std::max(read_to_s, seconds(packet->pts + packet->duration) - begin_s);
        const int sent = ours ? avcodec_send_packet(codec, packet) : 0;
        av_packet_unref(packet);
        if (sent < 0) ++damaged;
        if (ours) return true;
    }
}

Result<std::optional<double>> Movie::Decoder::next() {
    for (;;) {
        const int code = avcodec_receive_frame(codec, fresh);
        if (code == 0) {
            av_frame_unref(before);
            av_frame_move_ref(before, frame);
            av_frame_move_ref(frame, fresh);
            const std::int64_t stamp = frame->best_effort_timestamp;
            const double at_s = stamp != AV_NOPTS_VALUE ? seconds(stamp) - begin_s : last_s + frame_s;
            last_s = std::max(at_s, 0.0);
            return std::optional(last_s);
        }
        if (code == AVERROR_EOF) return std::optional<double>();
        if (code != AVERROR(EAGAIN)) {
            ++damaged;
            if (flushed) return std::optional<double>();
        }
        TRY(const bool more, feed());
        if (!more && !std::exchange(flushed, true)) avcodec_send_packet(codec, nullptr);
    }
}

Result<void> Movie::Decoder::seek(double at_s) {
    const auto stamp = static_cast<std::int64_t>(std::floor((at_s + begin_s) / av_q2d(stream->time_base)));
    int code = av_seek_frame(file, stream->index, stamp, AVSEEK_FLAG_BACKWARD);
    if (code < 0) code = av_seek_frame(file, stream->index, stamp, AVSEEK_FLAG_BACKWARD | AVSEEK_FLAG_ANY);
    // Raw streams cannot be searched: from the beginning.
    if (code < 0) code = avformat_seek_file(file, -1, INT64_MIN, 0, INT64_MAX, AVSEEK_FLAG_BYTE);
    if (code < 0) return ffmpeg_error("cannot be searched", code, path);
    avcodec_flush_buffers(codec);
    flushed = false;
    last_s = at_s - frame_s;
    return {};
}

Result<std::unique_ptr<Movie>> Movie::open(const std::filesystem::path& path) {
    auto decoder = std::make_unique<Decoder>();
    decoder->path = path;
    TRY_VOID(decoder->open());
    return std::unique_ptr<Movie>(new Movie(std::move(decoder)));
}

Movie::Movie(std::unique_ptr<Decoder> decoder) : decoder_(std::move(decoder)) {}
Movie::~Movie() = default;

double Movie::duration_s() const {
    return decoder_->length_s;
}
int Movie::width() const {
    return decoder_->quarter_turns % 2 ? decoder_->stream->codecpar->height : decoder_->stretched_width();
}
int Movie::height() const {
    return decoder_->quarter_turns % 2 ? decoder_->stretched_width() : decoder_->stream->codecpar->height;
}
bool Movie::drops_alpha() const {
    return decoder_->drops_alpha;
}
double Movie::read_to_s() const {
    return decoder_->read_to_s;
}
int Movie::damaged() const {
    return decoder_->damaged;
}

bool Movie::is_cut_short() const {
    const int entries = avformat_index_get_entries_count(decoder_->stream);
    const std::int64_t bytes = decoder_->file->pb ? avio_size(decoder_->file->pb) : -1;
    if (entries < 1 || bytes < 0) return false;
    const AVIndexEntry* last = avformat_index_get_entry(decoder_->stream, entries - 1);
    return last && last->pos + last->size > bytes;
}

Result<std::optional<double>> Movie::next() {
    return decoder_->next();
}

Result<void> Movie::seek(double at_s) {
    return decoder_->seek(at_s);
}

Result<image::Image8> Movie::picture(Which which, int width_px, int height_px) const {
    Decoder& d = *decoder_;
    const AVFrame& from = which == Which::newest ? *d.frame : *d.before;
    if (from.width < 1 || from.height < 1 || !from.data[0])
        return Error{"has no picture here", d.path.string()};
    image::Image8 picture(width_px, height_px, 4);
    if (d.quarter_turns % 2) std::swap(width_px, height_px);
    const bool smaller = width_px < from.width || height_px < from.height;
    d.scaler = sws_getCachedContext(
        d.scaler, from.width, from.height, static_cast<AVPixelFormat>(from.format), width_px, height_px,
        AV_PIX_FMT_RGBA, smaller ? SWS_AREA : SWS_BICUBIC, nullptr, nullptr, nullptr);
    if (!d.scaler) return Error{"has colours that cannot be converted", d.path.string()};
    sws_setColorspaceDetails(d.scaler, matrix_of(from), from.color_range == AVCOL_RANGE_JPEG ? 1 : 0,
                             sws_getCoefficients(SWS_CS_ITU709), 1, 0, 1 << 16, 1 << 16);
    // swscale writes whole blocks beyond a row's end.
    const int stride = (width_px * 4 + 63) / 64 * 64;
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height_px) +
                                   64);
    std::uint8_t* to[4] = {rows.data(), nullptr, nullptr, nullptr};
    const int strides[4] = {stride, 0, 0, 0};
    sws_scale(d.scaler, from.data, from.linesize, 0, from.height, to, strides);
    if (d.quarter_turns) {
        copy_turned(rows, stride, d.quarter_turns, picture);
        return picture;
    }
    for (int y = 0; y < height_px; ++y)
        std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(y) * stride, width_px * 4, picture.at(0, y));
    return picture;
}

} // namespace ghost::video
