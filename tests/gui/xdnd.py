"""xdnd.py -- drops a file on a window, as a file manager does (the XDND protocol, version 5)."""
import ctypes
import ctypes.util
import pathlib
import time

ID = ctypes.c_ulong  # windows, atoms, times
CURRENT_TIME, REPLACE, SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 0, 0, 30, 31, 33


class Message(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ID), ("sent", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ID), ("kind", ID),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5)]


class Request(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ID), ("sent", ctypes.c_int),
                ("display", ctypes.c_void_p), ("owner", ID), ("requestor", ID), ("selection", ID),
                ("target", ID), ("property", ID), ("time", ID)]


class Notice(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ID), ("sent", ctypes.c_int),
                ("display", ctypes.c_void_p), ("requestor", ID), ("selection", ID),
                ("target", ID), ("property", ID), ("time", ID)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("message", Message), ("request", Request),
                ("notice", Notice), ("pad", ctypes.c_long * 24)]


def drop(display_name, window, path, patience=90):
    """Drops `path` in the middle of the window; returns when the window has taken it."""
    x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XInternAtom.restype = x11.XCreateSimpleWindow.restype = ID
    x11.XDefaultRootWindow.restype = ID
    display = ctypes.c_void_p(x11.XOpenDisplay(display_name.encode()))
    assert display, f"no display {display_name}"

    def atom(name):
        return x11.XInternAtom(display, name.encode(), 0)

    def send(kind, *data):
        event = Event(message=Message(CLIENT_MESSAGE, 0, 1, display, window, atom(kind), 32,
                                      (ctypes.c_long * 5)(source, *data)))
        x11.XSendEvent(display, ID(window), 0, ctypes.c_long(0), ctypes.byref(event))
        x11.XFlush(display)

    def answer(request):
        text = (pathlib.Path(path).as_uri() + "\r\n").encode()
        x11.XChangeProperty(display, ID(request.requestor), ID(request.property),
                            ID(request.target), 8, REPLACE, text, len(text))
        event = Event(notice=Notice(SELECTION_NOTIFY, 0, 1, display, request.requestor,
                                    request.selection, request.target, request.property,
                                    request.time))
        x11.XSendEvent(display, ID(request.requestor), 0, ctypes.c_long(0), ctypes.byref(event))
        x11.XFlush(display)

    source = x11.XCreateSimpleWindow(display, ID(x11.XDefaultRootWindow(display)), 0, 0, 1, 1, 0,
                                     ID(0), ID(0))
    x11.XSetSelectionOwner(display, ID(atom("XdndSelection")), ID(source), ID(CURRENT_TIME))
    send("XdndEnter", 5 << 24, atom("text/uri-list"), 0, 0)
    send("XdndPosition", 0, 640 << 16 | 360, CURRENT_TIME, atom("XdndActionCopy"))
    accepted, event, end = False, Event(), time.monotonic() + patience
    while time.monotonic() < end:
        if not x11.XPending(display):
            time.sleep(0.02)
            continue
        x11.XNextEvent(display, ctypes.byref(event))
        if event.type == SELECTION_REQUEST:
            answer(event.request)
        elif event.type == CLIENT_MESSAGE and event.message.kind == atom("XdndStatus"):
            assert event.message.data[1] & 1, "the window does not want the file"
            if not accepted:
                accepted = True
                send("XdndDrop", 0, CURRENT_TIME, 0, 0)
        elif event.type == CLIENT_MESSAGE and event.message.kind == atom("XdndFinished"):
            x11.XCloseDisplay(display)
            return
    raise AssertionError(f"the window has not taken the file in {patience} s")
