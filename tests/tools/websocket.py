# SPDX-License-Identifier: Apache-2.0
"""A viewer of a live match: a WebSocket (RFC 6455) that speaks Foxglove's protocol v1, with no
package that is not Python's own. Waits at most PATIENCE for what it hears."""

import base64
import json
import os
import socket
import struct
import time
import urllib.error
import urllib.request

PATIENCE = 60.0
TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


class Viewer:
    """`offers`: channels by topic, as the server has told so far. `texts`: what it told besides."""

    def __init__(self, port, path="/", protocol="foxglove.websocket.v1", origin=None, buffer=0):
        self.socket = socket.socket()
        if buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer)
        self.socket.settimeout(PATIENCE)
        self.socket.connect(("127.0.0.1", port))
        self.heard, self.offers, self.texts, self.names = b"", {}, [], {}
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f"GET {path} HTTP/1.1", f"Host: 127.0.0.1:{port}", "Connection: Upgrade",
                 "Upgrade: websocket", "Sec-WebSocket-Version: 13", f"Sec-WebSocket-Key: {key}"]
        lines += [f"Sec-WebSocket-Protocol: {protocol}"] if protocol else []
        lines += [f"Origin: {origin}"] if origin else []
        self.socket.sendall("\r\n".join([*lines, "", ""]).encode())
        while b"\r\n\r\n" not in self.heard:
            self._more()
        head, self.heard = self.heard.split(b"\r\n\r\n", 1)
        self.status = int(head.split()[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def _more(self):
        got = self.socket.recv(1 << 20)
        if not got:
            raise EOFError("the server has hung up")
        self.heard += got

    def _take(self, count):
        while len(self.heard) < count:
            self._more()
        taken, self.heard = self.heard[:count], self.heard[count:]
        return taken

    def send(self, opcode, content):
        """With a mask of zeros, which leaves the content as it is."""
        size = len(content)
        length = struct.pack(">B", 0x80 | size) if size < 126 else struct.pack(">BQ", 0xFF, size)
        self.socket.sendall(bytes([0x80 | opcode]) + length + bytes(4) + content)

    def _frame(self):
        first, size = self._take(2)
        if size == 126:
            size = struct.unpack(">H", self._take(2))[0]
        elif size == 127:
            size = struct.unpack(">Q", self._take(8))[0]
        return first & 0x0F, self._take(size)

    def _hear(self, content):
        text = json.loads(content)
        self.texts.append(text)
        if text["op"] == "unadvertise":
            self.offers = {topic: one for topic, one in self.offers.items()
                           if one["id"] not in text["channelIds"]}
        for channel in text.get("channels", []) if text["op"] == "advertise" else []:
            self.offers[channel["topic"]] = channel

    def message(self, patience=PATIENCE):
        """(topic, time in s, bytes), or None when something else was said; TimeoutError."""
        self.socket.settimeout(patience)
        opcode, content = self._frame()
        if opcode == CLOSE:
            raise EOFError("the server says goodbye")
        if opcode == PING:
            self.send(PONG, content)
        if opcode == TEXT:
            self._hear(content)
        if opcode != BINARY:
            return None
        kind, subscription, ns = struct.unpack("<BIQ", content[:13])
        assert kind == 1
        return self.names.get(subscription), ns / 1e9, content[13:]

    def subscribe(self, *topics):
        """Waits until they are offered."""
        for topic in topics:
            self.until(lambda topic=topic: topic in self.offers)
            number = len(self.names) + 1
            self.names[number] = topic
            wanted = {"id": number, "channelId": self.offers[topic]["id"]}
            self.send(TEXT, json.dumps({"op": "subscribe", "subscriptions": [wanted]}).encode())

    def until(self, fact):
        """Hears until it is so."""
        end = time.monotonic() + PATIENCE
        while not fact():
            assert time.monotonic() < end
            self.message()

    def next(self, topic):
        """The next message of a topic."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            message = self.message()
            if message and message[0] == topic:
                return message
        raise TimeoutError(topic)

    def all_until_silence(self, seconds):
        """Messages until none has come for so long."""
        messages = []
        while True:
            try:
                message = self.message(seconds)
            except TimeoutError:
                return messages
            messages += [message] if message else []

    def told(self, op):
        return [text for text in self.texts if text["op"] == op]


def ask(port, path, method="GET", body=None, headers=None):
    """(status, body) of a request."""
    request = urllib.request.Request(f"http://127.0.0.1:{port}{path}", method=method,
                                     data=None if body is None else body.encode(),
                                     headers=headers or {})
    try:
        with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def order(port, **words):
    """What a match answers to an order: {"ok": true} or {"error": why}."""
    return json.loads(ask(port, "/api/control", "POST", json.dumps(words))[1])
