#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""sbom.py write OUT --version V --build DIR [--name NAME] PROGRAM...: what the programs are made
of, as OUT/NAME.spdx.json (SPDX 2.3), with OUT/copyright and the licences' texts in OUT/licences/.
NAME is that of the package, kelpie if it is not given.
sbom.py check FILE PROGRAM...: whether that file names every library that ldd finds; exit code 1:
no.

Nothing is listed by hand. Libraries come from ldd, headers that are compiled in from what ninja
recorded of each compilation that a program is made by, and both from Debian's packages, whose
copyright files name the licences; the studio's page, which is in the package kelpie, from its
package-lock.json, without what only builds it. Fails on a file that no package holds. Same inputs,
same bytes: the date is that of SOURCE_DATE_EPOCH."""

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = re.compile(r"^\t(?:\S+ => )?(/\S+) \(0x", re.M)
LICENCE = re.compile(r"(?m)^License:[ \t]*(\S.*)$")
LOCK = ROOT / "tools/studio/page/package-lock.json"
COPYRIGHT = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Kelpie
Comment: What the programs are linked with or compiled from is listed in %s.spdx.json
 beside this file, with the licences' texts in licences/.

Files: *
Copyright: the authors of Kelpie
License: Apache-2.0
 On Debian systems the text is /usr/share/common-licenses/Apache-2.0.
"""


class Trouble(Exception):
    pass


def output_of(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          check=False)
    if done.returncode:
        raise Trouble(f"{' '.join(map(str, words[:3]))}: {done.stderr.strip()[-300:]}")
    return done.stdout


def libraries(programs):
    """Paths of all that the loader loads, as ldd finds them."""
    return sorted({path for program in programs for path in LIBRARY.findall(output_of("ldd",
                                                                                   program))})


def objects(build, names):
    """Objects that ninja makes these targets of."""
    said = output_of("ninja", "-C", build, "-t", "inputs", *names)
    return {line for line in said.splitlines() if line.endswith(".o")}


def files_of(build, wanted):
    """Object -> what its compiler read, the source first, as ninja recorded it."""
    found, files = {}, []
    for line in output_of("ninja", "-C", build, "-t", "deps").splitlines():
        if line.startswith("    "):
            files.append(os.path.normpath(os.path.join(build, line.strip())))
        elif line:
            name, files = line.partition(": #deps")[0], []
            found.update({name: files} if name in wanted else {})
    if wanted - found.keys():
        raise Trouble(f"{build}: ninja does not know what {min(wanted - found.keys())} is made of")
    return found


def headers(build, programs):
    """Headers outside the tree, of what these programs are made of: what is compiled at the same
    time, or was left by an older build, is not in them."""
    names = [os.path.relpath(program, build) for program in programs]
    return sorted({path for files in files_of(build, objects(build, names)).values()
                   for path in files if path.startswith("/usr/")})


def owners(paths):
    """Debian package -> its files among these. The merged /usr gives a file two names."""
    names = {}
    for path in paths:
        real = os.path.realpath(path)
        for name in {path, real, real.removeprefix("/usr"), path.removeprefix("/usr")}:
            names[name] = path
    said = subprocess.run(["dpkg-query", "-S", *names], capture_output=True, text=True,
                          check=False).stdout
    found, left = {}, set(paths)
    for line in said.splitlines():
        package, _, name = line.rpartition(": ")
        if name in names and not line.startswith("diversion by"):
            found.setdefault(package.split(",")[0].split(":")[0], set()).add(names[name])
            left.discard(names[name])
    if left:
        raise Trouble(f"no package holds {', '.join(sorted(left)[:3])}")
    return found


def licences_of(package):
    """As Debian's copyright file names them; none where it is no table."""
    path = Path("/usr/share/doc") / package / "copyright"
    text = path.read_text(errors="replace") if path.is_file() else ""
    return sorted({name.strip() for name in LICENCE.findall(text)})


def identifier(text):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", text)


def entry(name, version, licence, **more):
    return {"SPDXID": identifier(f"{name}-{version}"), "name": name, "versionInfo": version,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": "NOASSERTION", "licenseDeclared": licence,
            "copyrightText": "NOASSERTION", **more}


def debian_entry(package, files, how):
    version, architecture = output_of("dpkg-query", "-W", "-f", "${Version} ${Architecture}\\n",
                                      package).splitlines()[0].split()
    purl = f"pkg:deb/debian/{package}@{version}?arch={architecture}"
    said = ", ".join(licences_of(package)) or "not named in a table"
    return entry(package, version, "NOASSERTION",
                 supplier="Organization: Debian",
                 licenseComments=f"by Debian's copyright file: {said}",
                 sourceInfo=f"{how}: {', '.join(sorted(files))}",
                 externalRefs=[{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                "referenceLocator": purl}])


def page_entries():
    packages = json.loads(LOCK.read_text())["packages"]
    for path, its in sorted(packages.items()):
        if path and not its.get("dev") and not its.get("devOptional"):
            name = path.rpartition("node_modules/")[2]
            yield entry(name, its["version"], its.get("license", "NOASSERTION"),
                        sourceInfo="bundled into the studio's page")


def document(own, groups, tool="sbom.py"):
    """Of the package `own`; groups are (kind of relationship, the entries of that kind)."""
    name, version = own["name"], own["versionInfo"]
    packages = [own, *(one for _, entries in groups for one in entries)]
    text = json.dumps(packages, sort_keys=True)
    stamp = time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", "0")))
    related = [{"spdxElementId": own["SPDXID"], "relationshipType": kind,
                "relatedSpdxElement": one["SPDXID"]} for kind, entries in groups for one in entries]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
            "name": f"{name}-{version}",
            "documentNamespace": f"https://example.org/{name}/{version}/"
                                 f"{hashlib.sha256(text.encode()).hexdigest()[:16]}",
            "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", stamp),
                             "creators": [f"Tool: tools/release/{tool}"]},
            "documentDescribes": [own["SPDXID"]],
            "packages": packages, "relationships": related}


def compiled_entries(owned):
    return [debian_entry(package, [f"{len(files)} headers"], "compiled in")
            for package, files in sorted(owned.items())]


def copy_licences(packages, to):
    """The copyright files of these Debian packages, into a folder that is made anew."""
    shutil.rmtree(to, ignore_errors=True)
    to.mkdir(parents=True)
    for package in sorted(packages):
        source = Path("/usr/share/doc") / package / "copyright"
        if not source.is_file():
            raise Trouble(f"{source}: no licence of what is linked")
        shutil.copyfile(source, to / package)


def save(made, path):
    path.write_text(json.dumps(made, indent=1, sort_keys=True) + "\n")


def write(out, own, build, programs):
    linked, compiled = owners(libraries(programs)), owners(headers(build, programs))
    groups = [
        ("DYNAMIC_LINK", [debian_entry(package, map(os.path.basename, files), "linked")
                          for package, files in sorted(linked.items())]),
        ("STATIC_LINK", compiled_entries(compiled)),
        ("CONTAINS", list(page_entries()) if own["name"] == "kelpie" else [])]
    copy_licences({*linked, *compiled}, out / "licences")
    (out / "copyright").write_text(COPYRIGHT % own["name"])
    save(document(own, groups), out / f"{own['name']}.spdx.json")


def missing(text, programs):
    """Libraries that ldd finds and the document does not name."""
    named = {name for package in json.loads(text)["packages"]
             if package.get("sourceInfo", "").startswith("linked: ")
             for name in package["sourceInfo"].removeprefix("linked: ").split(", ")}
    return sorted({os.path.basename(path) for path in libraries(programs)} - named)


def main():
    parser = argparse.ArgumentParser(prog="sbom.py", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    writes, checks = commands.add_parser("write"), commands.add_parser("check")
    writes.add_argument("out", type=Path, metavar="OUT")
    writes.add_argument("--version", required=True)
    writes.add_argument("--build", type=Path, required=True)
    writes.add_argument("--name", default="kelpie")
    checks.add_argument("file", type=Path, metavar="FILE")
    for command in (writes, checks):
        command.add_argument("programs", nargs="+", metavar="PROGRAM")
    options = parser.parse_args()
    if options.command == "write":
        own = entry(options.name, options.version, "Apache-2.0")
        write(options.out, own, options.build, options.programs)
        return 0
    left = missing(options.file.read_text(), options.programs)
    print("\n".join(f"{options.file}: does not name {name}" for name in left), end="\n" * any(left))
    return 1 if left else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Trouble, OSError) as error:
        sys.exit(f"sbom.py: {error}")
