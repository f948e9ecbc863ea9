#!/usr/bin/env bash
# Fetches the Debian packages of an emulated board without touching this machine's dpkg: a private apt root with its own
# status file and the foreign architecture, filled from the Debian source that this machine uses already.
# usage: fetch_packages.sh ARCH CACHE_DIR KERNEL_META_PACKAGE PACKAGE...
#        RELEASE=trixie fetch_packages.sh ARCH CACHE_DIR none PACKAGE...    from another Debian, without dependencies
# Result: CACHE_DIR/ARCH/root (unpacked, also the cross compiler's sysroot) and CACHE_DIR/ARCH/stamp, with a release
# CACHE_DIR/ARCH-RELEASE/. Exit 75: not to be had.
set -euo pipefail

arch=$1 cache=$2 kernel_meta=$3
shift 3
packages=("$@")
release=${RELEASE-}
home=$cache/$arch${release:+-$release}
root=$home/root
want="$kernel_meta ${packages[*]}"

# One at a time: another run may be filling the same folder.
mkdir -p "$home"
exec 9>"$home/lock"
flock 9

if [[ -f $home/stamp && $(cat "$home/stamp") == "$want" ]]; then
  exit 0
fi

unavailable() {
  echo "board packages for $arch are not to be had: $*" >&2
  exit 75
}

command -v apt-get >/dev/null || unavailable "no apt-get on this machine"
command -v dpkg-deb >/dev/null || unavailable "no dpkg-deb on this machine"

# One line per Debian archive that this machine reads, e.g. "deb [...] http://host/debian/ bookworm main".
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
signed=""
[[ -f $keyring ]] && signed="[signed-by=$keyring] "
debian_sources() {
  apt-get indextargets --format '$(ORIGIN)|$(CREATED_BY)|deb '"$signed"'$(REPO_URI) $(RELEASE) $(COMPONENT)' |
    sed -n 's/^Debian|Packages|//p' | sort -u
}
sources=$(debian_sources)
if [[ -z $sources ]]; then
  apt-get -q update >/dev/null 2>&1 || true  # a machine without package lists; needs root
  sources=$(debian_sources)
fi
[[ -n $sources ]] || unavailable "no Debian source with a package list; run 'apt-get update' first"
if [[ -n $release ]]; then  # the same archive, not that of the security updates
  sources=$(sed -nE "/ [^ ]*security[^ ]* /d; s/ [^ ]+ main\$/ $release main/p" <<<"$sources" | sort -u)
fi

mkdir -p "$home/state/lists/partial" "$home/archives/partial" "$home/etc/parts"
echo "$sources" >"$home/etc/sources.list"
: >"$home/state/status"

apt=(apt-get -q -y
  -o "Dir::State=$home/state" -o "Dir::State::status=$home/state/status" -o "Dir::State::lists=$home/state/lists"
  -o "Dir::Cache=$home" -o "Dir::Cache::archives=$home/archives"
  -o "Dir::Etc::sourcelist=$home/etc/sources.list" -o "Dir::Etc::sourceparts=$home/etc/parts"
  -o "Dir::Etc::preferencesparts=$home/etc/parts"
  -o "APT::Architecture=$arch" -o "APT::Architectures=$arch" -o "APT::Sandbox::User=root"
  -o "APT::Install-Recommends=false" -o "Acquire::Languages=none"
  -o "Acquire::Retries=3" -o "Acquire::http::Timeout=20" -o "Acquire::https::Timeout=20"
  -o "APT::Update::Post-Invoke=" -o "DPkg::Post-Invoke=" -o "Debug::NoLocking=true")

# A list that a mirror is just renewing is passed over: the others may do, and the downloads below tell.
"${apt[@]}" update >"$home/update.log" 2>&1 || echo "apt-get update was incomplete, see $home/update.log" >&2

# Exactly these packages, without what they depend on.
download() {
  (cd "$home/archives" && "${apt[@]}" download "$@") >>"$home/download.log" 2>&1 ||
    unavailable "the download of $* failed, see $home/download.log"
}
: >"$home/download.log"
if [[ -n $release ]]; then
  download "${packages[@]}"
else
  # The kernel package alone: its dependencies build a disk boot, which these boards do not have.
  kernel=$("${apt[@]}" -s install "$kernel_meta" 2>/dev/null |
    sed -n 's/^Inst \(linux-image-[0-9][^ ]*\) .*/\1/p' | head -n 1 || true)
  [[ -n $kernel ]] || unavailable "no kernel behind $kernel_meta, see $home/update.log"
  "${apt[@]}" install --download-only "${packages[@]}" >"$home/download.log" 2>&1 ||
    unavailable "the download of ${packages[*]} failed, see $home/download.log"
  download "$kernel"
fi

rm -rf "$root"
mkdir -p "$root"
for deb in "$home"/archives/*.deb; do
  dpkg-deb -x "$deb" "$root"
done
# Absolute links of development packages would point out of the sysroot.
python3 - "$root" <<'PY'
import os
import sys
root = sys.argv[1]
for folder, folders, files in os.walk(root):
    for path in (os.path.join(folder, name) for name in folders + files):
        if os.path.islink(path) and os.readlink(path).startswith("/"):
            target = os.path.relpath(root + os.readlink(path), folder)
            os.unlink(path)
            os.symlink(target, path)
PY
rm -f "$home"/archives/*.deb
echo "$want" >"$home/stamp"
