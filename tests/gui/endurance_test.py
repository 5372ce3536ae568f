"""What long work meets, in the real window: memory, journals and folders that go away, restoring what was long."""
import os
import shutil
import time

from desktop import Desktop, Editor, strokes, wait_for
from random_test import memory_mib
from window_test import STROKE, finish_and_replay, run

MOST_GROWTH_MIB = 40
LEAST_GIVEN_BACK_MIB = 60
RESTORED = 800  # strokes: seconds


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
    early = memory_mib(pid, "VmRSS")
    for key in "vvvvvvcvvvvvv":
        case.desktop.key(key)
        editor.screenshot()
        time.sleep(1)
    late, peak = memory_mib(pid, "VmRSS"), memory_mib(pid, "VmHWM")
    figures = f"{early:.0f} MiB after the first picture, {late:.0f} at the end, {peak:.0f} at most"
    print(figures)
    assert late - early < MOST_GROWTH_MIB and peak - late > LEAST_GIVEN_BACK_MIB, figures
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
    run((memory_of_compilers_goes_back, journals_deleted_between_strokes_miss_nothing,
         what_cannot_be_saved_on_the_way_out_is_saved_elsewhere, dialogs_fit_a_small_window_with_large_letters,
         a_long_restore_can_be_stopped_and_done_later))
