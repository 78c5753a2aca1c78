// SPDX-License-Identifier: Apache-2.0
// A file behind an address, read in parts by range requests. Fails with one sentence where the
// server has no such part.
export interface Readable {
  size(): Promise<bigint>;
  read(offset: bigint, size: bigint): Promise<Uint8Array>;
}

export class HttpFile implements Readable {
  // The last bytes hold summary and footer, which are asked for in small parts at the start.
  private tail: { from: number; bytes: Uint8Array } | undefined;
  private static readonly tailBytes = 256 * 1024;

  constructor(
    readonly url: string,
    readonly bytes: number,
  ) {}

  async size(): Promise<bigint> {
    return BigInt(this.bytes);
  }

  async read(offset: bigint, size: bigint): Promise<Uint8Array> {
    const from = Number(offset);
    const count = Number(size);
    if (count === 0) return new Uint8Array();
    if (from >= this.bytes - HttpFile.tailBytes) return this.fromTail(from, count);
    return this.fetchRange(from, count);
  }

  private async fromTail(from: number, count: number): Promise<Uint8Array> {
    if (!this.tail) {
      const begin = Math.max(0, this.bytes - HttpFile.tailBytes);
      this.tail = { from: begin, bytes: await this.fetchRange(begin, this.bytes - begin) };
    }
    const at = from - this.tail.from;
    return this.tail.bytes.slice(at, at + count);
  }

  private async fetchRange(from: number, count: number): Promise<Uint8Array> {
    const answer = await fetch(this.url, {
      headers: { Range: `bytes=${from}-${from + count - 1}` },
    });
    if (answer.status !== 206) throw new Error(`${this.url} answers ${answer.status} to a range`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    if (bytes.length !== count)
      throw new Error(`${this.url} gave ${bytes.length} of ${count} bytes`);
    return bytes;
  }
}
