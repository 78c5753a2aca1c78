# SPDX-License-Identifier: Apache-2.0
"""`kelpie stick` and `kelpie emon` as a user runs them: good sticks, and what they refuse."""

import gzip
import os
import random
import shutil
import signal
import stat
import struct
import subprocess
import time
import zipfile
import zlib

import pytest
from conftest import BIN, ROOT, complaint, kelpie


def linked(content, kind=2, address=0):
    """A MIPS ELF file of one segment, as mkbin makes it: executable, for the address 0."""
    header = b"\x7fELF\x01\x01\x01" + bytes(9) + struct.pack(
        "<HHIIIIIHHHHHH", kind, 8, 1, address, 52, 0, 0x1007, 52, 32, 1, 40, 0, 0)
    size = 84 + len(content)
    return header + struct.pack("<8I", 1, 0, address, address, size, size, 7, 4096) + content


MARK = b"\nkelpie player: python\0"
OBJECT = gzip.compress(linked(bytes(range(256)) * 40 + MARK), mtime=0)  # as a robot takes it
SECRET = "0xC0FFEE1234"
WLAN = f"ESSID=fourlegged\nWEPENABLE=1\nWEPKEY={SECRET}\nETHER_IP=10.0.1.3\n"


def files_in(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


def stick(*words):
    return kelpie("stick", "--robot", "2", *words)


@pytest.fixture(name="parts")
def parts_of_a_stick(tmp_path):
    (tmp_path / "AGENT.BIN").write_bytes(OBJECT)
    (tmp_path / "field.wlan").write_text(WLAN)
    mount = tmp_path / "mount"
    for name in ("APERIOS.GZ", "APERINIT.GZ", "BOOTPARA", "SYSTEM/OBJS/A.BIN",
                 "SYSTEM/CONF/CARDDRV.CFG"):
        (mount / "OPEN-R" / name).parent.mkdir(parents=True, exist_ok=True)
        (mount / "OPEN-R" / name).write_text("Sony's")
    return tmp_path


def all_options(parts):
    return ["--object", parts / "AGENT.BIN", "--wlan", parts / "field.wlan"]


def said_of(parts, text, pack=bytes):
    program = linked(bytes(3000) + b"\n%s\0" % text + bytes(99))
    (parts / "AGENT.BIN").write_bytes(pack(program))
    result = stick("--object", parts / "AGENT.BIN", "--out", parts / "out")
    assert result.returncode == 0, result.stderr
    return result.stdout.splitlines()


@pytest.mark.parametrize("text, line", [
    (b"kelpie player: simple",
     "player: simple, without Python: it walks to the ball, and no more"),
    (b"kelpie player: python", f"player: python; it plays the behaviours of {ROOT / 'pycode'}")])
@pytest.mark.parametrize("pack", [bytes, gzip.compress])
def test_it_says_which_player_the_program_has(parts, text, line, pack):
    assert line in said_of(parts, text, pack)


@pytest.mark.parametrize("text", [b"", b"kelpie player: pythons", b"a monitor of objects"])
@pytest.mark.parametrize("pack", [bytes, gzip.compress])
def test_a_program_that_is_no_agent_of_ours_is_refused_by_name(parts, text, pack):
    (parts / "OMONET.BIN").write_bytes(pack(linked(bytes(3000) + b"\n%s\0" % text)))
    before = files_in(parts / "mount")
    result = stick("--object", parts / "OMONET.BIN", "--install", parts / "mount")
    assert result.returncode == 2
    assert "OMONET.BIN: is no agent of Kelpie" in complaint(result)
    assert files_in(parts / "mount") == before


@pytest.mark.parametrize("program, line", [
    (linked(b"x" * 99, kind=1), "is not linked"),
    (linked(b"x" * 99, address=0x400000), "another system"),
    (linked(b"x" * 99)[:60], "is not linked"),
    (b"\x7fELF\x01\x01", "neither a MIPS program nor gzip of one"),
    (b"\x1f\x8b", "gzip cannot unpack it"),
    (gzip.compress(linked(b"x" * 99), mtime=0)[:-20], "gzip cannot unpack it"),
    (gzip.compress(b"hello", mtime=0), "neither a MIPS program nor gzip of one")])
def test_what_is_no_program_never_takes_the_place_of_one(parts, program, line):
    assert stick(*all_options(parts), "--install", parts / "mount").returncode == 0
    before = files_in(parts / "mount")
    (parts / "AGENT.BIN").write_bytes(program)
    result = stick(*all_options(parts), "--install", parts / "mount")
    assert result.returncode == 2 and line in complaint(result)
    assert files_in(parts / "mount") == before


def packed_zeros(megabytes):
    packer = zlib.compressobj(9, zlib.DEFLATED, 31)
    blocks = [packer.compress(bytes(1 << 20)) for _ in range(megabytes)]
    return b"".join(blocks) + packer.flush()


def test_of_a_program_no_more_is_unpacked_than_a_robot_could_take(parts):
    (parts / "tmp").mkdir()
    environment = os.environ | {"TMPDIR": str(parts / "tmp")}
    words = ["stick", "--robot", "2", *all_options(parts), "--out", parts / "out"]
    with open(parts / "AGENT.BIN", "wb") as file:
        file.write(packed_zeros(128))
    result = kelpie(*words, env=environment)
    assert result.returncode == 2 and "gzip cannot unpack it into" in complaint(result)
    os.truncate(parts / "AGENT.BIN", 100 << 20)
    assert "larger than a robot's memory" in complaint(kelpie(*words, env=environment))
    assert not list((parts / "tmp").iterdir())


def test_what_holds_the_radios_key_is_its_owners_alone(parts):
    assert stick(*all_options(parts), "--out", parts / "out").returncode == 0
    path = parts / "out/OPEN-R/SYSTEM/CONF/WLANCONF.TXT"
    assert stat.S_IMODE(path.stat().st_mode) & 0o077 == 0


@pytest.mark.skipif(shutil.which("mformat") is None, reason="mtools is not installed")
def test_a_stop_leaves_no_radios_key_behind(parts):
    (parts / "bin").mkdir()
    (parts / "bin/mcopy").write_text("#!/bin/sh\ntouch began\nsleep 1\n")
    (parts / "bin/mcopy").chmod(0o755)
    (parts / "tmp").mkdir()
    words = ["stick", "--robot", "2", *all_options(parts), "--out", parts / "s.img"]
    process = subprocess.Popen(
        [BIN / "kelpie", *map(str, words)], cwd=parts, stderr=subprocess.PIPE, text=True,
        start_new_session=True, env=os.environ | {"TMPDIR": str(parts / "tmp"),
                                                  "PATH": f"{parts}/bin:{os.environ['PATH']}"})
    while not (parts / "began").exists():
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)
    assert process.wait(20) == 2 and process.stderr.read().count("\n") == 1
    assert not list((parts / "tmp").iterdir()) and not list(parts.glob("s.img*"))


def test_a_folder_in_a_files_place_is_reported_before_anything_is_written(parts):
    (parts / "mount/OPEN-R/MW/DATA/P/STICK.BIN").mkdir(parents=True)
    before = files_in(parts / "mount")
    result = stick(*all_options(parts), "--install", parts / "mount")
    assert result.returncode == 2 and "STICK.BIN: is a folder" in complaint(result)
    assert files_in(parts / "mount") == before


def test_a_stick_written_twice_is_identical_in_8_3_and_small(tmp_path):
    for name in ("a", "b"):
        result = stick("--team", "blue", "--out", tmp_path / name)
        assert result.returncode == 0, result.stderr
        assert "lacks OPEN-R/MW/OBJS/AGENT.BIN" in result.stdout
    first = files_in(tmp_path / "a")
    assert first == files_in(tmp_path / "b")
    assert sum(map(len, first.values())) < 8e6
    assert sorted(first) == ["OPEN-R/MW/CONF/CONNECT.CFG", "OPEN-R/MW/CONF/DESIGNDB.CFG",
                             "OPEN-R/MW/CONF/OBJECT.CFG", "OPEN-R/MW/DATA/P/PYCODE.ZIP",
                             "OPEN-R/MW/DATA/P/STICK.BIN", "OPEN-R/SYSTEM/CONF/VRCOMM.CFG"]


@pytest.mark.skipif(shutil.which("mformat") is None, reason="mtools is not installed")
def test_images_of_the_same_behaviours_of_another_folder_and_day_are_identical(tmp_path):
    shutil.copytree(ROOT / "pycode", tmp_path / "one")
    for path in sorted((tmp_path / "one").rglob("*.py"), reverse=True):  # in another order, too
        copy = tmp_path / "another" / path.relative_to(tmp_path / "one")
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(path.read_bytes())
        os.utime(copy, (1_300_000_000, 1_300_000_000))
    for name in ("one", "another"):
        result = stick("--pycode", tmp_path / name, "--out", tmp_path / f"{name}.img")
        assert result.returncode == 0, result.stderr
        time.sleep(2.1)  # FAT keeps times in steps of two seconds
    assert (tmp_path / "one.img").read_bytes() == (tmp_path / "another.img").read_bytes()


def test_the_robots_jam_detection_is_relaxed_unless_it_is_kept(parts):
    path = parts / "mount/OPEN-R/SYSTEM/CONF/VRCOMM.CFG"
    words = [*all_options(parts), "--install", parts / "mount"]
    assert stick(*words, "--keep-jam-detection").returncode == 0
    assert not path.exists()
    assert stick(*words).returncode == 0
    assert path.read_text() == "JamDetectionHighThreshold\n"
    path.write_text("another word\n")
    assert stick(*words, "--keep-jam-detection").returncode == 0
    assert path.read_text() == "another word\n"


def test_what_a_robot_reads_before_it_plays_is_counted(parts):
    (parts / "AGENT.BIN").write_bytes(linked(bytes(200_000) + MARK))
    for options, twice in ((all_options(parts), True),
                           (["--object", parts / "AGENT.BIN"], False)):
        if not twice:
            (parts / "AGENT.BIN").write_bytes(
                linked(bytes(200_000) + MARK.replace(b"python", b"simple")))
        result = stick(*options, "--out", parts / f"out{twice}")
        assert result.returncode == 0, result.stderr
        sizes = {name: len(data) for name, data in files_in(parts / f"out{twice}").items()}
        read = [*sizes.values()] + [sizes["OPEN-R/MW/DATA/P/PYCODE.ZIP"]] * twice
        reads = sum(size // 65536 + 1 for size in read)
        assert f"boot: {sum(read)} bytes in {reads} reads of at most 64 KB" in result.stdout


def test_options_change_the_stick(tmp_path):
    for name, words in (("red", ["--team", "red"]), ("blue", ["--team", "blue"]),
                        ("old", ["--field", "2004"]), ("set", ["--set", "gps.ball.gate=4"])):
        assert stick(*words, "--out", tmp_path / name).returncode == 0
    binaries = {(tmp_path / name / "OPEN-R/MW/DATA/P/STICK.BIN").read_bytes()
                for name in ("red", "blue", "old", "set")}
    assert len(binaries) == 4


def test_the_behaviours_are_one_stored_zip(tmp_path):
    assert stick("--out", tmp_path / "s").returncode == 0
    with zipfile.ZipFile(tmp_path / "s/OPEN-R/MW/DATA/P/PYCODE.ZIP") as archive:
        assert "main.pyc" in archive.namelist()
        assert {info.compress_type for info in archive.infolist()} == {zipfile.ZIP_STORED}


@pytest.mark.skipif(shutil.which("mformat") is None, reason="mtools is not installed")
def test_an_image_holds_the_same_files_as_a_folder(parts):
    assert stick(*all_options(parts), "--out", parts / "s").returncode == 0
    result = stick(*all_options(parts), "--out", parts / "s.img")
    assert result.returncode == 0, result.stderr
    (parts / "back").mkdir()
    subprocess.run(["mcopy", "-s", "-n", "-i", parts / "s.img", "::OPEN-R", parts / "back"],
                   check=True, env=os.environ | {"MTOOLS_SKIP_CHECK": "1"})
    assert files_in(parts / "back") == files_in(parts / "s")


def test_an_image_without_mtools_is_one_line(tmp_path):
    result = kelpie("stick", "--robot", "1", "--out", tmp_path / "s.img",
                    env=os.environ | {"PATH": "/nowhere"})
    assert result.returncode == 2 and "mtools" in complaint(result)
    assert not list(tmp_path.glob("s.img*"))


def test_install_writes_a_stick_that_then_differs_in_nothing(parts):
    sony = files_in(parts / "mount")
    before = stick(*all_options(parts), "--diff", parts / "mount")
    assert before.returncode == 0 and "new      OPEN-R/MW/OBJS/AGENT.BIN" in before.stdout
    assert files_in(parts / "mount") == sony
    result = stick(*all_options(parts), "--install", parts / "mount")
    assert result.returncode == 0, result.stderr
    after = files_in(parts / "mount")
    assert all(after[name] == content for name, content in sony.items())
    assert after["OPEN-R/MW/OBJS/AGENT.BIN"] == OBJECT
    assert len(after) == len(sony) + 8
    same = stick(*all_options(parts), "--diff", parts / "mount")
    assert "changed" not in same.stdout and "new " not in same.stdout
    assert "the configuration is the same" in same.stdout


def test_diff_says_which_file_of_a_stick_is_damaged(parts):
    assert stick(*all_options(parts), "--install", parts / "mount").returncode == 0
    path = parts / "mount/OPEN-R/MW/CONF/CONNECT.CFG"
    path.write_text(path.read_text().replace("Sensor", "Censor", 1))
    result = stick(*all_options(parts), "--diff", parts / "mount")
    assert "CONNECT.CFG: is not the file that the stick was written with" in result.stdout


def test_the_radios_keys_are_never_reported(parts):
    for words in (["--diff", parts / "mount"], ["--install", parts / "mount"],
                  ["--out", parts / "s"]):
        result = stick(*all_options(parts), *words)
        assert result.returncode == 0
        assert SECRET not in result.stdout + result.stderr
    (parts / "field.wlan").write_text(WLAN.replace(SECRET, SECRET + "5"))
    result = stick(*all_options(parts), "--out", parts / "s")
    assert "field.wlan:3: WEPKEY" in complaint(result) and SECRET not in result.stderr


@pytest.mark.parametrize("words, reported", [
    (["--out", "x", "--wlan", "/no/such.wlan"], "does not exist"),
    (["--out", "x", "--wlan", str(ROOT / "README.md")], "source tree"),
    (["--out", "x", "--object", "/no/such.bin"], "does not exist"),
    (["--out", "x", "--object", "/etc/passwd"], "neither a MIPS program nor gzip"),
    (["--out", "x", "--pycode", "/no/such"], "does not exist"),
    (["--out", "x", "--field", "1999"], "1999"),
    (["--out", "x", "--set", "gps.love=1"], "gps.love"),
    (["--out", "/proc/x"], "/proc/x"),
    (["--install", "/"], "--object"),
    (["--out", "x", "--replace"], "--replace"),
    (["--diff", "/"], "APERIOS.GZ"),
    (["--out", "x", "--wlan", ""], "--wlan"),
    (["--out", "x", "--object", ""], "--object"),
    ([], "--out, --diff or --install"),
])
def test_what_cannot_be_is_one_line(words, reported, tmp_path):
    words = [str(tmp_path / "x") if word == "x" else word for word in words]
    result = stick(*words)
    assert result.returncode == 2
    assert reported in complaint(result)
    assert not (tmp_path / "x").exists()


def test_a_file_that_is_no_image_is_not_overwritten(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    result = stick("--out", tmp_path / "notes.txt")
    assert result.returncode == 2 and "is not a folder" in complaint(result)
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_a_robot_needs_a_number():
    assert kelpie("stick", "--out", "x").returncode == 2
    assert kelpie("stick", "--robot", "5", "--out", "x").returncode == 2


FIXED = "ESSID=fourlegged\nETHER_IP=10.0.1.3\n"
SONY_KEYS = ROOT.parent / "shared/cases/sony-keys.wlan"


def written_wlan(parts, text):
    (parts / "field.wlan").write_text(text)
    result = stick("--wlan", parts / "field.wlan", "--out", parts / "out")
    assert result.returncode == 0, result.stderr
    return (parts / "out/OPEN-R/SYSTEM/CONF/WLANCONF.TXT").read_text(), result.stdout


@pytest.mark.parametrize("text, unknown", [
    (FIXED + "APMODE=0\nCHANNEL=3\n", ""), (FIXED + "APMODE=1\nCHANNEL=3\n", ""),
    (FIXED + "APMODE=2\n", ""), ("ESSID=fourlegged\nUSE_DHCP=1\n", ""),
    (FIXED + "SSDP_ENABLE=1\nDNS_SERVER_2=10.0.1.1\n", "SSDP_ENABLE, DNS_SERVER_2")])
def test_every_kind_of_network_is_taken(parts, text, unknown):
    written, reported = written_wlan(parts, text)
    assert written == text
    lines = [line for line in reported.splitlines() if "field.wlan" in line]
    reported = f"{parts / 'field.wlan'}: not known here and kept as they are: {unknown}"
    assert lines == ([reported] if unknown else [])


@pytest.mark.skipif(not SONY_KEYS.exists(), reason=f"{SONY_KEYS.name} is not here")
def test_the_keys_of_sonys_own_sample_are_taken(parts):
    text = SONY_KEYS.read_text()
    written, reported = written_wlan(parts, text)
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    assert written.splitlines() == lines
    assert "kept as they are: SSDP_ENABLE\n" in reported
    key, = [line.split("=")[1] for line in lines if line.startswith("WEPKEY=")]
    assert key not in reported


FORMER = {"OPEN-R/MW/CONF/OBJECT.CFG": b"/MS/OPEN-R/MW/OBJS/WALKER.BIN\n",
          "OPEN-R/MW/CONF/CONNECT.CFG": b"Walker.Legs.OCommandVectorData.S other\n",
          "OPEN-R/MW/CONF/DESIGNDB.CFG": b"[ERS-7]\n"}
ITS_OWN = {"OPEN-R/MW/OBJS/WALKER.BIN": bytes(5000), "OPEN-R/MW/CONF/DESIGN.CFG": b"fast\n"}


def put_former_program(mount):
    for name, data in (FORMER | ITS_OWN).items():
        (mount / name).parent.mkdir(parents=True, exist_ok=True)
        (mount / name).write_bytes(data)


def test_another_programs_files_are_named_and_not_replaced(parts):
    put_former_program(parts / "mount")
    before = files_in(parts / "mount")
    result = stick(*all_options(parts), "--install", parts / "mount")
    assert result.returncode == 2
    assert all(name in complaint(result) for name in FORMER)
    assert "--replace" in complaint(result) and "WALKER" not in complaint(result)
    assert files_in(parts / "mount") == before


def test_another_programs_files_are_kept_when_they_are_replaced(parts):
    put_former_program(parts / "mount")
    words = [*all_options(parts), "--install", parts / "mount"]
    result = stick(*words, "--replace")
    assert result.returncode == 0, result.stderr
    assert "kept in FORMER.001" in result.stdout
    assert files_in(parts / "mount/FORMER.001") == FORMER
    after = files_in(parts / "mount")
    assert all(after[name] == data for name, data in ITS_OWN.items())
    again = stick(*words, "--set", "gps.ball.gate=4")
    assert again.returncode == 0, "over our own stick no --replace is needed"
    assert not (parts / "mount/FORMER.002").exists()


SETTINGS = {"OPEN-R/SYSTEM/CONF/WLANCONF.TXT": b"ESSID=theirs\n",
            "OPEN-R/SYSTEM/CONF/VRCOMM.CFG": b"theirs\n"}


def put_settings(mount):
    for name, data in SETTINGS.items():
        (mount / name).write_bytes(data)


def test_settings_that_the_first_installation_left_are_kept_by_the_next(parts):
    put_former_program(parts / "mount")
    put_settings(parts / "mount")
    words = ["--object", parts / "AGENT.BIN", "--install", parts / "mount"]
    assert stick(*words, "--replace", "--keep-jam-detection").returncode == 0
    assert files_in(parts / "mount/FORMER.001") == FORMER
    difference = stick(*all_options(parts), "--diff", parts / "mount")
    assert difference.stdout.count("its owner's, which is kept") == 2
    result = stick(*all_options(parts), "--install", parts / "mount")
    assert result.returncode == 0, result.stderr
    assert "the settings that were there are kept in FORMER.002" in result.stdout
    assert files_in(parts / "mount/FORMER.002") == SETTINGS
    assert files_in(parts / "mount/FORMER.001") == FORMER


def test_settings_on_a_stick_with_sonys_system_alone_are_no_other_program(parts):
    put_settings(parts / "mount")
    assert "another program" not in stick(*all_options(parts), "--diff", parts / "mount").stdout
    result = stick(*all_options(parts), "--install", parts / "mount")
    assert result.returncode == 0, result.stderr
    assert "another program" not in result.stdout
    assert files_in(parts / "mount/FORMER.001") == SETTINGS


def test_settings_of_ours_are_replaced_and_not_kept(parts):
    assert stick(*all_options(parts), "--install", parts / "mount").returncode == 0
    (parts / "field.wlan").write_text(FIXED)
    assert stick(*all_options(parts), "--install", parts / "mount").returncode == 0
    assert (parts / "mount/OPEN-R/SYSTEM/CONF/WLANCONF.TXT").read_text() == FIXED
    assert not (parts / "mount/FORMER.001").exists()


def test_a_stick_of_ours_that_was_never_finished_needs_no_replace(parts):
    words = [*all_options(parts), "--install", parts / "mount"]
    assert stick(*words).returncode == 0
    (parts / "mount/OPEN-R/MW/DATA/P/STICK.BIN").unlink()
    (parts / "mount/OPEN-R/MW/DATA/P/PYCODE.ZIP").write_text("of an earlier day")
    assert stick(*words).returncode == 0
    (parts / "mount/OPEN-R/MW/DATA/P/STICK.BIN").unlink()
    (parts / "mount/OPEN-R/MW/OBJS/AGENT.BIN").write_text("another's")
    assert "AGENT.BIN would be replaced" in complaint(stick(*words))


class Killed:
    """An installation over another program that is killed at some moment, seeded: a number of
    told steps and some time on."""

    def __init__(self, parts, mount, seed):
        chance = random.Random(seed)
        words = [BIN / "kelpie", "stick", "--robot", "2", *all_options(parts), "--replace",
                 "--install", mount]
        with subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
            for _ in range(chance.randrange(22)):
                process.stdout.readline()
            time.sleep(chance.uniform(0, 0.002))
            process.kill()
        self.done = process.returncode == 0

    @staticmethod
    def plays(parts, mount):
        """Whether the robot's own reader takes the stick, as --diff tells."""
        result = stick(*all_options(parts), "--diff", mount)
        assert result.returncode == 0, result.stderr
        return "the robot refuses it" not in result.stdout


def test_an_installation_killed_at_any_moment_loses_nothing(parts):
    stopped = set()
    for seed in range(20):
        mount = parts / f"mount{seed}"
        shutil.copytree(parts / "mount", mount)
        put_former_program(mount)
        killed = Killed(parts, mount, seed)
        now = files_in(mount)
        assert all(now[name] == data for name, data in ITS_OWN.items())
        replaced = [name for name, data in FORMER.items() if now[name] != data]
        if replaced:
            assert files_in(mount / "FORMER.001") == FORMER
            assert now["OPEN-R/MW/CONF/OBJECT.CFG"] == b"/MS/OPEN-R/MW/OBJS/AGENT.BIN\n"
            assert now["OPEN-R/MW/OBJS/AGENT.BIN"] == OBJECT, "our reader must run"
        whole = (len(replaced) == 3 and "OPEN-R/MW/DATA/P/STICK.BIN" in now)
        assert Killed.plays(parts, mount) == whole
        assert whole or not killed.done
        stopped.add((len(replaced), whole))
    assert {(0, False), (3, True)} <= stopped, "the moments are all alike"
    last = stick(*all_options(parts), "--replace", "--install", mount)
    assert last.returncode == 0 and Killed.plays(parts, mount)


def test_install_refuses_a_mount_that_is_no_programming_stick(parts):
    (parts / "camera/DCIM").mkdir(parents=True)
    result = stick(*all_options(parts), "--install", parts / "camera")
    assert result.returncode == 2 and "APERIOS.GZ" in complaint(result)
    assert not (parts / "camera/OPEN-R").exists()


def test_emon_refuses_what_is_no_log_and_no_program(tmp_path):
    (tmp_path / "EMON.LOG").write_text("hello\n")
    result = kelpie("emon", tmp_path / "EMON.LOG", "--object", tmp_path / "none.elf")
    assert result.returncode == 2 and "epc" in complaint(result)
    (tmp_path / "EMON.LOG").write_text("badvaddr: $8: 0x1, epc:$14: 0x22400000\n")
    result = kelpie("emon", tmp_path / "EMON.LOG", "--object", "/bin/true")
    assert result.returncode == 2 and "not a MIPS ELF file" in complaint(result)
    result = kelpie("emon", tmp_path / "EMON.LOG", "--object", "/bin/true", "--loaded-at", "here")
    assert result.returncode == 2 and "--loaded-at" in complaint(result)


@pytest.mark.skipif(shutil.which("mipsel-linux-gnu-gcc") is None,
                    reason="mipsel-linux-gnu-gcc is not installed")
def test_emon_names_the_function_and_line_of_a_crash(tmp_path):
    (tmp_path / "p.c").write_text("int broken(volatile int *p) {\n  return *p;\n}\n"
                                  "int __start(void) { return broken(0); }\n")
    elf = tmp_path / "p.elf"
    subprocess.run(["mipsel-linux-gnu-gcc", "-g", "-O1", "-fno-inline", "-nostdlib", "-static",
                    "-o", elf, tmp_path / "p.c"], check=True)
    symbols = subprocess.run(["mipsel-linux-gnu-nm", elf], check=True, capture_output=True,
                             text=True).stdout
    address = {line.split()[2]: int(line.split()[0], 16) for line in symbols.splitlines()}
    moved = 0x22000000
    (tmp_path / "EMON.LOG").write_text(
        f"cause:$13: 0x00000008\nbadvaddr: $8: 0x00000000, "
        f"epc:$14: {address['broken'] + moved:#010x}\n gp:r28: {address['_gp'] + moved:#010x}\n")
    result = kelpie("emon", tmp_path / "EMON.LOG", "--object", elf)
    assert result.returncode == 0, result.stderr
    assert "2: no page at a load or a fetch" in result.stdout
    assert "broken (" in result.stdout and "p.c:" in result.stdout
