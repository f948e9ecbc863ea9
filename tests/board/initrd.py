#!/usr/bin/env python3
"""Builds the initial file system of an emulated board: an uncompressed or gzip-packed "newc" cpio archive.

usage: initrd.py --root SYSROOT... --out FILE --init SCRIPT [--program PATH_IN_ROOT]... [--module NAME]... [--file SOURCE=TARGET]...

Programs from the first sysroot and files given with --file come with the shared libraries they need (from any sysroot, the first
that has one), modules with the modules they need, in loading order in /etc/modules. The archive depends on its contents alone: no dates, no owners.
"""
import argparse
import gzip
import os
import re
import subprocess
import sys


def needed_libraries(path):
    """Names of shared libraries and the loader that an ELF file asks for; nothing for other files."""
    with open(path, "rb") as file:
        if file.read(4) != b"\x7fELF":
            return []
    text = subprocess.run(["readelf", "-ld", path], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"\(NEEDED\).*\[(.+)\]", text)
    loader = re.search(r"program interpreter: (.+)\]", text)
    return names + ([os.path.basename(loader.group(1))] if loader else [])


def find_library(roots, name):
    """A library's path in the first sysroot that holds it."""
    for folder in (os.path.join(root, place) for root in roots for place in ("lib", "usr/lib", "usr/local/lib")):
        for base, _, files in os.walk(folder):
            if name in files and "modules" not in base:
                return os.path.join(base, name)
    sys.exit(f"initrd.py: no library {name} in {roots}")


def module_index(root):
    """Module name -> path in the sysroot."""
    index = {}
    for base, _, files in os.walk(os.path.join(root, "lib/modules")):
        for file in files:
            if file.endswith(".ko"):
                index[file[:-3].replace("-", "_")] = os.path.join(base, file)
    return index


def module_dependencies(path):
    with open(path, "rb") as file:
        found = re.search(rb"\0depends=([^\0]*)\0", file.read())
    return [name.replace("-", "_") for name in found.group(1).decode().split(",") if name] if found else []


def loading_order(index, names):
    """Names and all they depend on, dependencies first."""
    order = []

    def visit(name):
        if name in order:
            return
        if name not in index:
            sys.exit(f"initrd.py: no kernel module {name}")
        for other in module_dependencies(index[name]):
            visit(other)
        order.append(name)

    for name in names:
        visit(name.replace("-", "_"))
    return order


class Archive:
    """Collects entries and writes them as a newc archive with fixed times and owners."""

    def __init__(self):
        self.entries = {}

    def folder(self, path):
        parent = os.path.dirname(path)
        if parent:
            self.folder(parent)
        if path:
            self.entries.setdefault(path, (0o40755, b"", (0, 0)))

    def add(self, path, mode, data, device=(0, 0)):
        path = path.lstrip("/")
        self.folder(os.path.dirname(path))
        self.entries[path] = (mode, data, device)

    def write(self, out):
        body = bytearray()
        items = sorted(self.entries.items()) + [("TRAILER!!!", (0, b"", (0, 0)))]
        for inode, (path, (mode, data, device)) in enumerate(items, 1):
            name = path.encode() + b"\0"
            fields = (inode, mode, 0, 0, 1, 0, len(data), 0, 0, device[0], device[1], len(name), 0)
            body += b"070701" + b"".join(b"%08X" % field for field in fields) + name
            body += b"\0" * (-len(body) % 4) + data
            body += b"\0" * (-len(body) % 4)
        with open(out, "wb") as file:
            file.write(gzip.compress(bytes(body), compresslevel=1, mtime=0))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", required=True, action="append")
    parser.add_argument("--out", required=True)
    parser.add_argument("--init", required=True)
    parser.add_argument("--program", action="append", default=[])
    parser.add_argument("--module", action="append", default=[])
    parser.add_argument("--file", action="append", default=[])
    options = parser.parse_args()

    archive = Archive()
    for folder in ("proc", "sys", "dev", "tmp", "run", "root", "var", "etc", "lib/modules"):
        archive.folder(folder)
    archive.add("dev/console", 0o20600, b"", (5, 1))
    archive.add("dev/null", 0o20666, b"", (1, 3))

    def add_file(source, target):
        with open(source, "rb") as file:
            data = file.read()
        mode = 0o100755 if os.access(source, os.X_OK) or "/lib" in source else 0o100644
        archive.add(target, mode, data)
        for name in needed_libraries(source):
            if "lib/" + name not in archive.entries:
                add_file(find_library(options.root, name), "lib/" + name)

    add_file(options.init, "init")
    archive.add("init", 0o100755, archive.entries["init"][1])
    for program in ["bin/busybox"] + options.program:
        path = os.path.join(options.root[0], program.lstrip("/"))
        add_file(path, program)
    for pair in options.file:
        source, target = pair.split("=", 1)
        add_file(source, target)
    index = module_index(options.root[0])
    order = loading_order(index, options.module)
    for name in order:
        add_file(index[name], f"lib/modules/{name}.ko")
    archive.add("etc/modules", 0o100644, "".join(name + "\n" for name in order).encode())
    archive.write(options.out)


main()
