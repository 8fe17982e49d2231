#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/demo --live in a browser: cameras that send packets, a monitor, its page. An engineer teaches, an alarm is seen and
its cause is read, an operator restarts, a viewer may not; a camera is gone, and the monitor hangs.

  tests/system/browser_live.py --bin DIR    of the programs; says `skipped: …` where that cannot be
  … --screenshots DIR    also keeps pictures of the page in three sizes; one is docs/monitor-page.jpg
"""
import argparse
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from browser import PATIENCE_S, Page, check_no_errors, has_browser, open_browser, shoot

OWN_NETWORK = "HOROPTER_OWN_NETWORK"


def enter_own_network():
    """Ports and addresses that nobody else uses; everything that is started from here on has them."""
    if os.environ.get(OWN_NETWORK):
        return subprocess.run(["ip", "link", "set", "lo", "up"], check=False).returncode == 0
    as_root = [] if os.geteuid() == 0 else ["--map-root-user"]
    if subprocess.run(["unshare", "--net", *as_root, "true"], check=False).returncode != 0:
        return False
    os.environ[OWN_NETWORK] = "1"
    os.execvp("unshare", ["unshare", "--net", *as_root, sys.executable, *sys.argv])


class Demo:
    """scripts/demo-live, and words for its cameras."""

    def __init__(self, folder, programs):
        script = Path(__file__).resolve().parents[2] / "scripts" / "demo-live"
        self.log = folder / "demo.log"
        self.running = subprocess.Popen(
            [script], stdin=subprocess.PIPE, stdout=self.log.open("w"), stderr=subprocess.STDOUT, text=True,
            env={**os.environ, "BIN": str(programs), "OUT": str(folder / "out"), "TEACH": "true"}, start_new_session=True)
        self.password = self.find(r"password (\w+)")
        self.find(r"begins with")

    def find(self, pattern):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            if found := re.search(pattern, self.log.read_text()):
                return found[1] if found.groups() else found[0]
            if self.running.poll() is not None:
                break
            time.sleep(0.1)
        raise AssertionError(f"the demonstration never said {pattern}: {self.log.read_text()}")

    def tell(self, words):
        self.running.stdin.write(words + "\n")
        self.running.stdin.flush()

    def monitor(self):
        """Its process."""
        for entry in Path("/proc").glob("[0-9]*"):
            try:
                command = (entry / "cmdline").read_bytes().split(b"\0")
                parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except OSError:
                continue
            if parent == self.running.pid and b"monitor" in command:
                return int(entry.name)
        raise AssertionError("no monitor runs")

    def end(self):
        os.killpg(self.running.pid, signal.SIGTERM)
        self.running.wait(PATIENCE_S)


def log_in(page, demo, role):
    page.log_in(role, demo.password)


def wait_for_restart(page):
    page.wait("waiting", lambda: "waits for a restart" in page.at("reason").text)


def restart(page):
    """A computer that is busy may lose an image meanwhile: then it is refused, and asked for again."""
    for _ in range(10):
        page.click("restart")
        assert not page.at("confirm-send").is_enabled(), "a restart without a look"
        page.at("confirm-looked").click()
        page.at("confirm-send").click()
        end = time.monotonic() + 3
        while time.monotonic() < end:
            if page.at("state").text == "SAFE":
                return
            time.sleep(0.05)
        if page.at("confirm").is_displayed():
            page.driver.find_element("css selector", "#confirm .close").click()
    raise AssertionError("no restart made it safe")


def teach(page):
    """Where an image is lost meanwhile, it is refused or broken off, and that is told: then it is asked for again."""
    def said(pattern):
        return len(re.findall(pattern, page.at("events").text))

    for _ in range(10):
        nothing = said("taught nothing|broken off|teaching refused")
        page.click("teach")
        page.wait("how long", lambda: "20 pairs" in page.at("confirm-text").text)
        page.at("confirm-looked").click()
        page.at("confirm-send").click()
        page.wait("an end", lambda: said(r"taught by \d+ frames") or page.at("confirm-trouble").text
                  or said("taught nothing|broken off|teaching refused") > nothing)
        if said(r"taught by \d+ frames"):
            return
        if page.at("confirm").is_displayed():
            page.driver.find_element("css selector", "#confirm .close").click()
    raise AssertionError("every teaching was disturbed")


def stop_by_alarm(page, demo):
    """Nor may another fault have stopped it before."""
    for _ in range(10):
        if page.at("state").text != "SAFE":
            demo.tell("show 1")
            restart(page)
        demo.tell("show 2")  # the board is in the skin
        page.wait_for_state("ALARM")
        end = time.monotonic() + 3
        while time.monotonic() < end:
            if "Stop: Something is in the skin" in page.at("events").text:
                return
            time.sleep(0.05)
    raise AssertionError("no stop by an alarm in the log")


def check(page, demo, tell_shoot):
    demo.tell("show 1")  # nothing is in the skin
    log_in(page, demo, "engineer")
    page.wait("a picture", lambda: page.at("picture").get_property("naturalWidth") >= 640)
    page.wait("numbers of the cameras", lambda: "5.0" in page.at("cameras").text)
    teach(page)
    wait_for_restart(page)
    page.log_out()

    log_in(page, demo, "operator")
    restart(page)
    tell_shoot("safe")
    stop_by_alarm(page, demo)
    page.wait("the cause", lambda: "Something is in the skin" in page.at("cause-list").text)
    page.wait("what to do", lambda: "look that nobody is inside" in page.at("cause-list").text)
    page.wait("objects with their distance", lambda: re.search(r"\d+ mm", page.at("objects").text))
    assert not page.at("restart").is_enabled(), "a restart while something is in the skin"
    tell_shoot("alarm")
    demo.tell("show 1")
    wait_for_restart(page)
    page.log_out()

    log_in(page, demo, "viewer")
    page.wait("no restart for a viewer",
              lambda: not page.at("restart").is_displayed() and "may not restart" in page.at("hint").text)
    assert page.post("/api/restart", '{"stop": 1}', page.token()) == 403
    assert page.at("state").text == "NOT SAFE"
    page.log_out()
    log_in(page, demo, "operator")
    restart(page)
    page.driver.execute_script("document.querySelector('#events tr.stop button').click()")
    page.wait("the picture of the stop", lambda: page.at("event-picture").get_property("naturalWidth") >= 640)
    tell_shoot("event")
    page.driver.find_element("css selector", "#event .close").click()

    demo.tell("off right")
    page.wait("a camera that is gone", lambda: "No image comes from the right camera" in page.at("cause-list").text)
    assert page.at("state").text == "NOT SAFE"
    page.wait("that old objects are none", lambda: "Nobody knows" in page.at("no-objects").text)
    tell_shoot("camera")
    demo.tell("on right RIGHT")
    wait_for_restart(page)
    restart(page)
    monitor = demo.monitor()
    os.kill(monitor, signal.SIGSTOP)
    page.wait_for_state("NO CONNECTION")
    os.kill(monitor, signal.SIGCONT)
    page.wait("what happened", lambda: page.at("cause-list").text and page.at("state").text == "NOT SAFE")
    wait_for_restart(page)
    restart(page)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=Path)
    parser.add_argument("--screenshots", type=Path)
    arguments = parser.parse_args()
    if not has_browser():
        return 0
    if not enter_own_network():
        print("skipped: this user may have no network of its own")
        return 0
    if arguments.screenshots:
        arguments.screenshots.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="horopter-browser-", ignore_cleanup_errors=True) as name:
        demo = Demo(Path(name), arguments.bin.resolve())
        driver = None
        try:
            driver = open_browser(Path(name))
            driver.get("http://127.0.0.1:8080/")
            check(Page(driver), demo, lambda what: shoot(driver, arguments.screenshots, what))
            check_no_errors(driver)
            print("browser: the page of the live demonstration says what it must")
        except BaseException:
            print(demo.log.read_text())
            raise
        finally:
            if driver:
                driver.quit()
            demo.end()
    return 0


if __name__ == "__main__":
    sys.exit(main())
