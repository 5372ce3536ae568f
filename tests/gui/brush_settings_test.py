"""Settings of the brush chosen with the pointer in the real window: what the next strokes hold, what they do to the
map, and that the journal replays to the saved bytes."""
import os
import time

from desktop import Desktop, Editor, operations, strokes, wait_for
from hands import Hands
from stamp_clone_test import leave_and_replay
from window_test import STROKE, run

# Places in a window of 900 x 600 pixels.
UNIT, SIZE_LEFT = (789, 101), (715, 131)
MORE = (788, 22)
SYMMETRY_X = (718, 85)  # in the list behind it
ERASE_TO = (789, 281)
FALLOFF = (789, 461)
FIRST_CHOICE, NEXT_CHOICE = 29, 22  # below a row's middle, and from one choice to the next
LEFT, RIGHT, FLOOR, RISE = 602, 871, 570, 84  # the falloff's profile, drawn by hand


def place(part, weight):
    """In the profile, right of its middle."""
    return round(LEFT + (0.5 + 0.5 * part) * (RIGHT - LEFT)), round(FLOOR - weight * RISE)


def click(case, place, button=1):
    case.desktop.do("mousemove", *place)
    time.sleep(0.3)
    case.desktop.do("click", button)
    time.sleep(0.5)


def choose(case, row, index):
    click(case, row)
    click(case, (row[0], row[1] + FIRST_CHOICE + NEXT_CHOICE * index))


def drag_in_panel(case, start, end):
    """Slowly: a panel sees the pointer once a frame."""
    case.desktop.do("mousemove", *start)
    time.sleep(0.5)
    case.desktop.do("mousedown", 1)
    time.sleep(0.5)
    for part in (0.5, 1):
        case.desktop.do("mousemove", *(round(a + part * (b - a)) for a, b in zip(start, end)))
        time.sleep(0.5)
    case.desktop.do("mouseup", 1)
    time.sleep(0.5)


def erase_goes_back_to_what_was_saved(case):
    editor = case.open(case.journal)
    case.stroke(case.journal)
    editor.save_as(os.path.join(case.folder, "once.tif"))
    wait_for("the record of the save", lambda: operations(case.journal)[-1]["op"] == "save")
    case.stroke(case.journal, [(x, y + 20) for x, y in STROKE])
    case.desktop.key("5")
    assert case.stroke(case.journal)["brush"].get("erase_to", "midlevel") == "midlevel"
    choose(case, ERASE_TO, 1)
    stroke = case.stroke(case.journal)
    assert stroke["brush"]["tool"] == "erase" and stroke["brush"]["erase_to"] == "saved", stroke
    leave_and_replay(case, editor)  # what was saved is none of the files there: the journal tells it


def falloff_is_drawn_by_hand(case):
    editor = case.open(case.journal)
    choose(case, FALLOFF, 4)
    standard = case.stroke(case.journal)["brush"]
    assert standard["falloff"] == "custom" and "falloff_curve" not in standard, standard

    # The second of its points, on the right side, to less than half of its weight.
    drag_in_panel(case, place(0.25, 0.84), place(0.25, 0.4))
    drawn = case.stroke(case.journal)["brush"]["falloff_curve"]
    assert len(drawn) == 5 and abs(drawn[1][0] - 0.25) < 0.03 and abs(drawn[1][1] - 0.4) < 0.05, drawn
    click(case, place(0.25, 0.4), button=3)
    fewer = case.stroke(case.journal)["brush"]["falloff_curve"]
    assert fewer == drawn[:1] + drawn[2:], (drawn, fewer)
    leave_and_replay(case, editor)


def symmetry_is_behind_more_where_the_bar_is_short(case):
    editor = case.open(case.journal)
    click(case, MORE)
    click(case, SYMMETRY_X)
    case.desktop.key("Escape")
    mirrored = case.stroke(case.journal)
    assert mirrored["brush"]["mirror_x"] and len(mirrored["copies"]) == 1, mirrored
    click(case, MORE)
    click(case, SYMMETRY_X)
    case.desktop.key("Escape")
    assert "copies" not in case.stroke(case.journal)
    leave_and_replay(case, editor)


def a_stroke_that_comes_over_a_panel_pushes_nothing_there(case):
    case.desktop = Desktop(case.folder)
    # So few frames that the pointer is over the panel before the first of them after the press.
    case.editor = Editor(case.desktop, case.relievo, case.scene, case.folder, case.journal, ["--most-fps", "2"])
    case.editor.screenshot()
    first = case.stroke(case.journal)["brush"]
    hands = Hands(case.desktop.display)
    hands.move(*STROKE[0])
    time.sleep(0.8)
    hands.button(1, True)
    hands.move(*SIZE_LEFT)
    time.sleep(1.6)
    hands.button(1, False)
    wait_for("the stroke", lambda: len(strokes(case.journal)) == 2)
    assert case.stroke(case.journal)["brush"] == first
    # The other way about, the slider gets what was meant for it.
    hands.move(*SIZE_LEFT)
    time.sleep(0.8)
    hands.button(1, True)
    hands.move(*STROKE[0])
    hands.button(1, False)
    time.sleep(1.6)
    assert case.stroke(case.journal)["brush"]["radius"] < first["radius"] / 2
    hands.close()
    leave_and_replay(case, case.editor)


def drags_of_the_size_go_back_and_held_keys_repeat_what_helps(case):
    editor = case.open(case.journal)
    choose(case, UNIT, 1)
    first = case.stroke(case.journal)["brush"]
    assert not first.get("mirror_x"), first

    def radius_after_drag(end):
        case.desktop.do("mousemove", *STROKE[0])
        case.desktop.key("f")
        case.desktop.do("mousemove", STROKE[0][0] + 150, STROKE[0][1])
        editor.screenshot()
        end()
        editor.screenshot()
        return case.stroke(case.journal)["brush"]["radius"]

    assert radius_after_drag(lambda: case.desktop.key("Escape")) < 1.1 * first["radius"]
    assert radius_after_drag(lambda: case.desktop.do("click", 3)) < 1.1 * first["radius"]
    larger = radius_after_drag(lambda: case.desktop.key("Return"))
    assert larger > 1.5 * first["radius"], "Enter keeps it"

    def hold(key, seconds):
        case.desktop.do("keydown", key, "sleep", seconds, "keyup", key)

    hold("x", 1.5)  # a switch: once
    hold("bracketleft", 1.5)  # X repeats keys after 0.66 s, 25 times a second
    last = case.stroke(case.journal)["brush"]
    assert last.get("mirror_x"), last
    assert last["radius"] < larger / 3, (larger, last)
    leave_and_replay(case, editor)


if __name__ == "__main__":
    run((a_stroke_that_comes_over_a_panel_pushes_nothing_there, drags_of_the_size_go_back_and_held_keys_repeat_what_helps,
         erase_goes_back_to_what_was_saved, falloff_is_drawn_by_hand,
         symmetry_is_behind_more_where_the_bar_is_short))
