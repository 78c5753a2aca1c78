#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh WRITER FOLDER: writes a sample log with WRITER into FOLDER and reads it with third parties'
# readers (npm's, installed there once), which must also refuse it when its end is missing and, where
# it has chunks and so checksums, when one bit is wrong. 77 = skipped.
set -eu
writer=$1
folder=$2
here=$(cd "$(dirname "$0")" && pwd)
for program in node npm; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: $program is not on this machine (Debian's npm is 376 packages, so it is not installed)"
    exit 77
  fi
done
refused() {
  if node check_log.mjs "$1" 2>/dev/null; then
    echo "run.sh: the readers take $1, which is damaged" >&2
    exit 1
  fi
}
mkdir -p "$folder"
cp "$here/package.json" "$here/.npmrc" "$here"/check_*.mjs "$folder/"
cd "$folder"
if ! [ -e node_modules/.complete ] || ! cmp -s package.json node_modules/.complete; then
  npm install --no-audit --no-fund --loglevel=error
  cp package.json node_modules/.complete
fi
"$writer" sample.mcap
said=$(node check_log.mjs sample.mcap)
echo "$said"
half=$(($(stat -c %s sample.mcap) / 2))
head -c $half sample.mcap >cut.mcap
refused cut.mcap
case $said in
  *", 0 chunks, "*) exit 0 ;;
esac
node -e 'const fs = require("node:fs"), bytes = fs.readFileSync("sample.mcap");
bytes[bytes.length >> 1] ^= 16; fs.writeFileSync("wrong.mcap", bytes)'
refused wrong.mcap
