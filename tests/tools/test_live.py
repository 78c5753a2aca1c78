# SPDX-License-Identifier: Apache-2.0
"""Matches that are watched and ordered about while they are played: the studio's orders, viewers
that are slow or dead, matches that are killed and begun again. Nothing here is timed; what is
compared are counts of frames."""

import json
import re
import signal
import socket
import subprocess
import sys
import time

import pytest
from conftest import BIN, ROOT, complaint, kelpie
from websocket import Viewer, ask, order

FAST = ("--fast", "--no-film", "--seed", "7")
FRAMES = "/live/red-1/frame/output"
LINES = "/live/log"
SILENCE = 1.0  # s; frames come thirty times a second


class Program:
    """`kelpie WORDS` with its two outputs, killed at the end."""

    def __init__(self, *words):
        self.process = subprocess.Popen([BIN / "kelpie", *map(str, words)], cwd=ROOT, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        start_new_session=True)
        self.lines = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()

    def port(self):
        """That it says it serves at."""
        for line in self.process.stdout:
            self.lines.append(line.rstrip())
            found = re.match(r"(studio|live): \w+://127\.0\.0\.1:(\d+)", line)
            if found:
                return int(found[2])
        raise AssertionError(self.lines)

    def end(self, number=None, timeout=60):
        """Its exit code; what it printed is added to `lines`."""
        if number:
            self.process.send_signal(number)
        rest = self.process.communicate(timeout=timeout)[0]
        self.lines += rest.splitlines()
        return self.process.returncode


@pytest.fixture(scope="module", name="watched")
def fixture_watched(tmp_path_factory):
    """A match of two robots by the clock: its port and a page that sees red 1's frames."""
    out = tmp_path_factory.mktemp("watched") / "out"
    with Program("play", "--studio", "--robots", "1v1", *FAST, "--port", 0, "--out", out) as match:
        port = match.port()
        with Viewer(port, "/live") as page:
            page.subscribe(FRAMES)
            page.next(FRAMES)
            yield port, page, match


@pytest.fixture(name="standing")
def fixture_standing(watched):
    """The same, paused, and all that was said before heard; goes on behind the test."""
    port, page, _ = watched
    assert order(port, do="pause") == {"ok": True}
    page.all_until_silence(SILENCE)
    yield port, page
    order(port, do="resume")


def frames_of(messages):
    return [at for topic, at, _ in messages if topic == FRAMES]


def test_both_urls_are_told(watched):
    _, _, match = watched
    port = match.lines[-1].rsplit(":", 1)[1]
    assert match.lines[-1] == f"studio: http://127.0.0.1:{port}"
    assert match.process.stdout.readline().startswith(f"live: ws://127.0.0.1:{port}")


def test_a_paused_match_stands_and_a_resumed_one_goes_on(standing):
    port, page = standing
    assert page.all_until_silence(SILENCE) == []
    order(port, do="resume")
    first, second = page.next(FRAMES)[1], page.next(FRAMES)[1]
    assert second > first


def test_a_step_has_as_many_images_as_it_says(standing):
    port, page = standing
    for images in (3, 1):
        assert order(port, do="step", frames=images) == {"ok": True}
        assert len(frames_of(page.all_until_silence(SILENCE))) == images


def test_a_pause_ends_a_long_step(standing):
    port, page = standing
    order(port, do="step", frames=3000)
    page.next(FRAMES)
    order(port, do="pause")
    page.all_until_silence(SILENCE)
    assert page.all_until_silence(SILENCE) == []


def test_a_slow_match_hears_that_it_shall_be_faster(watched):
    port, page, _ = watched
    order(port, do="speed", factor=0.0001)
    page.all_until_silence(SILENCE)
    order(port, do="speed", factor=1)
    page.next(FRAMES)


def line_with(page, words):
    page.subscribe(LINES) if LINES not in page.names.values() else None
    while True:
        line = json.loads(page.next(LINES)[2])["line"]
        if words in line:
            return line


def test_a_ball_that_is_put_elsewhere_is_told(watched):
    port, page, _ = watched
    assert order(port, do="ball", x=60, y=300) == {"ok": True}
    assert line_with(page, "the ball is back").endswith("(60, 300)")


def test_a_robot_that_is_carried_is_told(watched):
    port, page, _ = watched
    assert order(port, do="robot", team="blue", player=1, x=300, y=100, heading_deg=90) == \
        {"ok": True}
    assert line_with(page, "is carried").endswith("blue 1 is carried to (300, 100)")


@pytest.mark.parametrize("words", [
    {"do": "halt"}, {"do": "ball", "x": -5, "y": 3}, {"do": "ball"}, {"do": "step", "frames": 0},
    {"do": "robot", "team": "red", "player": 3, "x": 100, "y": 100, "heading_deg": 0},
    {"do": "speed", "factor": -1}])
def test_an_order_that_cannot_be_obeyed_is_refused_in_a_line(watched, words):
    answer = order(watched[0], **words)
    assert list(answer) == ["error"] and "\n" not in answer["error"]


def test_another_pages_orders_and_viewers_are_refused(watched):
    port = watched[0]
    foreign = {"Origin": "http://evil.example"}
    assert ask(port, "/api/control", "POST", '{"do": "pause"}', foreign)[0] == 403
    assert ask(port, "/api/session", headers={"Host": "evil.example"})[0] == 403
    assert Viewer(port, "/live", origin="http://evil.example").status == 403
    assert Viewer(port, "/live", protocol=None).status == 400


def test_viewers_get_images_and_the_robots_frames(watched):
    with Viewer(watched[0]) as viewer:
        viewer.subscribe("/red1/camera", "/tf")
        assert b"\xff\xd8" in viewer.next("/red1/camera")[2]
        assert viewer.texts[0]["op"] == "serverInfo"
        assert viewer.offers["/tf"]["schemaEncoding"] == "protobuf"


def test_ctrl_c_ends_a_match_that_stands(tmp_path):
    with Program("play", "--studio", *FAST, "--port", 0, "--out", tmp_path / "out") as match:
        port = match.port()
        with Viewer(port, "/live") as page:
            page.subscribe(FRAMES)
            page.next(FRAMES)
            order(port, do="pause")
            page.all_until_silence(SILENCE)
            assert match.end(signal.SIGINT) == 0
            with pytest.raises((EOFError, ConnectionError)):
                page.all_until_silence(60)
        assert (tmp_path / "out/match.mcap").exists()
        assert not (tmp_path / "out/playing").exists()


def counts(log):
    """{topic: messages} of a log."""
    lines = kelpie("info", log).stdout.splitlines()
    return {words[0]: words[2] for words in map(str.split, lines) if words and words[0][0] == "/"}


STOPPED = """
import sys, time
sys.path.insert(0, sys.argv[2])
from websocket import Viewer
viewer = Viewer(int(sys.argv[1]))
viewer.subscribe("/tf", "/red1/camera")
print("watching", flush=True)
time.sleep(600)
"""


def test_viewers_that_are_stopped_or_never_read_cost_a_match_nothing(tmp_path):
    words = ("play", *FAST, "--robots", "1v1", "--seconds", 8, "--live", "--port", 0)
    assert kelpie(*words, "--out", tmp_path / "alone").returncode == 0
    with Program(*words, "--out", tmp_path / "out") as match:
        port = match.port()
        deaf = Viewer(port, "/live", buffer=4096)
        stopped = subprocess.Popen([sys.executable, "-c", STOPPED, str(port),
                                    ROOT / "tests/tools"], stdout=subprocess.PIPE)
        assert stopped.stdout.readline() == b"watching\n"
        stopped.send_signal(signal.SIGSTOP)
        try:
            deaf.subscribe(FRAMES, "/live/red-1/frame/picture")
            assert match.end(timeout=120) == 0, match.lines
        finally:
            stopped.kill()
            stopped.wait()
            deaf.socket.close()
    assert counts(tmp_path / "out/match.mcap") == counts(tmp_path / "alone/match.mcap")


def test_a_match_that_is_killed_and_begun_again_is_seen_in_the_studio(tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    words = ("play", *FAST, "--real-time", "--seconds", 100, "--out", out)
    with Program("studio", out, "--port", 0) as studio:
        port = studio.port()
        assert json.loads(ask(port, "/api/session")[1])["live"]["playing"] is False
        with Viewer(port, "/live") as page:
            with Program(*words) as first:
                page.subscribe(FRAMES)
                page.next(FRAMES)
                session = json.loads(ask(port, "/api/session")[1])["live"]
                assert session["playing"] is True and session["controls"] is False
                assert "error" in order(port, do="pause")
                first.end(signal.SIGKILL)
            with Program(*words) as second:
                page.until(lambda: page.told("unadvertise"))
                page.names.clear()
                page.subscribe(FRAMES)
                page.next(FRAMES)
                assert len({text["sessionId"] for text in page.told("serverInfo")}) == 2
                assert second.end(signal.SIGINT) == 0
            page.until(lambda: any(text.get("message") == "the match is over"
                                   for text in page.texts))
        deadline = time.monotonic() + 60
        while not (logs := json.loads(ask(port, "/api/session")[1])["logs"]):
            assert time.monotonic() < deadline
        assert logs[0]["name"] == "match.mcap"
        assert studio.end(signal.SIGINT) == 0


def test_a_log_is_replayed_to_who_watches(match):
    with Program("replay", match, "--live", "--port", 0) as replay:
        with Viewer(replay.port()) as viewer:
            viewer.subscribe("/tf", "/red1/camera")
            images = 0
            with pytest.raises((EOFError, ConnectionError)):
                while True:
                    message = viewer.message()
                    images += 1 if message and message[0] == "/red1/camera" else 0
            assert images > 10
        assert replay.end() == 0


@pytest.mark.parametrize("words", [("play", *FAST, "--studio"), ("play", *FAST, "--live"),
                                   ("studio",), ("replay", "LOG", "--live")])
def test_a_port_that_is_taken_is_a_line_and_exit_code_2(tmp_path, match, words):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        words = [match if word == "LOG" else word for word in words]
        if words[0] == "play":
            words += ["--out", tmp_path / "out"]
        if words[0] == "studio":
            words += [match]
        result = kelpie(*words, "--port", port)
    assert result.returncode == 2
    assert f"port {port}: Address already in use" in complaint(result)
    assert not (tmp_path / "out/playing").exists()


@pytest.mark.parametrize("words", [("studio",), ("replay", "--live")])
def test_what_is_no_log_is_a_line_and_exit_code_2(tmp_path, words):
    for name, content in (("text.mcap", b"no log"), ("empty.mcap", b""),
                          ("magic.mcap", b"\x89MCAP0\r\n")):
        (tmp_path / name).write_bytes(content)
        result = kelpie(*words, tmp_path / name, "--port", 0)
        assert result.returncode == 2
        assert str(tmp_path / name) in complaint(result)


@pytest.mark.parametrize("words", [("--port", 65536), ("--port", -1), ("--port", "x"),
                                   ("--listen", "nonsense"), ("--listen", "")])
def test_an_address_that_is_none_is_a_line_and_exit_code_2(match, words):
    result = kelpie("studio", match, *words)
    assert result.returncode == 2
    assert "kelpie" in result.stderr and "Traceback" not in result.stderr
