# Sourced by install and install-bench, from the root of the checkout: pip_install, and the settings of ccache.

# Settings of ccache, whose cache all clones share. Its default refuses precompiled headers.
export CCACHE_BASEDIR=${CCACHE_BASEDIR-$PWD}
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros,include_file_mtime,include_file_ctime}

# Shows the counter of the build tool as it comes: in place on a terminal, else every tenth step.
show_steps() {
  local line
  while IFS= read -r line; do
    [[ $line =~ ^\ *\[\ *([0-9]+)/([0-9]+)\]\ (Building|Linking) ]] || continue
    if [ -t 1 ]; then
      printf '\r  step %s of %s ' "${BASH_REMATCH[@]:1:2}"
    elif ((BASH_REMATCH[1] % 10 == 0)); then
      printf '  step %s of %s\n' "${BASH_REMATCH[@]:1:2}"
    fi
  done
  [ ! -t 1 ] || echo
}

# pip install ARGS, with a line of progress. What pip and the compiler say is in LOG, and is shown if they fail.
# ccache compiles if it is installed by now; a launcher of the user's own stays.
#   pip_install LOG ARGS...
pip_install() {
  local log=$1
  ! command -v ccache >/dev/null || export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
  mkdir -p "$(dirname "$log")"
  .venv/bin/pip install --verbose --no-build-isolation "${@:2}" 2>&1 | tee "$log" | show_steps && return
  cat "$log" >&2
  return 1
}
