#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tests/data/record.sh [SHEETS]   records everything in tests/data anew: the scenes, and the replayed
#                                 log. Pictures of all scenes to look at go to SHEETS (out/scenes).
set -euo pipefail
cd "$(dirname "$0")/../.."
. tools/progress
case ${1:-} in
  -h | --help) print_help tests/data/record.sh; exit 0 ;;
esac
if [ $# -gt 1 ] || [[ ${1:-} == -* ]]; then
  print_help tests/data/record.sh >&2
  exit 2
fi
sheets=${1:-out/scenes}
mkdir -p "$sheets" || exit 2
tools/build host record_scenes kelpie kelpie-agent kelpie-world
build/host/bin/record_scenes tests/data "$sheets"
match=$(mktemp -d)
trap 'rm -rf "$match"' EXIT
build/host/bin/kelpie play --scenario attack --opponent goalie-2004 --seed 9 --seconds 3 \
  --images all --no-film --out "$match"
build/host/bin/kelpie compress "$match/match.mcap" --out tests/data/attack.mcap
du -sh --apparent-size tests/data
