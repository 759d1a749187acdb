#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two Enttec DMX USB Pro widgets joined by a DMX cable, without any hardware: pseudo-terminals that speak their protocol.

What a desk sends through the first one (label 6) goes along the cable again and again, as DMX does, and comes out of the second
one as frames (label 5), or as changes (label 9) after its host asked for them (label 8). Both answer labels 3 and 10. Signals: USR1 pulls the second one's plug and the next USR1 puts it back,
USR2 makes it send changes whatever its host asked for, HUP makes every tenth byte a bad one until the next HUP.

Usage: usb_pro_widget.py DESK_PORT HOST_PORT      links to make, like /tmp/x/ttyUSB0 /tmp/x/ttyUSB1; runs until it is ended
"""
import os
import select
import signal
import sys
import time
import tty

START, END, MOST_DATA = 0x7E, 0xE7, 600
PARAMETERS, RECEIVED, SEND, RECEIVE_MODE, CHANGES, SERIAL = 3, 5, 6, 8, 9, 10
BLOCK = 40  # bytes that one message of changes speaks of
REPEAT_S = 0.025


class Widget:
    def __init__(self, link, serial):
        self.link, self.serial = link, serial
        self.only_changes = False
        self.plug_in()

    def plug_in(self):
        self.host, terminal = os.openpty()
        tty.setraw(terminal)
        os.set_blocking(self.host, False)
        os.chmod(os.ttyname(terminal), 0o666)
        self.terminal = terminal  # kept open, or the host's side hangs up with its first user
        if os.path.lexists(self.link):
            os.unlink(self.link)
        os.symlink(os.ttyname(terminal), self.link)
        self.pending, self.line = bytearray(), bytes(513)

    def pull_out(self):
        os.close(self.host)
        os.close(self.terminal)
        os.unlink(self.link)
        self.host = None

    def tell(self, label, data, damage=False):
        message = bytearray([START, label, len(data) & 255, len(data) >> 8]) + data + bytes([END])
        if damage:
            message[::10] = bytes(len(message[::10]))
        try:
            os.write(self.host, message)
        except BlockingIOError:
            pass  # nobody reads: a widget has no more room either

    def hear(self):
        """Messages of the host that are complete, as (label, data)."""
        try:
            self.pending += os.read(self.host, 65536)
        except BlockingIOError:
            pass
        while True:
            start = self.pending.find(START)
            del self.pending[:start if start >= 0 else len(self.pending)]
            if len(self.pending) < 4:
                return
            size = int.from_bytes(self.pending[2:4], 'little')
            whole = size + 5
            if size > MOST_DATA or (len(self.pending) >= whole and self.pending[whole - 1] != END):
                del self.pending[0]
            elif len(self.pending) < whole:
                return
            else:
                message = self.pending[1], bytes(self.pending[4:whole - 1])
                del self.pending[:whole]
                yield message

    def answer(self, label, data):
        if label == PARAMETERS:
            self.tell(PARAMETERS, bytes([44, 1, 9, 1, 40]))  # firmware 1.44, timing
        elif label == SERIAL:
            self.tell(SERIAL, bytes.fromhex(self.serial)[::-1])
        elif label == RECEIVE_MODE:
            self.only_changes = data[:1] == b'\1'
            self.line = bytes(513)

    def receive_dmx(self, line, damage):
        """line: start code and slots, as they come along the cable."""
        before, self.line = self.line, line.ljust(513, b'\0')
        if not self.only_changes:
            self.tell(RECEIVED, b'\0' + line, damage)
            return
        for first in range(0, 513, BLOCK):
            changed = [i for i in range(first, min(first + BLOCK, 513)) if self.line[i] != before[i]]
            bits = sum(1 << (i - first) for i in changed)
            if changed:
                self.tell(CHANGES, bytes([first // 8]) + bits.to_bytes(5, 'little') + bytes(self.line[i] for i in changed), damage)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    desk, host = Widget(sys.argv[1], '12345678'), Widget(sys.argv[2], '00000042')
    state = {'plugged': True, 'changes': False, 'damage': False}

    def toggle(name):
        def change(_signal, _frame):
            state[name] = not state[name]
        return change
    for number, name in ((signal.SIGUSR1, 'plugged'), (signal.SIGUSR2, 'changes'), (signal.SIGHUP, 'damage')):
        signal.signal(number, toggle(name))
    print('ready', flush=True)
    cable, due = None, 0.0  # what the desk sent last
    while True:
        if state['plugged'] != (host.host is not None):
            host.plug_in() if state['plugged'] else host.pull_out()
        select.select([w.host for w in (desk, host) if w.host is not None], [], [], REPEAT_S)
        for label, data in desk.hear():
            desk.answer(label, data)
            if label == SEND:
                cable, due = data, 0.0
        if host.host is None:
            continue
        for message in host.hear():
            host.answer(*message)
        if cable is not None and time.monotonic() >= due:
            due = time.monotonic() + REPEAT_S
            host.only_changes |= state['changes']
            host.receive_dmx(cable, state['damage'])


main()
