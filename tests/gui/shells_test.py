#!/usr/bin/env python3
# shells_test.py -- shells of a photograph in the window; run like gui_test.py.
import os
import subprocess
import unittest

import gui_test

# Places in a window of 1280 by 720.
VIEW, SHELLS, FROM, PHOTOGRAPH = (1052, 80), (1120, 501), (1120, 558), (1040, 608)
PANEL = (1000, 400)
# With the panel scrolled down to its end.
LAYERS, TWO_COLORS = (1170, 202), (983, 312)
HISTOGRAM, SHEET = "282x72+974+113", "282x140+974+353"
VIEWPORT = "640x560+270+100"


class ShellsOfAPhotograph(gui_test.WindowTest):
    def setUp(self):
        super().setUp()
        self.take("--animal", "2000")
        self.photo = self.path("fur.png")
        # Bright spots on dark, grey to the left and orange to the right.
        subprocess.run(
            ["convert", "-seed", "1", "-size", "128x256", "plasma:black-white", "-colorspace", "gray",
             "(", "+clone", "-fill", "orange", "-colorize", "60", ")", "+append",
             "PNG24:" + self.photo], check=True)

    def colors(self, name, part):
        """How many colors a part of a screenshot has."""
        return int(subprocess.run(
            ["convert", os.path.join(gui_test.OUT, name), "-crop", part, "+repage", "-format", "%k",
             "info:"], check=True, capture_output=True, text=True).stdout)

    def differs(self, a, b, part):
        """Pixels of that part that differ between two screenshots."""
        paths = [os.path.join(gui_test.OUT, name) for name in (a, b)]
        crops = [word for path in paths for word in ("(", path, "-crop", part, "+repage", ")")]
        result = subprocess.run(["compare", "-metric", "AE", "-fuzz", "2%", *crops, "null:"],
                                capture_output=True, text=True)
        return float(result.stderr)

    def shown(self, editor, name):
        editor.settle()
        self.shoot(name)

    def test_a_photograph_is_opened_shown_cut_in_layers_and_colors_and_is_no_step(self):
        editor = self.start(self.mesh)
        editor.ready()
        editor.click(VIEW)
        editor.click(SHELLS)
        self.shown(editor, "shells-hairs.png")
        editor.click(FROM)
        editor.click(PHOTOGRAPH)
        editor.type(self.photo)
        self.assertEqual(editor.expect("shells of"), "photograph 256x256, 16 layers, colors 1")
        editor.settle()
        editor.do("mousemove", *PANEL, *(["click", 5] * 30))
        self.shown(editor, "shells-photo.png")
        self.assertGreater(self.differs("shells-hairs.png", "shells-photo.png", VIEWPORT), 10000)
        for part in (HISTOGRAM, SHEET):
            self.assertGreater(self.colors("shells-photo.png", part), 20, part)

        editor.click(TWO_COLORS)
        self.assertEqual(editor.expect("shells of"), "photograph 256x256, 16 layers, colors 2")
        editor.do("mousemove", *PANEL)
        self.shown(editor, "shells-two.png")
        self.assertGreater(self.differs("shells-photo.png", "shells-two.png", HISTOGRAM), 100)

        x, y = LAYERS
        editor.do("mousemove", x, y, "sleep", "0.2", "mousedown", 1, "mousemove", x - 30, y, "sleep",
                  "0.2", "mousemove", x - 55, y, "sleep", "0.2", "mouseup", 1)
        layers = editor.expect("shells of")
        self.assertRegex(layers, r"^photograph 256x256, \d+ layers, colors 2$")
        self.assertNotIn(" 16 layers", layers)
        editor.do("mousemove", *PANEL)
        self.shown(editor, "shells-fewer.png")
        self.assertGreater(self.differs("shells-two.png", "shells-fewer.png", VIEWPORT), 1000)

        # Which picture is used is no step of history: taking one back leaves it.
        editor.drag()
        editor.expect("commit Comb")
        editor.key("ctrl+z")
        editor.expect("undo Comb")
        editor.do("mousemove", *PANEL)
        self.shown(editor, "shells-undone.png")
        self.assertLess(self.differs("shells-fewer.png", "shells-undone.png", VIEWPORT), 200)
        self.assertEqual(editor.close(), 0)

    def test_what_is_no_photograph_is_one_clear_line_and_changes_nothing(self):
        for name, content in (("text.png", b"No picture.\n"), ("cut.png", None)):
            if content is None:
                with open(self.photo, "rb") as file:
                    content = file.read(500)
            with open(self.path(name), "wb") as file:
                file.write(content)
        editor = self.start(self.mesh)
        editor.ready()
        for name, why in (
                ("text.png", "is no PNG or JPEG picture: its 12 bytes begin with 4e 6f 20 70"),
                ("cut.png", "ends after 500 bytes, in the middle of the picture")):
            gui_test.xdnd.drop(self.display.name, editor.window(), self.path(name))
            editor.settle()
            editor.key("Return")
            editor.settle()
            complaints = [line for line in editor.stderr().splitlines() if name in line]
            self.assertEqual(complaints, [f"pelage: {self.path(name)}: {why}"])
        gui_test.xdnd.drop(self.display.name, editor.window(), self.photo)
        self.assertEqual(editor.expect("shells of"), "photograph 256x256, 16 layers, colors 1")
        self.assertEqual(editor.close(), 0)


if __name__ == "__main__":
    unittest.main(argv=gui_test.sys.argv[:-3])
