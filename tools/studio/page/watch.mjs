// SPDX-License-Identifier: Apache-2.0
// node watch.mjs URL [deaf]: a viewer of a live match that subscribes every topic and shows nothing;
// with `deaf` it stops reading once it has subscribed. Runs until it is ended or the match is gone.
import { randomBytes } from "node:crypto";
import { connect } from "node:net";

const [, , url, mode] = process.argv;
const { hostname, port, pathname } = new URL(url);
const socket = connect(Number(port), hostname);

// A text frame of a client: masked (RFC 6455, section 5.2).
function frame(text) {
  const body = Buffer.from(text);
  const mask = randomBytes(4);
  const head =
    body.length < 126
      ? Buffer.from([0x81, 0x80 | body.length])
      : Buffer.from([0x81, 0xfe, body.length >> 8, body.length & 255]);
  return Buffer.concat([head, mask, body.map((byte, i) => byte ^ mask[i & 3])]);
}

function subscribeTo(message) {
  const subscriptions = message.channels.map(({ id }) => ({ id, channelId: id }));
  if (subscriptions.length > 0)
    socket.write(frame(JSON.stringify({ op: "subscribe", subscriptions })));
}

let waiting = Buffer.alloc(0);
let upgraded = false;
let advertised = 0;

// Frames of a server come whole and unmasked; texts say which channels there are.
function take(bytes) {
  waiting = waiting.length > 0 ? Buffer.concat([waiting, bytes]) : bytes;
  if (!upgraded) {
    const end = waiting.indexOf("\r\n\r\n");
    if (end < 0) return;
    upgraded = true;
    waiting = waiting.subarray(end + 4);
  }
  while (waiting.length >= 2) {
    const short = waiting[1] & 127;
    const head = short < 126 ? 2 : short === 126 ? 4 : 10;
    if (waiting.length < head) return;
    const size =
      short < 126
        ? short
        : short === 126
          ? waiting.readUInt16BE(2)
          : Number(waiting.readBigUInt64BE(2));
    if (waiting.length < head + size) return;
    const body = waiting.subarray(head, head + size);
    if ((waiting[0] & 15) === 1) hear(JSON.parse(body.toString()));
    if ((waiting[0] & 15) === 9) socket.write(Buffer.from([0x8a, 0x80, 0, 0, 0, 0])); // pong
    waiting = waiting.subarray(head + size);
  }
}

function hear(message) {
  if (message.op !== "advertise") return;
  subscribeTo(message);
  advertised += message.channels.length;
  if (mode === "deaf" && advertised > 8) socket.pause();
}

const key = randomBytes(16).toString("base64");
socket.write(
  `GET ${pathname} HTTP/1.1\r\nHost: ${hostname}:${port}\r\nUpgrade: websocket\r\n` +
    `Connection: Upgrade\r\nSec-WebSocket-Key: ${key}\r\nSec-WebSocket-Version: 13\r\n` +
    "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n",
);
socket.on("data", take);
socket.on("error", () => process.exit(0));
socket.on("close", () => process.exit(0));
