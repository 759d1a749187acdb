// SPDX-License-Identifier: Apache-2.0
// A Video4Linux camera for programs that load this library before all others (LD_PRELOAD): most machines have
// neither a camera nor a kernel module that acts as one. $FAKE_CAMERA is the path of its device, a link to
// /dev/null that is there while the camera is plugged in; $FAKE_CAMERA_DOES a file with what it does now:
//     yuyv Y U V   sends pictures of one colour, 25 a second
//     jpeg FILE    sends this file
//     silent       sends nothing
//     short        sends pictures that end early
//     grey         has a format that nobody asked for
//     busy         is used by another program
//     gone         has been pulled out, though its device is still there
#include <cerrno>
#include <chrono>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <dlfcn.h>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <linux/videodev2.h>
#include <mutex>
#include <sstream>
#include <string>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include <vector>

namespace {

constexpr std::uint32_t kWidth = 64, kHeight = 48;
constexpr std::uint32_t kBytes = 1u << 16; // of a buffer: more than a picture, whole pages
constexpr std::chrono::milliseconds kPeriod{40};

template <class F>
F* next_of(const char* name) {
    return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}

std::string setting(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

struct Does {
    std::string what;
    std::istringstream rest;
};

Does does() {
    std::ifstream file(setting("FAKE_CAMERA_DOES"));
    std::string line;
    std::getline(file, line);
    Does now{"", std::istringstream(line)};
    now.rest >> now.what;
    return now;
}

class Device {
public:
    bool is_plugged_in(const Does& now) const {
        return now.what != "gone" && ::access(setting("FAKE_CAMERA").c_str(), F_OK) == 0;
    }
    int answer(unsigned long request, void* argument);
    void* share(std::size_t bytes, off_t offset);
    void close() {
        buffers_.clear();
        waiting_.clear();
    }

private:
    int capability(v4l2_capability& can) const;
    int format(v4l2_format& format);
    int take(v4l2_buffer& buffer, Does& now);

    std::vector<void*> buffers_;
    std::deque<std::uint32_t> waiting_;
    std::uint32_t pixels_ = V4L2_PIX_FMT_YUYV;
    std::chrono::steady_clock::time_point last_{};
};

int failed(int error) {
    errno = error;
    return -1;
}

int Device::capability(v4l2_capability& can) const {
    std::strcpy(reinterpret_cast<char*>(can.card), "fake camera");
    can.capabilities = can.device_caps = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    return 0;
}

// Another format than was asked for is taken, as the interface has it, not refused.
int Device::format(v4l2_format& format) {
    const Does now = does();
    if (now.what == "busy") return failed(EBUSY);
    pixels_ = now.what == "grey"   ? V4L2_PIX_FMT_GREY
              : now.what == "jpeg" ? V4L2_PIX_FMT_MJPEG
                                   : V4L2_PIX_FMT_YUYV;
    format.fmt.pix.pixelformat = pixels_;
    format.fmt.pix.width = kWidth;
    format.fmt.pix.height = kHeight;
    format.fmt.pix.bytesperline = 2 * kWidth;
    format.fmt.pix.sizeimage = kBytes;
    return 0;
}

int Device::take(v4l2_buffer& buffer, Does& now) {
    const auto at = std::chrono::steady_clock::now();
    if (waiting_.empty() || now.what == "silent" || at - last_ < kPeriod) return failed(EAGAIN);
    last_ = at;
    buffer.index = waiting_.front();
    waiting_.pop_front();
    auto* const bytes = static_cast<std::uint8_t*>(buffers_[buffer.index]);
    if (now.what == "jpeg") {
        std::string name;
        now.rest >> name;
        std::ifstream file(name, std::ios::binary);
        const std::string jpeg{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        buffer.bytesused = static_cast<std::uint32_t>(jpeg.size());
        std::memcpy(bytes, jpeg.data(), jpeg.size() < kBytes ? jpeg.size() : kBytes);
        return 0;
    }
    unsigned y = 16, u = 128, v = 128;
    now.rest >> y >> u >> v;
    for (std::uint32_t k = 0; k < 2 * kWidth * kHeight; ++k)
        bytes[k] = static_cast<std::uint8_t>(k % 2 == 0 ? y : k % 4 == 1 ? u : v);
    buffer.bytesused = now.what == "short" ? 100 : 2 * kWidth * kHeight;
    return 0;
}

int Device::answer(unsigned long request, void* argument) {
    Does now = does();
    if (!is_plugged_in(now)) return failed(ENODEV);
    auto& buffer = *static_cast<v4l2_buffer*>(argument);
    switch (request) {
    case VIDIOC_QUERYCAP:
        return capability(*static_cast<v4l2_capability*>(argument));
    case VIDIOC_S_FMT:
        return format(*static_cast<v4l2_format*>(argument));
    case VIDIOC_REQBUFS:
        buffers_.assign(static_cast<v4l2_requestbuffers*>(argument)->count, nullptr);
        waiting_.clear();
        return 0;
    case VIDIOC_QUERYBUF:
        if (buffer.index >= buffers_.size()) return failed(EINVAL);
        buffer.length = kBytes;
        buffer.m.offset = kBytes * buffer.index;
        return 0;
    case VIDIOC_QBUF:
        if (buffer.index >= buffers_.size()) return failed(EINVAL);
        waiting_.push_back(buffer.index);
        return 0;
    case VIDIOC_DQBUF:
        return take(buffer, now);
    case VIDIOC_STREAMON:
    case VIDIOC_STREAMOFF:
        return 0;
    default:
        return failed(ENOTTY);
    }
}

void* Device::share(std::size_t bytes, off_t offset) {
    const auto index = static_cast<std::size_t>(offset) / kBytes;
    if (index >= buffers_.size() || bytes != kBytes) {
        errno = EINVAL;
        return MAP_FAILED;
    }
    return buffers_[index] = next_of<decltype(::mmap)>("mmap")(nullptr, bytes, PROT_READ | PROT_WRITE,
                                                               MAP_SHARED | MAP_ANONYMOUS, -1, 0);
}

std::mutex mutex;
Device device;
int device_file = -1;

} // namespace

extern "C" int open(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;
    va_end(more);
    const int file = next_of<int(const char*, int, mode_t)>("open")(path, flags, mode);
    if (file >= 0 && setting("FAKE_CAMERA") == path) {
        const std::scoped_lock lock(mutex);
        device_file = file;
    }
    return file;
}

// What the driver is: a video device.
static void pass_for_video(struct stat* status) {
    status->st_mode = (status->st_mode & ~static_cast<mode_t>(S_IFMT)) | S_IFCHR;
    status->st_rdev = makedev(81, 0);
}

extern "C" int stat(const char* path, struct stat* status) {
    const int result = next_of<int(const char*, struct stat*)>("stat")(path, status);
    if (result == 0 && setting("FAKE_CAMERA") == path) pass_for_video(status);
    return result;
}

extern "C" int fstat(int file, struct stat* status) {
    const int result = next_of<int(int, struct stat*)>("fstat")(file, status);
    const std::scoped_lock lock(mutex);
    if (result == 0 && file == device_file && file >= 0) pass_for_video(status);
    return result;
}

extern "C" int close(int file) {
    {
        const std::scoped_lock lock(mutex);
        if (file == device_file && file >= 0) {
            device.close();
            device_file = -1;
        }
    }
    return next_of<int(int)>("close")(file);
}

extern "C" int ioctl(int file, unsigned long request, ...) noexcept {
    va_list more;
    va_start(more, request);
    void* const argument = va_arg(more, void*);
    va_end(more);
    {
        const std::scoped_lock lock(mutex);
        if (file == device_file && file >= 0) return device.answer(request, argument);
    }
    return next_of<int(int, unsigned long, ...)>("ioctl")(file, request, argument);
}

extern "C" void* mmap(void* address, std::size_t bytes, int access, int flags, int file,
                      off_t offset) noexcept {
    if (file >= 0) {
        const std::scoped_lock lock(mutex);
        if (file == device_file) return device.share(bytes, offset);
    }
    return next_of<decltype(::mmap)>("mmap")(address, bytes, access, flags, file, offset);
}
