#!/usr/bin/env python3
"""A picture of host_sim watch for the docs: screen_picture.py HOST_SIM LOG COLUMNS LINES OUT.svg (and OUT.txt beside it).

The screen is that of the emulated terminal of the tests, character for character, with its colours."""
import html
import sys

from emulated_terminal import Terminal

COLOURS = {"default": "#d8dee9", "green": "#a3be8c", "brown": "#ebcb8b", "yellow": "#ebcb8b", "red": "#f07178"}
BACKGROUND, WIDTH, HEIGHT, MARGIN = "#1f2430", 8.4, 18, 12


def runs(row):
    """(first column, text, cell) of neighbouring cells that look alike."""
    start, text = 0, ""
    for column in range(len(row) + 1):
        cell = row[column] if column < len(row) else None
        look = cell and (cell.fg, cell.bold, cell.reverse)
        first = row[start]
        if cell is None or look != (first.fg, first.bold, first.reverse):
            yield start, text, first
            start, text = column, ""
        if cell is not None:
            text += cell.data


def picture(screen):
    rows = [[screen.buffer[y][x] for x in range(screen.columns)] for y in range(screen.lines)]
    width, height = screen.columns * WIDTH + 2 * MARGIN, screen.lines * HEIGHT + 2 * MARGIN
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
           f'height="{height:.0f}" font-family="DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="14">',
           f'<rect width="100%" height="100%" rx="6" fill="{BACKGROUND}"/>']
    for y, row in enumerate(rows):
        for x, text, cell in runs(row):
            left, top, length = MARGIN + x * WIDTH, MARGIN + y * HEIGHT, len(text) * WIDTH
            colour = COLOURS.get(cell.fg, COLOURS["default"])
            if cell.reverse:
                out.append(f'<rect x="{left:.1f}" y="{top}" width="{length:.1f}" height="{HEIGHT}" fill="{colour}"/>')
                colour = BACKGROUND
            if text.strip():
                weight = ' font-weight="bold"' if cell.bold else ""
                out.append(f'<text x="{left:.1f}" y="{top + 14}" textLength="{length:.1f}" fill="{colour}"{weight} '
                           f'xml:space="preserve">{html.escape(text)}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    program, log, columns, lines, path = sys.argv[1:]
    terminal = Terminal([program, "watch", log, "--speed", "0"], int(columns), int(lines))
    terminal.wait_for_text("end of the log", timeout=60.0)
    terminal.wait_until_quiet()
    with open(path, "w") as out:
        out.write(picture(terminal.screen))
    with open(path.rsplit(".", 1)[0] + ".txt", "w") as out:
        out.write(terminal.text() + "\n")
    terminal.press("q")
    terminal.end()


if __name__ == "__main__":
    main()
