// SPDX-License-Identifier: Apache-2.0
// Video4Linux 2, streaming with memory that the driver shares (kernel documentation, "Streaming I/O (Memory
// Mapping)").
#include "video/private/camera.h"

#include "base/byte_reader.h"
#include "image/ldr.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace ghost::video {
namespace {

constexpr std::uint32_t kBuffers = 4;
constexpr std::uint32_t kCameraWidth = 1280; // asked for; the driver takes the nearest it has
constexpr std::uint32_t kCameraHeight = 720;
constexpr int kTries = 40; // of 5 ms

int call(int device, unsigned long request, void* argument) {
    int result = 0;
    do result = ::ioctl(device, request, argument);
    while (result < 0 && errno == EINTR);
    return result;
}

// Opening alone does something to many a device: a serial port resets what hangs on it, a tape rewinds.
bool is_video_device(const struct stat& status) {
    constexpr unsigned kVideoMajor = 81; // Linux, Documentation/admin-guide/devices.txt
    return S_ISCHR(status.st_mode) && major(status.st_rdev) == kVideoMajor;
}

} // namespace

struct Camera::Device {
    std::string name;
    int file = -1;
    std::vector<std::pair<void*, std::size_t>> buffers;
    v4l2_format format{};
    bool streaming = false;

    ~Device() {
        v4l2_buf_type type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        if (streaming) call(file, VIDIOC_STREAMOFF, &type);
        for (const auto& [memory, bytes] : buffers) ::munmap(memory, bytes);
        if (file >= 0) ::close(file);
    }
    Error failed(const std::string& what) const { return Error{what + ": " + std::strerror(errno), name}; }
    Result<void> choose_format();
    Result<void> map_buffers();
    Result<image::Image8> decode(const std::uint8_t* bytes, std::size_t count) const;
};

Result<void> Camera::Device::choose_format() {
    v4l2_capability can{};
    if (call(file, VIDIOC_QUERYCAP, &can) < 0)
        return failed(errno == ENODEV ? "the camera is gone" : "is not a camera");
    const std::uint32_t has = can.capabilities & V4L2_CAP_DEVICE_CAPS ? can.device_caps : can.capabilities;
    if (!(has & V4L2_CAP_VIDEO_CAPTURE) || !(has & V4L2_CAP_STREAMING))
        return Error{"sends no pictures, expected a device that captures and streams", name};
    for (const std::uint32_t wanted : {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}) {
        format = {};
        format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        format.fmt.pix.width = kCameraWidth;
        format.fmt.pix.height = kCameraHeight;
        format.fmt.pix.pixelformat = wanted;
        format.fmt.pix.field = V4L2_FIELD_ANY;
        const bool taken = call(file, VIDIOC_S_FMT, &format) == 0;
        if (!taken && errno == EBUSY) return Error{"is in use by another program", name};
        if (taken && format.fmt.pix.pixelformat == wanted) return {};
    }
    return Error{"has neither Motion JPEG nor YUYV", name};
}

Result<void> Camera::Device::map_buffers() {
    v4l2_requestbuffers request{};
    request.count = kBuffers;
    request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request.memory = V4L2_MEMORY_MMAP;
    if (call(file, VIDIOC_REQBUFS, &request) < 0)
        return failed("gives no memory for pictures (another program may use it)");
    for (std::uint32_t k = 0; k < request.count; ++k) {
        v4l2_buffer buffer{};
        buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        buffer.memory = V4L2_MEMORY_MMAP;
        buffer.index = k;
        if (call(file, VIDIOC_QUERYBUF, &buffer) < 0) return failed("has no memory for pictures");
        void* memory =
            ::mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, file, buffer.m.offset);
        if (memory == MAP_FAILED) return failed("has no memory for pictures");
        buffers.emplace_back(memory, buffer.length);
        if (call(file, VIDIOC_QBUF, &buffer) < 0) return failed("takes no memory for pictures");
    }
    v4l2_buf_type type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (call(file, VIDIOC_STREAMON, &type) < 0) return failed("does not begin to send");
    streaming = true;
    return {};
}

Result<image::Image8> Camera::Device::decode(const std::uint8_t* bytes, std::size_t count) const {
    const v4l2_pix_format& pixels = format.fmt.pix;
    if (pixels.pixelformat == V4L2_PIX_FMT_MJPEG) {
        std::string damage; // not said: some cameras leave rubbish in every picture, and the next one is near
        return image::decode_ldr(Bytes(bytes, count), name, {}, &damage);
    }
    return picture_from_yuyv(bytes, count, static_cast<int>(pixels.width), static_cast<int>(pixels.height),
                             static_cast<int>(pixels.bytesperline));
}

Result<std::unique_ptr<Camera>> Camera::open(const std::filesystem::path& path) {
    auto device = std::make_unique<Device>();
    device->name = path.string();
    const Error other{"is no video device, expected one such as /dev/video0", path.string()};
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && !is_video_device(status)) return other;
    // To write as well, as the interface wants it ("Opening and Closing Devices").
    device->file = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (device->file < 0 && errno == EACCES)
        return Error{"you may not open this camera; on most systems members of the group 'video' may",
                     path.string()};
    if (device->file < 0) return device->failed("cannot be opened as a camera");
    if (::fstat(device->file, &status) != 0 || !is_video_device(status)) return other;
    TRY_VOID(device->choose_format());
    TRY_VOID(device->map_buffers());
    return std::unique_ptr<Camera>(new Camera(std::move(device)));
}

Camera::Camera(std::unique_ptr<Device> device) : device_(std::move(device)) {}
Camera::~Camera() = default;

Result<std::optional<image::Image8>> Camera::next() {
    for (int attempt = 0; attempt < kTries; ++attempt) {
        v4l2_buffer buffer{};
        buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        buffer.memory = V4L2_MEMORY_MMAP;
        if (call(device_->file, VIDIOC_DQBUF, &buffer) < 0) {
            if (errno != EAGAIN) return device_->failed("the camera is gone");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            continue;
        }
        Result<image::Image8> picture = Error{"the device calls them damaged", device_->name};
        if (buffer.index < device_->buffers.size() && !(buffer.flags & V4L2_BUF_FLAG_ERROR)) {
            const auto& [memory, bytes] = device_->buffers[buffer.index];
            picture = device_->decode(static_cast<const std::uint8_t*>(memory),
                                      std::min<std::size_t>(buffer.bytesused, bytes));
        }
        if (call(device_->file, VIDIOC_QBUF, &buffer) < 0) return device_->failed("the camera is gone");
        damage_ = picture.ok() ? "" : picture.error().text();
        if (picture.ok()) return std::optional(std::move(*picture));
        // A picture that was damaged on its way: the next one.
    }
    return std::optional<image::Image8>();
}

Error Camera::silence() const {
    return Error{damage_.empty() ? "sends no pictures" : "sends pictures that cannot be read: " + damage_,
                 device_->name};
}

} // namespace ghost::video
