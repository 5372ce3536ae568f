"""What an hour of work meets, in the real window: memory, journals and files that go away."""
import time

from random_test import memory_mib
from window_test import run

MOST_GROWTH_MIB = 40
LEAST_GIVEN_BACK_MIB = 60


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


if __name__ == "__main__":
    run((memory_of_compilers_goes_back,))
