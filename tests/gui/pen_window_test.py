"""A pen in the real window, pretended (pretended_pen.cpp): its pressure is the pointer's y."""
import contextlib
import os

from desktop import strokes
from window_test import run

FULL = 600  # pixels: as high as the desktop
DOWN = [(300, 240 + 4 * i) for i in range(31)]


@contextlib.contextmanager
def pen(**variables):
    """For programs that start within."""
    before = dict(os.environ)
    os.environ.update(LD_PRELOAD=os.environ["PRETENDED_PEN"], RELIEVO_PEN_FULL=str(FULL), **variables)
    try:
        yield
    finally:
        os.environ.clear()
        os.environ.update(before)


def pressures(stroke):
    return [dab[4] / 65535 for dab in stroke["dabs"]]


def pressure_goes_into_dabs(case):
    case.open(case.journal)
    assert set(pressures(case.stroke(case.journal, DOWN))) == {1}, "a mouse presses fully"
    case.editor.kill()
    other = os.path.join(case.folder, "pen.jsonl")
    with pen():
        case.open(other)
    case.desktop.key("Escape")  # what the first one left is offered
    stroke = case.stroke(other, DOWN)
    got = pressures(stroke)
    assert len(got) > 8 and got == sorted(got), got
    assert abs(got[0] - DOWN[0][1] / FULL) < 0.002, got[0]
    # Dabs lie by length along the stroke, and so do pressures: neither knows of frames.
    steps = [b - a for a, b in zip(got, got[1:])]
    assert DOWN[-1][1] / FULL - got[-1] < 2 * max(steps), (got, steps)
    assert max(steps) < 0.05, steps


def the_eraser_lowers(case):
    with pen(RELIEVO_PEN_ERASER="1"):
        case.open(case.journal)
    assert case.stroke(case.journal, DOWN)["brush"]["invert"] is True
    case.desktop.do("keydown", "ctrl")
    with_control = case.stroke(case.journal, DOWN)
    case.desktop.do("keyup", "ctrl")
    assert with_control["brush"].get("invert", False) is False, "the opposite of the opposite"


if __name__ == "__main__":
    run((pressure_goes_into_dabs, the_eraser_lowers))
