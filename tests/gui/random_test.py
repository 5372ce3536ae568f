"""Random keys, clicks, drags and resizes in the real window: it neither crashes nor gets a message from the validation
layers, undo leads back to the first map, the journal replays to the same bytes, and memory stays in bounds.

Dialogs that write files are opened and left by Esc only, so that nothing random ever replaces anyone's file.
"""
import argparse
import json
import os
import random
import shutil
import subprocess
import tempfile
import time

from desktop import Desktop, Editor, operations
from hands import Hands

SIZE = (1000, 640)
KEYS = ("1 2 3 4 5 6 7 8 9 bracketleft bracketright f x y z a l m KP_1 KP_3 KP_5 KP_7 v v c p p s F2 Tab Escape space "
        "BackSpace Left Right Up Down").split()
HELD = ([], [], ["Shift_L"], ["Control_L"], ["Alt_L"], ["Control_L", "Shift_L"])
EDITS = [("z", ["Control_L"]), ("z", ["Control_L", "Shift_L"]), ("y", ["Control_L"]), ("s", ["Control_L"])]
DIALOGS = [("o", ["Control_L"]), ("n", ["Control_L"]), ("e", ["Control_L"]), ("s", ["Control_L", "Shift_L"]), ("F1", [])]
BATCH = 40  # events between two questions whether it is alive
# Resident beside undo steps, which have a budget of their own, at any time. Over 10,000 events 310 became 530: 160 of
# it are the driver's compiled programs, of which a fixed number is kept, and a compiler takes 110 more for a moment.
MOST_MIB = 850
MOST_GROWTH_MIB = 200  # of that, from the first quarter to the end: 60 in long runs, 150 where programs come late


def memory_mib(pid, field):
    with open(f"/proc/{pid}/status") as file:
        for line in file:
            if line.startswith(field + ":"):
                return int(line.split()[1]) / 1024
    raise AssertionError(f"no {field} of process {pid}")


def undo_mib(frame_log):
    """What undo steps held when the last frame was shown."""
    with open(frame_log, "rb") as file:
        file.seek(max(0, file.seek(0, os.SEEK_END) - 65536))
        lines = file.read().split(b"\n")[1:-1]
    return [json.loads(line) for line in lines if b'"frame"' in line][-1]["frame"]["undo_bytes"] / 2**20


class Monkey:
    def __init__(self, editor, hands, seed):
        self.editor, self.hands, self.random = editor, hands, random.Random(seed)

    def place(self):
        # The file menu at the top left leads to dialogs that write.
        while True:
            x, y = self.random.randrange(SIZE[0]), self.random.randrange(SIZE[1])
            if x > 130 or y > 60:
                return x, y

    def over_picture(self):
        return self.random.randrange(80, 640), self.random.randrange(70, 560)

    def step(self):
        action = self.random.choices(("drag", "click", "key", "edit", "scroll", "dialog", "resize", "cancelled"),
                                     (28, 22, 22, 12, 8, 3, 2, 3))[0]
        getattr(self, action)()

    def with_held(self, act):
        held = self.random.choice(HELD)
        for key in held:
            self.hands.key(key, True)
        act()
        for key in reversed(held):
            self.hands.key(key, False)

    def drag(self, cancel=False):
        if self.random.random() < 0.3:
            self.hands.tap("a")  # else the object is soon out of sight

        def act():
            self.hands.move(*(self.over_picture() if self.random.random() < 0.8 else self.place()))
            button = self.random.choices((1, 2, 3), (8, 1, 1))[0]
            self.hands.button(button, True)
            x, y = self.over_picture()
            for _ in range(self.random.randrange(1, 12)):
                x, y = x + self.random.randrange(-25, 26), y + self.random.randrange(-25, 26)
                self.hands.move(max(x, 0), max(y, 61))
                time.sleep(0.002)
            if cancel:
                self.hands.tap("Escape")
            self.hands.button(button, False)
        self.with_held(act)

    def cancelled(self):
        self.drag(cancel=True)

    def click(self):
        self.hands.move(*self.place())
        self.hands.button(1, True)
        self.hands.button(1, False)

    def scroll(self):
        self.hands.move(*self.place())
        button = self.random.choice((4, 5))
        self.hands.button(button, True)
        self.hands.button(button, False)

    def key(self):
        self.hands.tap(self.random.choice(KEYS), self.random.choice(([], [], ["Shift_L"], ["Alt_L"])))

    def edit(self):
        self.hands.tap(*self.random.choice(EDITS))

    def dialog(self):
        self.hands.tap(*self.random.choice(DIALOGS))
        self.editor.screenshot()
        for _ in range(3):
            self.hands.move(*self.place())
        self.calm()

    def resize(self):
        self.editor.desktop.do("windowsize", self.editor.window, self.random.randrange(640, SIZE[0] + 1),
                               self.random.randrange(400, SIZE[1] + 1))

    def calm(self):
        """Out of every dialog, menu, drag and text field."""
        for _ in range(3):
            self.hands.tap("Escape")
            time.sleep(0.1)
        self.editor.screenshot()


def undo_all(monkey, journal):
    while True:
        before = len(operations(journal))
        for _ in range(10):
            monkey.hands.tap("z", ["Control_L"])
        monkey.editor.screenshot()
        time.sleep(0.2)
        if len(operations(journal)) == before:
            return


def run(options, folder):
    for part in ("scenes/asteroid.json", "meshes/asteroid.obj", "maps/asteroid.png"):
        os.makedirs(os.path.dirname(os.path.join(folder, part)), exist_ok=True)
        shutil.copy(os.path.join(options.assets, part), os.path.join(folder, part))
    journal, first, last = (os.path.join(folder, name) for name in ("session.jsonl", "first.tif", "last.tif"))
    frame_log = os.path.join(folder, "frames.jsonl")
    desktop = Desktop(folder, *SIZE)
    editor = Editor(desktop, options.relievo, os.path.join(folder, "scenes", "asteroid.json"), folder, journal,
                    ("--frame-log", frame_log))
    hands = Hands(desktop.display)
    monkey = Monkey(editor, hands, options.seed)
    try:
        editor.screenshot()
        saved = os.path.join(folder, "saved.tif")  # which Ctrl+S goes on writing
        editor.save_as(saved)
        shutil.copy(saved, first)
        early = (0, 0)  # resident, and undo steps in it
        for event in range(options.events):
            monkey.step()
            if event % BATCH == BATCH - 1:
                os.remove(editor.screenshot())
                assert editor.process.poll() is None, editor.output()
            if event == options.events // 4:
                early = memory_mib(editor.process.pid, "VmRSS"), undo_mib(frame_log)
        monkey.calm()
        late = memory_mib(editor.process.pid, "VmRSS"), undo_mib(frame_log)
        peak = memory_mib(editor.process.pid, "VmHWM")
        undo_all(monkey, journal)
        desktop.do("windowsize", editor.window, *SIZE)
        editor.save_as(last)
        kinds = [op["op"] for op in operations(journal)]
        print(f"{options.events} events, seed {options.seed}: {kinds.count('stroke')} strokes, {kinds.count('undo')} "
              f"undone, {kinds.count('redo')} redone; {early[0]:.0f} MiB after a quarter with undo steps of "
              f"{early[1]:.0f}, {late[0]:.0f} with {late[1]:.0f} at the end, {peak:.0f} at most")
        desktop.key("ctrl+q")
        editor.ended()
    except BaseException:
        print(editor.output())
        raise
    finally:
        hands.close()
        if editor.process.poll() is None:
            editor.kill()
        desktop.close()
    check(options, folder, journal, first, last)
    assert peak - late[1] < MOST_MIB, f"{peak} MiB with undo steps of {late[1]}"
    growth = (late[0] - late[1]) - (early[0] - early[1])
    assert growth < MOST_GROWTH_MIB, f"{growth} MiB more beside undo steps: {early}, {late}"


def check(options, folder, journal, first, last):
    replayed, colours = os.path.join(folder, "replayed.tif"), os.path.join(folder, "last_colour.png")
    painted = os.path.exists(colours)
    also = ["--colour-output", os.path.join(folder, "replayed.png")] if painted else []
    subprocess.run([options.relievo, "replay", journal, "-o", replayed, *also], check=True, capture_output=True)
    if painted:
        first_colours, last_colours = (open(path, "rb").read() for path in (colours, also[1]))
        assert first_colours == last_colours, "the journal replays to other colours"
    contents = [open(path, "rb").read() for path in (first, last, replayed)]
    assert contents[1] == contents[0], "undo did not lead back to the first map"
    assert contents[2] == contents[0], "the journal replays to another map"
    assert any(op["op"] == "stroke" for op in operations(journal)), "no stroke in all these events"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--relievo", required=True, type=os.path.abspath)
    parser.add_argument("--assets", required=True, type=os.path.abspath)
    parser.add_argument("--events", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        run(options, folder)


if __name__ == "__main__":
    main()
