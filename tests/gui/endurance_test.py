"""What long work meets, in the real window: memory, journals and folders that go away, restoring what was long."""
import json
import os
import shutil
import signal
import subprocess
import time

from desktop import Desktop, Editor, difference, operations, strokes, wait_for
from dropping import drop
from hands import Hands
from random_test import memory_mib
from window_test import STROKE, finish_and_replay, run

LEAST_GIVEN_BACK_MIB = 80  # 140 with it, 25 without
RESTORED = 800  # strokes: seconds
DIALOG = (260, 260, 640, 340)  # pixels in the window's middle


def click(case, x, y):
    """In a dialog, which sees the pointer once a frame."""
    case.desktop.do("mousemove", x, y)
    time.sleep(0.5)
    case.desktop.do("mousedown", 1)
    case.editor.screenshot()
    case.desktop.do("mouseup", 1)
    time.sleep(1)


def memory_of_compilers_goes_back(case):
    """Every view, then two methods side by side in every view: a dozen programs are compiled."""
    editor = case.open()
    pid = editor.process.pid
    for key in "vvvvvvcvvvvvv":
        case.desktop.key(key)
        editor.screenshot()
        time.sleep(1)
    late, peak = memory_mib(pid, "VmRSS"), memory_mib(pid, "VmHWM")
    figures = f"{late:.0f} MiB at the end, {peak:.0f} at most"
    print(figures)
    assert peak - late > LEAST_GIVEN_BACK_MIB, figures
    case.desktop.key("ctrl+q")
    editor.ended()


def journals_deleted_between_strokes_miss_nothing(case):
    editor = case.open(case.journal)
    case.stroke(case.journal)
    recovery = case.recovery_journals()[0]
    for journal in (case.journal, recovery):
        os.remove(journal)
    case.desktop.drag(STROKE[10:])
    for journal in (case.journal, recovery):
        wait_for(f"both strokes in {journal}", lambda: len(strokes(journal)) == 2)
    finish_and_replay(case, editor)


def a_long_save_shows_how_far_it_is_and_can_be_stopped(case):
    subprocess.run([case.relievo, "bake", os.path.join(case.assets, "scenes", "procedural_plane.json"), "-o", case.map,
                    "--size", "4096x4096"], check=True, capture_output=True)
    editor = case.open(case.journal)
    case.stroke(case.journal)
    case.desktop.do("mousemove", 300, 30)
    old, before = os.stat(case.map).st_ino, case.desktop.screen()
    case.desktop.key("ctrl+s")
    wait_for("the bar", lambda: difference(before, case.desktop.screen(), DIALOG) > 20)
    case.desktop.key("Escape")
    wait_for("the picture", lambda: difference(before, case.desktop.screen(), DIALOG) < 5)
    assert os.stat(case.map).st_ino == old and operations(case.journal)[-1]["op"] == "stroke", "it was not stopped"
    assert not [name for name in os.listdir(os.path.dirname(case.map)) if name.startswith(".")], "half a file is left"
    case.command("ctrl+s", "save")
    assert os.stat(case.map).st_ino != old
    case.desktop.key("ctrl+q")
    editor.ended()


def a_press_that_waits_for_a_save_is_no_long_one(case):
    subprocess.run([case.relievo, "bake", os.path.join(case.assets, "scenes", "procedural_plane.json"), "-o", case.map,
                    "--size", "4096x4096"], check=True, capture_output=True)
    case.desktop = Desktop(case.folder, 900, 1000)
    editor = case.open(case.journal)
    click(case, 790, 602)  # an airbrush of 100 dabs a second
    hands = Hands(case.desktop.display)
    hands.move(320, 400)
    time.sleep(1)
    hands.button(1, True)
    time.sleep(1)
    hands.button(1, False)
    wait_for("the stroke", lambda: strokes(case.journal))
    assert len(strokes(case.journal)[0]["dabs"]) > 40, "no airbrush"
    # Key and press are read together; the release comes while the map is being saved.
    editor.process.send_signal(signal.SIGSTOP)
    hands.tap("s", held=["Control_L"])
    hands.button(1, True)
    editor.process.send_signal(signal.SIGCONT)
    time.sleep(0.9)
    hands.button(1, False)
    saved, stroke = wait_for("save and stroke", lambda: len(operations(case.journal)) > 2 and operations(case.journal)[1:])
    assert [saved["op"], stroke["op"]] == ["save", "stroke"], (saved, stroke)
    assert len(stroke["dabs"]) < 10, len(stroke["dabs"])
    hands.close()
    editor.kill()


def a_picture_being_saved_can_be_stopped_and_keeps_its_size(case):
    case.desktop = Desktop(case.folder, 2560, 1600)
    slow = ("--set", "dt=0.002", "--method", "pdm")  # its layers take seconds
    editor = case.editor = Editor(case.desktop, case.relievo, case.scene, case.folder, case.journal, slow)
    editor.screenshot()
    case.desktop.do("mousemove", 300, 30)
    picture = os.path.join(case.folder, "picture.exr")
    # Bright without a dialog, and there before anything is traced: a slider. And a place in the dialog for files alone.
    slider, beside = (2370, 180, 2430, 200), (1005, 770, 1040, 830)
    before = case.desktop.screen()

    def is_dark():
        return difference(before, case.desktop.screen(), slider) > 15

    def save():
        case.desktop.drag([(29, 22)] * 2)
        editor.screenshot()
        click(case, 80, 241)  # Save the picture...
        case.desktop.do("type", "--delay", "30", picture)
        time.sleep(0.5)
        files = case.desktop.screen()
        case.desktop.key("Return")
        wait_for("the bar", lambda: is_dark() and difference(files, case.desktop.screen(), beside) > 5)

    def saved_bytes():
        wait_for("the picture's file", lambda: os.path.exists(picture))
        size = os.stat(picture).st_size
        os.remove(picture)
        return size

    save()
    case.desktop.key("Escape")
    wait_for("the picture", lambda: not is_dark())
    editor.screenshot()
    assert not os.path.exists(picture), "it was not stopped"
    save()
    whole = saved_bytes()
    editor.screenshot()
    save()
    case.desktop.do("windowsize", editor.window, 1400, 900)
    resized = saved_bytes()
    assert resized > 0.9 * whole, (resized, whole)  # what is missing takes no room; what is refined takes more
    editor.screenshot()
    case.desktop.key("ctrl+q")
    editor.ended()


def what_cannot_be_saved_on_the_way_out_is_saved_elsewhere(case):
    editor = case.open(case.journal)
    case.stroke(case.journal)
    shutil.move(os.path.dirname(case.map), os.path.join(case.folder, "moved"))
    case.desktop.key("ctrl+q")
    editor.screenshot()
    case.desktop.key("Return")  # Save
    editor.screenshot()  # it is still there
    click(case, 376, 333)  # Save as...
    saved, replayed = os.path.join(case.folder, "saved.tif"), os.path.join(case.folder, "replayed.tif")
    case.desktop.do("type", "--delay", "30", saved)
    time.sleep(0.5)
    case.desktop.key("Return")
    editor.ended()
    shutil.move(os.path.join(case.folder, "moved"), os.path.dirname(case.map))
    case.replay(case.journal, replayed)
    case.same_bytes(saved, replayed)
    assert not case.recovery_journals(), "nothing is unsaved, but a recovery journal stayed"


def dialogs_fit_a_small_window_with_large_letters(case):
    case.desktop = Desktop(case.folder, 640, 400)
    editor = case.editor = Editor(case.desktop, case.relievo, case.scene, case.folder, case.journal,
                                  preferences={"interface_scale": 2})
    editor.screenshot()
    case.desktop.key("ctrl+e")
    editor.screenshot()
    case.desktop.key("Escape")
    click(case, 122, 190)  # what there is of the picture
    wait_for("the stroke", lambda: strokes(case.journal))
    case.desktop.key("ctrl+q")
    editor.screenshot()
    click(case, 154, 312)  # Don't save
    editor.ended()


def a_menu_higher_than_the_window_scrolls_to_its_end(case):
    case.desktop = Desktop(case.folder, 640, 400)
    editor = case.editor = Editor(case.desktop, case.relievo, case.scene, case.folder, case.journal,
                                  preferences={"interface_scale": 2})
    editor.screenshot()
    case.desktop.drag([(58, 44)] * 2)
    editor.screenshot()
    # Another menu comes under the pointer, and stays folded until that moves.
    unfolded = (44, 150, 306, 390)
    case.desktop.do("mousemove", 400, 322)
    case.desktop.do("click", "--repeat", 15, "--delay", 50, 5)
    editor.screenshot()
    scrolled = case.desktop.screen()
    case.desktop.do("mousemove", 402, 130)
    editor.screenshot()
    assert difference(scrolled, case.desktop.screen(), unfolded) < 1, "it unfolded"
    case.desktop.do("mousemove", 402, 322)
    editor.screenshot()
    assert difference(scrolled, case.desktop.screen(), unfolded) > 5, "it does not unfold"
    case.desktop.do("mousemove", 402, 130)
    editor.screenshot()
    case.desktop.drag([(400, 366)] * 2)  # Quit
    editor.ended()


def a_command_during_a_stroke_that_lags_is_refused_aloud(case):
    editor = case.open(case.journal)
    for _ in range(8):
        case.desktop.key("bracketright")
    case.desktop.do("mousemove", 700, 22)
    before = case.desktop.settled_screen()
    hands = Hands(case.desktop.display)
    hands.move(*STROKE[0])
    time.sleep(0.5)
    hands.button(1, True)
    for _ in range(120):  # to and fro: thousands of large dabs
        for x, y in (STROKE[-1], STROKE[0]):
            hands.move(x, y)
            time.sleep(0.004)
    hands.button(1, False)
    hands.move(80, 22)  # Save, in the top bar
    time.sleep(0.2)
    hands.button(1, True)
    time.sleep(0.2)
    hands.button(1, False)
    time.sleep(0.5)
    lagged = not strokes(case.journal)
    message = difference(before, case.desktop.screen(), (74, 540, 330, 560))
    wait_for("the stroke", lambda: strokes(case.journal))
    hands.close()
    assert lagged, "the dabs kept up: the test needs more of them"
    assert message > 5, f"no message: {message}"
    editor.screenshot()
    assert [op["op"] for op in operations(case.journal)] == ["stroke"], "saved half a stroke"
    finish_and_replay(case, editor)


def files_dropped_together_are_opened_together_or_not_at_all(case):
    editor = case.open(case.journal)
    mesh = os.path.join(case.folder, "meshes", "asteroid.obj")
    other = shutil.copy(case.map, os.path.join(case.folder, "maps", "other.png"))
    drop(case.desktop.display, editor.window, [case.map, other])
    editor.screenshot()
    assert len(case.preferences()["recent"]) == 1, case.preferences()
    drop(case.desktop.display, editor.window, [other, mesh])
    wait_for("the mesh with the map", lambda: "-other-" in case.preferences()["recent"][0])
    editor.focus()
    editor.screenshot()
    with open(case.preferences()["recent"][0]) as file:
        thing = json.load(file)["objects"][0]
    assert thing["mesh"] == mesh and thing["displacement"]["map"] == other, thing
    drop(case.desktop.display, editor.window, [mesh, case.scene, other])
    wait_for("the scene", lambda: case.preferences()["recent"][0] == case.scene)
    editor.focus()
    editor.screenshot()
    case.desktop.key("ctrl+q")
    editor.ended()


def a_scene_that_cannot_be_opened_takes_nothing_away(case):
    editor = case.open(case.journal)
    case.stroke(case.journal)  # which is not saved
    bad = os.path.join(case.folder, "bad.json")
    with open(bad, "w") as file:
        json.dump({"relievo": 1, "objects": [{"mesh": "none.obj"}]}, file)
    cut = os.path.join(case.folder, "cut.png")  # which only its texels tell
    with open(case.map, "rb") as whole, open(cut, "wb") as file:
        file.write(whole.read()[:5000])
    coloured = os.path.join(case.folder, "coloured.json")  # what it looks like is read last
    with open(coloured, "w") as file:
        json.dump({"relievo": 1, "objects": [{"mesh": "meshes/asteroid.obj", "material": {"albedo_map": "cut.png"}}]},
                  file)
    for path in (bad, cut, coloured):
        drop(case.desktop.display, editor.window, [path])
        editor.screenshot()
        click(case, 504, 333)  # Don't save
        editor.screenshot()
    assert case.recovery_journals(), "the stroke could not be restored any more"
    case.command("ctrl+z", "undo")
    case.command("ctrl+y", "redo")
    case.command("ctrl+s", "save")
    case.desktop.key("ctrl+q")
    editor.ended()


def what_is_dropped_on_a_save_dialog_opens_after_the_answer_about_unsaved_work(case):
    editor = case.open(case.journal)
    other = shutil.copy(case.scene, os.path.join(case.folder, "scenes", "other.json"))
    case.stroke(case.journal)
    case.desktop.key("ctrl+shift+s")
    editor.screenshot()
    drop(case.desktop.display, editor.window, [other])
    editor.screenshot()
    time.sleep(1)
    click(case, 504, 333)  # Don't save
    wait_for("the other scene", lambda: case.preferences()["recent"][0] == other)
    editor.focus()
    editor.screenshot()
    case.desktop.key("ctrl+q")
    editor.ended()


def a_long_restore_can_be_stopped_and_done_later(case):
    editor = case.open()
    case.desktop.drag(STROKE)
    journal = wait_for("the recovery journal", case.recovery_journals)[0]
    wait_for("the stroke in it", lambda: strokes(journal))
    editor.kill()
    with open(journal) as file:
        header, stroke = file.read().split("\n")[:2]
    with open(journal, "w") as file:
        file.write("\n".join([header, *[stroke] * RESTORED]) + "\n")
    expected = os.path.join(case.folder, "expected.tif")
    case.replay(shutil.copy(journal, os.path.join(case.folder, "kept.jsonl")), expected)

    def under_way():
        fresh = [path for path in case.recovery_journals() if path != journal]
        return fresh and len(strokes(fresh[0])) > 5

    editor = case.open()
    case.desktop.key("Return")  # Restore
    wait_for("some strokes to be restored", under_way)
    time.sleep(1)  # for what shows how far it is
    case.desktop.key("Escape")
    wait_for("the old journal alone", lambda: case.recovery_journals() == [journal])
    editor.focus()
    editor.screenshot()
    case.desktop.key("ctrl+q")
    editor.ended()

    editor = case.open()
    case.desktop.key("Return")
    wait_for("all to be restored", lambda: not os.path.exists(journal))
    editor.focus()
    editor.screenshot()
    restored = os.path.join(case.folder, "restored.tif")
    editor.save_as(restored)
    case.desktop.key("ctrl+q")
    editor.ended()
    case.same_bytes(expected, restored)


if __name__ == "__main__":
    run((memory_of_compilers_goes_back, a_press_that_waits_for_a_save_is_no_long_one, a_long_save_shows_how_far_it_is_and_can_be_stopped,
         a_picture_being_saved_can_be_stopped_and_keeps_its_size, journals_deleted_between_strokes_miss_nothing,
         what_cannot_be_saved_on_the_way_out_is_saved_elsewhere, dialogs_fit_a_small_window_with_large_letters,
         a_menu_higher_than_the_window_scrolls_to_its_end,
         a_command_during_a_stroke_that_lags_is_refused_aloud,
         files_dropped_together_are_opened_together_or_not_at_all, a_scene_that_cannot_be_opened_takes_nothing_away,
         what_is_dropped_on_a_save_dialog_opens_after_the_answer_about_unsaved_work,
         a_long_restore_can_be_stopped_and_done_later))
