"""A display of its own for a test of the window: Xvfb, the program in it, and hands made of xdotool."""
import json
import os
import shutil
import struct
import subprocess
import sys
import time

PATIENCE_S = 90  # on a loaded machine the first picture waits for a compiler
SKIPPED = 77


def wait_for(what, condition):
    deadline = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline:
        result = condition()
        if result:
            return result
        time.sleep(0.1)
    raise AssertionError(f"waited {PATIENCE_S} s for {what}")


class Screen:
    """Pixels of the display, read from Xvfb's frame buffer file (XWD, 32 bits a pixel)."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        header = struct.unpack(">25I", data[:100])
        self.row_bytes = header[12]
        start = header[0] + 12 * header[19]
        self.pixels = data[start:]

    def box(self, x0, y0, x1, y1):
        rows = [self.pixels[y * self.row_bytes + 4 * x0:y * self.row_bytes + 4 * x1] for y in range(y0, y1)]
        return b"".join(rows)


def difference(a, b, box):
    """Mean absolute difference of the bytes in a box, 0 to 255."""
    first, second = a.box(*box), b.box(*box)
    return sum(abs(x - y) for x, y in zip(first, second)) / len(first)


class Desktop:
    def __init__(self, folder, width=900, height=600):
        self.width, self.height = width, height
        for tool in ("Xvfb", "xdotool"):
            if not shutil.which(tool):
                print(f"skipped: {tool} is not installed")
                sys.exit(SKIPPED)
        self.buffer = os.path.join(folder, "buffer")
        os.mkdir(self.buffer)
        reader, writer = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{width}x{height}x24", "-fbdir",
             self.buffer, "-nolisten", "tcp", "-noreset"], pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as pipe:
            self.display = ":" + pipe.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()

    def screen(self):
        return Screen(os.path.join(self.buffer, "Xvfb_screen0"))

    def settled_screen(self):
        """A screen that shows a lit object and hardly changes any more. Messages stand below the box."""
        box = (60, 50, 560, 460)
        last = [self.screen()]

        def is_still():
            time.sleep(1)
            now = self.screen()
            before, last[0] = last[0], now
            pixels = now.box(*box)
            lit = sum(value > 120 for value in pixels) > len(pixels) / 50
            return lit and difference(before, now, box) < 0.15 and now

        return wait_for("the picture to come to rest", is_still)

    def do(self, *command):
        subprocess.run(["xdotool", *map(str, command)], check=True, env={**os.environ, "DISPLAY": self.display},
                       stdout=subprocess.DEVNULL)

    def key(self, name):
        self.do("key", name)
        time.sleep(0.3)

    def drag(self, points, button=1, before_release=None):
        self.do("mousemove", *points[0])
        time.sleep(0.5)
        self.do("mousedown", button)
        for x, y in points[1:]:
            self.do("mousemove", x, y)
            time.sleep(0.01)
        if before_release:
            before_release()
        self.do("mouseup", button)


class Editor:
    """The program with its window. Leaves with stop() or kill()."""

    def __init__(self, desktop, relievo, scene, folder, journal=None, arguments=(), validation=True,
                 preferences=None):
        self.desktop, self.folder = desktop, folder
        self.log = os.path.join(folder, f"log-{time.monotonic_ns()}.txt")
        environment = {**os.environ, "DISPLAY": desktop.display, "RELIEVO_VALIDATION": "1" if validation else "0",
                       "XDG_STATE_HOME": os.path.join(folder, "state"),
                       "XDG_CONFIG_HOME": os.path.join(folder, "config")}
        environment.pop("WAYLAND_DISPLAY", None)
        settings = os.path.join(folder, "config", "relievo", "preferences.json")
        if not os.path.exists(settings):
            os.makedirs(os.path.dirname(settings))
            with open(settings, "w") as file:
                json.dump({"first_hint_seen": True, **(preferences or {})}, file)
        command = [relievo, "edit", "--size", f"{desktop.width}x{desktop.height}", *arguments]
        if scene:
            command.append(scene)
        if journal:
            command += ["--journal", journal]
        with open(self.log, "w") as log:
            self.process = subprocess.Popen(command, cwd=folder, env=environment, stdout=log, stderr=log)
        self.focus()

    def output(self):
        with open(self.log) as log:
            return log.read()

    def find_window(self):
        assert self.process.poll() is None, f"the program ended: {self.output()}"
        found = subprocess.run(["xdotool", "search", "--name", "Relievo"], capture_output=True, text=True,
                               env={**os.environ, "DISPLAY": self.desktop.display})
        return found.stdout.split()

    def focus(self):
        self.window = wait_for("the window", self.find_window)[-1]
        self.desktop.do("windowfocus", "--sync", self.window)

    def screenshot(self):
        """F12. Returns the new file's path; the program answers between two frames, so it is alive."""
        known = {name for name in os.listdir(self.folder) if name.startswith("relievo-screenshot-")}
        self.desktop.key("F12")

        def appeared():
            names = {name for name in os.listdir(self.folder) if name.endswith(".png")} - known
            return [name for name in names if name.startswith("relievo-screenshot-")]

        return os.path.join(self.folder, wait_for("the screenshot", appeared)[0])

    def save_as(self, path):
        self.desktop.key("ctrl+shift+s")
        self.screenshot()  # the dialog is open now
        self.desktop.do("type", "--delay", "30", path)
        time.sleep(0.5)
        self.desktop.key("Return")
        wait_for(f"the map {path}", lambda: os.path.exists(path))

    def ended(self):
        status = wait_for("the program to end", lambda: (self.process.poll(),) if self.process.poll() is not None
                          else None)[0]
        output = self.output()
        assert "validation:" not in output, output
        assert status == 0, f"exit status {status}: {output}"

    def kill(self):
        self.process.kill()
        self.process.wait()


def operations(journal):
    """The operations of a journal, whole lines only."""
    if not os.path.exists(journal):
        return []
    with open(journal) as file:
        lines = [line for line in file.read().split("\n")[:-1] if line]
    return [json.loads(line) for line in lines[1:]]


def strokes(journal):
    return [op for op in operations(journal) if op["op"] == "stroke"]
