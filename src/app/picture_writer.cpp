// SPDX-License-Identifier: Apache-2.0
#include "app/picture_writer.h"

#include "app/caption.h"
#include "image/exr.h"
#include "image/ldr.h"

#include <cstdio>

namespace ghost::app {

Result<OutputKind> output_kind(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".png") return OutputKind::png;
    if (ending == ".exr") return OutputKind::exr;
    if (ending == ".mp4") return OutputKind::film;
    return Error{"the output must end in .png, .exr or .mp4", path.string()};
}

Result<std::unique_ptr<PictureWriter>> PictureWriter::create(const std::filesystem::path& path, int width,
                                                             int height, int fps, bool numbered) {
    std::unique_ptr<PictureWriter> writer(new PictureWriter);
    writer->path_ = path;
    writer->numbered_ = numbered;
    TRY(writer->kind_, output_kind(path));
    if (writer->kind_ == OutputKind::film) {
        TRY(writer->film_, video::FilmWriter::create(path, width, height, fps));
    }
    return writer;
}

Result<void> PictureWriter::add(const render::Relighter& relighter, const std::string& caption) {
    image::Image8 picture;
    if (kind_ != OutputKind::exr) {
        picture = relighter.picture();
        draw_caption(picture, caption);
    }
    if (kind_ == OutputKind::film) return film_->add(picture.samples.data());
    std::filesystem::path path = path_;
    if (numbered_) {
        char number[16];
        std::snprintf(number, sizeof number, "-%05d", count_++);
        path.replace_filename(path_.stem().string() + number + path_.extension().string());
    }
    if (kind_ == OutputKind::png) return image::write_png(path, picture);
    image::ExrFile file;
    file.pixels = relighter.frame();
    file.channels = {"R", "G", "B"};
    file.chromaticities = image::kRec2020;
    file.text["unit"] = "cd/m^2";
    return image::write_exr(path, file, image::ExrSample::full);
}

Result<void> PictureWriter::finish() {
    return film_ ? film_->finish() : Result<void>{};
}

} // namespace ghost::app
