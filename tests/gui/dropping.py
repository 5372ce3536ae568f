"""Files dragged from another program and dropped on a window: the X drag-and-drop protocol (XDND, version 5), its
source's side."""
import ctypes
import ctypes.util
import time
from pathlib import Path

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
VERSION, PATIENCE_S = 5, 30
LONG = ctypes.c_long


class Message(ctypes.Structure):  # XClientMessageEvent
    _fields_ = [("type", ctypes.c_int), ("serial", LONG), ("sent", ctypes.c_int), ("display", ctypes.c_void_p),
                ("window", LONG), ("kind", LONG), ("format", ctypes.c_int), ("data", LONG * 5)]


class Request(ctypes.Structure):  # XSelectionRequestEvent
    _fields_ = [("type", ctypes.c_int), ("serial", LONG), ("sent", ctypes.c_int), ("display", ctypes.c_void_p),
                ("owner", LONG), ("requestor", LONG), ("selection", LONG), ("target", LONG), ("property", LONG),
                ("time", LONG)]


class Answer(ctypes.Structure):  # XSelectionEvent
    _fields_ = [("type", ctypes.c_int), ("serial", LONG), ("sent", ctypes.c_int), ("display", ctypes.c_void_p),
                ("requestor", LONG), ("selection", LONG), ("target", LONG), ("property", LONG), ("time", LONG)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("message", Message), ("request", Request), ("answer", Answer),
                ("pad", LONG * 24)]


def drop(display_name, window, paths):
    """Returns when the window has taken them."""
    x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = x11.XDefaultRootWindow.restype = x11.XCreateSimpleWindow.restype = LONG
    display = ctypes.c_void_p(x11.XOpenDisplay(display_name.encode()))
    assert display, f"no display {display_name}"
    window = int(window)

    def atom(name):
        return x11.XInternAtom(display, name.encode(), 0)

    source = x11.XCreateSimpleWindow(display, LONG(x11.XDefaultRootWindow(display)), 0, 0, 1, 1, 0, LONG(0), LONG(0))
    x11.XSetSelectionOwner(display, LONG(atom("XdndSelection")), LONG(source), LONG(0))
    contents = "".join(Path(path).as_uri() + "\r\n" for path in paths).encode()

    def send(to, event):
        x11.XSendEvent(display, LONG(to), 0, LONG(0), ctypes.byref(event))
        x11.XFlush(display)

    def tell(kind, *data):
        event = Event()
        event.message = Message(CLIENT_MESSAGE, 0, 1, display, window, atom(kind), 32, (LONG * 5)(source, *data))
        send(window, event)

    tell("XdndEnter", VERSION << 24, atom("text/uri-list"))
    tell("XdndPosition", 0, 300 << 16 | 300, 0, atom("XdndActionCopy"))
    tell("XdndDrop", 0, 0)
    deadline, event = time.monotonic() + PATIENCE_S, Event()
    while time.monotonic() < deadline:
        if not x11.XPending(display):
            time.sleep(0.02)
            continue
        x11.XNextEvent(display, ctypes.byref(event))
        if event.type == SELECTION_REQUEST:
            asked = event.request
            x11.XChangeProperty(display, LONG(asked.requestor), LONG(asked.property), LONG(asked.target), 8, 0, contents,
                                len(contents))
            reply = Event()
            reply.answer = Answer(SELECTION_NOTIFY, 0, 1, display, asked.requestor, asked.selection, asked.target,
                                  asked.property, asked.time)
            send(asked.requestor, reply)
        elif event.type == CLIENT_MESSAGE and event.message.kind == atom("XdndFinished"):
            x11.XCloseDisplay(display)
            return
    raise AssertionError("the window did not take what was dropped")
