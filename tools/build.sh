#!/usr/bin/env bash
# build.sh PRESET [TARGET…]: configures and builds in build/PRESET. Says nothing if nothing is to be done, a line now
# and then while it works, what it has to leave out, and everything if it fails.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
preset=$1
shift
targets=("${@:-all}")
folder=$root/build/$preset
log=$folder/build.log

fail() {
  echo "scatter: $1" >&2
  exit 1
}

# Two builds in one folder would spoil each other.
mkdir -p "$folder"
exec 9> "$folder/build.lock"
flock 9

configure() {
  local version
  version=$(cmake --version | sed -n '1s/[^0-9]*//p')
  if [[ $(printf '%s\n' 3.25 "$version" | sort -V | head -n 1) != 3.25 ]]; then
    fail "CMake 3.25 or newer is needed, this is $version; use Debian 12, Ubuntu 24.04 or newer"
  fi
  local options=(-DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
  if command -v ccache > /dev/null; then
    # What ccache must know to remember what was compiled with a precompiled header.
    options+=("-DCMAKE_CXX_COMPILER_LAUNCHER=env;CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;ccache")
  fi
  # With the compiler that the project is checked with, warnings are errors; another one has other warnings.
  if [[ $(c++ -dumpversion 2> /dev/null) != 12* ]]; then
    options+=(-DSCATTER_WARNINGS_AS_ERRORS=OFF)
  fi
  cd "$root"
  if ! cmake --preset "$preset" "${options[@]}" > "$log" 2>&1; then
    cat "$log" >&2
    fail "CMake could not configure the $preset build; what it said is above and in $log"
  fi
}

# Reads ninja's output: a line that is rewritten on a terminal, else one for every tenth of the work.
show_progress() {
  local line steps total next=0 shown=no
  while IFS= read -r line; do
    printf '%s\n' "$line" >> "$log"
    # What a build has to leave out, it says in a line of its own.
    [[ $line != "scatter: "* ]] || echo "$line" >&2
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      steps=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
      if [[ -t 2 ]]; then
        printf '\rscatter: building %s, %d of %d steps ' "$preset" "$steps" "$total" >&2
        shown=yes
      elif ((steps * 10 >= next * total && total > 1)); then
        echo "scatter: building $preset, $steps of $total steps" >&2
        next=$((steps * 10 / total + 1))
      fi
    fi
  done
  [[ $shown == no ]] || echo >&2
}

# Anew also when packages came: they may be those of parts that were left out.
configured=$folder/configured
if [[ ! -f $folder/build.ninja || ! -f $folder/compile_commands.json || $root/CMakePresets.json -nt $configured ||
  /var/lib/dpkg/status -nt $configured ]]; then
  configure
  touch "$configured"
fi
: > "$log"
jobs=${SCATTER_JOBS:-$(nproc)}
if ! ninja -C "$folder" -j "$jobs" "${targets[@]}" 2>&1 | show_progress; then
  # From the first failed step on.
  sed -n '/^FAILED:/,$p' "$log" >&2
  fail "the $preset build failed; its whole output is in $log"
fi
