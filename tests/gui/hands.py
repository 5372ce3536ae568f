"""Quick hands: pointer and keys through the XTest extension, thousands of events a second, each with the time at
which it was sent. xdotool (desktop.py) is slower: a process an event."""
import ctypes
import ctypes.util
import time


class Hands:
    def __init__(self, display):
        self.x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        self.xtst = ctypes.CDLL(ctypes.util.find_library("Xtst"))
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))
        assert self.display, f"no display {display}"

    def close(self):
        self.x11.XCloseDisplay(self.display)

    def move(self, x, y):
        """Returns when it was sent: milliseconds of the monotonic clock."""
        now = time.monotonic() * 1000
        self.xtst.XTestFakeMotionEvent(self.display, -1, int(x), int(y), 0)
        self.x11.XFlush(self.display)
        return now

    def button(self, number, down):
        self.xtst.XTestFakeButtonEvent(self.display, number, int(down), 0)
        self.x11.XSync(self.display, 0)  # before any other program's events

    def key(self, name, down):
        code = self.x11.XKeysymToKeycode(self.display, ctypes.c_ulong(self.x11.XStringToKeysym(name.encode())))
        self.xtst.XTestFakeKeyEvent(self.display, code, int(down), 0)
        self.x11.XSync(self.display, 0)

    def tap(self, name, held=()):
        for key in held:
            self.key(key, True)
        self.key(name, True)
        self.key(name, False)
        for key in reversed(held):
            self.key(key, False)
        time.sleep(0.004)  # GLFW takes two presses in one millisecond for one
