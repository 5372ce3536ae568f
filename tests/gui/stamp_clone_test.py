"""Stamp and clone in the real window: what a click, a drag, Alt+F and Ctrl+click leave in the journal, and that it
replays to the saved bytes."""
import math
import os

from desktop import operations, strokes, wait_for
from window_test import STROKE, run

ROW = [(230 + 5 * i, 300) for i in range(31)]


def right_of(dab):
    """Where the stamp's right lies, as a unit vector."""
    length = math.sqrt(sum(part * part for part in dab[6:9]))
    return [part / length for part in dab[6:9]]


def angle(a, b):
    return math.degrees(math.acos(max(-1, min(1, sum(x * y for x, y in zip(a, b))))))


def leave_and_replay(case, editor):
    saved, replayed = os.path.join(case.folder, "saved.tif"), os.path.join(case.folder, "replayed.tif")
    editor.save_as(saved)
    wait_for("the record of the save", lambda: operations(case.journal)[-1]["op"] == "save")
    case.desktop.key("ctrl+q")
    editor.ended()
    case.replay(case.journal, replayed)
    case.same_bytes(saved, replayed)


def stamp_clicks_rows_and_turns(case):
    editor = case.open(case.journal)
    case.desktop.key("shift+4")
    click = case.stroke(case.journal, [(300, 280), (300, 281)])
    assert click["brush"]["tool"] == "stamp" and len(click["dabs"]) == 1, click
    assert os.path.basename(click["alpha"]["file"]) == "cracks.png" and len(click["alpha"]["hash"]) == 16, click
    assert not os.path.isabs(click["alpha"]["file"]), "journals and images can move together"
    row = case.stroke(case.journal, ROW)
    assert 2 <= len(row["dabs"]) <= 8, "side by side"
    assert angle(right_of(row["dabs"][0]), right_of(click["dabs"][0])) < 15, "upright, but for the perspective"

    # Alt + F turns it until a click; Esc takes it back.
    case.desktop.do("mousemove", 300, 280)
    case.desktop.key("alt+f")
    case.desktop.do("mousemove", 360, 280)
    case.desktop.do("click", 1)
    turned = case.stroke(case.journal, [(300, 280), (300, 281)])["brush"]["rotation"]
    assert 20 < turned < 80, turned
    case.desktop.key("alt+f")
    case.desktop.do("mousemove", 420, 280)
    case.desktop.key("Escape")
    assert case.stroke(case.journal, [(300, 280), (300, 281)])["brush"]["rotation"] == turned
    case.desktop.key("ctrl+z")
    leave_and_replay(case, editor)


def clone_copies_from_where_ctrl_clicked(case):
    editor = case.open(case.journal)
    case.desktop.key("shift+5")
    case.desktop.drag(STROKE)
    editor.screenshot()
    assert not strokes(case.journal), "nothing to copy from yet"
    case.desktop.do("mousemove", 330, 200)
    case.desktop.do("keydown", "ctrl")
    case.desktop.do("click", 1)
    case.desktop.do("keyup", "ctrl")
    first = case.stroke(case.journal)
    assert first["brush"]["tool"] == "clone" and not first["brush"]["invert"], first
    assert len(first["sources"]) == 1 and len(first["sources"][0]) == len(first["dabs"]) > 5, first
    assert first["sources"][0][0] != first["sources"][0][-1], "it moves along"
    # Aligned: what a later stroke copies comes from where the first one's movement leads.
    elsewhere = case.stroke(case.journal, [(x, y + 60) for x, y in STROKE])
    assert elsewhere["dabs"][0][6:9] == first["dabs"][0][6:9], "the same turn"
    assert elsewhere["sources"][0][0] != first["sources"][0][0], elsewhere
    leave_and_replay(case, editor)


if __name__ == "__main__":
    run((stamp_clicks_rows_and_turns, clone_copies_from_where_ctrl_clicked))
