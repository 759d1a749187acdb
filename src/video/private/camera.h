#pragma once
// SPDX-License-Identifier: Apache-2.0
// Camera: pictures of a video device (Video4Linux 2: webcams, capture cards), as YUYV or Motion JPEG. Errors
// name the device. One thread at a time. Elsewhere than on Linux there is none.

#include "base/result.h"
#include "image/image.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace ghost::video {

class Camera {
public:
    // Error: no such device, no permission, not a camera, in use, none of the two formats.
    static Result<std::unique_ptr<Camera>> open(const std::filesystem::path& device);
    ~Camera();
    Camera(const Camera&) = delete;
    Camera& operator=(const Camera&) = delete;

    // The next picture; nothing: none that can be read came within a fifth of a second. Error: the device is
    // gone.
    Result<std::optional<image::Image8>> next();
    // Why none came since the last one.
    Error silence() const;

private:
    struct Device;
    explicit Camera(std::unique_ptr<Device> device);
    std::unique_ptr<Device> device_;
    std::string damage_; // of the last picture; empty: it had none
};

// A picture as a camera sends it: YUYV with 4:2:2 samples of Rec.601, rows of stride_bytes. Error: fewer
// bytes than that takes.
Result<image::Image8> picture_from_yuyv(const std::uint8_t* bytes, std::size_t count, int width, int height,
                                        int stride_bytes);

} // namespace ghost::video
