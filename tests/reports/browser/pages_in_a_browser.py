"""Every kind of page, of rigs that differ, in a real browser: two widths, light and dark.

pages_in_a_browser.py HOST_SIM REPORT_PREVIEW [SCREENSHOT_DIR]
"""
import pathlib
import subprocess
import sys
import tempfile

from chromium import Chromium, find_chromium

HERE = pathlib.Path(__file__).parent
SKIPPED = 77
# dygraphs follows a new size of its place when the browser tells it, some frames later: until then, at most 10 s.
SETTLED = """new Promise((done) => {
  const fits = () => [...document.querySelectorAll('.zoom > div')].every((place) => !place.firstElementChild ||
    Math.abs(place.firstElementChild.getBoundingClientRect().width - place.clientWidth) < 2);
  let frames = 0;
  const look = () => (++frames > 2 && fits()) || frames > 600 ? done(frames) : requestAnimationFrame(look);
  look();
})"""
SCREENS = [(1280, False), (1280, True), (400, True), (400, False)]  # width in px, dark


def chain_of_twelve():
    """A scenario: twelve masses between two walls."""
    text = 'schema = "scenario/1"\nname = "chain of twelve"\n' + "[[dof]]\nmass_kg = 1.0\n" * 12
    truth = "[truth]\n"
    for a, b in [(1, 0), *((i, i + 1) for i in range(1, 12)), (12, 0)]:
        text += f'[[link]]\nbetween = [{a}, {b}]\nstiffness_N_m = 10000.0\nviscous_N_s_m = "estimate"\n'
        truth += f'"viscous[{a}-{b}]" = {9 + a}.0\n'
    level = '[[level]]\nkind = "random"\nrms_N = {}.0\nband_Hz = [2.0, 60.0]\nsettle_s = 1.0\nduration_s = 6.0\n'
    return text + truth + level.format(20) + level.format(60) + "[sensors]\nbits = 24\nnoise_percent = 0.5\n"


def make_pages(host_sim, preview, place):
    """{"rig, command": path of the page}"""
    (place / "twelve.toml").write_text(chain_of_twelve())
    scenarios = {"accelerometers": HERE / "rigs/accelerometers.toml", "shaker table": HERE / "rigs/shaker_table.toml",
                 "drive train": HERE / "rigs/drive_train.toml", "twelve": place / "twelve.toml",
                 "random": "paper_3dof_random", "free decay": "paper_3dof_free_decay"}
    pages = {}
    for rig, scenario in scenarios.items():
        folder = place / rig.replace(" ", "_")
        folder.mkdir()

        def host(command, *arguments):
            page = folder / command
            result = subprocess.run([host_sim, command, *map(str, arguments), "--report", str(page)], cwd=place,
                                    capture_output=True, text=True, timeout=120)
            if result.returncode not in (0, 3):  # 3: some coefficient has no answer; the page is there all the same
                raise SystemExit(f"host_sim {command} of {rig}: status {result.returncode}\n{result.stderr}")
            pages[f"{rig}, {command}"] = page / "index.html"

        host("run", "--scenario", scenario, "--records", folder, "--log", folder / "frames.log")
        data = [part for file in sorted(folder.glob("*.csv")) for part in ("--data", file)]
        for command in ("estimate", "diagnose"):
            host(command, "--rig", folder / "rig.toml", *data)
    subprocess.run([preview, str(place / "made_up_diagnosis"), str(place / "made_up_run")], check=True)
    pages["made up, diagnose"] = place / "made_up_diagnosis/index.html"
    pages["made up, run"] = place / "made_up_run/index.html"
    return pages


def faults_of_zoom(browser, name):
    """Drags across the upper picture and looks whether both follow, and whether another record can be chosen."""
    window = "[...document.querySelectorAll('.zoom canvas')].length"
    if browser.evaluate(window) < 2:
        return [f"{name}: nothing to zoom"]
    box = browser.evaluate("""(() => { const e = document.getElementById('zoom-signals'); e.scrollIntoView();
        const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()""")
    labels = """(id => [...document.querySelectorAll('#' + id + ' .dygraph-axis-label-x')].map(e => +e.textContent))"""
    middle = box[1] + box[3] / 2
    before = browser.evaluate(labels + "('zoom-errors')")
    browser.drag((box[0] + 0.5 * box[2], middle), (box[0] + 0.6 * box[2], middle))
    after = browser.evaluate(labels + "('zoom-errors')")
    faults = []
    if not after or max(after) - min(after) > 0.5 * (max(before) - min(before)):
        faults.append(f"{name}: dragging zooms from {before} to {after}")
    title = "document.getElementById('zoom-title').textContent"
    first = browser.evaluate(title)
    browser.evaluate("""(() => { const c = document.getElementById('zoom-choice'); c.selectedIndex = c.options.length - 1;
        c.dispatchEvent(new Event('change')); })()""")
    if browser.evaluate("document.getElementById('zoom-choice').options.length") > 1 and browser.evaluate(title) == first:
        faults.append(f"{name}: choosing another record changes nothing")
    return faults


def faults_of(browser, name, page, audit, screenshots):
    """Sentences about what is wrong with one page on any screen."""
    faults, pictures = [], None
    browser.open(page.as_uri(), *_size(SCREENS[0]))
    for screen in SCREENS:
        browser.show_as(*_size(screen))
        browser.evaluate(SETTLED)
        seen = browser.evaluate(audit)
        label = f"{name} at {screen[0]} px, {'dark' if screen[1] else 'light'}"
        faults += [f"{label}: {fault}" for fault in seen["faults"]]
        if pictures not in (None, seen["pictures"]):
            faults.append(f"{label}: {seen['pictures']} pictures, {pictures} on another screen")
        pictures = seen["pictures"]
        if screenshots:
            browser.screenshot(screenshots / (label.replace(", ", "_").replace(" ", "_") + ".png"))
    browser.show_as(*_size(SCREENS[0]))
    browser.evaluate(SETTLED)
    faults += faults_of_zoom(browser, name)
    if pictures == 0:
        faults.append(f"{name}: no picture at all")
    return faults + [f"{name}: {complaint}" for complaint in browser.complaints]


def _size(screen):
    width, dark = screen
    return width, 900, dark


def main():
    path = find_chromium()
    if path is None:
        print("SKIPPED: no browser here; Debian's package is called chromium")
        return SKIPPED
    host_sim, preview = (str(pathlib.Path(program).resolve()) for program in sys.argv[1:3])
    screenshots = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
    audit = (HERE / "page_audit.js").read_text()
    faults = []
    with tempfile.TemporaryDirectory(prefix="pages_") as place:
        pages = make_pages(host_sim, preview, pathlib.Path(place))
        with Chromium(path) as browser:
            for name, page in pages.items():
                faults += faults_of(browser, name, page, audit, screenshots)
    for fault in faults:
        print(fault)
    print(f"{len(pages)} pages on {len(SCREENS)} screens: {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
