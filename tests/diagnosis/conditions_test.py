#!/usr/bin/env python3
"""conditions.py with a program that says what condition_report might: asked once for each condition and for what is hidden, joined."""
import pathlib
import subprocess
import sys
import tempfile

SAYS = """#!/bin/sh
echo "$@" >> asked
case "$*" in
*one*) echo "right calm xva 7 hidden: backlash on link 1-0 (rho 0.200); 1 masses; answer: explained (3.5 s)"
       echo "WRONG calm x 8 hidden: backlash on link 1-0 (rho 0.200); 2 masses; answer: explained (12.25 s)"
       echo "| all | 0 of 0 | 0 | 1 | 0 | 0 | 1 | 0 | 75 | 3.50 | 12.2 |" ;;
*) echo "right calm xva 7 hidden: nothing; 1 masses; answer: none (0.5 s)"
   echo "missed calm x 8 hidden: nothing; 2 masses; answer: unknown (0.25 s)"
   echo "| all | 1 of 2 | 1 | 0 | 0 | 0 | 0 | 0 | 100 | 0.50 | 0.5 |" ;;
esac
"""


def main():
    script = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        report = here / "condition_report"
        report.write_text(SAYS)
        report.chmod(0o755)
        ask = [sys.executable, script, str(report), str(here / "said"), "--draws", "2", "--first-seed", "7", "--conditions", "calm"]
        for _ in range(2):  # the second time all is there
            subprocess.run(ask, check=True, cwd=here)
        assert sorted((here / "asked").read_text().splitlines()) == [
            "--draws 2 --first-seed 7 --conditions calm --hidden nothing",
            "--draws 2 --first-seed 7 --conditions calm --hidden one"], (here / "asked").read_text()
        other = subprocess.run([*ask[:-3], "8", *ask[-2:]], cwd=here, capture_output=True, text=True)
        assert other.returncode == 1 and "holds the answers to --draws 2 --first-seed 7" in other.stderr, other
        page, raw = here / "page.md", here / "raw.txt"
        page.write_text("before\n<!-- tables: written by tests/diagnosis/conditions.py -->\nearlier\n<!-- end of tables -->\nbehind\n")
        subprocess.run([sys.executable, script, "--page", str(here / "said"), str(page), str(raw)], check=True)
        text = page.read_text()
        # 0.25, 0.5, 3.5 and 12.25 s: the third of four is the upper median
        assert "| `calm` | 1 of 2 | 1 | 1 | 0 | 0 | 1 | 0 | 100 | 75 | 3.50 | 12.2 |" in text, text
        assert "| `x` | 0 of 1 | 1 | 0 | 0 | 0 | 1 | 0 |" in text, text
        assert text.startswith("before\n") and text.endswith("behind\n") and "earlier" not in text, text
        assert raw.read_text().splitlines()[3].startswith("WRONG calm x 8 hidden: backlash"), raw.read_text()
    print("conditions.py: asks once, joins")
    return 0


if __name__ == "__main__":
    sys.exit(main())
