# What run.sh and test.sh share. Sourced by them, not run.
# shellcheck shell=bash

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/release"

# Without any locale Qt warns about the encoding on every start.
if [[ -z ${LC_ALL:-}${LC_CTYPE:-}${LANG:-} ]]; then
  export LC_ALL=C.UTF-8
fi

say() { printf '%s\n' "$*" >&2; }

fail() {
  say "$(basename -- "$0"): $*"
  exit 1
}

# The packages named in the given lists that are not installed.
missing_packages() {
  local installed name
  declare -A installed=()
  while read -r name; do
    installed[$name]=1
  done < <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p')
  sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' -- "$@" | while read -r name; do
    [[ -n ${installed[$name]:-} ]] || printf '%s\n' "$name"
  done
}

# As root, or through sudo; a password is asked for only at a terminal.
apt_as_root() {
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=120 "$@")
  if [[ $(id -u) -eq 0 ]]; then
    "${apt[@]}"
  elif [[ -t 2 ]]; then
    sudo -- "${apt[@]}"
  else
    sudo -n -- "${apt[@]}"
  fi
}

# Installs what the given lists name and the machine lacks. Touches neither apt nor the network when all is there.
install_packages() {
  command -v dpkg-query >/dev/null || {
    say "This is not Debian or a relative of it: taking the packages of ${*##*/} for installed."
    return
  }
  local missing
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  if [[ $(id -u) -ne 0 ]] && ! command -v sudo >/dev/null; then
    fail "these packages are missing, and neither root nor sudo is at hand to install them: ${missing[*]}"
  fi
  say "Installing ${missing[*]}"
  { apt_as_root update -q && apt_as_root install -y -q --no-install-recommends "${missing[@]}"; } </dev/null >&2 ||
    fail "apt-get could not install: ${missing[*]}"
}

# Configures with a preset unless the build directory stands already, as its own build or as that of tests.
configure() {
  local preset=$1 cache="$build/CMakeCache.txt" fresh=()
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    fresh=(--fresh)  # the folder was moved or copied
  elif [[ -f $build/build.ninja && ! $root/CMakePresets.json -nt $build/build.ninja ]]; then
    [[ $preset == test ]] || return 0
    ! grep -qx 'ALIDADE_TESTS:[A-Z]*=ON' "$cache" || return 0
  fi
  cmake --preset "$preset" "${fresh[@]}" -S "$root" >&2
}
