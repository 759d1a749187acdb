// SPDX-License-Identifier: Apache-2.0
// libpng reports an error by a jump out of the middle of it: between guarded() and libpng nothing may stand
// that has a destructor.
#include "image/private/png_file.h"

#include "base/check.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>

namespace ghost::image {
namespace {

// Level 6 takes a tenth to a third off the bytes and two to five times as long
// (docs/measurements/libraries.md).
constexpr int kLevel = 1;

struct Messages {
    std::string error;
    std::string warning; // the first: the others follow from it
};

void on_error(png_structp png, png_const_charp text) {
    static_cast<Messages*>(png_get_error_ptr(png))->error = text;
    png_longjmp(png, 1);
}

void on_warning(png_structp png, png_const_charp text) {
    std::string& warning = static_cast<Messages*>(png_get_error_ptr(png))->warning;
    if (warning.empty()) warning = text;
}

// Runs a step of references only; false where libpng had an error.
template <class Step>
bool guarded(png_structp png, const Step& step) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    step();
    return true;
}

class Reader {
public:
    explicit Reader(Bytes bytes)
        : left_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &messages_, on_error, on_warning)),
          info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) messages_.error = "memory is short";
    }
    ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    Result<PictureSize> size() {
        if (info_ == nullptr || !guarded(png_, [this] { begin(); })) return failed();
        return PictureSize{static_cast<int>(png_get_image_width(png_, info_)),
                           static_cast<int>(png_get_image_height(png_, info_))};
    }

    // After size().
    Result<Image8> pixels(const PictureSize& size) {
        Image8 image(size.width, size.height, 4);
        if (!guarded(png_, [this, &image] { read_rows(image); })) return failed();
        // All pixels are there: what is wrong behind them does no harm.
        if (!guarded(png_, [this] { png_read_end(png_, nullptr); }))
            on_warning(png_, messages_.error.c_str());
        return image;
    }

    const std::string& warning() const { return messages_.warning; }

private:
    static void take(png_structp png, png_bytep to, std::size_t count) {
        Bytes& left = static_cast<Reader*>(png_get_io_ptr(png))->left_;
        if (count > left.size()) png_error(png, "the file ends early");
        std::memcpy(to, left.data(), count);
        left = left.subspan(count);
    }

    void begin() {
        png_set_read_fn(png_, this, take);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_crc_action(png_, PNG_CRC_WARN_USE, PNG_CRC_DEFAULT);
        // Some programs write a window that is smaller than what they packed with.
        png_set_option(png_, PNG_MAXIMUM_INFLATE_WINDOW, PNG_OPTION_ON);
        png_read_info(png_, info_);
    }

    void read_rows(Image8& image) {
        png_set_expand(png_);
        png_set_strip_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
        const int passes = png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        CHECK(png_get_rowbytes(png_, info_) == static_cast<std::size_t>(image.width) * 4);
        for (int pass = 0; pass < passes; ++pass)
            for (int y = 0; y < image.height; ++y) png_read_row(png_, image.at(0, y), nullptr);
    }

    Error failed() const { return Error{"not a readable PNG picture: " + messages_.error, ""}; }

    Bytes left_;
    Messages messages_;
    png_structp png_;
    png_infop info_;
};

class Writer {
public:
    Writer()
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &messages_, on_error, on_warning)),
          info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) messages_.error = "memory is short";
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    Result<std::vector<std::uint8_t>> encode(const Image8& pixels) {
        if (info_ == nullptr || !guarded(png_, [this, &pixels] { write(pixels); }))
            return Error{"cannot encode as PNG: " + messages_.error, ""};
        return std::move(bytes_);
    }

private:
    static void append(png_structp png, png_bytep from, std::size_t count) {
        std::vector<std::uint8_t>& bytes = static_cast<Writer*>(png_get_io_ptr(png))->bytes_;
        bytes.insert(bytes.end(), from, from + count);
    }

    void write(const Image8& pixels) {
        png_set_write_fn(png_, this, append, nullptr);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(pixels.width),
                     static_cast<png_uint_32>(pixels.height), 8,
                     pixels.channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_compression_level(png_, kLevel);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
        png_write_info(png_, info_);
        for (int y = 0; y < pixels.height; ++y) png_write_row(png_, pixels.at(0, y));
        png_write_end(png_, info_);
    }

    std::vector<std::uint8_t> bytes_;
    Messages messages_;
    png_structp png_;
    png_infop info_;
};

} // namespace

bool is_png(Bytes bytes) {
    constexpr std::array<std::uint8_t, 8> kStart{0x89, 'P', 'N', 'G', 13, 10, 26, 10};
    return bytes.size() >= kStart.size() && std::equal(kStart.begin(), kStart.end(), bytes.begin());
}

Result<PictureSize> png_size(Bytes bytes) {
    return Reader(bytes).size();
}

Result<Image8> decode_png(Bytes bytes, std::string& damage) {
    Reader reader(bytes);
    TRY(const PictureSize size, reader.size());
    auto image = reader.pixels(size);
    damage = reader.warning();
    return image;
}

Result<std::vector<std::uint8_t>> encode_png(const Image8& pixels) {
    CHECK(pixels.channels == 3 || pixels.channels == 4);
    return Writer().encode(pixels);
}

} // namespace ghost::image
