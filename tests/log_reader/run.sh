#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh WRITER FOLDER: installs the npm packages into FOLDER once, writes a sample log with WRITER
# and reads it back with them. 77 = skipped.
set -eu
writer=$1
folder=$2
here=$(cd "$(dirname "$0")" && pwd)
for program in node npm; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: $program is not installed"
    exit 77
  fi
done
mkdir -p "$folder"
cp "$here/package.json" "$here/.npmrc" "$here/check_log.mjs" "$folder/"
cd "$folder"
if ! [ -e node_modules/.complete ] || ! cmp -s package.json node_modules/.complete; then
  npm install --no-audit --no-fund --loglevel=error
  cp package.json node_modules/.complete
fi
"$writer" sample.mcap
node check_log.mjs sample.mcap
