"""three_shells.py WORK NODE_MODULES LAYERS -- opens three_shells.html in Chromium without a window,
with WORK/animal.glb, and writes what it sends to WORK/three.json."""

import http.server
import json
import pathlib
import subprocess
import sys
import threading

work, modules, layers = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
page = pathlib.Path(__file__).with_suffix(".html")
done = threading.Event()


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {".js": "text/javascript", ".html": "text/html", "": "application/octet-stream"}

    def translate_path(self, path):
        path = path.split("?")[0].lstrip("/")
        if path.startswith("node_modules/"):
            return str(modules / path.removeprefix("node_modules/"))
        return str(page if path == "" else work / path)

    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        (work / "three.json").write_bytes(body)
        self.send_response(204)
        self.end_headers()
        done.set()

    def log_message(self, *_):
        pass


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
threading.Thread(target=server.serve_forever, daemon=True).start()
address = f"http://127.0.0.1:{server.server_port}/?layers={layers}"
with open(work / "chromium.txt", "w") as log:
    browser = subprocess.Popen(
        ["chromium", "--headless", "--no-sandbox", "--disable-gpu-watchdog", "--use-angle=swiftshader",
         "--remote-debugging-port=0", f"--user-data-dir={work}/profile", address],
        stdout=log, stderr=log)
    arrived = done.wait(300)
    browser.terminate()
    browser.wait()
server.shutdown()
if not arrived:
    sys.exit("three_shells: Chromium sent nothing within 300 s")
result = json.loads((work / "three.json").read_text())
if "error" in result:
    sys.exit(f"three_shells: {result['error']}")
