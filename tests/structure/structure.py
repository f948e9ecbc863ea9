#!/usr/bin/env python3
"""The structure drawn in docs/design.md against the tree: every folder has its row, a row says what the folder includes, and
no two folders include each other, not even around a corner.

usage: structure.py SOURCE_ROOT [--write]
--write renews the column of includes; what a folder holds is written by hand.
"""
import pathlib
import re
import sys

PARTS = ("firmware", "hal", "host_sim")
BEGIN, END = "<!-- structure: begin -->\n", "<!-- structure: end -->\n"
HEAD = "| folder | holds | includes |\n|---|---|---|\n"


def folder_of(path):
    """'firmware/links' of firmware/links/effects.cpp; 'firmware' of firmware/version.hpp."""
    return "/".join(path.split("/")[:2]) if path.count("/") > 1 else path.split("/")[0]


def includes(root):
    """{folder: set of the folders that its sources include}"""
    graph = {}
    for part in PARTS:
        for path in sorted((root / part).rglob("*")):
            if path.suffix not in (".hpp", ".cpp", ".inc"):
                continue
            own = folder_of(path.relative_to(root).as_posix())
            found = re.findall(r'^#include "((?:%s)/[^"]+)"' % "|".join(PARTS), path.read_text(), re.MULTILINE)
            graph.setdefault(own, set()).update({folder_of(name) for name in found} - {own})
    return graph


def reachable(graph, start):
    seen, waiting = set(), [start]
    while waiting:
        new = graph.get(waiting.pop(), set()) - seen
        seen |= new
        waiting += new
    return seen


def below(graph):
    """The folders, each after those that it includes."""
    return sorted(graph, key=lambda folder: (PARTS.index(folder.split("/")[0]), len(reachable(graph, folder)), folder))


def short(folder, own):
    part = own.split("/")[0]
    return folder[len(part) + 1:] if folder.startswith(part + "/") else folder


def row(folder, holds, graph):
    return f"| `{folder}` | {holds} | {', '.join(sorted(short(other, folder) for other in graph[folder])) or 'nothing'} |\n"


def main():
    root = pathlib.Path(sys.argv[1])
    page = root / "docs" / "design.md"
    text = page.read_text()
    before, _, rest = text.partition(BEGIN)
    table, _, after = rest.partition(END)
    holds = dict(re.findall(r"^\| `([^`]+)` \| ([^|]*) \|", table, re.MULTILINE))
    graph = includes(root)
    wrong = [f"{folder} has no row in docs/design.md" for folder in graph if folder not in holds]
    wrong += [f"docs/design.md has a row for {folder}, which is not there" for folder in holds if folder not in graph]
    wrong += [f"{folder} and {other} include each other" for folder in sorted(graph) for other in sorted(graph[folder])
              if folder in reachable(graph, other)]
    wrong += [f"{folder} includes {other}: firmware and hal know nothing of what is above them"
              for folder, others in graph.items() for other in others
              if PARTS.index(other.split("/")[0]) > PARTS.index(folder.split("/")[0]) and other != "hal/interface"]
    wanted = HEAD + "".join(row(folder, holds.get(folder, ""), graph) for folder in below(graph))
    if "--write" in sys.argv:
        page.write_text(before + BEGIN + wanted + END + after)
    elif table != wanted:
        wrong.append("the table in docs/design.md is not that of the tree: run tests/structure/structure.py . --write")
    print("\n".join(wrong) or f"{len(graph)} folders as drawn in docs/design.md")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
