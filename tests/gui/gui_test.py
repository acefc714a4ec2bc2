#!/usr/bin/env python3
# gui_test.py -- a person at the editor: a real window under Xvfb, driven by xdotool.
#
# gui_test.py [-v] PELAGE MESHES OUT: the program, the folder of shared meshes (the built-in animal
# is used without it), and a folder for screenshots. What the editor did is read from its trace
# (PELAGE_TRACE=1); what it wrote is compared with the same lines run by the command line.
import csv
import functools
import hashlib
import json
import os
import queue
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import xdnd

PELAGE, MESHES, OUT = sys.argv[-3:]
BUNNY = os.path.join(MESHES, "stanford-bunny.obj")
PATIENCE = 90  # s until a trace line must have come; software OpenGL on a busy machine is slow
MADE = tempfile.TemporaryDirectory()  # of meshes, for all tests


@functools.cache
def furry(*source):
    """A groomed .glb, made once, of as few hairs as software OpenGL draws quickly."""
    path = os.path.join(MADE.name, f"{len(os.listdir(MADE.name))}.glb")
    subprocess.run([PELAGE, "export", *source, "--hairs", "5000", "-o", path], check=True,
                   stdout=subprocess.DEVNULL)
    return path


class Display:
    """An X server of our own, on a free display number."""

    def __init__(self, size="1280x720"):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", size + "x24", "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.name = ":" + number.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()


class Editor:
    """One run of the program; `folder` holds its settings and its journal."""

    def __init__(self, display, folder, *arguments):
        self.folder = folder
        self.environment = dict(
            os.environ, DISPLAY=display.name, PELAGE_TRACE="1", HOME=folder,
            XDG_STATE_HOME=os.path.join(folder, "state"),
            XDG_DATA_HOME=os.path.join(folder, "data"),
            XDG_CONFIG_HOME=os.path.join(folder, "config"))
        for unwanted in ("WAYLAND_DISPLAY", "PELAGE_SCALE"):
            self.environment.pop(unwanted, None)
        self.complaints = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen(
            [PELAGE, *arguments], env=self.environment, text=True, stdout=subprocess.PIPE,
            stderr=self.complaints, cwd=folder)
        self.lines = queue.Queue()
        self.latest = None  # of what was read from them since something was done
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self.process.stdout:
            self.lines.put(line.strip())
        self.lines.put(None)

    def expect(self, start):
        """The rest of the next trace line that begins like this; others are skipped."""
        wanted, seen, end = "trace: " + start, [], time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                line = self.lines.get(timeout=1)
            except queue.Empty:
                continue
            if line is None:
                break
            seen.append(line)
            self.latest = line
            if line.startswith(wanted):
                return line[len(wanted):].strip()
        raise AssertionError(f"no '{wanted}' after {seen}; stderr: {self.stderr()}")

    def settle(self):
        """Until all that was done is shown."""
        while self.latest != "trace: rest" or not self.lines.empty():
            self.expect("")

    def ready(self):
        self.expect("opened")
        x, y, width, height = map(float, self.expect("ready, viewport").split())
        self.settle()
        self.middle = (x + width / 2, y + height / 2)
        self.reach = min(width, height) / 10

    def do(self, *command):
        """What was traced before is forgotten."""
        while not self.lines.empty():
            self.lines.get()
        self.latest = None
        subprocess.run(["xdotool", *map(str, command)], env=self.environment, check=True)

    def window(self):
        found = subprocess.run(["xdotool", "search", "--pid", str(self.process.pid)],
                               env=self.environment, check=True, capture_output=True, text=True)
        return int(found.stdout.split()[0])

    def key(self, name):
        self.do("key", name)

    def click(self, place):
        """Once all before is shown, since a place is clicked that is seen."""
        self.settle()
        self.do("mousemove", *place, "sleep", "0.1", "click", 1)

    def drag(self, release=True):
        x, y = map(int, self.middle)
        path = ["mousemove", x, y, "sleep", "0.2", "mousedown", 1]
        for step in range(1, 6):
            path += ["mousemove", x + int(step * self.reach / 5), y, "sleep", "0.05"]
        self.do(*path, *(["mouseup", 1] if release else []))

    def answer(self, key, path):
        """Types a path over the one that the dialog of the key proposes."""
        self.key(key)
        self.type(path)

    def type(self, text):
        """Into the field that takes the keyboard now."""
        self.expect("typing")
        self.do("type", "--delay", "10", text)
        self.key("Return")

    def save(self, path):
        # Not ctrl+s: where the mesh is a groomed .glb that writes the same file without asking.
        self.answer("ctrl+shift+s", path)
        return self.expect("saved")

    def journal(self):
        folder = os.path.join(self.folder, "state", "pelage")
        names = [name for name in os.listdir(folder) if name.endswith(".journal")]
        assert len(names) == 1, names
        with open(os.path.join(folder, names[0])) as file:
            return file.read()

    def journals(self):
        return os.listdir(os.path.join(self.folder, "state", "pelage"))

    def stderr(self):
        self.complaints.seek(0)
        return self.complaints.read()

    def close(self):
        self.key("ctrl+q")
        return self.process.wait(timeout=PATIENCE)

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        self.complaints.close()


class WindowTest(unittest.TestCase):
    """A display, a home of its own, and a mesh."""

    def setUp(self):
        self.display = Display()
        self.addCleanup(self.display.close)
        self.home = tempfile.TemporaryDirectory()
        self.addCleanup(self.home.cleanup)
        self.take(*([BUNNY] if os.path.exists(BUNNY) else ["--animal", "60000"]))

    def take(self, *source):
        """A mesh of its own: a furry copy of a file, or of the built-in animal."""
        self.mesh = self.path("mesh.glb")
        shutil.copy(furry(*source), self.mesh)

    def path(self, name):
        return os.path.join(self.home.name, name)

    def start(self, *arguments):
        editor = Editor(self.display, self.home.name, *arguments)
        self.addCleanup(editor.end)
        return editor

    def info(self, path):
        return json.loads(subprocess.run([PELAGE, "info", path, "--json"], check=True,
                                         capture_output=True, text=True).stdout)

    def assertReplayGives(self, lines, saved):
        """The command line makes the same file of the journal, byte for byte."""
        first, rest = lines.split("\n", 1)
        with open(self.path("lines.txt"), "w") as script:
            script.write(rest)
        subprocess.run([PELAGE, "export", first.removeprefix("open "), "-o", self.path("again.glb"),
                        "--script", self.path("lines.txt")], check=True, stdout=subprocess.DEVNULL)
        with open(saved, "rb") as a, open(self.path("again.glb"), "rb") as b:
            self.assertTrue(a.read() == b.read(), f"replaying differs from what was saved:\n{rest}")

    def shoot(self, name):
        subprocess.run(["import", "-window", "root", os.path.join(OUT, name)],
                       env=dict(os.environ, DISPLAY=self.display.name), check=True)


class EditorInAWindow(WindowTest):
    def test_a_painted_stroke_is_undone_redone_saved_and_read_again(self):
        self.mesh = BUNNY if os.path.exists(BUNNY) else self.mesh
        editor = self.start(self.mesh)
        editor.ready()
        editor.key("l")
        editor.drag()
        editor.expect("commit Length")
        editor.key("ctrl+z")
        editor.expect("undo")
        editor.key("ctrl+shift+z")
        editor.expect("redo")
        lines = editor.journal()
        self.assertIn("undo\nredo\n", lines)
        saved = editor.save(self.path("painted.glb"))
        self.assertEqual(saved, self.path("painted.glb"))
        self.shoot("painted.png")
        editor.answer("ctrl+e", self.path("exported.glb"))
        self.assertIn("equal to the bit", editor.expect("exported"))
        self.assertEqual(editor.close(), 0)
        self.assertEqual(editor.journals(), [], "a good end leaves no journal")
        self.assertReplayGives(lines, saved)

        before, after = self.info(self.mesh), self.info(saved)
        self.assertTrue(after["hasFur"])
        self.assertEqual(before["triangles"], after["triangles"])
        again = self.start(saved)
        again.ready()
        self.assertEqual(again.close(), 0)

    def test_killing_it_while_painting_loses_no_committed_step(self):
        editor = self.start(self.mesh)
        editor.ready()
        editor.drag()
        editor.expect("commit Comb")
        lines = editor.journal()
        editor.drag(release=False)
        editor.process.send_signal(signal.SIGKILL)
        editor.process.wait()
        editor.do("mouseup", 1)

        again = self.start(self.mesh)
        self.assertEqual(again.expect("lost"), "1 " + os.path.normpath(self.mesh))
        again.ready()
        self.shoot("lost.png")
        again.key("Return")
        self.assertEqual(again.expect("restored"), "1")
        saved = again.save(self.path("restored.glb"))
        self.assertEqual(again.close(), 0)
        self.assertReplayGives(lines, saved)

    def test_taking_back_what_is_saved_is_kept_as_well(self):
        editor = self.start(self.mesh)
        editor.ready()
        editor.drag()
        editor.expect("commit Comb")
        editor.save(self.path("saved.glb"))
        editor.key("ctrl+z")
        editor.expect("undo")
        editor.process.send_signal(signal.SIGKILL)
        editor.process.wait()

        again = self.start(self.mesh)
        self.assertTrue(again.expect("lost").startswith("1 "))
        again.ready()
        again.key("Return")
        again.expect("restored")
        saved = again.save(self.path("restored.glb"))
        self.assertEqual(again.close(), 0)
        self.assertEqual(again.journals(), [])
        subprocess.run([PELAGE, "export", self.mesh, "-o", self.path("untouched.glb")], check=True,
                       stdout=subprocess.DEVNULL)
        self.assertEqual(self.fur(saved), self.fur(self.path("untouched.glb")))
        self.assertNotEqual(self.fur(saved), self.fur(self.path("saved.glb")))

    def test_a_press_on_a_playing_animal_paints_it_as_it_stands(self):
        fox = os.path.join(MESHES, "Fox.glb")
        if not os.path.exists(fox):
            self.skipTest("Fox.glb is not there")
        self.take(fox)
        editor = self.start(self.mesh)
        editor.ready()
        editor.key("space")
        editor.expect("play")
        time.sleep(1)
        editor.drag()
        pose = editor.expect("pause")
        editor.expect("commit Comb")
        self.shoot("posed.png")
        editor.key("shift+space")
        editor.drag()
        editor.expect("commit Comb")
        lines = editor.journal()
        self.assertTrue(pose.startswith("pose 1 "), pose)
        self.assertEqual([line.split()[0] for line in lines.split("\n")[1:-1]],
                         ["pose", "stroke", "pose", "stroke"])
        self.assertIn("\n" + pose + "\nstroke comb", lines)
        self.assertIn("\npose rest\n", lines)
        saved = editor.save(self.path("posed.glb"))
        self.assertEqual(editor.close(), 0)
        self.assertReplayGives(lines, saved)

    def restore(self, killed):
        """Kills the editor and takes up its work in another one."""
        killed.process.send_signal(signal.SIGKILL)
        killed.process.wait()
        again = self.start(self.mesh)
        again.expect("lost")
        again.ready()
        again.key("Return")
        again.expect("restored")
        return again

    def fur(self, path):
        """All of the fur in a file: its bytes after two exports, which carry the rest unchanged."""
        for name in ("once.glb", "twice.glb"):
            subprocess.run([PELAGE, "export", path, "-o", self.path(name)], check=True,
                           stdout=subprocess.DEVNULL)
            path = self.path(name)
        with open(path, "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()

    def stroke(self, editor):
        editor.drag()
        editor.expect("commit Length")

    def test_an_arrow_of_the_body_is_dragged_and_its_segment_painted(self):
        self.take("--animal", "20000")
        editor = self.start(self.mesh)
        editor.ready()
        editor.click((1167, 80))  # the tab Body
        editor.click((1040, 170))  # the row of the left ear
        editor.settle()
        editor.do("mousemove", 478, 186)  # the tip of that ear
        editor.expect("in reach: tip")
        editor.do("mousedown", 1, "sleep", "0.2", "mousemove", 500, 170, "sleep", "0.2",
                  "mousemove", 530, 140, "sleep", "0.5")
        self.shoot("arrow.png")
        editor.do("mouseup", 1)
        editor.expect("commit Move axis of ear.left")
        editor.key("ctrl+z")
        editor.expect("undo Move axis")
        editor.key("ctrl+shift+z")
        editor.expect("redo Move axis")
        editor.key("j")
        editor.drag()
        editor.expect("commit Segment stroke")
        lines = editor.journal()
        self.assertIn("\nbody move ear.left root ", lines)
        self.assertIn("\nstroke segment ear.left ", lines)
        again = self.restore(editor)
        saved = again.save(self.path("body.glb"))
        self.assertEqual(again.close(), 0)
        self.assertReplayGives(lines, saved)
        self.assertNotEqual(self.fur(saved), self.fur(self.mesh))

    def test_steps_from_before_saving_are_kept_both_ways(self):
        editor = self.start(self.mesh)
        editor.ready()
        editor.key("l")
        self.stroke(editor)
        self.stroke(editor)
        editor.save(self.path("two.glb"))
        for _ in range(2):
            editor.key("ctrl+z")
            editor.expect("undo")
        again = self.restore(editor)
        none = again.save(self.path("none.glb"))
        subprocess.run([PELAGE, "export", self.mesh, "-o", self.path("untouched.glb")], check=True,
                       stdout=subprocess.DEVNULL)
        self.assertEqual(self.fur(none), self.fur(self.path("untouched.glb")))

        again.key("l")
        self.stroke(again)
        again.answer("ctrl+e", self.path("one.glb"))
        again.expect("exported")
        again.key("ctrl+z")
        again.expect("undo")
        again.key("ctrl+s")
        again.expect("saved")
        again.key("ctrl+shift+z")
        again.expect("redo")
        last = self.restore(again)
        redone = last.save(self.path("redone.glb"))
        self.assertEqual(last.close(), 0)
        self.assertEqual(last.journals(), [])
        self.assertEqual(self.fur(redone), self.fur(self.path("one.glb")))
        self.assertNotEqual(self.fur(redone), self.fur(none))

    def test_exporting_over_the_open_file_does_not_make_its_steps_twice(self):
        path = self.path("open.glb")
        subprocess.run([PELAGE, "export", self.mesh, "-o", path], check=True,
                       stdout=subprocess.DEVNULL)
        editor = self.start(path)
        editor.ready()
        editor.key("l")
        self.stroke(editor)
        before = self.fur(path)
        editor.answer("ctrl+e", path)
        editor.settle()
        editor.key("Return")  # yes, replace it
        editor.expect("exported")
        again = self.restore(editor)
        saved = again.save(self.path("restored.glb"))
        self.assertEqual(again.close(), 0)
        self.assertEqual(self.fur(saved), self.fur(path))
        self.assertNotEqual(self.fur(saved), before)

    def test_a_dropped_file_and_a_recent_one_are_opened(self):
        editor = self.start(self.mesh)
        editor.ready()
        dropped = self.path("with space" + os.path.splitext(self.mesh)[1])
        shutil.copy(self.mesh, dropped)
        xdnd.drop(self.display.name, editor.window(), dropped)
        self.assertEqual(editor.expect("opened"), dropped)
        # File, Open recent, and the second: the first is what is open.
        for place in ((25, 12), (60, 60), (320, 80)):
            editor.click(place)
        self.assertEqual(editor.expect("opened"), os.path.normpath(self.mesh))
        self.assertEqual(editor.close(), 0)

    def test_subdividing_is_one_step_that_is_undone_redone_and_replayed(self):
        self.take("--animal", "2000")
        editor = self.start(self.mesh)
        editor.ready()
        editor.click((205, 12))  # Mesh
        editor.click((225, 41))  # Subdivide...
        editor.expect("asked subdivide")
        editor.key("Return")
        editor.expect("commit Subdivide")
        editor.settle()
        editor.drag()
        editor.expect("commit Comb")
        for key, step in (("ctrl+z", "undo Comb"), ("ctrl+z", "undo Subdivide"),
                          ("ctrl+shift+z", "redo Subdivide"), ("ctrl+shift+z", "redo Comb")):
            editor.key(key)
            editor.expect(step)
        lines = editor.journal()
        self.assertIn("\nsubdivide\n", lines)
        saved = editor.save(self.path("fine.glb"))
        self.assertReplayGives(lines, saved)
        self.assertEqual(self.info(saved)["triangles"], 4 * self.info(self.mesh)["triangles"])
        self.assertEqual(editor.close(), 0)

    def test_dragging_a_slider_is_one_step(self):
        editor = self.start(self.mesh)
        editor.ready()
        path = ["mousemove", 1130, 199, "sleep", "0.3", "mousedown", 1]
        for x in range(1134, 1170, 4):
            path += ["mousemove", x, 199, "sleep", "0.1"]
        editor.do(*path, "mouseup", 1)
        editor.expect("commit Share of overcoat")
        editor.settle()
        lines = editor.journal().splitlines()
        self.assertEqual(len(lines), 2, lines)
        self.assertTrue(lines[1].startswith("set fur.share "), lines)
        editor.key("ctrl+z")
        editor.expect("undo Share of overcoat")
        self.assertEqual(editor.close(), 0)

    def test_a_saved_preset_is_put_on_again_and_needs_no_file_afterwards(self):
        editor = self.start(self.mesh)
        editor.ready()
        editor.click((1218, 133))
        editor.type("mine")
        self.assertEqual(editor.expect("kept"), "mine")
        editor.expect("pictures")
        folder = os.path.join(editor.folder, "data", "pelage", "presets")
        with open(os.path.join(folder, "mine.fur.json")) as file:
            mine = json.load(file)
        self.assertTrue(mine["thumbnail"].startswith("data:image/jpeg;base64,"))

        # The list: one's own at the top, the program's below it.
        mink, own = (898, 604), (898, 220)
        editor.click((1050, 133))
        editor.expect("pictures")
        editor.settle()
        self.shoot("presets.png")
        editor.click(mink)
        self.assertEqual(editor.expect("commit"), "Preset mink")
        editor.click((1050, 133))
        editor.click(own)
        self.assertEqual(editor.expect("commit"), "Preset mine")
        editor.key("ctrl+z")
        self.assertEqual(editor.expect("undo"), "Preset mine")

        dropped = self.path("other.fur.json")
        mine["fur"]["over"]["stiffness"] = 0.125
        mine["name"] = "other"
        with open(dropped, "w") as file:
            json.dump(mine, file)
        xdnd.drop(self.display.name, editor.window(), dropped)
        self.assertEqual(editor.expect("commit"), "Preset other")
        editor.click((1012, 163))
        self.assertEqual(editor.expect("kept"), "other")
        self.assertEqual(sorted(os.listdir(folder)), ["mine.fur.json", "other.fur.json"])

        lines = editor.journal()
        self.assertIn("over.stiffness 0.125", lines)
        shutil.rmtree(folder)
        os.remove(dropped)
        again = self.restore(editor)
        saved = again.save(self.path("worn.glb"))
        self.assertEqual(again.close(), 0)
        self.assertReplayGives(lines, saved)

    def test_the_accuracy_of_a_view_is_measured_flipped_saved_and_gets_old(self):
        self.take("--animal", "2000")
        editor = self.start(self.mesh)
        editor.ready()
        editor.key("shift+n")
        words = editor.expect("accuracy 256 samples, ").split()
        figures = dict(zip(words[::2], map(float, words[1::2])))
        self.assertEqual(list(figures), ["flip", "rmse", "ssim", "noise", "ms"])
        for name, figure in figures.items():
            self.assertTrue(0.0 < figure < (1e6 if name == "ms" else 1.0), figures)
        self.assertLess(figures["noise"], figures["rmse"])
        editor.key("h")
        self.assertEqual(editor.expect("accuracy shows"), "2")
        self.shoot("accuracy.png")
        editor.key("h")
        self.assertEqual(editor.expect("accuracy shows"), "1")
        editor.key("KP_3")
        editor.expect("accuracy old")
        editor.settle()
        self.shoot("accuracy-old.png")
        editor.click((147, 492))  # Measure again
        editor.expect("accuracy 16 samples")
        editor.do("click", 1)  # Cancel, in the same place
        editor.expect("accuracy ended")
        editor.click((1186, 492))  # Save report...
        editor.type(self.path("figures.csv"))
        editor.expect("saved")
        with open(self.path("figures.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 1)
        self.assertTrue(0.0 < float(rows[0]["flipMean"]) < 1.0, rows)
        self.assertEqual(rows[0]["detail"], "distance")
        for name in ("live", "reference", "heat"):
            self.assertGreater(os.path.getsize(self.path(f"figures-{name}.png")), 1000)
        editor.settle()
        self.assertEqual(editor.close(), 0)

    def test_unsaved_work_is_asked_about(self):
        editor = self.start()
        editor.ready()
        editor.drag()
        editor.expect("commit Comb")
        editor.key("ctrl+q")
        editor.expect("asked unsaved")
        editor.key("Escape")
        editor.settle()
        self.assertIsNone(editor.process.poll(), "Esc goes on editing")
        editor.key("ctrl+z")
        editor.expect("undo")
        self.assertEqual(editor.close(), 0, "what was taken back needs no saving")

    def test_a_bad_file_is_one_clear_line(self):
        bad = self.path("bad.glb")
        with open(bad, "wb") as file:
            file.write(b"glTF\x02\x00\x00\x00\xff\xff\xff\x7f")
        editor = self.start(bad)
        editor.settle()
        self.assertIsNone(editor.process.poll(), "the editor stays open")
        self.shoot("bad.png")
        editor.key("Return")
        editor.settle()
        self.assertEqual(editor.close(), 1)
        complaints = [line for line in editor.stderr().splitlines() if "bad.glb" in line]
        self.assertEqual(len(complaints), 1, editor.stderr())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:-3])
