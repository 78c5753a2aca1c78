# SPDX-License-Identifier: Apache-2.0
"""The target program against the PC's: the same bits, the same costs each time, clear lines when
something is wrong. Run by ctest, which builds the target and names the PC's programs."""

import json
import os
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TOOLCHAIN = ROOT / "toolchain"
BIN = ROOT / "build/mipsel/bin"
KELPIE = os.environ.get("KELPIE", str(ROOT / "build/host/bin/kelpie"))
STICK_HASH = os.environ.get("STICK_HASH", str(ROOT / "build/host/bin/stick-hash"))
MATHS_HASH = os.environ.get("MATHS_HASH", str(ROOT / "build/host/bin/maths-hash"))


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          timeout=120, **options)


def emulated(name, *arguments):
    return run("qemu-mipsel", BIN / name, *arguments)


@pytest.fixture(scope="session")
def log(tmp_path_factory):
    made = run(TOOLCHAIN / "record", tmp_path_factory.mktemp("recording"), KELPIE)
    assert made.returncode == 0, made.stderr
    return Path(made.stdout.strip())


@pytest.fixture(scope="session")
def cost(log, tmp_path_factory):
    out = tmp_path_factory.mktemp("cost") / "cost.json"
    made = run(TOOLCHAIN / "target-cost", log, "--json", out)
    assert made.returncode == 0, made.stderr
    return out


@pytest.fixture(scope="session")
def behaviours(tmp_path_factory):
    out = tmp_path_factory.mktemp("zip") / "pycode.zip"
    assert run(TOOLCHAIN / "make-pyzip", out).returncode == 0
    return out


def test_maths_has_the_same_bits_on_both():
    here, there = run(MATHS_HASH), emulated("maths-hash")
    assert len(here.stdout.strip()) == 16
    assert here.stdout == there.stdout


def test_the_target_reads_a_stick_as_the_pc_does(tmp_path):
    stick = tmp_path / "stick"
    made = run(KELPIE, "stick", "--robot", "3", "--team", "blue", "--out", stick)
    assert made.returncode == 0, made.stderr
    here, there = run(STICK_HASH, stick), emulated("stick-hash", stick)
    assert here.returncode == 0 and "STICK.BIN: is good" in here.stdout
    assert here.stdout == there.stdout
    binary = stick / "OPEN-R/MW/DATA/P/STICK.BIN"
    content = bytearray(binary.read_bytes())
    content[len(content) // 2] ^= 1
    binary.write_bytes(content)
    there = emulated("stick-hash", stick)
    assert there.returncode == 1 and "the CRC-32 of a part is wrong (fault 7)" in there.stdout


def test_replay_on_the_target_gives_the_recorded_bits(log, behaviours):
    result = emulated("kelpie-target", log, "--pycode", behaviours)
    assert result.stderr == "" and result.returncode == 0
    assert "replayed 180 frames, 0 differ" in result.stdout


def test_other_behaviours_are_noticed(log, tmp_path):
    pycode = tmp_path / "pycode"
    pycode.mkdir()
    (pycode / "main.py").write_text(
        "import kelpie\ndef decide(world):\n    return kelpie.Command(mouth_open=True)\n")
    run(TOOLCHAIN / "make-pyzip", tmp_path / "other.zip", "--pycode", pycode)
    result = emulated("kelpie-target", log, "--pycode", tmp_path / "other.zip", "--limit", 30)
    assert result.returncode == 1
    assert "replayed 30 frames, 30 differ" in result.stdout
    assert "frame 0: command." in result.stderr


def test_log_that_is_cut_off_ends_with_2_and_a_line(log, behaviours, tmp_path):
    cut = tmp_path / "cut.mcap"
    with open(log, "rb") as whole:
        cut.write_bytes(whole.read(log.stat().st_size // 2))
    result = emulated("kelpie-target", cut, "--pycode", behaviours)
    assert result.returncode == 2
    assert f"kelpie-target: {cut}: cut off at byte" in result.stderr


@pytest.mark.parametrize("arguments, line", [
    (["none.mcap", "--pycode", "pycode"], "none.mcap"),
    (["none.mcap", "--pycode", "nowhere"], "nowhere: No such file"),
    (["none.mcap", "--pycode", "pycode", "--limit", "0"], "--limit needs a number"),
    (["none.mcap"], "usage: kelpie-target LOG"),
])
def test_bad_arguments_end_with_2_and_one_line(arguments, line):
    result = run("qemu-mipsel", BIN / "kelpie-target", *arguments, cwd=ROOT)
    assert result.returncode == 2
    assert line in result.stderr and result.stderr.count("\n") == 1


def test_cost_repeats_to_the_last_digit(log, cost, tmp_path):
    there = tmp_path / "a place with a longer name"
    there.mkdir()
    shutil.copy(log, there)
    again = there / "again.json"
    result = run(TOOLCHAIN / "target-cost", there / log.name, "--json", again, cwd="/",
                 env={**os.environ, "LONG": "x" * 5000, "TZ": "Asia/Tokyo"})
    assert result.returncode == 0
    assert cost.read_text() == again.read_text()
    figures = json.loads(cost.read_text())
    assert figures["frames"] == 180 and figures["replay"] == {"frames": 180, "differing": 0}
    assert all(stage["cycles_mean"] > 1000 for stage in figures["stages"].values())


def budget(*arguments):
    return run(TOOLCHAIN / "budget", *arguments)


def test_every_stage_is_within_its_budget(cost):
    result = budget("--table", "short", "--cost", cost)
    assert result.returncode == 0, result.stderr
    assert "none over its budget" in result.stdout


def figures_of(table):
    return tomllib.loads((TOOLCHAIN / "budget.toml").read_text())[table]


def test_every_stage_the_frame_memory_image_and_start_have_a_budget():
    names = {f"stages.{name}.cycles_mean"
             for name in ("body", "vision", "gps", "behaviour", "actuator")}
    names |= {"image.program_bytes", "image.scripts_bytes"}
    assert names <= figures_of("match").keys() and names <= figures_of("short").keys()
    assert figures_of("required") == {
        "frame.cycles_mean": 5e6, "frame.cycles_p99": 9e6, "memory.all_bytes": 24e6,
        "first_command.seconds": 3, "replay.differing": 0}


def test_renewed_budgets_hold_for_the_figures_that_they_were_made_of(cost, tmp_path):
    budgets = tmp_path / "budget.toml"
    budgets.write_text(budget("--renew", "--table", "short", "--cost", cost).stdout)
    table = tomllib.loads(budgets.read_text())["short"]
    assert len(table) == 17 and "stages.gps.instructions_mean" in table
    result = budget("--table", "short", "--cost", cost, "--budgets", budgets)
    assert result.returncode == 0 and "17 figures over 180 frames" in result.stdout


@pytest.mark.parametrize("name", sorted(figures_of("short")))
def test_a_figure_over_its_budget_by_more_than_a_tenth_is_refused_by_name(cost, tmp_path, name):
    figure = json.loads(cost.read_text())
    for key in name.split("."):
        figure = figure[key]
    for over, verdict in ((1.09, 0), (1.12, 1)):
        budgets = tmp_path / "budget.toml"
        budgets.write_text(f'[short]\n"{name}" = {figure / over}\n')
        result = budget("--table", "short", "--cost", cost, "--budgets", budgets)
        assert result.returncode == verdict
    assert result.stderr.count("\n") == 1 and f"budget: {name} is " in result.stderr
    assert "12.0 % over its budget" in result.stderr


def test_what_is_required_has_no_margin(cost, tmp_path):
    mean = json.loads(cost.read_text())["frame"]["cycles_mean"]
    budgets = tmp_path / "budget.toml"
    budgets.write_text(f'[short]\n"frame.cycles_mean" = {mean}\n'
                       f'[required]\n"frame.cycles_mean" = {mean - 1}\n')
    result = budget("--table", "short", "--cost", cost, "--budgets", budgets)
    assert result.returncode == 1 and "as required" in result.stderr


@pytest.mark.parametrize("text, line", [
    ('[short]\n"stages.eyes.cycles_mean" = 5\n', "stages.eyes.cycles_mean is no figure"),
    ('[match]\n"frame.cycles_mean" = 5\n', "no budgets [short]"),
    ("[short]\n= 5\n", "Invalid"),
    ('[short]\n"frame.cycles_mean" = "few"\n', "[short] holds what is not a number"),
    ("short = 5\n", "[short] holds what is not a number"),
    ("\xff\n", "budget.toml"),
])
def test_a_wrong_file_of_budgets_ends_with_2_and_one_line(cost, tmp_path, text, line):
    budgets = tmp_path / "budget.toml"
    budgets.write_text(text, encoding="latin-1")
    result = budget("--table", "short", "--cost", cost, "--budgets", budgets)
    assert result.returncode == 2
    assert line in result.stderr and result.stderr.count("\n") == 1


def test_figures_that_lack_what_the_page_tells_end_with_2_and_one_line(cost, tmp_path):
    figures = json.loads(cost.read_text())
    del figures["first_command"]["seconds"]
    (tmp_path / "cost.json").write_text(json.dumps(figures))
    result = budget("--table", "short", "--cost", tmp_path / "cost.json", "--doc",
                    tmp_path / "page.md")
    assert result.returncode == 2 and result.stderr.count("\n") == 1
    assert not (tmp_path / "page.md").exists()


def test_a_log_that_is_not_there_ends_with_2_and_one_line():
    result = budget("none.mcap")
    assert result.returncode == 2
    assert result.stderr == "target-cost: none.mcap: no such file\n"


def test_the_page_of_costs_has_the_figures(cost, tmp_path):
    page = tmp_path / "budget.md"
    budget("--table", "short", "--cost", cost, "--doc", page)
    text, figures = page.read_text(), json.loads(cost.read_text())
    for row in (*figures["stages"].values(), figures["frame"]):
        cells = [f"{row[key]:,.0f}" for key in ("cycles_mean", "cycles_p99", "cycles_max")]
        assert f"| {' | '.join(cells)} |" in text
    assert "replayed 180, **0 differ**" in text
    assert f"{figures['memory']['all_bytes'] / 1024:,.0f} KB" in text


def test_memory_that_a_program_touches_is_counted_in_pages(tmp_path):
    counted = {}
    for pages in (0, 300):
        source = tmp_path / "touch.c"
        source.write_text(f"""#include <stdlib.h>
int main(void) {{
  volatile char* room = malloc(1000 * 4096);
  for (int i = 0; i < {pages}; ++i) room[i * 4096] = 1;
}}
""")
        run("mipsel-linux-gnu-gcc", "-static", "-O1", "-o", tmp_path / "touch", source)
        run("qemu-mipsel", "-plugin", f"{ROOT}/build/mipsel/libicount.so,out={tmp_path}/counts",
            tmp_path / "touch")
        last = (tmp_path / "counts").read_text().splitlines()[-1].split()
        assert last[0] == "pages"
        counted[pages] = len(last) - 1
    assert 299 <= counted[300] - counted[0] <= 301


def test_counter_counts_a_known_loop(tmp_path):
    source = tmp_path / "loop.c"
    source.write_text("""#include <sys/syscall.h>
#include <unistd.h>
int main(void) {
  syscall(SYS_getpriority, 0x41694230, 1);
  __asm__ volatile(".set noreorder\\n li $8, 100000\\n 1: addiu $8, $8, -1\\n"
                   " bnez $8, 1b\\n sw $0, 0($29)\\n .set reorder" ::: "$8", "memory");
  syscall(SYS_getpriority, 0x41694230, 2);
}
""")
    run("mipsel-linux-gnu-gcc", "-static", "-O1", "-o", tmp_path / "loop", source)
    run("qemu-mipsel", "-plugin", f"{ROOT}/build/mipsel/libicount.so,out={tmp_path}/counts",
        tmp_path / "loop")
    lines = (tmp_path / "counts").read_text().splitlines()
    row = dict(zip(lines[0].split(), map(int, lines[2].split())))
    assert (row["from"], row["to"]) == (1, 2)
    assert 300000 < row["instructions"] < 300200
    assert 100000 <= row["stores"] < 100050 and row["loads"] < 50
    assert row["l1d"] < 20


def test_own_code_has_only_instructions_of_mips_ii():
    result = run(TOOLCHAIN / "check-isa", BIN / "kelpie-target")
    assert result.returncode == 0, result.stderr
    assert "0 faults of ours" in result.stdout


def test_instruction_of_another_processor_is_found(tmp_path):
    (tmp_path / "CMakeCache.txt").write_text("")
    source = tmp_path / "own.c"
    source.write_text("int main(int argc, char** argv) { return __builtin_clz(argc); }\n")
    run("mipsel-linux-gnu-gcc", "-O2", "-march=mips32r2", "-c", "-o", tmp_path / "own.o", source)
    run("mipsel-linux-gnu-gcc", "-static", "-o", tmp_path / "own", tmp_path / "own.o")
    result = run(TOOLCHAIN / "check-isa", tmp_path / "own")
    assert result.returncode == 1
    assert "own.o: compiled for MIPS32r2" in result.stderr
    assert "main has 1 instructions beyond MIPS II" in result.stderr


def test_zip_of_behaviours_has_the_same_bytes_each_time(tmp_path, behaviours):
    again = tmp_path / "again.zip"
    run(TOOLCHAIN / "make-pyzip", again, env={"PYTHONHASHSEED": "7", "PATH": os.environ["PATH"]})
    assert again.read_bytes() == behaviours.read_bytes()


def test_behaviour_with_a_syntax_error_is_named_with_its_line(tmp_path):
    (tmp_path / "main.py").write_text("x = 1\ndef\n")
    result = run(TOOLCHAIN / "make-pyzip", tmp_path / "out.zip", "--pycode", tmp_path)
    assert result.returncode == 1
    assert "make-pyzip: main.py:2:" in result.stderr
    assert not (tmp_path / "out.zip").exists()


@pytest.mark.parametrize("program, package", [
    ("mipsel-linux-gnu-g++", "g++-mipsel-linux-gnu"), ("qemu-mipsel", "qemu-user")])
def test_what_is_not_installed_is_named(tmp_path, program, package):
    for tool in ("bash", "dirname", "cmake", "ninja", "gcc", "mipsel-linux-gnu-g++", "qemu-mipsel"):
        if tool != program:
            (tmp_path / tool).symlink_to(shutil.which(tool))
    result = run("/bin/bash", TOOLCHAIN / "build-target", env={"PATH": str(tmp_path)})
    assert result.returncode == 2
    assert f"needs {program}; install the Debian package {package}" in result.stderr
