#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the scripts share: install missing Debian packages, configure, build, run with a display.
# To be sourced, not run.

unset CDPATH # or cd says where it went
DGG_ROOT="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

# What a build needs, and what a picture needs. Debian's VTK looks for its Qt parts when configured.
# PCL has one package of headers for all of its parts, which brings 130 others (42 MB).
DGG_PACKAGES=(build-essential cmake ninja-build libeigen3-dev libflann-dev libnanoflann-dev libpcl-dev
  libspectra-dev libvtk9-dev libvtk9-qt-dev pybind11-dev python3-dev python3-numpy python3-vtk9 xvfb xauth
  zlib1g-dev)

dgg_fail() {
  echo "error: $*" >&2
  exit 1
}

dgg_is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Install those of the packages that are missing.
dgg_install() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "note: this is not a Debian-like system, so nothing is installed. Needed are the" >&2
    echo "      equivalents of: $*" >&2
    return
  fi
  local missing=() package
  for package in "$@"; do
    dgg_is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || dgg_fail "please install as root: ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]} ..."
  local log
  log="$(mktemp)"
  if ! { "${as_root[@]}" apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    dgg_fail "could not install: ${missing[*]}"
  fi
  rm -f "$log"
}

# Shows the progress of ninja, whose output is read, in steps of 10 %.
dgg_show_progress() {
  awk -F '[][/]' '/^\[[0-9]+\/[0-9]+\]/ {
      percent = 10 * int(10 * $2 / $3)
      if (percent > shown) { printf " %d %%", percent; fflush(); shown = percent }
    }
    END { if (shown) print "" }'
}

# dgg_build FOLDER [CMAKE ARGUMENTS]: configure and build, showing progress, and the end of the
# output when it fails.
dgg_build() {
  local folder="$1"
  shift
  mkdir -p "$folder"
  local log="$folder/build.log"
  echo "Building in $folder ..."
  if ! { cmake -G Ninja -S "$DGG_ROOT" -B "$folder" "$@" &&
    cmake --build "$folder"; } 2>&1 | tee "$log" | dgg_show_progress; then
    tail -n 60 "$log" >&2
    dgg_fail "the build failed; all of its output is in $log"
  fi
}

# Run a command that draws. Without a display, on a virtual one.
dgg_with_display() {
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
  else
    command -v xvfb-run >/dev/null || dgg_fail "no DISPLAY, and no xvfb-run to make one"
    # Without -noreset it starts anew whenever the last client leaves, and refuses those that come then.
    xvfb-run -a -s "-screen 0 1920x1440x24 -noreset" "$@"
  fi
}

# dgg_make_root RELEASE FOLDER NAME: a fresh, minimal Debian 12, 13 or testing in FOLDER/NAME, mounted
# until the script ends. FOLDER keeps what debootstrap and apt have downloaded.
dgg_make_root() {
  local folder="$2" suite
  case "$1" in
    12) suite=bookworm ;;
    13) suite=trixie ;;
    testing) suite=testing ;;
    *) dgg_fail "The release $1 is unknown. Choose 12, 13 or testing." ;;
  esac
  dgg_root="$folder/$3"
  [ "$(id -u)" -eq 0 ] || dgg_fail "Only root can make a system of its own."
  command -v debootstrap >/dev/null || dgg_fail "debootstrap was not found. Install debootstrap."
  mkdir -p "$folder/archives/partial"
  if [ ! -d "$folder/$suite" ]; then
    rm -rf --one-file-system "$folder/$suite.part"
    debootstrap --variant=minbase "$suite" "$folder/$suite.part"
    mv "$folder/$suite.part" "$folder/$suite"
  fi
  dgg_unmount_root
  rm -rf --one-file-system "$dgg_root"
  cp -a "$folder/$suite" "$dgg_root"
  trap dgg_unmount_root EXIT
  mount -t proc proc "$dgg_root/proc"
  mount --rbind --make-rslave /sys "$dgg_root/sys"
  mount --rbind --make-rslave /dev "$dgg_root/dev"
  mount --bind "$folder/archives" "$dgg_root/var/cache/apt/archives"
  # Proxies and mirrors of this system, but not the clean-up of containers.
  cp /etc/apt/apt.conf.d/* "$dgg_root/etc/apt/apt.conf.d"
  rm -f "$dgg_root/etc/apt/apt.conf.d/docker-clean"
  echo 'Binary::apt::APT::Keep-Downloaded-Packages "true"; APT::Install-Recommends "false";
Dpkg::Use-Pty "0";' >"$dgg_root/etc/apt/apt.conf.d/99keep"
}

dgg_unmount_root() {
  local mounted
  for mounted in var/cache/apt/archives dev sys proc; do
    ! mountpoint -q "$dgg_root/$mounted" || umount -R "$dgg_root/$mounted"
  done
}

# Run a shell command in that system as its user would, in /srv.
dgg_in_root() {
  chroot "$dgg_root" env -i HOME=/srv XDG_CACHE_HOME=/srv/.cache PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive TERM=xterm MANPAGER=cat bash -c "cd /srv && $1"
}
