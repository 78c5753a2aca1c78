# SPDX-License-Identifier: Apache-2.0
"""README.md's commands run as they stand there, leave nothing that git sees, and its figures hold.

Only what a reader must put in himself is replaced: DIR by a folder of images, LOG by the log of a
robot that stood and looked round, the length of a match by a second, and the robots of a team by
one. The match that the commands read is a short one."""

import os
import re
import shlex
import shutil
import signal
import subprocess
import time

import pytest
from conftest import BIN, PLANE, ROOT, kelpie, make_recording
from test_cli import wait_for_log

README = (ROOT / "README.md").read_text()
PAPERS = ((82, 121, 167), (189, 124, 129), (120, 160, 61))


def listed_commands():
    """The lines of the block under "## kelpie", without what they are for."""
    block = README.split("\n## kelpie\n", 1)[1].split("```")[1]
    lines = [line for line in block.splitlines() if line.startswith("kelpie ")]
    return [re.split(r"\s{2,}", line)[0] for line in lines]


def commands_in_the_text():
    prose = re.sub(r"```.*?```", "", README, flags=re.S)
    return [" ".join(command.split()) for command in re.findall(r"`(kelpie [^`]+)`", prose)]


COMMANDS = listed_commands() + commands_in_the_text()


def words_of(command):
    words = shlex.split(command, comments=True)
    folder = "sheets" if words[1] == "calibrate" else "recording"
    put_in = {"DIR": folder, "LOG": "out/stand/match.mcap",
              "CARPET.mcap": "out/carpet/match.mcap", "4v4": "1v1"}
    words = [put_in.get(word, word) for word in words]
    if "--seconds" in words:
        words[words.index("--seconds") + 1] = "1"
    elif "--minutes" in words:
        words[words.index("--minutes") + 1] = "0.1"
        words.append("--no-film")  # of a minute, with the walks to the kick-offs
    elif words[1] == "league":
        words += ["--minutes", "0.1", "--matches", "2", "--robots", "1v1"]
    elif words[1] == "teleop":  # nobody is there to drive
        words += ["--keys", "keys.txt"]
    elif "--game-controller" in words:  # the commands after it ask for 2 s
        words += ["--seconds", "4"]
    elif words[1] == "play":
        words += ["--seconds", "1"]
    return stopped(words) if "studio" in words or "--studio" in words else words


def stopped(words):
    """What serves until Ctrl-C, with that after some seconds, and where no other test serves."""
    return ["timeout", "--signal=INT", "--preserve-status", "15", *words, "--port", "0"]


def sheet(colour):
    """Planes of a coloured sheet, a little darker below."""
    rows = [bytes([value - y // 16]) * 208 for value in colour for y in range(160)]
    return b"".join(rows)


@pytest.fixture(scope="module", name="place")
def place_of_a_reader(match, tmp_path_factory):
    """A folder like the root of the source tree after tools/run; all of the commands run in it."""
    place = tmp_path_factory.mktemp("readme")
    (place / "out").mkdir()
    for folder in ("pycode", "teams", "examples"):
        (place / folder).symlink_to(ROOT / folder)
    shutil.copy(match, place / "out/match.mcap")
    (place / "keys.txt").write_text("0.2 w\n1 x\n")
    make_recording(place / "recording", [bytes([90]) * PLANE + bytes([128]) * (2 * PLANE)] * 3)
    (place / "sheets").mkdir()
    for i, paper in enumerate(PAPERS):
        (place / "sheets" / f"{i}.yuv").write_bytes(sheet(paper))
    for script, out in (("looking", "stand"), ("carpet", "carpet")):
        kelpie("play", "--fast", "--pycode", ROOT / "tools/calibrate" / script, "--seconds", "14",
               "--seed", "3", "--images", "all", "--no-film", "--out", place / "out" / out)
    return place


@pytest.fixture(scope="module", name="results")
def results_of_all(place):
    env = dict(os.environ, PATH=f"{BIN}:{os.environ['PATH']}")
    return {command: subprocess.run(words_of(command), cwd=place, env=env, capture_output=True,
                                    text=True, timeout=240, check=False) for command in COMMANDS}


def in_git():
    return (ROOT / ".git").exists() and shutil.which("git") is not None


def test_the_readme_has_commands_to_try():
    assert len(listed_commands()) >= 8
    assert {words_of(c)[1] for c in COMMANDS} >= {"play", "replay", "film", "import", "calibrate"}


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_readme_runs(results, command):
    result = results[command]
    assert result.returncode == 0, result.stderr
    assert "behaviour:" not in result.stderr


def test_what_the_commands_write_is_there_and_git_does_not_see_it(place, results):
    wanted = {word for command in results for word in words_of(command)
              if re.search(r"\.(mcap|png|mp4|tab|kt|jsonl?)$", word)}
    assert len(wanted) >= 5 and all((place / name).is_file() for name in wanted)
    if not in_git():
        pytest.skip("no repository: nothing to be ignored")
    fixtures = {"recording", "sheets", "pycode", "teams", "examples", "keys.txt"}
    left = [name for name in os.listdir(place) if name not in fixtures]
    assert "out" in left
    for name in left:
        path = name + "/x" if (place / name).is_dir() else name
        ignored = subprocess.run(["git", "check-ignore", "-q", path], cwd=ROOT, check=False)
        assert ignored.returncode == 0, f"{name} is not in .gitignore"


def test_no_file_of_the_tree_is_ignored_nor_would_test_data_be():
    if not in_git():
        pytest.skip("no repository: nothing to be ignored")
    tracked = subprocess.run(["git", "ls-files", "-ci", "--exclude-standard"], cwd=ROOT,
                             capture_output=True, text=True, check=True).stdout
    assert tracked == ""
    for path in ("tests/core/sample/new.mcap", "tests/tools/data/a.png", "vision/ring.tab"):
        assert subprocess.run(["git", "check-ignore", "-q", path], cwd=ROOT,
                              check=False).returncode == 1, path


@pytest.mark.parametrize("script", re.findall(r"(?m)(?:^|`)(t(?:ools|oolchain)/[a-z-]+)", README))
def test_a_script_of_the_readme_is_there(script):
    assert os.access(ROOT / script, os.X_OK)


def test_a_compressed_log_is_about_as_small_as_it_says(match, tmp_path):
    stated = re.search(r"kelpie compress .*?(\d+) KB instead of 97.5", README)
    said = kelpie("compress", match, "--out", tmp_path / "s.mcap").stdout
    measured = float(re.search(r"([\d.]+) KB a frame", said).group(1))
    assert 0.5 < measured / float(stated.group(1)) < 2.0
    assert "an image has 97.5" in said


def test_images_come_thirty_times_a_second_and_joints_every_8_ms(match):
    assert "thirty times a\nsecond" in README and "camera, 30 Hz" in README
    assert "motion, 8 ms" in README
    rows = [line.split() for line in kelpie("info", match).stdout.splitlines()]
    count = {row[0]: int(row[2]) for row in rows if row[0].startswith("/")}
    assert abs(count["/frame/input"] / 3.0 - 30) < 1
    assert abs(count["/motion/input"] * 4 * 0.008 / 3.0 - 1) < 0.03


def test_the_figures_of_the_robot_are_those_of_the_sources():
    joints = re.search(r"kJointCount = (\d+);", (ROOT / "robot/core/types/Joints.h").read_text())
    assert joints.group(1) == "18" and "eighteen joint angles" in README
    budget = re.search(r"BUDGET = ([\d.e]+) / 30",
                       (ROOT / "toolchain/target-cost").read_text()).group(1)
    assert f"{float(budget) / 30 / 1e6:.1f} million cycles a frame" in README


def wait_for(path, text, times=1):
    for _ in range(600):
        if path.read_text().count(text) >= times:
            return
        time.sleep(0.05)
    raise AssertionError(f"no {text!r} in {path.read_text()!r}")


def save(path, text):
    """In one go, as editors do."""
    part = path.with_suffix(".part")
    part.write_text(text)
    part.replace(path)


def test_a_file_edited_while_a_match_runs_plays_and_a_mistake_is_reported_once(tmp_path):
    pycode = tmp_path / "pycode"
    shutil.copytree(ROOT / "pycode", pycode, ignore=shutil.ignore_patterns("__pycache__"))
    main = pycode / "main.py"
    good = main.read_text()
    reported = tmp_path / "told"
    with reported.open("w") as stream:
        play = subprocess.Popen([BIN / "kelpie", "play", "--seconds", "600", "--goals", "99",
                                 "--no-film", "--pycode", pycode, "--out", tmp_path / "out"],
                                stderr=stream, stdout=subprocess.DEVNULL, cwd=ROOT)
    try:
        wait_for_log(tmp_path / "out", play.pid)
        save(main, good + "\nboom(\n")
        wait_for(reported, "the version before plays on")
        save(main, good + "\n")
        wait_for(reported, "main.py: loaded again")
        main.unlink()
        wait_for(reported, "main.py: gone; the version before plays on")
        save(main, good)
        wait_for(reported, "main.py: loaded again", 2)
    finally:
        play.send_signal(signal.SIGINT)
        play.wait(60)
    lines = [line for line in reported.read_text().splitlines() if line.startswith("behaviour: ")]
    assert len(lines) == 4
    assert f"{main}:{good.count(chr(10)) + 2}: SyntaxError" in lines[0]
