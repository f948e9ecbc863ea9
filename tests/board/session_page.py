#!/usr/bin/env python3
"""Writes what docs/board_session.md shows, from a run of the test `session` on the emulated arm64 board.

usage: session_page.py RESULTS HOST_SIM PAGE
RESULTS holds arm64_session.console and arm64_session_session.log (tests/board/run.sh --only session); HOST_SIM decodes the log.
Between `<!-- NAME -->` and `<!-- end -->` of the page stands the part of that name; all else is written by hand."""
import pathlib
import re
import subprocess
import sys


def block(lines):
    return "".join(f"    {line}\n" for line in lines)


def between(lines, first, last):
    """The lines from the first that matches `first` to the first after it that matches `last`, both included."""
    start = next(i for i, line in enumerate(lines) if re.search(first, line))
    end = next(i for i, line in enumerate(lines) if i >= start and re.search(last, line))
    return lines[start:end + 1]


def network(console):
    said = [line for line in console if line.startswith("can0: ")]
    link = [line.rstrip() for line in between(console, r"^\d+: can0: ", r"bitrate")]
    return block(["board# systemctl enable --now systemd-networkd", "board# journalctl -u systemd-networkd", *said,
                  "board# ip -d link show can0", *(line.replace("\t", "    ") for line in link)])


def check(console):
    said = between(console, r"^/session.toml:", r"^  drives ")
    return block(["board# rig_controller --check /etc/rig_controller/board.toml",
                  *(line.replace("/session.toml", "/etc/rig_controller/board.toml") for line in said)])


def start(console):
    said = between(console, r"^rig_controller: node 1", r"^rig_controller: measuring")
    return block(["board# systemctl start rig_controller", "board# cansend can0 000#0101",
                  "board# journalctl -fu rig_controller", *said])


def estimates(decoded):
    """Those of the last window before the stop."""
    lines = [line for line in decoded if re.search(r" node \d+ +estimate ", line)]
    names = {re.search(r"(\S+\[\S+\])", line).group(1) for line in lines}
    return block(lines[-len(names):])


def stop(console, decoded):
    alarm = next(i for i, line in enumerate(decoded) if "code = EMERGENCY_STOP" in line)
    drives = [i for i, line in enumerate(decoded[:alarm]) if re.search(r" drive +drive = ", line)]
    moving = [i for i in drives if not decoded[i].rstrip().endswith(" drive = 0 %")]
    if not drives or drives[-1] != moving[-1]:
        sys.exit("the drive was at rest when the stop was pressed, the page stays as it is")
    value = decoded[moving[-1]].split("drive = ")[1].strip()
    after = [line for line in decoded[alarm:] if re.search(r"mode = EMERGENCY|drive = 0 %|state = STOPPED", line)]
    said = [line for line in console if re.match(r"rig_controller: (emergency stop|drive zero and relay off \d+ us)", line)]
    shown = decoded[moving[-1]:moving[-1] + 3] + [decoded[alarm]] + after[:3]
    return (f"It was pressed while the drive was at {value}:\n\n" + block(shown) + "\n" +
            block(["board# journalctl -fu rig_controller", *said]))


def end(console):
    said = [line for line in console if re.match(r"rig_controller: (\d+ samples|CAN \d+ sent)", line)]
    return block(["board# systemctl stop rig_controller", *said])


def main():
    results, host_sim, page = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    console = (results / "arm64_session.console").read_text(errors="replace").replace("\r", "").splitlines()
    failed = [line for line in console if line.startswith("MARK result") and " failed" in line]
    if failed or "MARK end" not in console:
        sys.exit(f"the session did not pass, the page stays as it is: {failed}")
    decoded = subprocess.run([host_sim, "decode", results / "arm64_session_session.log"], check=True, capture_output=True,
                             text=True).stdout.splitlines()
    parts = {"network": network(console), "check": check(console), "start": start(console),
             "estimates": estimates(decoded), "stop": stop(console, decoded), "end of the session": end(console)}
    text = page.read_text()
    for name, part in parts.items():
        pattern = rf"(<!-- {name} -->\n).*?(<!-- end -->\n)"
        if not re.search(pattern, text, re.DOTALL):
            sys.exit(f"{page} has no part {name}")
        text = re.sub(pattern, lambda match: match.group(1) + "\n" + part + "\n" + match.group(2), text, flags=re.DOTALL)
    page.write_text(text)
    print(f"{page}: {len(parts)} parts written")


if __name__ == "__main__":
    main()
