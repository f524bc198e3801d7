#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# viewer_test.sh SNELL: drives "snell view" by keys and mouse, in a display without a screen (Xvfb) and with Mesa's
# OpenGL in software. The viewer tells what it has come to in $SNELL_VIEWER_LOG, which is waited for. Exits 77, for
# CTest "skipped", where Xvfb or xdotool are missing.
set -euo pipefail

snell=$1
for program in Xvfb xdotool; do
  command -v "$program" >/dev/null || { echo "skipped: $program is not installed"; exit 77; }
done

folder=$(mktemp -d)
xvfb='' viewer=''
finish() {
  [[ -z $viewer ]] || kill "$viewer" 2>/dev/null || true
  [[ -z $xvfb ]] || kill "$xvfb" 2>/dev/null || true
  wait
  rm -rf -- "$folder"
}
trap finish EXIT
cd -- "$folder"

fail() {
  echo "FAILED: $*"
  echo "the viewer's log:"
  cat log
  cat errors
  exit 1
}

# How many lines of the log begin with this text.
count_of() { awk -v text="$1" 'index($0, text) == 1 { n++ } END { print n + 0 }' log; }

# Wait until the log has `count` lines that begin with `text`.
wait_for() {
  local text=$1 count=${2:-1} i
  for ((i = 0; i < 600; i++)); do
    if [[ -e log ]] && (($(count_of "$text") >= count)); then return; fi
    kill -0 "$viewer" 2>/dev/null || fail "the viewer ended while '$text' was awaited"
    sleep 0.05
  done
  fail "'$text' did not come $count times"
}

# Wait for a line that is not there yet, after doing something.
expect() {
  local text=$1 before
  shift
  before=$(count_of "$text")
  "$@"
  wait_for "$text" $((before + 1))
}

step() { echo "- $*"; }

start_viewer() {
  rm -f log
  "$snell" view "$@" 2>errors &
  viewer=$!
  wait_for ready
  window=$(xdotool search --sync --onlyvisible --name ' - Snell$' | head -n 1)
  xdotool windowmove "$window" 0 0 windowfocus "$window"
  sleep 0.2
}

write_scene() {
  cat >"scene.toml" <<END
[camera]
position = [0, 1, 5]
look_at = [0, 0.5, 0]
fov = 40

[environment]
top = "#5a7396"

[[light]]
type = "point"
position = [-3, 4, 3]
intensity = 60

[[object]]
shape = "plane"
material = { type = "phong", diffuse = "checker" }

[[object]]
shape = "sphere"
center = [0, 0.6, 0]
radius = $1
material = { type = "phong", diffuse = [0.8, 0.2, 0.1] }
END
}

write_scene 0.6
step "without a display there is one clear line"
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$snell" view scene.toml 2>errors || status=$?
: >log
((status == 1)) || fail "the exit status is $status"
(($(wc -l <errors) == 1)) || fail "there is not one line"
grep -q '^snell: error: no window can be opened' errors || fail "it says something else"

exec 3>display
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null &
xvfb=$!
for ((i = 0; i < 200; i++)); do if [[ -s display ]]; then break; else sleep 0.05; fi; done
DISPLAY=:$(<display)
export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 XDG_CONFIG_HOME=$folder/config SNELL_VIEWER_LOG=$folder/log
unset WAYLAND_DISPLAY

step "open"
start_viewer scene.toml --size 160x120 --spp 4
wait_for finished

step "orbit"
xdotool mousemove 400 300 mousedown 1
sleep 0.2
expect view xdotool mousemove_relative 60 10
xdotool mousemove_relative 30 10 mouseup 1
wait_for finished 2

step "back to the camera of the file"
expect finished xdotool key Home

step "render, done, save"
expect 'render done' xdotool key r
expect 'saved scene.png' xdotool key ctrl+s
"$snell" render scene.toml --size 160x120 --spp 4 -o reference.png --quiet
"$snell" compare reference.png scene.png --metric max --tolerance 0 >difference ||
  fail "the saved picture is another one: $(<difference)"
xdotool key Escape

step "click a pixel"
expect 'explained ' xdotool mousemove 440 390 click 1

step "read the file again when it changes, and keep the camera"
expect view xdotool key Left
views=$(count_of view)
expect ready write_scene 0.5
(($(count_of view) == views + 1)) || fail "the camera was not kept"

step "tell errors with their place"
expect 'error scene.toml:21:' sed -i 's/radius = 0.5/radius = "large"/' scene.toml
expect ready write_scene 0.7

step "quit"
xdotool key ctrl+q
wait "$viewer" || fail "the exit status is $?"
viewer=''
grep -q '^dark = 1' config/snell/viewer.conf || fail "nothing is remembered"

step "stop a long render"
start_viewer scene.toml --size 640x480 --spp 1000000
wait_for 'samples'
expect 'render started' xdotool key r
sleep 0.5
expect 'render stopped' xdotool key Escape
expect 'saved scene-2.png' xdotool key ctrl+s
xdotool key ctrl+q
wait "$viewer" || fail "the exit status is $?"
viewer=''
[[ -s scene-2.png ]] || fail "there is no picture"
