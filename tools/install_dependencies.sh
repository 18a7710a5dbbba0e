#!/usr/bin/env bash
# install_dependencies.sh GROUP…: installs what is missing of the groups in packages.txt. Says first what it installs.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
groups=" ${*:-build} "

fail() {
  echo "scatter: $1" >&2
  exit 1
}

wanted=()
while read -r group package; do
  if [[ $group != "#"* && $groups == *" $group "* ]]; then
    wanted+=("$package")
  fi
done < "$root/tools/packages.txt"

if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
  echo "scatter: this system has no apt-get; going on in the hope that it has the equivalents of: ${wanted[*]}" >&2
  exit 0
fi

# Prints the names of the wanted packages that are not installed.
missing_packages() {
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2> /dev/null || true)
  for package in "${wanted[@]}"; do
    # Node's own packages bring npm with them, and exclude Debian's.
    [[ $package == npm ]] && command -v npm > /dev/null && continue
    grep -qxF "installed $package" <<< "$installed" || echo "$package"
  done
}

mapfile -t missing < <(missing_packages)
[[ ${#missing[@]} -gt 0 ]] || exit 0

by_hand="apt-get update && apt-get install --no-install-recommends ${missing[*]}"
as_root=(env)
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo > /dev/null || fail "cannot install packages without root or sudo; as root, run: $by_hand"
  as_root=(sudo)
  if ! sudo -n true 2> /dev/null && [[ ! -t 0 ]]; then
    fail "sudo asks for a password and there is no terminal to type it; as root, run: $by_hand"
  fi
fi

echo "scatter: installing ${#missing[@]} missing packages with apt-get: ${missing[*]}" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 "$@" >> "$log" 2>&1
}

# apt-get waits for the lock on packages, but not for the one on its lists.
update_lists() {
  local end=$((SECONDS + 300))
  while ((SECONDS < end)); do
    : > "$log"
    apt update && return 0
    grep -q 'Could not get lock' "$log" || return 1
    sleep 5
  done
  return 1
}

# Lists of other software that cannot be fetched need not stop ours.
update_lists || echo "scatter: apt-get update had errors; trying to install all the same" >&2
if ! apt install --no-install-recommends "${missing[@]}"; then
  tail -n 20 "$log" >&2
  fail "apt-get could not install the packages; its last words are above. By hand: $by_hand"
fi
echo "scatter: installed in $SECONDS s" >&2
