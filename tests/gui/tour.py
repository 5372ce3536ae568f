"""Makes the pictures of the README's tour from the real window: tour.py --relievo PROGRAM --assets FOLDER -o FOLDER.

FOLDER of the assets is the built one. Needs Xvfb, xdotool and oiiotool. The waits are for a processor as device."""
import argparse
import math
import os
import subprocess
import tempfile
import time

from desktop import Desktop, Editor
from hands import Hands

SIZE = (1280, 760)
REFINING_S = 25


class Tour:
    def __init__(self, options, folder, scene, **preferences):
        self.out, self.folder = options.out, folder
        self.desktop = Desktop(folder, *SIZE)
        self.editor = Editor(self.desktop, options.relievo, scene, folder, validation=False, preferences=preferences)
        self.hands = Hands(self.desktop.display)
        self.editor.screenshot()

    def close(self):
        self.hands.close()
        self.editor.kill()
        self.desktop.close()

    def stroke(self, points, held=()):
        self.hands.move(*points[0])
        time.sleep(0.3)
        for key in held:
            self.hands.key(key, True)
        self.hands.button(1, True)
        for x, y in points:
            self.hands.move(x, y)
            time.sleep(0.02)
        self.hands.button(1, False)
        for key in held:
            self.hands.key(key, False)
        time.sleep(0.5)

    def picture(self, name):
        time.sleep(5)  # until messages are gone
        source = self.editor.screenshot()
        target = os.path.join(self.out, f"tour_{name}.jpg")
        subprocess.run(["oiiotool", source, "--ch", "R,G,B", "--resize", "1024x608", "--compression", "jpeg:86", "-o", target],
                       check=True)
        print(target, os.path.getsize(target), "bytes")


def first_minute(options, folder):
    tour = Tour(options, folder, None, first_hint_seen=False)
    try:
        tour.hands.move(520, 330)
        time.sleep(REFINING_S)
        tour.picture("start")
    finally:
        tour.close()


def spiral(x, y, radius, turns):
    count = int(60 * turns)
    return [(int(x + radius * i / count * math.cos(i * 2 * math.pi * turns / count)),
             int(y + radius * i / count * math.sin(i * 2 * math.pi * turns / count))) for i in range(count)]


def sculpting(options, folder):
    tour = Tour(options, folder, os.path.join(options.assets, "scenes", "asteroid.json"))
    try:
        for _ in range(3):
            tour.stroke(spiral(500, 310, 120, 2.5))
        for _ in range(2):
            tour.stroke([(300 + 4 * i, 500 - int(30 * math.sin(i / 9))) for i in range(80)], held=["Control_L"])
            tour.stroke([(700 + int(40 * math.sin(i / 8)), 240 + 4 * i) for i in range(60)])
        tour.hands.move(600, 400)
        time.sleep(REFINING_S)
        tour.picture("sculpted")
    finally:
        tour.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--relievo", required=True, type=os.path.abspath)
    parser.add_argument("--assets", required=True, type=os.path.abspath)
    parser.add_argument("-o", "--out", required=True, type=os.path.abspath)
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    for part in (first_minute, sculpting):
        with tempfile.TemporaryDirectory() as folder:
            part(options, folder)


if __name__ == "__main__":
    main()
