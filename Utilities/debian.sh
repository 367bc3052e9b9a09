#!/bin/sh
# Systems of Debian in folders, for the scripts that try Palpate in them; read by `. Utilities/debian.sh`. They need root,
# mmdebstrap and Debian's archive in reach.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Label: Debian' | head -1)
systems=

# make_system SUITE FOLDER PACKAGES [OPTION…]: unless the folder has a system, a minimal one with packages (a,b,c); ready for `inside`.
make_system() {
  system_suite=$1
  system_folder=$2
  system_packages=$3
  shift 3
  if [ ! -d "$system_folder/etc" ]; then
    echo "== Debian $system_suite in $system_folder"
    # A mirror of the unstable branch may be older than its index allows.
    [ "$system_suite" != sid ] || set -- --aptopt='Acquire::Check-Valid-Until "false"' "$@"
    mmdebstrap --variant=minbase --quiet --include="$system_packages" "$@" "$system_suite" "$system_folder" "$mirror"
  fi
  systems="$systems $system_folder"
  mount -t proc proc "$system_folder/proc"
  mount --bind /dev "$system_folder/dev"
  mount --bind /dev/pts "$system_folder/dev/pts" # a folder of its own, with terminals
}

# inside FOLDER COMMANDS: runs them in the system.
inside() {
  chroot "$1" env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive sh -euc "$2"
}

# inside_offline FOLDER COMMANDS: the same without network.
inside_offline() {
  unshare --net chroot "$1" env LC_ALL=C.UTF-8 sh -euxc "$2"
}

# copy_source FOLDER: the source tree as /source of the system; a build there finds unchanged files as old as they were.
copy_source() {
  mkdir -p "$1/source"
  find "$1/source" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} + # files that were moved since
  tar -c --exclude=./build --exclude=./.git --exclude=./demo-output . | tar -x -C "$1/source"
}

# close_systems: before a script ends; the folders stay.
close_systems() {
  for system_folder in $systems; do
    umount "$system_folder/proc" "$system_folder/dev/pts" "$system_folder/dev" 2>/dev/null || true
  done
}
