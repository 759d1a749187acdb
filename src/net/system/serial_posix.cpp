// SPDX-License-Identifier: Apache-2.0
#include "net/serial.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

namespace ghost::dmx {

namespace {

constexpr int kMostInterrupts = 8;

std::string why_not_opened() {
    if (errno == EACCES)
        return "may not be opened; join the group that owns it: sudo usermod -aG dialout $USER, then log in "
               "again";
    if (errno == ENOENT || errno == ENXIO || errno == ENODEV) return "is not plugged in";
    return std::string("cannot be opened: ") + std::strerror(errno);
}

} // namespace

struct SerialPort::Overlapped {};

SerialPort::SerialPort(int handle) : handle_(handle), buffer_(4096) {}

Result<std::unique_ptr<SerialPort>> SerialPort::open(const std::string& path) {
    const int handle = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0) return Error{why_not_opened(), path};
    std::unique_ptr<SerialPort> port(new SerialPort(handle));
    termios settings{};
    if (tcgetattr(handle, &settings) != 0) return Error{"is no serial port", path};
    if (flock(handle, LOCK_EX | LOCK_NB) != 0)
        return Error{"is in use by another program; close it and try again", path};
    cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cc[VMIN] = 0;
    settings.c_cc[VTIME] = 0;
    cfsetispeed(&settings, B57600);
    cfsetospeed(&settings, B57600);
    if (tcsetattr(handle, TCSANOW, &settings) != 0)
        return Error{std::string("cannot be set up: ") + std::strerror(errno), path};
    // What a widget sent before somebody listened is old.
    tcflush(handle, TCIFLUSH);
    return port;
}

Result<std::unique_ptr<SerialPort>> SerialPort::open_midi(const std::string& path) {
    const int handle = ::open(path.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0) {
        if (errno == EACCES)
            return Error{
                "may not be opened; join the group that owns it: sudo usermod -aG audio $USER, then log "
                "in again",
                path};
        if (errno == EBUSY) return Error{"is in use by another program; close it and try again", path};
        return Error{why_not_opened(), path};
    }
    std::unique_ptr<SerialPort> port(new SerialPort(handle));
    struct stat what {};
    if (fstat(handle, &what) != 0 || !(S_ISCHR(what.st_mode) || S_ISFIFO(what.st_mode)))
        return Error{"is no MIDI port, expected a device like /dev/snd/midiC1D0", path};
    termios settings{};
    if (tcgetattr(handle, &settings) == 0) {
        cfmakeraw(&settings);
        (void)tcsetattr(handle, TCSANOW, &settings);
    }
    return port;
}

SerialPort::~SerialPort() {
    close(handle_);
}

std::optional<Bytes> SerialPort::receive() {
    for (int tries = 0; tries < kMostInterrupts; ++tries) {
        const ssize_t count = ::read(handle_, buffer_.data(), buffer_.size());
        if (count > 0) return Bytes(buffer_.data(), static_cast<std::size_t>(count));
        if (count < 0 && errno == EAGAIN) return Bytes();
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        // 0 is "nothing yet" of a serial port and "hung up" of one that was pulled out.
        pollfd entry{handle_, POLLIN, 0};
        if (poll(&entry, 1, 0) > 0 && (entry.revents & (POLLHUP | POLLERR | POLLNVAL))) return std::nullopt;
        return Bytes();
    }
    return Bytes();
}

bool SerialPort::send(Bytes bytes) {
    for (int tries = 0; tries < kMostInterrupts && !bytes.empty(); ++tries) {
        const ssize_t count = ::write(handle_, bytes.data(), bytes.size());
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
        if (count < 0 && errno != EINTR) return false;
    }
    return bytes.empty();
}

} // namespace ghost::dmx
