// SPDX-License-Identifier: Apache-2.0
// A port is asked for overlapped; its handle() is an event that is set while bytes wait or the port is gone.
// Windows gives a port to one program alone. MIDI devices are no ports there (WinMM has them) and are not
// read.
#include "net/serial.h"

#include "net/private/system_sizes.h"
#include "net/private/winsock.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace ghost::dmx {

namespace {

constexpr DWORD kSend_ms = 50; // for what a driver does not take at once

// DEVPKEY_Device_BusReportedDeviceDesc: what a device calls itself, where its driver says "USB Serial Port".
constexpr DEVPROPKEY kSaysItself{
    {0x540b947e, 0x8b40, 0x45bc, {0xa8, 0xa2, 0x6a, 0x0b, 0x89, 0x4c, 0xbd, 0xa2}}, 4};
// GUID_DEVINTERFACE_COMPORT.
constexpr GUID kComPorts{0x86e0d1e0, 0x8089, 0x11d0, {0x9c, 0xe4, 0x08, 0x00, 0x3e, 0x30, 0x1f, 0x73}};

std::string why_port_not_opened(DWORD code) {
    if (code == ERROR_FILE_NOT_FOUND || code == ERROR_PATH_NOT_FOUND || code == ERROR_DEV_NOT_EXIST)
        return "is not plugged in";
    if (code == ERROR_ACCESS_DENIED || code == ERROR_SHARING_VIOLATION)
        return "is in use by another program; close it and try again";
    return "cannot be opened: " + windows_reason(code);
}

// "COM3" is a name of old; of higher numbers only the long one works.
std::wstring device_name(const std::string& path) {
    const bool is_plain = path.find_first_of("/\\:") == std::string::npos;
    return wide_text(is_plain ? "\\\\.\\" + path : path);
}

std::string lowered(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

} // namespace

struct SerialPort::Overlapped {
    HANDLE port = INVALID_HANDLE_VALUE;
    OVERLAPPED coming{}, reading{}, sending{};
    DWORD what = 0;

    ~Overlapped() {
        if (port != INVALID_HANDLE_VALUE) {
            ::CancelIoEx(port, nullptr);
            DWORD size = 0;
            (void)::GetOverlappedResult(port, &coming, &size, TRUE);
            ::CloseHandle(port);
        }
        for (const HANDLE event : {coming.hEvent, reading.hEvent, sending.hEvent})
            if (event != nullptr) ::CloseHandle(event);
    }
    // From now on its event tells of bytes. False: the port is gone.
    bool wait_again() {
        ::ResetEvent(coming.hEvent);
        what = 0;
        if (::WaitCommEvent(port, &what, &coming)) return true; // the event is set: bytes are there
        return ::GetLastError() == ERROR_IO_PENDING;
    }
};

SerialPort::SerialPort(int handle) : handle_(handle), buffer_(4096) {}

Result<std::unique_ptr<SerialPort>> SerialPort::open(const std::string& path) {
    auto state = std::make_unique<Overlapped>();
    state->port = ::CreateFileW(device_name(path).c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr,
                                OPEN_EXISTING, FILE_FLAG_OVERLAPPED, nullptr);
    if (state->port == INVALID_HANDLE_VALUE) return Error{why_port_not_opened(::GetLastError()), path};
    DCB settings{};
    settings.DCBlength = sizeof settings;
    if (!::GetCommState(state->port, &settings)) {
        ::CloseHandle(std::exchange(state->port, INVALID_HANDLE_VALUE));
        return Error{"is no serial port", path};
    }
    for (OVERLAPPED* one : {&state->coming, &state->reading, &state->sending})
        one->hEvent = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);
    settings = {};
    settings.DCBlength = sizeof settings;
    settings.BaudRate = CBR_57600;
    settings.fBinary = TRUE;
    settings.ByteSize = 8;
    settings.Parity = NOPARITY;
    settings.StopBits = ONESTOPBIT;
    settings.fDtrControl = DTR_CONTROL_ENABLE;
    settings.fRtsControl = RTS_CONTROL_ENABLE;
    COMMTIMEOUTS times{};
    times.ReadIntervalTimeout = MAXDWORD; // what is there, at once
    times.WriteTotalTimeoutConstant = kSend_ms;
    if (!::SetCommState(state->port, &settings) || !::SetCommTimeouts(state->port, &times) ||
        !::SetCommMask(state->port, EV_RXCHAR | EV_ERR))
        return Error{"cannot be set up: " + windows_reason(::GetLastError()), path};
    // What a widget sent before somebody listened is old.
    ::PurgeComm(state->port, PURGE_RXCLEAR);
    if (!state->wait_again()) return Error{"cannot be set up: " + windows_reason(::GetLastError()), path};
    std::unique_ptr<SerialPort> port(
        new SerialPort(static_cast<int>(reinterpret_cast<INT_PTR>(state->coming.hEvent))));
    port->overlapped_ = std::move(state);
    return port;
}

Result<std::unique_ptr<SerialPort>> SerialPort::open_midi(const std::string& path) {
    auto port = open(path);
    if (!port.ok() && port.error().what == "is no serial port")
        return Error{
            "is no MIDI port, expected a serial port like COM3: MIDI devices of Windows are not read", path};
    return port;
}

SerialPort::~SerialPort() = default;

std::optional<Bytes> SerialPort::receive() {
    Overlapped& state = *overlapped_;
    // First the wait for more, then what is there: so nothing comes in between.
    if (::WaitForSingleObject(state.coming.hEvent, 0) == WAIT_OBJECT_0) {
        DWORD size = 0;
        if (!::GetOverlappedResult(state.port, &state.coming, &size, FALSE)) return std::nullopt;
        if (!state.wait_again()) return std::nullopt;
    }
    DWORD count = 0;
    ::ResetEvent(state.reading.hEvent);
    if (!::ReadFile(state.port, buffer_.data(), static_cast<DWORD>(buffer_.size()), nullptr,
                    &state.reading) &&
        ::GetLastError() != ERROR_IO_PENDING)
        return std::nullopt;
    if (!::GetOverlappedResult(state.port, &state.reading, &count, TRUE)) return std::nullopt;
    // A full buffer may have left some, of which no event would tell.
    if (count == buffer_.size()) ::SetEvent(state.coming.hEvent);
    return Bytes(buffer_.data(), count);
}

bool SerialPort::send(Bytes bytes) {
    Overlapped& state = *overlapped_;
    DWORD count = 0;
    ::ResetEvent(state.sending.hEvent);
    if (!::WriteFile(state.port, bytes.data(), static_cast<DWORD>(bytes.size()), nullptr, &state.sending) &&
        ::GetLastError() != ERROR_IO_PENDING)
        return false;
    return ::GetOverlappedResult(state.port, &state.sending, &count, TRUE) && count == bytes.size();
}

// folder: Windows has none; it is asked what each port's device calls itself.
std::vector<std::string> list_usb_pro_ports(const std::filesystem::path& folder) {
    std::vector<std::string> result;
    if (folder != kSerialPortsById) return result;
    const HDEVINFO devices =
        ::SetupDiGetClassDevsW(&kComPorts, nullptr, nullptr, DIGCF_PRESENT | DIGCF_DEVICEINTERFACE);
    if (devices == INVALID_HANDLE_VALUE) return result;
    SP_DEVINFO_DATA device{};
    device.cbSize = sizeof device;
    for (DWORD k = 0; result.size() < kMostPorts && ::SetupDiEnumDeviceInfo(devices, k, &device); ++k) {
        std::array<wchar_t, 256> name{}, port{};
        DEVPROPTYPE type = 0;
        if (!::SetupDiGetDevicePropertyW(devices, &device, &kSaysItself, &type,
                                         reinterpret_cast<BYTE*>(name.data()),
                                         static_cast<DWORD>((name.size() - 1) * sizeof(wchar_t)), nullptr, 0))
            continue;
        std::string says = lowered(utf8_text(name.data()));
        std::replace(says.begin(), says.end(), ' ', '_');
        if (says.find("dmx_usb_pro") == std::string::npos) continue;
        const HKEY key = ::SetupDiOpenDevRegKey(devices, &device, DICS_FLAG_GLOBAL, 0, DIREG_DEV, KEY_READ);
        if (key == INVALID_HANDLE_VALUE) continue;
        auto size = static_cast<DWORD>((port.size() - 1) * sizeof(wchar_t));
        if (::RegQueryValueExW(key, L"PortName", nullptr, nullptr, reinterpret_cast<BYTE*>(port.data()),
                               &size) == ERROR_SUCCESS)
            result.push_back(utf8_text(port.data()));
        ::RegCloseKey(key);
    }
    ::SetupDiDestroyDeviceInfoList(devices);
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace ghost::dmx
