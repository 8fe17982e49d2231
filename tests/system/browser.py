#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The page of a monitor in a browser: sees an alarm, reads its cause, restarts as operator, fails to as viewer.

  tests/system/browser.py --fake-monitor PROGRAM --horopter PROGRAM    says `skipped: …` where there is no browser
  … --screenshots DIR    also keeps pictures of the page in three sizes; one is docs/monitor-page.jpg
"""
import argparse
import base64
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PASSWORD = "correct horse"
PATIENCE_S = 40
DATA = Path("/usr/share/doc/opencv-doc/examples/data")
SKIN = """surface:
  type: plane
  point_mm: [26, -52, 458]
  normal: [-0.268, 0.156, -0.951]
"""
SIZES = {"tablet": (1024, 768), "upright": (768, 1024), "large": (1920, 1080)}


def has_browser():
    try:
        import selenium  # pylint: disable=unused-import
    except ImportError:
        print("skipped: python3-selenium is not installed")
        return False
    if shutil.which("chromium") and shutil.which("chromedriver"):
        return True
    print("skipped: chromium or chromium-driver is not installed")
    return False


def open_browser(folder):
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    options = webdriver.ChromeOptions()
    for option in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu",
                   f"--user-data-dir={folder / 'profile'}", "--window-size=1024,768", "--force-device-scale-factor=1"):
        options.add_argument(option)
    options.binary_location = shutil.which("chromium")
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver"), log_path=os.devnull), options=options)
    driver.set_script_timeout(PATIENCE_S)
    return driver


def shoot(driver, folder, what):
    """Pictures of the page in all sizes, and a small one of the alarm on a tablet."""
    if not folder:
        return
    for size, (width, height) in SIZES.items():
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        time.sleep(1)
        driver.save_screenshot(str(folder / f"{what}-{size}.png"))
        if (what, size) == ("alarm", "tablet"):
            small = driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "jpeg", "quality": 70})
            (folder / "monitor-page.jpg").write_bytes(base64.b64decode(small["data"]))
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def check_no_errors(driver):
    """Refused requests are none: they were meant."""
    severe = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE" and " 40" not in entry["message"]]
    assert not severe, severe


def run(*command, **options):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, **options)


def photographs(horopter, folder):
    """A pair with an alarm and one without, with what the program found in them."""
    if not (DATA / "left01.jpg").exists():
        return None
    (folder / "skin.yaml").write_text(SKIN)
    left, right = sorted(DATA.glob("left??.jpg")), sorted(DATA.glob("right??.jpg"))
    run(horopter, "calibrate", "--left", *left, "--right", *right, "--target", "chessboard:9x6:30mm", "-o",
        folder / "rig.yaml", stderr=subprocess.DEVNULL)
    run(horopter, "run", "--left", *left[:2], "--right", *right[:2], "--rig", folder / "rig.yaml", "--skin",
        folder / "skin.yaml", "--out", folder / "result", stderr=subprocess.DEVNULL)
    for name, frame in (("alarm", 0), ("good", 1)):
        for side, files in (("left", left), ("right", right)):
            shutil.copy(files[frame], folder / f"{name}-{side}.png")
        shutil.copy(folder / "result" / f"frame-{frame:04d}-state.png", folder / f"{name}-state.png")
    return folder


class Page:
    """A browser, and what the page of it says."""

    def __init__(self, driver):
        self.driver = driver

    def at(self, name):
        return self.driver.find_element("id", name)

    def wait(self, what, condition):
        end = time.monotonic() + PATIENCE_S
        problem = None
        while time.monotonic() < end:
            try:
                if condition():
                    return
            except Exception as error:  # pylint: disable=broad-except
                problem = error  # it was being redrawn
            time.sleep(0.05)
        raise AssertionError(f"the page never said: {what}; it says {self.at('state').text!r}, "
                             f"{self.at('reason').text!r} ({problem})")

    def wait_for_state(self, state):
        self.wait(state, lambda: self.at("state").text == state)

    def click(self, name):
        self.wait(f"a button {name}", lambda: self.at(name).is_displayed() and self.at(name).is_enabled())
        self.at(name).click()

    def log_in(self, name, password=PASSWORD):
        def is_open():  # by itself, where nobody may look without
            if not self.at("login-name").is_displayed():
                self.at("login-open").click()
            return self.at("login-name").is_displayed()
        self.wait("a place to log in", is_open)
        self.at("login-name").clear()
        self.at("login-name").send_keys(name)
        self.at("login-password").send_keys(password)
        self.at("login-send").click()
        self.wait(f"logged in as {name}", lambda: self.at("who").text.startswith(name))

    def log_out(self):
        self.click("logout")
        self.wait("logged out", lambda: self.at("who").text in ("viewer", "") and not self.at("logout").is_displayed())

    def post(self, path, body, token):
        """What a page of somebody who tries without buttons gets."""
        return self.driver.execute_async_script(
            "const done = arguments[arguments.length - 1];"
            "fetch(arguments[0], {method: 'POST', headers: {'Content-Type': 'application/json',"
            " 'X-Horopter-Token': arguments[2]}, body: arguments[1]}).then((a) => done(a.status));", path, body, token)

    def token(self):
        return self.driver.execute_async_script(
            "const done = arguments[0]; fetch('/api/session').then((a) => a.json()).then((j) => done(j.token || ''));")


def restart(page):
    page.click("restart")
    assert not page.at("confirm-send").is_enabled(), "a restart without a look"
    page.at("confirm-looked").click()
    page.at("confirm-send").click()
    page.wait_for_state("SAFE")


def check(page, tell, shoot):
    tell("good")
    page.wait_for_state("NOT SAFE")  # at the start nobody has restarted it
    page.wait("a picture", lambda: page.at("picture").get_property("naturalWidth") > 0)
    page.log_in("otto")
    restart(page)
    page.wait("no cause", lambda: not page.at("causes").is_displayed())
    assert page.driver.title == "Cell 3, palletizer", page.driver.title
    shoot("safe")

    tell("alarm")
    page.wait_for_state("ALARM")
    assert page.driver.title == "ALARM – Cell 3, palletizer", page.driver.title
    page.wait("the cause", lambda: "Something is in the skin" in page.at("cause-list").text)
    page.wait("what to do", lambda: "look whether somebody is inside" in page.at("cause-list").text)
    page.wait("objects", lambda: page.at("objects").is_displayed())
    page.wait("the stop in the log", lambda: "Stop: Something is in the skin" in page.at("events").text)
    assert not page.at("restart").is_enabled(), "a restart while something is in the skin"
    shoot("alarm")

    tell("good")
    page.wait("waiting", lambda: "waits for a restart" in page.at("reason").text)
    page.log_out()
    page.wait("who may restart", lambda: page.at("hint").text == "Log in as operator to restart.")
    page.driver.execute_script("session.restart_allowed = false;")  # until the next log-in
    page.wait("that nobody may", lambda: "Nobody can restart this cell" in page.at("hint").text)
    page.log_in("vera")
    page.wait("no restart for a viewer", lambda: not page.at("restart").is_displayed() and "may not restart" in page.at("hint").text)
    assert page.post("/api/restart", '{"stop": 1}', page.token()) == 403
    assert page.at("state").text == "NOT SAFE"
    page.log_out()
    page.log_in("otto")
    assert page.post("/api/restart", '{"stop": 1}', "") == 403
    restart(page)

    # In one step: the list is made anew when there is a new event.
    page.driver.execute_script("document.querySelector('#events tr.stop button').click()")
    page.wait("the picture of the stop", lambda: page.at("event-picture").get_property("naturalWidth") > 0)
    page.wait("the pair that did it", lambda: "the pair that stopped it" in page.at("event-name").text)
    shoot("event")
    page.driver.find_element("css selector", "#event .close").click()

    # An answer that does not come is told, and asked for again.
    page.driver.execute_script("window.usual = fetch; window.fetch = () => Promise.reject(new Error('none'));")
    page.driver.execute_script("document.querySelector('#events tr.stop button').click()")
    page.wait("that it is told", lambda: page.at("unanswered").is_displayed())
    page.click("logout")
    page.wait_for_state("NO CONNECTION")
    page.driver.execute_script("window.fetch = window.usual;")
    page.wait_for_state("SAFE")
    assert page.at("logout").is_displayed() and page.at("unanswered").is_displayed(), "logged out without an answer"
    page.driver.execute_script("document.querySelector('#events tr.stop button').click()")
    page.wait("the event after all", lambda: page.at("event-name").is_displayed() and not page.at("unanswered").is_displayed())
    page.driver.find_element("css selector", "#event .close").click()
    # The way out is heard, its answer and the next ones are not.
    page.driver.execute_script("window.fetch = (...asked) => window.usual(...asked).then(() => Promise.reject(new Error('lost')));")
    page.click("logout")
    page.wait_for_state("NO CONNECTION")
    page.driver.execute_script("window.fetch = window.usual;")
    page.wait("that it is out", lambda: not page.at("logout").is_displayed())
    page.log_in("otto")
    page.wait_for_state("SAFE")
    assert not page.at("unanswered").is_displayed()

    # Pictures whose answers do not end: the last one is not shown as live, and the next one is asked for.
    def is_veiled():
        return page.at("picture").find_element("xpath", "..").find_element("class name", "veil").value_of_css_property("visibility") == "visible"
    for hangs in ("new Promise(late)", "window.usual(path, options).then((answer) => { answer.blob = () => new Promise(late); return answer; })"):
        page.wait("a live picture", lambda: not is_veiled())
        page.driver.execute_script(
            "window.fetch = (path, options) => {"
            "  const late = (_, fail) => options.signal.addEventListener('abort', () => fail(new Error('late')));"
            f"  return path === '/api/picture' ? {hangs} : window.usual(path, options); }};")
        page.wait("an old picture", is_veiled)
        assert page.at("state").text == "SAFE"
        page.driver.execute_script("window.fetch = window.usual;")
    page.wait("a live picture", lambda: not is_veiled())

    tell("blind")
    page.wait("a fault by name", lambda: "left_late" in page.at("cause-list").text and page.at("state").text == "NOT SAFE")
    tell("good")
    restart(page)
    page.log_out()
    page.log_in("emma")
    # The question goes with the session of whoever was asked.
    page.click("teach")
    page.wait("a question", lambda: page.at("confirm").is_displayed())
    page.driver.execute_script("document.getElementById('logout').click()")
    page.wait("no question", lambda: not page.at("confirm").is_displayed())
    page.log_in("emma")
    page.click("teach")
    page.at("confirm-looked").click()
    page.at("confirm-send").click()
    page.wait("teaching", lambda: "being taught" in page.at("teach").text)

    # No decision comes any more: the page does not go on saying safe.
    tell("quiet")
    page.wait("an old decision", lambda: page.at("state").text == "NOT SAFE" and "too old" in page.at("reason").text)
    page.wait("an old picture", is_veiled)
    tell("good")
    page.wait_for_state("SAFE")
    # The script of the page hangs: the state is covered all the same.
    hung = ("const end = performance.now() + 4000; while (performance.now() < end);"
            "return getComputedStyle(document.querySelector('.expired')).visibility;")
    assert page.driver.execute_script(hung) == "visible", "safe while the page hangs"
    page.wait_for_state("SAFE")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fake-monitor", required=True, type=Path)
    parser.add_argument("--horopter", required=True, type=Path)
    parser.add_argument("--screenshots", type=Path)
    arguments = parser.parse_args()
    if not has_browser():
        return 0

    with tempfile.TemporaryDirectory(prefix="horopter-browser-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        users = folder / "users"
        for user, role in (("vera", "viewer"), ("otto", "operator"), ("emma", "engineer")):
            run(arguments.horopter, "monitor-user", users, user, role, input=PASSWORD.encode())
        pictures = []
        if arguments.screenshots:
            arguments.screenshots.mkdir(parents=True, exist_ok=True)
            found = photographs(arguments.horopter, folder)
            pictures = [found] if found else []
        monitor = subprocess.Popen([arguments.fake_monitor, folder / "log", users, *pictures], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True)
        driver = None
        try:
            port = int(monitor.stdout.readline())
            driver = open_browser(folder)
            driver.get(f"http://127.0.0.1:{port}/")

            def tell(word):
                monitor.stdin.write(word + "\n")
                monitor.stdin.flush()

            check(Page(driver), tell, lambda what: shoot(driver, arguments.screenshots, what))
            check_no_errors(driver)
            print("browser: the page says what it must")
        finally:
            if driver:
                driver.quit()
            monitor.stdin.close()
            monitor.wait(PATIENCE_S)
    return 0


if __name__ == "__main__":
    sys.exit(main())
