#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""manual.py KELPIE OUT --version V: writes the page that `man kelpie` shows (kelpie.1.gz), the
words that bash completes (kelpie) and CHANGELOG.md packed (changelog.gz) into the folder OUT.
manual.py PROGRAM OUT --version V --of NAME: of the program that `kelpie NAME` starts the page
kelpie-NAME.1.gz alone.

Everything comes from the program's own --help, of each subcommand in turn, so neither can fall
behind it. A path into the data of the build that is asked, as a default value shows it, becomes the
installed one. Same program, same bytes: the date is that of SOURCE_DATE_EPOCH."""

import argparse
import gzip
import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INSTALLED = "/usr/share/kelpie"
ELSEWHERE = ("evaluate", "farm")  # have their help from other programs
ENTRY = re.compile(r"  (\S.*?)(?:\s{2,}(\S.*))?$")
WORD = re.compile(r"--?[A-Za-z][\w-]*")


class Command:
    """A command as its help describes it: sections by their title, each a list of (name, text)."""

    def __init__(self, program, words, given=None):
        """`given`: the words that the program wants, where it does not want those behind kelpie."""
        self.words, self.about, self.sections, self.end = words, "", {}, ""
        given = words[1:] if given is None else given
        done = subprocess.run([program, *given, "--help"], capture_output=True, text=True,
                              check=True, timeout=60)
        data = (Path(program).parent.parent / "share/kelpie").resolve()
        self.read(done.stdout.replace(str(data), INSTALLED))
        self.subcommands = [Command(program, [*words, name])
                            for name, _ in self.sections.get("Subcommands", ())
                            if name not in ELSEWHERE]

    def read(self, text):
        self.about, rest = re.split(r"(?m)^Usage: .*\n", text, maxsplit=1)
        section = None
        for line in rest.splitlines():
            entry = ENTRY.match(line)
            if re.fullmatch(r"[A-Z][\w ]*:", line):
                section = self.sections.setdefault(line[:-1], [])
            elif line.startswith("      ") and section:
                section[-1][1] = f"{section[-1][1]} {line.strip()}".strip()
            elif entry and section is not None:
                section.append([entry.group(1), entry.group(2) or ""])
            elif line.strip():
                section, self.end = None, f"{self.end}{line}\n"

    def options(self):
        """Every option's spellings; those of flags that a value follows in braces too."""
        return [word for name, _ in self.sections.get("Options", ())
                for word in WORD.findall(name.split(" ")[0])]


def roff(text):
    escaped = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").strip()
    return re.sub(r"(?m)^\.", r"\\&.", escaped)


def entries(command, titles=("Positionals", "Options")):
    for title in titles:
        for name, text in command.sections.get(title, ()):
            yield f".TP\n\\fB{roff(name)}\\fR\n{roff(text) or '.'}\n"


def all_below(command):
    for one in command.subcommands:
        yield one
        yield from all_below(one)


def heading(name, version):
    day = time.strftime("%Y-%m-%d", time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", "0"))))
    return f'.TH {roff(name.upper())} 1 "{day}" "kelpie {version}"\n.SH NAME\n{roff(name)} \\- '


def manual(top, version):
    parts = [f"{heading('kelpie', version)}robot soccer of the "
             f"AIBO ERS\\-7, simulated\n.SH SYNOPSIS\n.B kelpie\n[\\fIOPTIONS\\fR] "
             f"\\fISUBCOMMAND\\fR ...\n.SH DESCRIPTION\n{roff(top.about)}\n.SH OPTIONS\n",
             *entries(top), ".SH SUBCOMMANDS\n"]
    for name, text in top.sections["Subcommands"]:
        parts.append(f".TP\n\\fB{roff(name)}\\fR\n{roff(text)}\n")
    for one in all_below(top):
        parts += [f".SH {roff(' '.join(one.words).upper())}\n{roff(one.about)}\n", *entries(one)]
    parts += [".SH EXIT STATUS\n", roff(top.end.replace("Exit codes: ", "")), "\n.SH FILES\n.TP\n",
              f"{INSTALLED}\nBehaviours, teams, the studio's page.\n",
              ".SH SEE ALSO\n.BR kelpie\\-evaluate (1),\nof the package kelpie\\-dev\n"]
    return "".join(parts)


def manual_of_one(one, version):
    """Of a command that has other lists than options, such as its experiments: each is a part."""
    words = " ".join(one.words)
    parts = [f"{heading('-'.join(one.words), version)}{roff(one.about)}\n.SH SYNOPSIS\n"
             f".B {roff(words)}\n[\\fIOPTIONS\\fR] ...\n.SH OPTIONS\n", *entries(one)]
    for title in sorted(one.sections.keys() - {"Positionals", "Options"}):
        parts += [f".SH {roff(title.upper())}\n", *entries(one, [title])]
    return "".join([*parts, ".SH SEE ALSO\n.BR kelpie (1)\n"])


COMPLETION = """# SPDX-License-Identifier: Apache-2.0
# Completes kelpie's words in bash, written from its own help.
_kelpie() {
  local at words=() current=${COMP_WORDS[COMP_CWORD]} command=kelpie word known
  for ((at = 1; at < COMP_CWORD; at++)); do
    word="$command ${COMP_WORDS[at]}"
    [[ -z ${_kelpie_words[$word]+x} ]] || command=$word
  done
  mapfile -t COMPREPLY < <(compgen -W "${_kelpie_words[$command]}" -- "$current")
}
complete -o default -F _kelpie kelpie
declare -gA _kelpie_words=(
%s)
"""


def completion(top):
    rows = []
    for one in (top, *all_below(top)):
        known = [name for name, _ in one.sections.get("Subcommands", ())] + one.options()
        rows.append(f'  ["{" ".join(one.words)}"]="{" ".join(known)}"\n')
    return COMPLETION % "".join(rows)


def packed(text):
    return gzip.compress(text.encode(), mtime=0)


def main():
    parser = argparse.ArgumentParser(prog="manual.py", description=__doc__)
    parser.add_argument("program", metavar="KELPIE")
    parser.add_argument("out", type=Path, metavar="OUT")
    parser.add_argument("--version", required=True)
    parser.add_argument("--of", metavar="NAME")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    if options.of:
        page = manual_of_one(Command(options.program, ["kelpie", options.of], []), options.version)
        (options.out / f"kelpie-{options.of}.1.gz").write_bytes(packed(page))
        return
    top = Command(options.program, ["kelpie"])
    (options.out / "kelpie.1.gz").write_bytes(packed(manual(top, options.version)))
    (options.out / "kelpie").write_text(completion(top))
    (options.out / "changelog.gz").write_bytes(packed((ROOT / "CHANGELOG.md").read_text()))


if __name__ == "__main__":
    try:
        main()
    except (OSError, subprocess.SubprocessError) as error:
        sys.exit(f"manual.py: {error}")
