#!/usr/bin/env bash
# The launcher on made-up machines: a PATH with nothing but what a claim needs, and a project that
# has nothing but the launcher.
#   test.sh LAUNCHER
set -u
launcher=$1
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
failures=0

expect() {  # expect WHAT FOUND WANTED-PATTERN
  # shellcheck disable=SC2053
  [[ $2 == $3 ]] && return
  printf 'FAILED %s: %s\n  found:  %s\n  wanted: %s\n' "$claim" "$1" "$2" "$3"
  failures=$((failures + 1))
}

tool() {  # tool NAME BODY
  printf '#!%s\nproject="%s" machine="%s"\n%s\n' "$BASH" "$project" "$machine" "$2" >"$machine/$1"
  chmod +x "$machine/$1"
}

# A fresh machine with the basic tools only, and a fresh project on it, in a path with a space.
claim() {
  claim=$1
  machine=$(mktemp -d -p "$scratch")
  project="$(mktemp -d -p "$scratch")/my project"
  mkdir "$project"
  chmod 755 "$machine" "${project%/*}"
  local basic
  for basic in bash chmod env cat cut dirname find flock grep mkdir nproc readlink rm tail tee; do
    ln -s "$(command -v "$basic")" "$machine/$basic"
  done
  cp "$launcher" "$project/vortree"
}

# cmake and ninja that only leave a program behind, which prints where and with what it is called
# and returns 7.
builders() {
  tool cmake 'echo "CMAKE_HOME_DIRECTORY:INTERNAL=$project" >"$project/build/CMakeCache.txt"
    echo configured >>"$project/steps"; : >"$project/build/build.ninja"'
  tool ninja 'echo "ninja ${@: -1}" >>"$project/steps"; echo "[1/1] Building CXX object"
    mkdir -p "$project/build/bin"
    printf '"'#!%s\\necho \"\$PWD: \$*\"; exit 7\\n'"' "$BASH" >"$project/build/bin/vortree"
    chmod +x "$project/build/bin/vortree"'
  tool ctest 'echo "ctest $*"; exit 8'
}

# An apt whose installed packages are the words of the file `installed`.
apt() {
  printf '%s\n' "$@" >"$machine/installed"
  tool apt-get 'echo "$DEBIAN_FRONTEND $*" >>"$project/steps"'
  tool dpkg-query 'while read -r name; do echo "$name installed"; done <"$machine/installed"; exit 1'
}

call() {  # call FROM LAUNCHER ARGUMENTS: sets out, err, code
  local from=$1
  shift
  out=$(cd "$from" && PATH=$machine "$@" 2>"$scratch/err")
  code=$?
  err=$(<"$scratch/err")
}

# The same by a user who may not write what others own, if the caller is root.
call_as_user() {
  if ((EUID == 0)); then
    call "$1" "$(command -v setpriv)" --reuid=65534 --regid=65534 --clear-groups "${@:2}"
  else
    call "$@"
  fi
}

steps() { cat "$project/steps" 2>/dev/null; }

packages='g++ cmake ninja-build libeigen3-dev libboost-dev libfftw3-dev libhdf5-dev
libtomlplusplus-dev libcli11-dev libfmt-dev libmuparser-dev nlohmann-json3-dev catch2 python3-matplotlib python3-h5py
ffmpeg'

claim "without apt it names what is missing and stops"
call "$project" ./vortree cases
expect code $code 1
expect lines "$(grep -c '' <<<"$err")" 1
expect names "$err" "vortree: missing: g++ cmake ninja-build*"
expect nothing-done "$(steps)" ""

claim "with everything installed apt is not called; arguments, folder and exit code pass through"
apt $packages; builders
mkdir "$project/elsewhere"
ln -s "$project/vortree" "$project/elsewhere/link"
call "$project/elsewhere" ./link run "my scene.toml" nu=1
expect code $code 7
expect out "$out" "$project/elsewhere: run my scene.toml nu=1"
expect steps "$(steps)" "configured"$'\n'"ninja vortree"
expect said "$err" "vortree: building"
call "$project" ./vortree cases
expect again "$(steps)" "configured"$'\n'"ninja vortree"$'\n'"ninja vortree"

claim "a package that is known but not or half installed is installed, and no other, after an update"
apt ${packages/catch2/}; builders
printf 'catch2 half-\ncatch2 not-\n' >>"$machine/installed"
if ((EUID != 0)); then tool sudo 'exec "$@"'; fi
call "$project" ./vortree cases
expect code $code 7
expect said "${err%%$'\n'*}" "vortree: installing catch2"
expect steps "$(steps)" "noninteractive * update
noninteractive * install -y --no-install-recommends catch2
configured*"

claim "a failing installation ends with apt's words and 1"
apt g++; builders
tool apt-get 'echo "E: Unable to locate package" >&2; exit 100'
if ((EUID != 0)); then tool sudo 'exec "$@"'; fi
call "$project" ./vortree cases
expect code $code 1
expect words "$err" "*E: Unable to locate package*could not install cmake ninja-build*"

claim "test builds all, and leaves with ctest's code"
apt $packages; builders
call "$project" ./vortree test -R tree
expect code $code 8
expect out "$out" "ctest --test-dir $project/build --output-on-failure -R tree"
expect steps "$(steps)" "configured"$'\n'"ninja all"

claim "python installs and builds what its package needs, and says how to import it"
apt $packages; builders
if ((EUID != 0)); then tool sudo 'exec "$@"'; fi
call "$project" ./vortree python
expect code $code 0
expect out "$out" "PYTHONPATH=\"$project/build/python\" /usr/bin/python3 -c \"import vortree\""
expect steps "$(steps)" "noninteractive * update
noninteractive * install -y --no-install-recommends pybind11-dev python3-dev python3-numpy python3-scipy python3-pytest
configured
ninja vortree_python"

claim "a folder that was built before is configured once more for the Python package, and only once"
apt $packages pybind11-dev python3-dev python3-numpy python3-scipy python3-pytest; builders
call "$project" ./vortree cases
tool cmake 'echo "again $*" >>"$project/steps"; echo "VORTREE_PYTHON:STRING=ON" >>"$project/build/CMakeCache.txt"'
call "$project" ./vortree python
call "$project" ./vortree python
expect code $code 0
expect steps "$(steps)" "configured"$'\n'"ninja vortree"$'\n'"again -S *-DVORTREE_PYTHON=ON"$'\n'"ninja vortree_python"$'\n'"ninja vortree_python"

claim "once the Python package was asked for it is built with the program"
apt $packages pybind11-dev python3-dev python3-numpy python3-scipy python3-pytest; builders
call "$project" ./vortree cases
echo "VORTREE_PYTHON:STRING=ON" >>"$project/build/CMakeCache.txt"
tool ninja 'echo "ninja ${*:5}" >>"$project/steps"'
call "$project" ./vortree cases
expect steps "$(steps)" "configured"$'\n'"ninja vortree"$'\n'"ninja vortree_python vortree"

claim "python with words calls Python with them, which finds the package"
apt $packages pybind11-dev python3-dev python3-numpy python3-scipy python3-pytest; builders
mkdir -p "$project/build/python/vortree"
echo 'built = __file__' >"$project/build/python/vortree/__init__.py"
call "$project" ./vortree python -c 'import vortree, sys; print(vortree.built, sys.argv[1:]); sys.exit(5)' "a b"
expect code $code 5
expect out "$out" "$project/build/python/vortree/__init__.py \['a b'\]"

claim "docs installs what makes the site and no compiler, makes it, and builds nothing"
apt python3-sphinx; builders
if ((EUID != 0)); then tool sudo 'exec "$@"'; fi
mkdir -p "$project/src/docs"
echo 'import sys; print(sys.argv[1:])' >"$project/src/docs/build.py"
call "$project" ./vortree docs
expect code $code 0
expect out "$out" "\['$project/build/docs'\]"
expect said "${err##*$'\n'}" "vortree: $project/build/docs/index.html"
expect steps "$(steps)" "noninteractive * update
noninteractive * install -y --no-install-recommends python3-myst-parser python3-breathe furo doxygen"

claim "a site that cannot be made is told, and the code is 1"
apt python3-sphinx python3-myst-parser python3-breathe furo doxygen; builders
mkdir -p "$project/src/docs"
echo 'import sys; sys.exit("a link leads nowhere")' >"$project/src/docs/build.py"
call "$project" ./vortree docs
expect code $code 1
expect words "$err" "a link leads nowhere*the site could not be made"

claim "a build that fails is shown, and nothing runs"
apt $packages; builders
tool ninja 'echo "[1/2] Building CXX object a.o"; echo "a.cpp:1: error: no"; exit 1'
call "$project" ./vortree cases
expect code $code 1
expect out "$out" ""
expect shown "$err" "*a.cpp:1: error: no*the build failed*"

claim "a project that was moved is configured afresh"
apt $packages; builders
call "$project" ./vortree cases
echo "CMAKE_HOME_DIRECTORY:INTERNAL=/old/place" >"$project/build/CMakeCache.txt"
call "$project" ./vortree cases
expect steps "$(steps)" "configured"$'\n'"ninja vortree"$'\n'"configured"$'\n'"ninja vortree"

claim "two calls at once build one after the other"
apt $packages; builders
# The first to build goes on when the other waits for it, or clashes with it.
mkfifo "$project/other"
rm "$machine/flock"
tool flock '[[ $1 == -n ]] || echo waits >"$project/other"
  exec '"$(command -v flock)"' "$@"'
tool ninja '[[ -e $project/built ]] && exit
  mkdir "$project/busy" || { echo clash | tee -a "$project/steps" >"$project/other"; exit; }
  read -r _ <"$project/other"; : >"$project/built"'
(cd "$project" && PATH=$machine ./vortree cases) >/dev/null 2>&1 &
call "$project" ./vortree cases
wait
expect steps "$(steps)" "configured"

claim "with HOME unset, by way of a link to a link, the call is the same"
apt $packages; builders
mkdir "$project/elsewhere"
ln -s "$project/vortree" "$project/elsewhere/link"
ln -s link "$project/elsewhere/link to link"
call "$project/elsewhere" env -u HOME "./link to link" cases
expect code $code 7
expect out "$out" "$project/elsewhere: cases"

claim "a built project that cannot be written runs as built, and says nothing"
apt $packages; builders
call "$project" ./vortree cases
chmod -R a-w "$project/build"
call_as_user / "$project/vortree" run "my scene.toml"
expect code $code 7
expect out "$out" "/: run my scene.toml"
expect said "$err" ""
expect steps "$(steps)" "configured"$'\n'"ninja vortree"

claim "a program that is older than sources that cannot be built is run with a line about it"
apt $packages; builders
call "$project" ./vortree cases
mkdir "$project/tree"
touch -d "+1 hour" "$project/tree/new.cpp"
chmod -R a-w "$project/build"
call_as_user "$project" ./vortree cases
expect code $code 7
expect said "$err" "vortree: cannot write to $project/build: running an older build than the sources"

claim "what needs a build folder that cannot be written is refused in one line"
apt $packages; builders
mkdir "$project/build"
chmod -R a-w "$project"
call_as_user "$project" ./vortree cases
expect code $code 1
expect said "$err" "vortree: cannot write to $project/build, and there is no program in it"
chmod -R u+w "$project"
call "$project" ./vortree cases
chmod -R a-w "$project"
call_as_user "$project" ./vortree test
expect code $code 1
expect said "$err" "vortree: cannot write to $project/build, as test needs to"

claim "what OpenMP would not take for a number of threads is refused in one line"
apt $packages; builders
for threads in -4 0 four 2.5 4,; do
  call "$project" env OMP_NUM_THREADS="$threads" ./vortree cases
  expect code $code 1
  expect said "$err" "vortree: OMP_NUM_THREADS is \"$threads\"; numbers of threads from 1 on were expected"
done
for threads in 4 " 4 " 4,2 ""; do
  call "$project" env OMP_NUM_THREADS="$threads" ./vortree cases
  expect code $code 7
done

claim "without sudo a user is told what to ask for"
apt ${packages/catch2/}; builders
chmod 777 "$project"
call_as_user "$project" ./vortree cases
expect code $code 1
expect said "$err" "vortree: missing: catch2. There is no sudo here; ask an administrator for: apt-get install catch2"
expect nothing-done "$(steps)" ""

claim "a user whom sudo refuses is told what to ask for"
apt ${packages/catch2/}; builders
chmod 777 "$project"
tool sudo 'echo "nobody is not in the sudoers file" >&2; exit 1'
call_as_user "$project" ./vortree cases
expect code $code 1
expect said "$err" "*not in the sudoers file*could not install catch2*ask an administrator for: apt-get install catch2"

claim "packages installs what is missing and what is named, and builds nothing"
apt ${packages/catch2/}; builders
if ((EUID != 0)); then tool sudo 'exec "$@"'; fi
call "$project" ./vortree packages clang "libomp-dev"
expect code $code 0
expect steps "$(steps)" "noninteractive * update
noninteractive * install -y --no-install-recommends catch2 clang libomp-dev"
apt $packages clang
rm "$project/steps"
call "$project" ./vortree packages clang
expect again "$code $(steps)" "0 "

((failures == 0)) && echo "all claims hold"
exit $((failures > 0))
