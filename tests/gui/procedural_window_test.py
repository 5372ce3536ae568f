"""Procedural heights in the real window: live sliders, another exemplar, the bake and a stroke on it, all of it in the
journal and replayed to the saved bytes."""
import os
import shutil
import time

from desktop import difference, operations, wait_for
from stamp_clone_test import leave_and_replay
from window_test import run

# Places in a window of 900 x 600 with the panel's first section closed.
BRUSH_HEADER, EXEMPLAR, BAKE = (660, 70), (742, 259), (655, 439)
INVERT_MASK = (787, 497)  # with it open, three notches down
SCALE, SEED = 289, 409
ON_THE_OBJECT = [(250 + 4 * i, 330) for i in range(20)]
PICTURE = (150, 230, 500, 440)


def use_procedural_scene(case):
    """The plane of the samples, and the asteroid's map as another exemplar beside its own."""
    assets = case.assets
    for part in ("scenes/procedural_plane.json", "meshes/procedural_plane.obj", "maps/scree.png"):
        shutil.copy(os.path.join(assets, part), os.path.join(case.folder, part))
    case.scene = os.path.join(case.folder, "scenes", "procedural_plane.json")


def click(case, place):
    case.desktop.drag([place, place], before_release=lambda: time.sleep(0.5))
    case.editor.screenshot()  # it has been answered


def last_set(case, key):
    found = [op for op in operations(case.journal) if op["op"] == "set" and op["key"] == key]
    return found[-1]["value"] if found else None


def sliders_exemplar_bake_and_stroke_replay(case):
    use_procedural_scene(case)
    editor = case.open(case.journal)
    for button, place in ((5, INVERT_MASK), (4, BRUSH_HEADER)):
        case.desktop.do("mousemove", 650, 400, "click", "--repeat", 3, "--delay", 60, button)
        editor.screenshot()
        click(case, place)  # a mask of what cannot be sculpted is refused
    case.desktop.do("mousemove", 300, 30)
    before = case.desktop.settled_screen()

    def picture_follows():
        wait_for("another picture while the slider is held",
                 lambda: difference(before, case.desktop.screen(), PICTURE) > 4)
        editor.screenshot()  # a slider takes what it has seen before the release

    case.desktop.drag([(777 - 4 * i, SCALE) for i in range(12)], before_release=picture_follows)
    case.desktop.drag([(720 + 4 * i, SEED) for i in range(8)])

    click(case, EXEMPLAR)  # opens a dialog
    case.desktop.do("type", "--delay", "30", case.map)
    editor.screenshot()  # all of it is typed
    case.desktop.key("Return")
    editor.screenshot()
    case.desktop.drag(ON_THE_OBJECT)
    editor.screenshot()
    click(case, BAKE)
    wait_for("the bake", lambda: operations(case.journal)[-1]["op"] == "bake")  # its bar lies over the object
    case.stroke(case.journal, ON_THE_OBJECT)
    assert [op["op"] for op in operations(case.journal) if op["op"] != "set"] == ["bake", "stroke"], "sculpted unbaked"
    scale, seed = last_set(case, "procedural.scale"), last_set(case, "procedural.seed")
    assert 0.05 <= scale < 0.9 and seed == round(seed) > 7, (scale, seed)
    assert os.path.basename(last_set(case, "procedural.exemplar")) == "asteroid.png"
    leave_and_replay(case, editor)


if __name__ == "__main__":
    run((sliders_exemplar_bake_and_stroke_replay,))
