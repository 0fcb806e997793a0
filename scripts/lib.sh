# Shared by the scripts of this folder; sourced, not run.
#
#   setup [EXTRA...]     system packages, .venv, the wheel with those extras; quick when all is there
#   choose_window        sets the offscreen window that VTK opens; after setup
#
# Environment: SPHEREPACKING_PYTHON names the CPython to use; CXX the compiler.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
log=$root/build/setup.log
venv=$root/.venv
oldest_python=12
peers=()         # packages that only one of the scripts needs
newest_python=14 # the newest 3.x that every dependency has wheels for

say() { printf '==> %s\n' "$*"; }
die() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# Runs a command with its output in the log; shows the log's end when it fails.
logged() {
  printf '\n$ %s\n' "$*" >>"$log"
  "$@" >>"$log" 2>&1 </dev/null || {
    printf '%s\n' "--- the last lines of $log:" >&2
    tail -n 40 "$log" >&2
    die "failed: $*"
  }
}

# --- Python -------------------------------------------------------------------------------------

# Prints "<minor> <micro>" of a usable interpreter, or says on stderr what it lacks.
probe_python() {
  "$1" -I -c '
import sys, sysconfig
from pathlib import Path

oldest, newest = map(int, sys.argv[1:])
version = sys.version_info
lacks = []
if sys.implementation.name != "cpython" or version[0] != 3 or not oldest <= version[1] <= newest:
    sys.exit(f"is {sys.implementation.name} {sys.version.split()[0]}")
if version.releaselevel != "final":
    lacks.append("a final release")
if sysconfig.get_config_var("Py_GIL_DISABLED"):
    lacks.append("the stable ABI (it is free-threaded)")
for module in ("ssl", "venv", "ensurepip", "zlib", "ctypes"):
    try:
        __import__(module)
    except ImportError:
        lacks.append(module)
if not Path(sysconfig.get_path("include"), "Python.h").is_file():
    lacks.append("Python.h")
if lacks:
    sys.exit(f"is {sys.version.split()[0]} but lacks " + ", ".join(lacks))
print(version[1], version[2])
' "$oldest_python" "$newest_python" </dev/null
}

# Every interpreter worth a probe, one a line.
python_candidates() {
  local folder
  if [ -n "${SPHEREPACKING_PYTHON:-}" ]; then
    printf '%s\n' "$SPHEREPACKING_PYTHON"
    return
  fi
  {
    local IFS=:
    for folder in $PATH; do
      printf '%s\n' "$folder"/python3 "$folder"/python3.[0-9]*
    done
    printf '%s\n' "${PYENV_ROOT:-$HOME/.pyenv}"/versions/*/bin/python3
  } | grep -E '/python3(\.[0-9]+)?$' | while read -r folder; do
    if [ -x "$folder" ] && [ ! -d "$folder" ]; then printf '%s\n' "$folder"; fi
  done | awk '!seen[$0]++'
}

# Sets `python` to the newest usable interpreter, or to nothing with the reasons in `rejected`.
find_python() {
  local candidate answer best=""
  python=""
  rejected=""
  while read -r candidate; do
    if answer=$(probe_python "$candidate" 2>&1) && [[ $answer =~ ^[0-9]+\ [0-9]+$ ]]; then
      answer=$(printf '%03d%03d' ${answer})
      if [[ -z $best || $answer > $best ]]; then
        best=$answer
        python=$candidate
      fi
    else
      rejected+="  $candidate ${answer##*$'\n'}"$'\n'
    fi
  done < <(python_candidates)
}

# --- system packages ----------------------------------------------------------------------------

# Not grep -q: it would end before ldconfig does, which pipefail takes for a failure.
can_load() { /sbin/ldconfig -p | grep -F "$1" >/dev/null; }

has_x11_headers() {
  printf '#include <X11/Xlib.h>\n' | "${CXX:-c++}" -E -x c++ - >/dev/null 2>&1
}

# Whether .venv has a Python with pip, and no installation into it was cut short.
venv_works() {
  [ ! -e "$venv/.installing" ] && "$venv/bin/python" -c 'import pip' 2>/dev/null
}

# What Debian calls the missing things, in `packages`.
missing_packages() {
  local package
  packages=()
  if ! command -v "${CXX:-c++}" >/dev/null; then packages+=(g++); fi
  # find_package(VTK) asks for X11's headers, although no display is needed.
  if ! has_x11_headers; then packages+=(libx11-dev); fi
  if ! can_load libOSMesa.so.8; then
    # Mesa 25.1 dropped OSMesa; its EGL draws without a display, too.
    if command -v apt-cache >/dev/null && [ -z "$(apt-cache madison libosmesa6 2>/dev/null)" ] &&
      [ -n "$(apt-cache madison libegl-mesa0 2>/dev/null)" ]; then
      if ! can_load libEGL.so.1 || ! { can_load libEGL_mesa.so.0 || can_load libEGL_nvidia.so.0; }
      then
        packages+=(libegl1 libegl-mesa0 libgl1-mesa-dri)
      fi
    else
      packages+=(libosmesa6)
    fi
  fi
  for package in "${peers[@]}"; do
    if ! dpkg -s "$package" >/dev/null 2>&1; then packages+=("$package"); fi
  done
  if venv_works; then return; fi
  find_python
  # Debian's own Python would do, but Debian keeps parts of it in packages of their own.
  if [ -z "$python" ] && [[ $rejected =~ /usr/bin/python3\ is\ .*\ but\ lacks ]]; then
    packages+=(python3-venv python3-dev)
  fi
}

install_packages() {
  missing_packages
  if [ ${#packages[@]} -eq 0 ]; then return; fi
  if ! command -v apt-get >/dev/null; then
    die "these are missing (Debian's names): ${packages[*]}"
  fi
  if [ "$(id -u)" -ne 0 ]; then
    die "packages of the system are missing. Type this, then run the command again:
  sudo apt-get install ${packages[*]}"
  fi
  say "apt-get update"
  logged apt-get update
  missing_packages # what is on offer is known only now
  say "apt-get install ${packages[*]}"
  DEBIAN_FRONTEND=noninteractive logged \
    apt-get install --yes --no-install-recommends "${packages[@]}"
  missing_packages
  if [ ${#packages[@]} -ne 0 ]; then die "still missing after apt-get: ${packages[*]}"; fi
}

# --- environment and package --------------------------------------------------------------------

# A .venv that these scripts began is made anew when it is broken or an installation into it was cut
# short, of which pip itself keeps no trace; another one is left alone.
make_venv() {
  if venv_works; then return; fi
  if [ -e "$venv" ] && [ ! -e "$venv/.begun-by-scripts" ]; then
    die "$venv is there, but does not work or was left half-filled: move it away"
  fi
  if [ -z "$python" ]; then
    die "no usable CPython 3.$oldest_python to 3.$newest_python on PATH or under pyenv.
${rejected:-  (no python3 at all)
}Install one (pyenv install 3.$((oldest_python + 1)), say), or name it in SPHEREPACKING_PYTHON."
  fi
  say "making .venv with $python"
  rm -rf "$venv"
  mkdir "$venv"
  touch "$venv/.begun-by-scripts"
  logged "$python" -m venv "$venv"
}

# A hash of everything that the wheel is made of, and of the interpreter that it goes into.
sources_hash() {
  {
    "$venv/bin/python" -VV
    "${CXX:-c++}" --version
    find CMakeLists.txt pyproject.toml README.md LICENSE cmake python vtkSpherePacking \
      -type f -not -name '*.pyc' -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
  } | sha256sum | cut -d ' ' -f 1
}

# pip install, only of wheels: a dependency without one for this Python must fail here, not compile
# for hours.
install_wheels() {
  touch "$venv/.installing"
  logged "$venv/bin/python" -m pip install --only-binary :all: "$@"
  rm "$venv/.installing"
}

# The wheel is built the way `pip install .` builds it: isolated, with what pyproject.toml names.
install_package() {
  local hash wheel extra
  hash=$(sources_hash)
  if [ "$(cat "$venv/.package-stamp" 2>/dev/null)" != "$hash" ]; then
    say "building the wheel (a minute or two)"
    rm -rf build/wheel "$venv"/.*-stamp
    logged "$venv/bin/python" -m pip wheel --no-deps --wheel-dir build/wheel .
    say "installing it and what it needs into .venv"
    wheel=$(echo build/wheel/*.whl)
    install_wheels "$wheel"
    # pip skips a wheel of the same version, so the package itself is put in once more.
    install_wheels --no-deps --force-reinstall "$wheel"
    printf '%s\n' "$hash" >"$venv/.package-stamp"
  fi
  wheel=$(echo build/wheel/*.whl)
  [ -f "$wheel" ] || die "no wheel in build/wheel: remove .venv/.package-stamp and start again"
  for extra; do
    if [ "$(cat "$venv/.$extra-stamp" 2>/dev/null)" = "$hash" ]; then continue; fi
    say "installing the extra '$extra'"
    install_wheels "$wheel[$extra]"
    printf '%s\n' "$hash" >"$venv/.$extra-stamp"
  done
}

setup() {
  mkdir -p build
  exec 9>build/.setup-lock
  flock 9 # two scripts at once would write the same .venv
  : >"$log"
  install_packages
  make_venv
  install_package "$@"
  exec 9>&-
}

# The one that the package chooses where there is no display, even if there is one.
choose_window() {
  VTK_DEFAULT_OPENGL_WINDOW=$("$venv/bin/python" -m spherepacking.draw.offscreen)
  export VTK_DEFAULT_OPENGL_WINDOW
}
