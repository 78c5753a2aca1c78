// SPDX-License-Identifier: Apache-2.0
// The WebSocket of a live match, in the Foxglove WebSocket protocol, version 1. It subscribes to
// every channel that is wanted, and connects again by itself where the connection breaks.
export interface LiveChannel {
  id: number;
  topic: string;
  encoding: string;
  schemaName: string;
  schema: string;
}
export interface LiveListener {
  state(connected: boolean): void;
  channel(channel: LiveChannel): void;
  message(channel: LiveChannel, time: number, bytes: Uint8Array): void; // time in us
  said(line: string): void; // by the server, of the match
  anotherMatch(): void; // what came so far is of a match before
}

const PROTOCOL = "foxglove.websocket.v1";
const MESSAGE = 1;
const HEADER = 13; // bytes before the payload
const FIRST_PAUSE = 500; // ms
const LONGEST_PAUSE = 5000;

export class LiveLink {
  private socket: WebSocket | undefined;
  private readonly channels = new Map<number, LiveChannel>(); // by subscription
  private pause = FIRST_PAUSE;
  private nextSubscription = 1;
  private session: unknown;
  private closed = false;

  constructor(
    private readonly url: string,
    private readonly wanted: (topic: string) => boolean,
    private readonly listener: LiveListener,
  ) {
    this.connect();
  }

  close(): void {
    this.closed = true;
    this.socket?.close();
  }

  private connect(): void {
    const socket = new WebSocket(this.url, [PROTOCOL]);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.channels.clear();
    socket.addEventListener("open", () => {
      this.pause = FIRST_PAUSE;
      this.listener.state(true);
    });
    socket.addEventListener("message", (e: MessageEvent<string | ArrayBuffer>) => {
      if (typeof e.data === "string") this.takeText(e.data);
      else this.takeBytes(e.data);
    });
    socket.addEventListener("close", () => this.again());
  }

  private again(): void {
    if (this.closed) return;
    this.listener.state(false);
    window.setTimeout(() => this.connect(), this.pause);
    this.pause = Math.min(LONGEST_PAUSE, 2 * this.pause);
  }

  private takeText(text: string): void {
    const message = parsed(text);
    if (message?.["op"] === "serverInfo") this.takeSession(message["sessionId"]);
    if (message?.["op"] === "status") this.listener.said(String(message["message"]));
    if (message?.["op"] === "advertise")
      this.subscribe((message["channels"] ?? []) as LiveChannel[]);
    if (message?.["op"] === "unadvertise")
      for (const id of (message["channelIds"] ?? []) as number[])
        for (const [subscription, channel] of this.channels)
          if (channel.id === id) this.channels.delete(subscription);
  }

  private takeSession(session: unknown): void {
    const another = this.session !== undefined && this.session !== session;
    this.session = session;
    if (another) this.listener.anotherMatch();
  }

  private subscribe(channels: LiveChannel[]): void {
    const subscriptions = channels
      .filter((c) => this.wanted(c.topic))
      .map((channel) => {
        const id = this.nextSubscription++;
        this.channels.set(id, channel);
        this.listener.channel(channel);
        return { id, channelId: channel.id };
      });
    if (subscriptions.length > 0)
      this.socket?.send(JSON.stringify({ op: "subscribe", subscriptions }));
  }

  private takeBytes(data: ArrayBuffer): void {
    if (data.byteLength < HEADER) return;
    const view = new DataView(data);
    if (view.getUint8(0) !== MESSAGE) return;
    const channel = this.channels.get(view.getUint32(1, true));
    const time = Number(view.getBigUint64(5, true) / 1000n);
    if (channel) this.listener.message(channel, time, new Uint8Array(data, HEADER));
  }
}

function parsed(text: string): Record<string, unknown> | undefined {
  try {
    return JSON.parse(text) as Record<string, unknown>;
  } catch {
    return undefined;
  }
}
