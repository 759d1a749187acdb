# SPDX-License-Identifier: Apache-2.0
"""Files dropped on a window as a file manager does it: the source of a drag by the XDND protocol (freedesktop.org, version 5), by Xlib alone.
drop() returns what the window answered to the position and to the drop: whether it takes them, and whether it took them."""
import ctypes
import time
from ctypes import POINTER, Structure, Union, byref, c_char_p, c_int, c_long, c_ubyte, c_ulong, c_void_p
from pathlib import Path

SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 30, 31, 33
VERSION, LATEST_S = 5, 60
HEAD = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p)]


class Message(Structure):
    _fields_ = [*HEAD, ("window", c_ulong), ("message_type", c_ulong), ("format", c_int), ("data", c_long * 5)]


class Request(Structure):
    _fields_ = [*HEAD, ("owner", c_ulong), ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong), ("property", c_ulong), ("time", c_ulong)]


class Answer(Structure):
    _fields_ = [*HEAD, ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong), ("property", c_ulong), ("time", c_ulong)]


class Event(Union):
    _fields_ = [("type", c_int), ("message", Message), ("request", Request), ("answer", Answer), ("room", c_long * 24)]


X = ctypes.CDLL("libX11.so.6")
X.XOpenDisplay.restype, X.XOpenDisplay.argtypes = c_void_p, [c_char_p]
X.XDefaultRootWindow.restype, X.XDefaultRootWindow.argtypes = c_ulong, [c_void_p]
X.XCreateSimpleWindow.restype, X.XCreateSimpleWindow.argtypes = c_ulong, [c_void_p, c_ulong, *[c_int] * 5, c_ulong, c_ulong]
X.XInternAtom.restype, X.XInternAtom.argtypes = c_ulong, [c_void_p, c_char_p, c_int]
X.XSetSelectionOwner.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong]
X.XSendEvent.argtypes = [c_void_p, c_ulong, c_int, c_long, POINTER(Event)]
X.XNextEvent.argtypes = [c_void_p, POINTER(Event)]
X.XPending.argtypes = X.XFlush.argtypes = X.XCloseDisplay.argtypes = [c_void_p]
X.XChangeProperty.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong, c_int, c_int, c_char_p, c_int]
X.XGetWindowProperty.argtypes = [c_void_p, c_ulong, c_ulong, c_long, c_long, c_int, c_ulong, *[c_void_p] * 5]
X.XTranslateCoordinates.argtypes = [c_void_p, c_ulong, c_ulong, c_int, c_int, POINTER(c_int), POINTER(c_int), POINTER(c_ulong)]
X.XFree.argtypes = [c_void_p]


class Source:
    def __init__(self, display, words):
        self.display = X.XOpenDisplay(display.encode())
        self.words = words
        self.root = X.XDefaultRootWindow(self.display)
        self.window = X.XCreateSimpleWindow(self.display, self.root, 0, 0, 1, 1, 0, 0, 0)
        self.selection, self.types = self.atom("XdndSelection"), self.atom("text/uri-list")
        X.XSetSelectionOwner(self.display, self.selection, self.window, 0)

    def atom(self, name):
        return X.XInternAtom(self.display, name.encode(), 0)

    def is_aware(self, window):
        kind, form, count, left, value = c_ulong(), c_int(), c_ulong(), c_ulong(), POINTER(c_ubyte)()
        X.XGetWindowProperty(self.display, window, self.atom("XdndAware"), 0, 1, 0, 0, *[ctypes.addressof(one) for one in (kind, form, count, left, value)])
        X.XFree(ctypes.cast(value, c_void_p))
        return count.value > 0

    def target(self, x, y):
        """The window there, on the screen, that takes drops."""
        window, child, left, top = self.root, c_ulong(), c_int(), c_int()
        while not self.is_aware(window):
            X.XTranslateCoordinates(self.display, self.root, window, x, y, byref(left), byref(top), byref(child))
            if not child.value:
                raise AssertionError(f"no window at {x}, {y} takes drops")
            window = child.value
        return window

    def send(self, window, name, *data):
        event = Event()
        event.message.type, event.message.window, event.message.format = CLIENT_MESSAGE, window, 32
        event.message.message_type = self.atom(name)
        event.message.data[:] = [self.window, *data, *[0] * (4 - len(data))]
        X.XSendEvent(self.display, window, 0, 0, byref(event))
        X.XFlush(self.display)

    def serve(self, asked):
        """Puts the list of files where the window asked for it."""
        has_it = asked.target == self.types
        if has_it:
            X.XChangeProperty(self.display, asked.requestor, asked.property, asked.target, 8, 0, self.words, len(self.words))
        event = Event()
        event.answer.type, event.answer.requestor, event.answer.selection = SELECTION_NOTIFY, asked.requestor, asked.selection
        event.answer.target, event.answer.property, event.answer.time = asked.target, asked.property if has_it else 0, asked.time
        X.XSendEvent(self.display, asked.requestor, 0, 0, byref(event))
        X.XFlush(self.display)

    def until(self, name):
        """Waits for that message of the window; meanwhile it is served. Returns whether it says yes."""
        event, latest_s = Event(), time.monotonic() + LATEST_S
        while time.monotonic() < latest_s:
            if not X.XPending(self.display):
                time.sleep(0.01)
                continue
            X.XNextEvent(self.display, byref(event))
            if event.type == SELECTION_REQUEST:
                self.serve(event.request)
            elif event.type == CLIENT_MESSAGE and event.message.message_type == self.atom(name):
                return bool(event.message.data[1] & 1)
        raise AssertionError(f"the window does not answer with {name}")


def drop(display, x, y, *files):
    """x, y: of the screen."""
    source = Source(display, "".join(Path(file).as_uri() + "\r\n" for file in files).encode())
    try:
        window = source.target(x, y)
        source.send(window, "XdndEnter", VERSION << 24, source.types)
        source.send(window, "XdndPosition", 0, x << 16 | y, 0, source.atom("XdndActionCopy"))
        takes = source.until("XdndStatus")
        if not takes:
            source.send(window, "XdndLeave")
            return False, False
        source.send(window, "XdndDrop", 0, 0)
        return True, source.until("XdndFinished")
    finally:
        X.XCloseDisplay(source.display)
