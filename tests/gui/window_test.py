"""The real window under Xvfb: strokes by xdotool change picture, map and journal, and replay to the same bytes.

Asserts on the journal and the saved map, on pixels only where a person would look. The validation layers run in
every case, synchronization included, and any message fails it.
"""
import argparse
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

from desktop import SKIPPED, Desktop, Editor, difference, operations, strokes, wait_for
from hands import Hands

STROKE = [(230 + 5 * i, 260 + 2 * i) for i in range(31)]  # over the asteroid's lit side
NEAR = (240, 240, 380, 340)  # pixels around it
FAR = (62, 48, 110, 96)  # sky


class Case:
    def __init__(self, options, folder):
        self.relievo, self.assets, self.folder = options.relievo, options.assets, folder
        for part in ("scenes/asteroid.json", "meshes/asteroid.obj", "maps/asteroid.png"):
            target = os.path.join(folder, part)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copy(os.path.join(options.assets, part), target)
        self.scene = os.path.join(folder, "scenes", "asteroid.json")
        self.map = os.path.join(folder, "maps", "asteroid.png")
        self.journal = os.path.join(folder, "session.jsonl")
        self.desktop = None
        self.editor = None

    def open(self, journal=None):
        if not self.desktop:
            self.desktop = Desktop(self.folder)
        self.editor = Editor(self.desktop, self.relievo, self.scene, self.folder, journal)
        self.editor.screenshot()
        return self.editor

    def stroke(self, journal, points=STROKE):
        count = len(strokes(journal))
        self.desktop.drag(points)
        return wait_for("the stroke in the journal", lambda: strokes(journal)[count:])[0]

    def command(self, key, operation):
        """Presses a key that the journal records as that operation."""
        self.desktop.key(key)
        wait_for(f"the {operation}", lambda: operations(self.journal)[-1]["op"] == operation)

    def recovery_journals(self):
        return glob.glob(os.path.join(self.folder, "state", "relievo", "*.jsonl"))

    def preferences(self):
        with open(os.path.join(self.folder, "config", "relievo", "preferences.json")) as file:
            return json.load(file)

    def replay(self, journal, out):
        subprocess.run([self.relievo, "replay", journal, "-o", out], check=True, capture_output=True)

    def same_bytes(self, first, second):
        with open(first, "rb") as a, open(second, "rb") as b:
            assert a.read() == b.read(), f"{first} and {second} differ"

    def close(self):
        if self.editor and self.editor.process.poll() is None:
            self.editor.kill()
        if self.desktop:
            self.desktop.close()


def stroke_saves_and_replays(case):
    editor = case.open(case.journal)
    case.desktop.do("mousemove", 300, 30)
    before = case.desktop.settled_screen()
    for _ in range(3):
        stroke = case.stroke(case.journal)
    assert len(stroke["dabs"]) > 5, stroke
    assert stroke["brush"]["tool"] == "draw" and not stroke["brush"]["invert"], stroke
    case.desktop.do("mousemove", 300, 30)
    after = case.desktop.settled_screen()
    near, far = difference(before, after, NEAR), difference(before, after, FAR)
    assert near > 2 and far < 0.5, f"changed by {near} near the stroke and by {far} far from it"

    case.command("ctrl+z", "undo")
    case.command("ctrl+shift+z", "redo")

    saved, replayed = os.path.join(case.folder, "saved.tif"), os.path.join(case.folder, "replayed.tif")
    editor.save_as(saved)
    wait_for("the record of the save", lambda: operations(case.journal)[-1]["op"] == "save")
    case.desktop.key("ctrl+q")
    editor.ended()
    assert not case.recovery_journals(), "nothing is unsaved, but a recovery journal stayed"
    case.replay(case.journal, replayed)
    case.same_bytes(saved, replayed)


def modifiers_and_cancel(case):
    editor = case.open(case.journal)
    case.desktop.do("keydown", "ctrl")
    assert case.stroke(case.journal)["brush"]["invert"]
    case.desktop.do("keyup", "ctrl")
    case.desktop.do("keydown", "shift")
    assert case.stroke(case.journal)["brush"]["tool"] == "smooth"
    case.desktop.do("keyup", "shift")
    case.desktop.key("shift+6")
    case.desktop.do("keydown", "shift")
    case.desktop.drag(STROKE)  # nothing is masked yet
    case.desktop.do("keyup", "shift")
    assert case.stroke(case.journal)["brush"]["tool"] == "mask"
    case.desktop.do("keydown", "shift")
    blurred = case.stroke(case.journal)["brush"]
    assert blurred["tool"] == "mask" and blurred["blur"], blurred
    case.desktop.do("keyup", "shift")
    case.desktop.key("3")
    assert case.stroke(case.journal)["brush"]["tool"] == "flatten"

    # Esc leaves no trace; nor does a stroke beside the object.
    case.desktop.drag(STROKE, before_release=lambda: case.desktop.key("Escape"))
    case.desktop.drag([(70, 60), (90, 60)])
    # Three ways of turning the camera, none of them a stroke.
    case.desktop.drag(STROKE, button=2)
    case.desktop.do("keydown", "alt")
    case.desktop.drag(STROKE)
    case.desktop.do("keyup", "alt")
    case.desktop.do("click", "4")
    case.desktop.key("bracketright")
    camera = wait_for("the camera in the journal", lambda: [op for op in operations(case.journal)
                                                             if op["op"] == "set" and op["key"] == "camera"])
    assert len(camera[-1]["value"]) == 10, camera
    last = case.stroke(case.journal, [(310, 300), (330, 300)])
    assert len(strokes(case.journal)) == 6, operations(case.journal)
    assert last["brush"]["radius"] > 1.1 * strokes(case.journal)[0]["brush"]["radius"]
    saved, replayed = os.path.join(case.folder, "saved.png"), os.path.join(case.folder, "replayed.png")
    editor.save_as(saved)
    case.desktop.key("ctrl+q")
    editor.ended()
    case.replay(case.journal, replayed)
    case.same_bytes(saved, replayed)


def a_key_right_behind_escape_is_not_lost(case):
    """In the frame in which Esc closes a dialog."""
    editor = case.open(case.journal)
    hands = Hands(case.desktop.display)
    cameras = []

    def look_from(key):
        hands.tap(key)
        wait_for(f"the view of {key}", lambda: [op["value"] for op in operations(case.journal)][-1:] not in ([], cameras))
        cameras[:] = [operations(case.journal)[-1]["value"]]

    for key in ("KP_1", "KP_3", "KP_7"):
        hands.tap("F1")
        editor.screenshot()  # the dialog is open now
        hands.tap("Escape")
        look_from(key)
    # A menu, and the list of an entry under the pointer.
    case.desktop.drag([(29, 22)] * 2)
    editor.screenshot()
    case.desktop.do("mousemove", 80, 285)
    time.sleep(0.5)
    case.desktop.key("Escape")
    editor.screenshot()
    look_from("KP_1")
    case.desktop.key("ctrl+q")
    editor.ended()


def letters_are_those_printed_on_the_keys(case):
    """A German keyboard has Y and Z changed over."""
    if not shutil.which("setxkbmap"):
        print("skipped: setxkbmap is not installed")
        sys.exit(SKIPPED)
    case.desktop = Desktop(case.folder)
    subprocess.run(["setxkbmap", "-display", case.desktop.display, "de"], check=True)
    case.open(case.journal)
    case.stroke(case.journal)
    case.command("ctrl+z", "undo")
    case.command("ctrl+y", "redo")
    case.command("ctrl+s", "save")
    case.desktop.key("ctrl+q")
    case.editor.ended()


def mask_is_shown_darker_and_in_no_journal(case):
    editor = case.open(case.journal)

    def brightness(box=NEAR):
        pixels = case.desktop.screen().box(*box)
        return sum(pixels) / len(pixels)

    # Samples may come in all the while: they change single pixels, and their mean by much less than a mask does.
    case.desktop.do("mousemove", 300, 30)
    case.desktop.settled_screen()
    free, far = brightness(), brightness(FAR)
    dark = free - 6

    def is_free():
        return brightness() > (free + dark) / 2

    case.desktop.key("shift+6")
    for _ in range(3):
        assert case.stroke(case.journal)["brush"]["tool"] == "mask"
    case.desktop.do("mousemove", 300, 30)
    wait_for("a darker picture", lambda: brightness() < dark)
    assert abs(brightness(FAR) - far) < 2, (brightness(FAR), far)
    count = len(operations(case.journal))
    case.desktop.key("m")
    wait_for("the picture without the mask", is_free)
    case.desktop.key("m")
    wait_for("the picture with the mask", lambda: not is_free())
    assert len(operations(case.journal)) == count, operations(case.journal)[count:]
    for _ in range(3):
        case.command("ctrl+z", "undo")
    wait_for("the picture before the mask", is_free)
    editor.kill()


def a_mask_is_asked_for_saved_and_there_again(case):
    mask = case.map + ".mask.png"
    editor = case.open(case.journal)
    case.desktop.key("shift+6")
    assert case.stroke(case.journal)["brush"]["tool"] == "mask"
    case.desktop.key("ctrl+q")
    editor.screenshot()  # it asks
    case.desktop.key("Return")  # Save
    editor.ended()
    assert os.path.exists(mask) and not case.recovery_journals()
    second = os.path.join(case.folder, "second.jsonl")
    editor = case.open(second)
    case.desktop.key("shift+6")
    case.desktop.do("keydown", "shift")
    assert case.stroke(second)["brush"].get("blur"), "there was no mask to blur"
    case.desktop.do("keyup", "shift")
    case.desktop.key("ctrl+z")
    wait_for("the undo", lambda: operations(second)[-1]["op"] == "undo")
    case.desktop.key("ctrl+q")  # nothing is unsaved
    editor.ended()
    with open(second) as file:
        assert json.loads(file.readline())["mask"] == os.path.relpath(mask, case.folder)


def crash_offers_recovery(case):
    editor = case.open()
    case.desktop.drag(STROKE)
    journal = wait_for("the recovery journal", case.recovery_journals)[0]
    wait_for("the stroke in it", lambda: strokes(journal))
    # The second stroke is under way when the program dies: it alone is lost.
    case.desktop.drag(STROKE, before_release=editor.kill)
    kept = shutil.copy(journal, os.path.join(case.folder, "kept.jsonl"))
    expected, restored = os.path.join(case.folder, "expected.tif"), os.path.join(case.folder, "restored.tif")
    case.replay(kept, expected)

    editor = case.open()
    case.desktop.key("Return")  # Restore
    wait_for("the journal to be replayed", lambda: not os.path.exists(journal))
    editor.focus()
    editor.screenshot()
    editor.save_as(restored)
    case.desktop.key("ctrl+q")
    editor.ended()
    case.same_bytes(expected, restored)
    assert not case.recovery_journals()


def moving_tools_and_mask_survive_a_kill(case):
    """Mask, then grab, smear and draw beside it, mirrored: a save, kill -9, Restore, and all bytes are the same."""
    editor = case.open()
    case.desktop.key("shift+6")
    case.desktop.drag(STROKE[:12])
    journal = wait_for("the recovery journal", case.recovery_journals)[0]
    wait_for("the mask's stroke in it", lambda: strokes(journal))
    case.desktop.key("x")
    for key in ("shift+1", "shift+2", "1"):
        case.desktop.key(key)
        case.stroke(journal)
    saved, restored = os.path.join(case.folder, "saved.tif"), os.path.join(case.folder, "restored.tif")
    editor.save_as(saved)
    case.desktop.key("shift+2")
    case.stroke(journal)
    assert [s["brush"]["tool"] for s in strokes(journal)] == ["mask", "grab", "smear", "draw", "smear"]
    assert all(s["brush"]["mirror_x"] for s in strokes(journal)[1:]), strokes(journal)
    editor.kill()
    kept = shutil.copy(journal, os.path.join(case.folder, "kept.jsonl"))
    expected = os.path.join(case.folder, "expected.tif")
    case.replay(kept, expected)

    editor = case.open()
    case.desktop.key("Return")  # Restore
    wait_for("the journal to be replayed", lambda: not os.path.exists(journal))
    editor.focus()
    editor.screenshot()
    editor.save_as(restored)
    case.desktop.key("ctrl+q")
    editor.ended()
    case.same_bytes(expected, restored)
    with open(saved, "rb") as a, open(restored, "rb") as b:
        assert a.read() != b.read(), "the last stroke changed nothing"


def quit_asks_for_unsaved_work(case):
    with open(case.map, "rb") as file:
        before = file.read()
    editor = case.open(case.journal)
    case.stroke(case.journal)
    case.desktop.key("ctrl+q")
    editor.screenshot()
    case.desktop.key("Escape")
    editor.screenshot()  # it is still there
    with open(case.map, "rb") as file:
        assert file.read() == before, "saved without being told to"
    case.desktop.key("ctrl+q")
    editor.screenshot()
    case.desktop.key("Return")  # Save
    editor.ended()
    with open(case.map, "rb") as file:
        assert file.read() != before, "the stroke was not saved"


def resized_and_reopened(case):
    editor = case.open(case.journal)
    for width, height in ((700, 450), (899, 599), (640, 400), (200, 60), (900, 600)):
        case.desktop.do("windowsize", editor.window, width, height)
        editor.screenshot()
    for name in ("Tab", "Tab", "KP_1", "KP_3", "KP_7", "a", "F1", "Escape", "f"):
        case.desktop.key(name)
    case.desktop.do("mousemove", 320, 300)
    case.desktop.key("Escape")
    # Ctrl+O opens the scene once more, by its name in the dialog: a second device and window surface.
    case.desktop.key("ctrl+o")
    editor.screenshot()
    case.desktop.do("type", "--delay", "30", case.scene)
    time.sleep(0.5)
    case.desktop.key("Return")
    time.sleep(1)
    editor.focus()
    editor.screenshot()
    case.desktop.key("ctrl+q")
    editor.ended()


def views_show_the_surface_each_in_its_way(case):
    editor = case.open(case.journal)
    case.desktop.do("mousemove", 300, 30)
    shown = [case.desktop.settled_screen()]
    for name in ("normals", "height", "steps", "error", "prisms"):
        case.desktop.key("v")
        editor.screenshot()
        time.sleep(1.5)
        wait_for(f"{name} to look like no view before", lambda: all(
            difference(earlier, case.desktop.screen(), NEAR) > 1.5 for earlier in shown))
        shown.append(case.desktop.screen())
    # Strokes and camera moves in every view; the journal knows strokes and cameras, and of views nothing.
    for _ in range(6):
        case.desktop.key("v")
        case.stroke(case.journal)
    case.desktop.drag(STROKE[:8], button=2)
    case.desktop.key("V")
    kinds = {op["op"] if op["op"] != "set" else op["key"] for op in operations(case.journal)}
    assert kinds == {"stroke", "camera"}, kinds
    finish_and_replay(case, editor)


def save_picture(case, picture="scenes/asteroid-picture.png"):
    """From the menu, under the name that is suggested."""
    case.desktop.drag([(29, 22)] * 2)
    case.editor.screenshot()
    case.desktop.drag([(80, 241)] * 2)
    case.editor.screenshot()
    case.desktop.key("Return")
    wait_for("the picture", lambda: os.path.exists(os.path.join(case.folder, picture)))


def what_comes_of_a_bare_mesh_lies_beside_it(case):
    case.desktop = Desktop(case.folder)
    mesh = os.path.join(case.folder, "meshes", "asteroid.obj")
    case.editor = Editor(case.desktop, case.relievo, mesh, case.folder, case.journal)
    case.editor.screenshot()
    save_picture(case, "meshes/asteroid-picture.png")
    case.stroke(case.journal)
    case.desktop.key("ctrl+s")
    case.editor.screenshot()  # it asks for a name
    case.desktop.key("Return")
    wait_for("the map", lambda: os.path.exists(os.path.join(case.folder, "meshes", "asteroid.tif")))
    wait_for("the record of the save", lambda: operations(case.journal)[-1]["op"] == "save")
    # The mesh alone would be flat again.
    scene = wait_for("a scene with the map", lambda: [path for path in case.preferences()["recent"] if "tif" in open(path).read()])
    with open(scene[0]) as file:
        assert json.load(file)["objects"][0]["displacement"]["map"] == os.path.join(case.folder, "meshes", "asteroid.tif")
    case.desktop.key("ctrl+q")
    case.editor.ended()


def two_methods_side_by_side_while_sculpting(case):
    editor = case.open(case.journal)
    case.desktop.do("mousemove", 300, 30)
    before = case.desktop.settled_screen()
    case.desktop.key("c")
    editor.screenshot()
    case.desktop.do("mousemove", 300, 30)
    time.sleep(1)
    assert difference(before, case.desktop.screen(), (318, 60, 326, 400)) > 3, "no line between the halves"
    stroke = case.stroke(case.journal)  # from the left half into the right one
    assert len(stroke["dabs"]) > 5, stroke
    case.desktop.drag([(322, 500), (240, 500)])  # the divider, and no stroke
    for name in ("normals", "height", "steps", "error"):
        case.desktop.key("v")
        editor.screenshot()
        if name in ("height", "error"):
            case.stroke(case.journal)
    case.desktop.drag(STROKE[:8], button=2)
    case.desktop.key("ctrl+z")
    case.desktop.do("windowsize", editor.window, 700, 450)
    editor.screenshot()
    case.desktop.do("windowsize", editor.window, 900, 600)
    case.desktop.key("c")
    editor.screenshot()
    case.desktop.key("c")
    save_picture(case)
    case.desktop.key("c")
    assert len(strokes(case.journal)) == 3, operations(case.journal)
    finish_and_replay(case, editor)


def why_this_pixel_lists_its_ray(case):
    editor = case.open(case.journal)
    case.desktop.do("mousemove", 300, 30)
    before = case.desktop.settled_screen()
    case.desktop.key("F2")
    case.desktop.do("mousemove", 150, 280)
    case.desktop.do("click", "1")
    editor.screenshot()
    time.sleep(1)
    assert difference(before, case.desktop.screen(), (400, 110, 560, 300)) > 20, "no list"
    case.desktop.do("mousemove", 480, 250)  # over the list: neither zoom nor stroke
    case.desktop.do("click", "5")
    case.desktop.key("Escape")
    case.desktop.drag([(480, 250), (500, 260)])
    assert not operations(case.journal), operations(case.journal)
    case.desktop.drag([(150, 280), (180, 290)])
    wait_for("a stroke again", lambda: strokes(case.journal))
    case.desktop.key("Escape")  # closes the list, which lay there
    case.desktop.drag([(480, 250), (500, 260)])
    wait_for("a stroke where the list was", lambda: len(strokes(case.journal)) == 2)
    finish_and_replay(case, editor)


def export_asks_for_each_file_it_would_replace(case):
    names = {ending: os.path.join(case.folder, "maps", "asteroid-export." + ending) for ending in ("exr", "tif")}
    for name in names.values():
        with open(name, "w") as file:
            file.write("another's")

    def untouched(ending):
        with open(names[ending], "rb") as file:
            return file.read() == b"another's"

    def press(name):
        case.desktop.key(name)
        editor.screenshot()

    def click(x, y):
        case.desktop.do("mousemove", x, y, "sleep", 0.3, "mousedown", 1, "sleep", 0.1, "mouseup", 1)
        editor.screenshot()

    formats, tiff = (450, 226), (450, 276)
    editor = case.open(case.journal)
    press("ctrl+e")
    press("Return")
    assert untouched("exr"), "it was not asked"
    click(*formats)
    press("Escape")  # leaves the list, not the dialog
    click(*formats)
    click(*tiff)
    press("Return")
    assert untouched("tif"), "the answer was for another file"
    press("Return")
    wait_for("the export", lambda: not untouched("tif"))
    assert untouched("exr")
    assert not operations(case.journal), "a click went through to the surface"
    case.desktop.key("ctrl+q")
    editor.ended()


def finish_and_replay(case, editor):
    saved, replayed = os.path.join(case.folder, "saved.tif"), os.path.join(case.folder, "replayed.tif")
    editor.save_as(saved)
    case.desktop.key("ctrl+q")
    editor.ended()
    case.replay(case.journal, replayed)
    case.same_bytes(saved, replayed)


def first_start_opens_the_sample_with_a_hint(case):
    case.desktop = Desktop(case.folder)
    case.editor = Editor(case.desktop, case.relievo, None, case.folder, case.journal,
                         preferences={"first_hint_seen": False, "recent": ["/long" * 40 + "/name.json"]})
    case.editor.screenshot()
    case.desktop.do("mousemove", 300, 30)
    before = case.desktop.settled_screen()
    case.desktop.do("windowsize", case.editor.window, 640, 400)
    case.desktop.do("mousemove", 200, 300)  # off the bar and its tooltips
    case.editor.screenshot()
    narrow = case.desktop.screen()
    for edge in (60, 319):  # of the picture, where nothing of the hint is bright
        pixels = narrow.box(edge, 62, edge + 5, 135)
        assert max(max(pixels[i::4]) for i in range(3)) < 150, f"the hint is cut off at {edge}"
    case.desktop.do("windowsize", case.editor.window, 900, 600)
    case.editor.screenshot()
    case.stroke(case.journal)
    case.desktop.do("mousemove", 300, 30)
    hint = (140, 66, 520, 110)
    assert difference(before, case.desktop.settled_screen(), hint) > 2, "the hint did not go away"
    assert case.preferences()["first_hint_seen"], case.preferences()
    assert case.preferences()["recent"][0].endswith("asteroid.json"), case.preferences()
    # The list of recent files lies beside its menu, however long their paths are.
    case.desktop.drag([(29, 22)] * 2)
    case.editor.screenshot()
    folded = case.desktop.screen()
    case.desktop.do("mousemove", 84, 97)
    case.editor.screenshot()
    unfolded = case.desktop.screen()
    assert difference(folded, unfolded, (290, 88, 400, 150)) > 2, "no list"
    assert difference(folded, unfolded, (22, 66, 100, 82)) < 1, "the list lies over its menu"
    case.desktop.key("Escape")
    case.desktop.key("Escape")
    case.desktop.key("ctrl+z")  # nothing is unsaved then
    wait_for("the undo", lambda: operations(case.journal)[-1]["op"] == "undo")
    case.desktop.key("ctrl+q")
    case.editor.ended()


def views_are_kept_and_drags_cancelled(case):
    def camera():  # of several in a row the journal keeps the last
        found = [op["value"] for op in operations(case.journal) if op["op"] == "set" and op["key"] == "camera"]
        return found[-1] if found else None

    editor = case.open(case.journal)
    case.desktop.drag(STROKE[:8], button=2)
    editor.screenshot()
    kept = wait_for("the camera", camera)
    case.desktop.key("ctrl+shift+2")
    case.desktop.drag(STROKE[:12], button=2)
    wait_for("another camera", lambda: camera() != kept)
    case.desktop.key("ctrl+2")
    wait_for("the view that was kept", lambda: camera() == kept)
    # Esc gives back the view before the drag, though the button is still down.
    case.desktop.drag(STROKE, button=2, before_release=lambda: case.desktop.key("Escape"))
    editor.screenshot()
    assert camera() == kept, "the cancelled drag moved the camera"
    case.desktop.key("KP_5")
    wait_for("nearly parallel lines of sight", lambda: camera()[9] == 2)
    case.desktop.key("KP_5")
    wait_for("the first field of view", lambda: camera()[9] == kept[9])
    assert max(abs(a - b) for a, b in zip(camera(), kept)) < 1e-6, (camera(), kept)
    assert not strokes(case.journal)
    case.desktop.key("ctrl+q")
    editor.ended()


def light_follows_the_pointer_until_a_click(case):
    def places():
        """Of the sky's zenith and the light; a drag is one record, and so are two with nothing between them."""
        found = operations(case.journal)
        assert [op["key"] for op in found] == ["lights"] * len(found) and len(found) < 2, found
        return found and (found[0]["value"][:3], found[0]["value"][3:])

    editor = case.open(case.journal)
    case.desktop.do("mousemove", 300, 280)
    case.desktop.key("l")
    case.desktop.do("mousemove", 380, 280)
    wait_for("the light", places)
    case.desktop.do("click", 1)
    editor.screenshot()
    kept = places()
    assert kept[0] == [0, 1, 0], "the sky is the same from all sides"
    case.desktop.do("mousemove", 380, 340)
    editor.screenshot()
    assert places() == kept, "the click kept it"
    # Across the way the camera stands the sky is turned, too; Esc takes it back.
    case.desktop.key("l")
    case.desktop.do("mousemove", 380, 400)
    tilted = wait_for("the sky", lambda: places()[0] != kept[0] and places())
    assert tilted[0][1] < 0.99 and tilted[1] != kept[1], tilted
    case.desktop.key("Escape")
    wait_for("the light as it was", lambda: places() == kept)
    assert not strokes(case.journal)
    case.desktop.key("ctrl+q")
    editor.ended()


def new_map_export_and_revert(case):
    editor = case.open(case.journal)
    case.stroke(case.journal)
    # Alone in the dialog, Enter exports; the session still has to be saved.
    case.desktop.key("ctrl+e")
    editor.screenshot()
    case.desktop.key("Return")
    exported = os.path.join(case.folder, "maps", "asteroid-export.exr")
    wait_for("the export", lambda: os.path.exists(exported))
    case.command("ctrl+z", "undo")
    case.desktop.key("ctrl+n")
    editor.screenshot()
    case.desktop.key("Return")
    wait_for("the new map", lambda: os.path.exists(os.path.join(case.folder, "maps", "asteroid-new.png")))
    wait_for("its scene among the recent ones",
             lambda: "asteroid-new" in case.preferences()["recent"][0] and case.preferences())
    editor.focus()
    editor.screenshot()
    case.desktop.drag(STROKE)
    wait_for("the stroke on it", case.recovery_journals)
    journal = case.recovery_journals()[0]
    wait_for("the stroke on it", lambda: strokes(journal))
    case.desktop.key("ctrl+s")
    case.desktop.key("ctrl+q")
    editor.ended()


def redness(screen, box):
    """Mean of red minus blue, -255 to 255; the buffer holds blue, green, red and a spare byte."""
    pixels = screen.box(*box)
    return (sum(pixels[2::4]) - sum(pixels[0::4])) / (len(pixels) / 4)


def painting_goes_to_a_colour_map(case):
    editor = case.open(case.journal)
    case.desktop.do("mousemove", 300, 30)
    before = case.desktop.settled_screen()
    case.desktop.key("p")  # colours alone
    for _ in range(4):
        stroke = case.stroke(case.journal)
    assert stroke["brush"]["paint"] == "colour", stroke
    made = [op for op in operations(case.journal) if op["op"] == "colour_map"]
    assert made == [{"op": "colour_map", "bits": 8}], made
    case.desktop.do("mousemove", 300, 30)
    after = case.desktop.settled_screen()
    near, far = (redness(after, box) - redness(before, box) for box in (NEAR, FAR))
    assert near > 4 and abs(far) < 0.5, f"red grew by {near} near the stroke and by {far} far from it"

    case.desktop.do("mousemove", *STROKE[15])  # the middle of what was painted
    time.sleep(1)
    case.desktop.key("s")
    case.desktop.key("p")  # both
    both = case.stroke(case.journal, [(260, 330), (300, 345)])
    assert both["brush"]["paint"] == "both", both
    taken = [both["brush"].get(part, standard) for part, standard in (("red", 0.8), ("green", 0.3), ("blue", 0.2))]
    assert taken[0] > taken[1] > 0.2 and taken != [0.8, 0.3, 0.2], taken
    case.command("ctrl+z", "undo")
    case.command("ctrl+y", "redo")

    saved = os.path.join(case.folder, "saved.tif")
    editor.save_as(saved)
    colours = os.path.join(case.folder, "saved_colour.png")
    wait_for("the colours", lambda: os.path.exists(colours))
    wait_for("the record of the save", lambda: operations(case.journal)[-1]["op"] == "save")
    wait_for("a scene that names both", lambda: "saved" in case.preferences()["recent"][0])
    case.desktop.key("ctrl+q")
    editor.ended()
    assert not case.recovery_journals(), "nothing is unsaved, but a recovery journal stayed"
    replayed = [os.path.join(case.folder, name) for name in ("replayed.tif", "replayed.png")]
    subprocess.run([case.relievo, "replay", case.journal, "-o", replayed[0], "--colour-output", replayed[1]], check=True,
                   capture_output=True)
    case.same_bytes(saved, replayed[0])
    case.same_bytes(colours, replayed[1])


def no_display(case):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    result = subprocess.run([case.relievo, "edit", case.scene], env=environment, capture_output=True, text=True)
    assert result.returncode == 1, result
    lines = result.stderr.strip().split("\n")
    assert len(lines) == 1 and "display" in lines[0].lower(), result.stderr


def run(functions):
    """Runs the case that the command line names."""
    cases = {function.__name__: function for function in functions}
    parser = argparse.ArgumentParser()
    parser.add_argument("case", choices=cases)
    parser.add_argument("--relievo", required=True, type=os.path.abspath)
    parser.add_argument("--assets", required=True, type=os.path.abspath)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        case = Case(options, folder)
        try:
            cases[options.case](case)
        except BaseException:
            if case.editor:
                print(case.editor.output())
            raise
        finally:
            case.close()


if __name__ == "__main__":
    run((stroke_saves_and_replays, mask_is_shown_darker_and_in_no_journal, modifiers_and_cancel,
         a_mask_is_asked_for_saved_and_there_again, a_key_right_behind_escape_is_not_lost,
         letters_are_those_printed_on_the_keys, crash_offers_recovery,
         moving_tools_and_mask_survive_a_kill, quit_asks_for_unsaved_work, resized_and_reopened,
         what_comes_of_a_bare_mesh_lies_beside_it, views_show_the_surface_each_in_its_way, two_methods_side_by_side_while_sculpting,
         why_this_pixel_lists_its_ray, first_start_opens_the_sample_with_a_hint,
         views_are_kept_and_drags_cancelled, light_follows_the_pointer_until_a_click, new_map_export_and_revert,
         export_asks_for_each_file_it_would_replace, painting_goes_to_a_colour_map, no_display))
