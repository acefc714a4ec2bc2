#!/usr/bin/env python3
# hand_test.py -- what the hand does in the window beyond a plain stroke; run like gui_test.py.
import unittest

import gui_test

# Places in a window of 1280 by 720.
PX = (175, 390)  # the button beside the radius
CLEAR, FILL = (101, 527), (162, 527)  # of the mask, below the falloff
STRING = (110, 600)  # the bar of the stabiliser, with the panel at its end
REGIONS = (1228, 80)  # the tab
WHERE, LASSO = (1060, 134), (1000, 303)  # the list and its last entry
DRAW, APPLY = (1115, 162), (1115, 335)  # with a lasso chosen


def numbers(line):
    """The points of a stroke as lists of numbers; each has seven with a pressure."""
    head, _, tail = line.partition(" : ")
    each = 7 if head.endswith("pressure") else 6
    values = [float(word) for word in tail.split()]
    return [values[i:i + each] for i in range(0, len(values), each)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


class Hand(gui_test.WindowTest):
    def open(self):
        editor = self.start(self.mesh)
        editor.ready()
        return editor

    def last(self, editor):
        return editor.journal().splitlines()[-1]

    def test_shift_and_click_paints_a_straight_line_from_the_last_stroke(self):
        editor = self.open()
        editor.key("l")
        editor.drag()
        editor.expect("commit Length")
        x, y = editor.middle
        editor.do("keydown", "shift", "mousemove", int(x - 1.5 * editor.reach),
                  int(y + editor.reach))
        editor.settle()
        self.shoot("straight.png")
        editor.do("click", 1)
        editor.expect("commit Length")
        editor.do("keyup", "shift")
        points = [point[:3] for point in numbers(self.last(editor))]
        self.assertGreater(len(points), 10)
        # A straight line of the picture: all points lie in a plane through the eye.
        first, last = points[0], points[-1]
        chord = minus(last, first)
        normals = [cross(chord, minus(p, first)) for p in points]
        largest = max(normals, key=lambda n: dot(n, n))
        size = dot(largest, largest) ** 0.5
        self.assertGreater(size, 1e-4 * dot(chord, chord), "the skin is curved")
        for p in points:
            distance = abs(dot(largest, minus(p, first))) / size
            self.assertLess(distance, 1e-3 * dot(chord, chord) ** 0.5)
        editor.key("ctrl+z")
        editor.expect("undo Length")
        editor.key("ctrl+shift+z")
        editor.expect("redo")
        lines = editor.journal()
        saved = editor.save(self.path("line.glb"))
        self.assertEqual(editor.close(), 0)
        self.assertReplayGives(lines, saved)

    def test_dragging_a_gradient_is_one_line_and_one_step(self):
        editor = self.open()
        editor.key("l")
        editor.key("g")
        editor.drag(release=False)
        editor.settle()
        self.shoot("gradient.png")
        editor.do("mouseup", 1)
        editor.expect("commit Gradient of length")
        lines = editor.journal()
        self.assertEqual(len(lines.splitlines()), 2, lines)
        self.assertTrue(self.last(editor).startswith("gradient length from "), lines)
        words = self.last(editor).split()
        self.assertNotEqual(words[3:6], words[8:11], "two places")
        editor.key("Escape")
        editor.settle()
        saved = editor.save(self.path("gradient.glb"))
        editor.key("ctrl+z")
        editor.expect("undo Gradient of length")
        editor.process.kill()
        self.assertReplayGives(lines, saved)

    def test_the_eyedropper_takes_the_length_under_the_pointer(self):
        editor = self.open()
        found = self.info(self.mesh)
        box = found["bounds"]
        size = sum((b - a) ** 2 for a, b in zip(box["min"], box["max"])) ** 0.5
        # Hair that nobody has painted is equally long everywhere.
        first = {"min": 0.04 * size, "max": 0.04 * size}
        lengths = found["fields"].get("length", first)
        editor.key("l")
        x, y = editor.middle
        editor.do("mousemove", int(x), int(y), "sleep", "0.2", "key", "e")
        picked = float(editor.expect("picked length"))
        self.assertGreater(picked, lengths["min"] - 1e-5 * size)
        self.assertLess(picked, lengths["max"] + 1e-5 * size)
        editor.do("key", "d", "key", "e")
        self.assertEqual(float(editor.expect("picked density")), 1.0)
        self.shoot("picked.png")
        editor.process.kill()

    def test_buttons_and_keys_change_the_whole_mask(self):
        editor = self.open()
        editor.key("m")
        editor.settle()
        self.shoot("mask.png")
        editor.click(FILL)
        editor.expect("commit Mask: fill")
        editor.click(CLEAR)
        editor.expect("commit Mask: clear")
        editor.settle()
        editor.drag()
        editor.expect("commit Mask")
        editor.key("ctrl+i")
        editor.expect("commit Mask: invert")
        editor.key("l")
        editor.drag()
        editor.expect("commit Length")
        lines = editor.journal()
        self.assertIn("mask fill\nmask clear\nstroke mask", lines)
        self.assertIn("\nmask invert\n", lines)
        saved = editor.save(self.path("masked.glb"))
        self.assertEqual(editor.close(), 0)
        self.assertReplayGives(lines, saved)

    def test_a_lasso_is_the_region(self):
        editor = self.open()
        for place in (REGIONS, WHERE, LASSO, DRAW):
            editor.click(place)
        editor.settle()
        x, y = map(int, editor.middle)
        r = int(editor.reach)
        editor.do("mousemove", x, y, "sleep", "0.3", "mousedown", 1)
        for dx, dy in ((r, 0), (r, r), (0, r)):
            editor.do("mousemove", x + dx, y + dy)
            editor.settle()
        self.shoot("lasso.png")
        editor.do("mouseup", 1)
        self.assertEqual(editor.expect("lasso"), "4")
        editor.settle()
        self.shoot("lasso-drawn.png")
        editor.click(APPLY)
        editor.expect("commit Region lasso: length scale")
        lines = editor.journal()
        self.assertIn("region lasso eye ", lines)
        saved = editor.save(self.path("lasso.glb"))
        self.assertEqual(editor.close(), 0)
        self.assertReplayGives(lines, saved)

    def test_a_held_key_presses_lightly(self):
        editor = self.open()
        editor.key("l")
        editor.do("keydown", "z")
        editor.drag()
        editor.expect("commit Length")
        editor.do("keyup", "z")
        pressures = [point[6] for point in numbers(self.last(editor))]
        self.assertEqual(set(pressures), {0.15})
        editor.drag()
        editor.expect("commit Length")
        self.assertEqual(len(numbers(self.last(editor))[0]), 6, "full pressure is not written")
        editor.process.kill()

    def test_the_radius_in_screen_units_follows_the_distance(self):
        editor = self.open()
        editor.key("l")
        editor.click(PX)
        editor.settle()
        radii = []
        for zoomed in (False, True):
            if zoomed:
                x, y = map(int, editor.middle)
                editor.do("mousemove", x, y, "click", 4, "sleep", "0.3", "click", 4)
                editor.settle()
                self.shoot("nearer.png")
            editor.drag()
            editor.expect("commit Length")
            words = self.last(editor).split()
            radii.append(float(words[words.index("radius") + 1]))
        self.assertLess(radii[1], 0.9 * radii[0])
        self.assertGreater(radii[1], 0.5 * radii[0])
        editor.process.kill()

    def test_the_brush_hangs_behind_the_pointer_by_a_string(self):
        editor = self.open()
        editor.key("l")
        editor.drag()
        editor.expect("commit Length")
        free = numbers(self.last(editor))
        self.drawString(editor)
        editor.drag(release=False)
        editor.settle()
        self.shoot("string.png")
        editor.do("mouseup", 1)
        editor.expect("commit Length")
        steady = numbers(self.last(editor))
        length = lambda points: dot(*[minus(points[-1][:3], points[0][:3])] * 2) ** 0.5
        self.assertLess(length(steady), 0.8 * length(free))
        editor.process.kill()

    def drawString(self, editor):
        """Drags the bar of the stabiliser."""
        editor.do("mousemove", 100, 600, "sleep", "0.2", "click", "--repeat", 30, 5)
        editor.settle()
        self.shoot("panel-end.png")
        editor.do("mousemove", *STRING, "sleep", "0.2", "mousedown", 1, "sleep", "0.2", "mousemove",
                  STRING[0] + 12, STRING[1], "sleep", "0.2", "mouseup", 1)
        editor.settle()


if __name__ == "__main__":
    unittest.main(argv=gui_test.sys.argv[:-3])
