#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# scripts/setup.sh [--yes] [--tests] [--preset NAME] makes the checkout ready for ./snell, ./test.
#
# Names and installs missing packages (asking first at a terminal, unless --yes is given or CI is
# set), configures and builds: the program alone, or everything with --tests. Speaks on stderr; all
# that CMake and Ninja say is kept in build/setup.log. It remembers nothing but the build itself, so
# it may be interrupted and repeated at any time. Exits 0 when all is built, 1 with the reason when
# not, 130 after Ctrl-C.
set -euo pipefail

# Debian 12, Ubuntu 24.04 and newer have all of these under the same names.
program_packages=(g++ cmake ninja-build glslc spirv-tools libtbb-dev libglm-dev libfmt-dev
  libtomlplusplus-dev libcli11-dev libopenexr-dev libpng-dev libjpeg-dev libwebp-dev
  libtinyobjloader-dev libtinygltf-dev nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev
  libosd-dev libassimp-dev libnanovdb-dev libvulkan-dev zlib1g-dev libglfw3-dev libimgui-dev
  fonts-dejavu-core)
test_packages=(libgtest-dev libembree-dev mesa-vulkan-drivers clang libclang-rt-dev xvfb
  xdotool libgl1-mesa-dri)

# Print the packages' names for other systems, where nothing is installed.
suggest_packages() {
  cat <<'END'
snell: without apt, please install what is missing of these packages by hand:
  Fedora:   dnf install gcc-c++ cmake ninja-build glslc spirv-tools tbb-devel glm-devel fmt-devel
              tomlplusplus-devel cli11-devel openexr-devel libpng-devel libjpeg-turbo-devel
              libwebp-devel tinyobjloader-devel json-devel draco-devel meshoptimizer-devel
              opensubdiv-devel assimp-devel nanovdb-devel vulkan-headers zlib-devel;
              and from its source: tinygltf
            for the tests: gtest-devel vulkan-loader mesa-vulkan-drivers
  Arch:     pacman -S --needed gcc cmake ninja shaderc spirv-tools onetbb glm fmt tomlplusplus cli11
              openexr libpng libjpeg-turbo libwebp nlohmann-json draco opensubdiv assimp openvdb
              vulkan-headers zlib; and from the AUR: tinyobjloader tinygltf meshoptimizer
            for the tests: gtest vulkan-icd-loader vulkan-swrast
  Homebrew: brew install cmake ninja shaderc spirv-tools tbb glm fmt tomlplusplus cli11
              openexr libpng jpeg-turbo webp nlohmann-json draco meshoptimizer opensubdiv assimp
              openvdb vulkan-headers;
              and from their sources: tinyobjloader tinygltf
            for the tests: googletest vulkan-loader molten-vk
  Embree 3 (not 4), where there is a package, adds the benchmark of rays; clang with its runtime
  (Fedora: clang compiler-rt; Arch: clang compiler-rt; Homebrew: llvm) adds the fuzzers. GLFW and Dear
  ImGui add 'snell view' (Fedora: glfw-devel imgui-devel; Arch: glfw imgui; Homebrew: glfw imgui), Xvfb
  and xdotool its test.
END
}

say() { printf 'snell: %s\n' "$@"; }

fail() {
  say "$@"
  exit 1
}

missing_packages() {
  local installed package
  installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "$@" 2>/dev/null || true)"
  for package in "$@"; do
    [[ $installed == *" installed:$package "* ]] || echo "$package"
  done
}

install_packages() {
  local answer sudo='' run
  say "$# packages are needed that are not installed:"
  fold -s -w 96 <<<"$*" | sed 's/^/  /'

  # Only root may install.
  # shellcheck disable=SC2016 # the inner shell expands "$@"
  run=(sh -c 'apt-get update -q; DEBIAN_FRONTEND=noninteractive apt-get install -y -q \
    --no-install-recommends -o DPkg::Lock::Timeout=300 "$@"' apt "$@")
  if ((EUID != 0)); then sudo='sudo ' run=(sudo "${run[@]}"); fi
  local by_hand="${sudo}apt-get update && ${sudo}apt-get install --no-install-recommends $*"
  if [[ $sudo ]] && ! command -v sudo >/dev/null; then
    fail "you are not root and there is no sudo; please have root run this, then try again:" \
      "  ${by_hand//sudo /}"
  fi

  # Ask whoever sits at the terminal.
  if ((terminal)) && [[ -z $yes && -z ${CI:-} ]]; then
    printf 'snell: install them now? [Y/n] ' >/dev/tty
    read -r answer </dev/tty || { echo && answer=n; }
    [[ $answer =~ ^([Yy].*)?$ ]] || fail "nothing was installed; by hand it is:" "  $by_hand"
  fi

  "${run[@]}" || fail "the packages could not be installed; by hand it is:" "  $by_hand" \
    "(Debian 12, Ubuntu 24.04 and newer have all of them, Ubuntu in its universe)"
}

# Without apt, what is missing shows when CMake looks for it.
provide_packages() {
  local packages=("${program_packages[@]}") missing
  if ((!has_apt)); then return; fi
  if ((tests)); then packages+=("${test_packages[@]}"); fi
  mapfile -t missing < <(missing_packages "${packages[@]}")
  ((${#missing[@]} == 0)) || install_packages "${missing[@]}" 9>&-
}

configure() {
  local cache=$dir/CMakeCache.txt rules=$dir/build.ninja home switch options has_tests=0

  # A build directory that was copied or moved here names another checkout's files.
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache" 2>/dev/null || true)
  if [[ $home && ! $home -ef . ]]; then
    say "$dir was made for $home; starting afresh"
    rm -rf -- "$dir"
  fi

  # Tests stay once they are there, lest ./snell and ./test undo each other's configuration.
  if [[ -e $rules ]] && grep -qs '^SNELL_BUILD_TESTS:BOOL=ON' "$cache"; then has_tests=1; fi
  if ((tests || has_tests)); then switch=ON; else switch=OFF; fi

  # Ninja follows changed CMake files by itself. Only changed presets, tests wanted for the first
  # time, and a build that did not finish (build.ninja may be at fault) need a new run.
  if [[ $rules -nt CMakePresets.json && ! -e $dir/setup.stamp.new ]] && ((has_tests >= tests)); then
    return
  fi

  say "configuring ($preset)"
  options=("-DSNELL_BUILD_TESTS=$switch" "-DSNELL_BUILD_BENCH=$switch")
  if ! cmake --preset "$preset" "${options[@]}" >>"$log" 2>&1; then
    cat "$log"
    ((has_apt)) || suggest_packages
    fail "configuring failed; $advice"
  fi
}

# As many jobs as there are cores, but no more than memory bears at 1.5 GB each.
count_jobs() {
  {
    nproc 2>/dev/null || getconf _NPROCESSORS_ONLN
    awk '/^MemAvailable:/ { print int($2 / 1.5e6) }' /proc/meminfo 2>/dev/null || true
    awk '/^[0-9]/ { print int($1 / 1.5e9) }' /sys/fs/cgroup/memory.max 2>/dev/null || true
  } | sort -n | awk 'NR == 1 { print ($1 > 1 ? $1 : 1) }'
}

# Show the build that comes in on stdin: at a terminal its steps in one line, else one step every
# 5 percent; all else that it says, such as warnings and errors, in full.
show_progress() {
  local line width=0 due=0
  if [[ -t 2 && ${TERM:-dumb} != dumb ]]; then
    read -r _ width < <(stty size <&2 2>/dev/null) || true
    ((width)) || width=80
  fi
  clear_line() { ((!width)) || printf '\r%*s\r' $((width - 1)) ''; }

  while IFS= read -r line; do
    if [[ $line =~ ^'['\ *([0-9]+)%']' ]]; then
      if ((width)); then
        printf '\r%-*.*s' $((width - 1)) $((width - 1)) "$line"
      elif ((BASH_REMATCH[1] >= due)); then
        printf '%s\n' "$line"
        due=$((BASH_REMATCH[1] + 5))
      fi
    elif [[ $line != '-- '* && $line != 'ninja: no work to do.' ]]; then
      clear_line
      printf '%s\n' "$line"
    fi
  done
  clear_line
}

build() {
  local target=snell_programs jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(count_jobs)}
  if ((tests)); then target=all; fi
  say "building ($preset, $jobs jobs)"

  # The stamp is as old as the build's beginning: what is edited meanwhile is newer.
  touch "$dir/setup.stamp.new"
  NINJA_STATUS='[%p] ' cmake --build --preset "$preset" --parallel "$jobs" --target $target 2>&1 |
    tee -a "$log" | show_progress || fail "the build failed; $advice"
  mv "$dir/setup.stamp.new" "$dir/setup.stamp"
}

yes='' tests=0 preset=release
while (($#)); do
  case $1 in
    --yes) yes=1 ;;
    --tests) tests=1 ;;
    --preset) preset=${2:?--preset needs a name} && shift ;;
    *) fail "setup.sh does not know '$1'" >&2 ;;
  esac
  shift
done

# Is somebody there to answer? Leave stdin and stdout to the program.
terminal=0 has_apt=0
if [[ -t 0 || -t 2 ]] && { : </dev/tty; } 2>/dev/null; then terminal=1; fi
if command -v apt-get && command -v dpkg-query; then has_apt=1; fi >/dev/null
exec </dev/null >&2
trap 'echo; say "interrupted; the next run goes on from here"; exit 130' INT TERM

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
dir=build/$preset log=build/setup.log
advice="the whole log is '$PWD/$log'; to start afresh, remove '$PWD/$dir'"

# One set-up works at a time; another waits, and finds the work done.
{ mkdir -p build && : >>build/setup.lock; } 2>/dev/null || fail "cannot write to '$PWD/build'"
exec 9>>build/setup.lock
if command -v flock >/dev/null && ! flock -n 9; then
  say "another set-up is at work in this checkout; waiting for it"
  flock 9 || true
fi

: >"$log"
provide_packages
configure
build
