// Reads back what reports/planes/coding.cpp wrote.

export async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
    const native = (Uint8Array as unknown as {fromBase64?: (text: string) => Uint8Array<ArrayBuffer>}).fromBase64;
    if (native) return native.call(Uint8Array, text);
    const characters = atob(text), bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
    return bytes;
}

/// Merges byte planes, lowest first, of which the last may be left out, and unfolds: 0, 1, 2, 3 ... become 0, -1, 1, -2 ...
function missed(planes: Uint8Array, count: number): Uint32Array<ArrayBuffer> {
    const words = new Uint32Array(count);
    words.set(planes.subarray(0, Math.min(count, planes.length)));
    for (let shift = 8, at = count; at < planes.length; shift += 8, at += count)
        for (let i = 0, k = at; i < count; ++i, ++k) words[i] |= planes[k] << shift;
    for (let i = 0; i < count; ++i) words[i] = (words[i] >>> 1) ^ -(words[i] & 1);
    return words;
}

export function fromLeft(planes: Uint8Array, count: number, width: number): Uint32Array<ArrayBuffer> {
    const words = missed(planes, count);
    for (let row = 0; row < count; row += width)
        for (let i = row + 1, end = row + width, left = words[row]; i < end; ++i) words[i] = left = (left + words[i]) >>> 0;
    return words;
}

/// left + upper - upper left is a sum along the row, then one along the column.
export function fromPlanar(planes: Uint8Array, count: number, width: number): Uint32Array<ArrayBuffer> {
    const words = fromLeft(planes, count, width);
    for (let i = width; i < count; ++i) words[i] += words[i - width];
    return words;
}

export function beside(planes: Uint8Array, guess: Uint32Array): Uint32Array<ArrayBuffer> {
    const words = missed(planes, guess.length);
    for (let i = 0; i < words.length; ++i) words[i] += guess[i];
    return words;
}

/// Places and values of what the guess misses.
export function sparse(planes: Uint8Array, count: number, guess: Uint32Array): Uint32Array<ArrayBuffer> {
    const missing = fromLeft(planes, 2 * count, Math.max(count, 1)), words = new Uint32Array(guess);
    for (let i = 0; i < count; ++i) words[missing[i]] = missing[count + i];
    return words;
}

/// Reads runs: the length of each, seven bits to a byte and the lowest first, then its value.
export function fromRuns(runs: Uint8Array, count: number): Uint8Array<ArrayBuffer> {
    const values = new Uint8Array(count);
    for (let i = 0, at = 0; i < runs.length; ++i) {
        let length = 0;
        for (let shift = 1; ; shift *= 128) {
            length += (runs[i] & 127) * shift;
            if (runs[i++] < 128) break;
        }
        values.fill(runs[i], at, at += length);
    }
    return values;
}

export function doublesFrom(planes: Uint8Array, count: number): Float64Array<ArrayBuffer> {
    const bytes = new Uint8Array(8 * count);
    for (let k = 0; k * count < planes.length; ++k)
        for (let i = 0; i < count; ++i) bytes[8 * i + k] = planes[k * count + i];
    return new Float64Array(bytes.buffer);
}

/// Channels, each number less its left neighbour.
export function fromChannels(differences: Uint8Array): Uint8Array<ArrayBuffer> {
    const third = differences.length / 3, values = new Uint8Array(differences.length);
    for (let channel = 0; channel < 3; ++channel)
        for (let i = channel * third, end = i + third, left = 0; i < end; ++i)
            values[i] = left = (left + differences[i]) & 0xff;
    return values;
}

const crcTable = Uint32Array.from({length: 256}, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
});

/// CRC-32 as zlib has it, of the memory of a typed array.
export function checksum(values: ArrayBufferView): number {
    const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
    let crc = 0xffffffff;
    for (let i = 0; i < bytes.length; ++i) crc = crcTable[(crc ^ bytes[i]) & 0xff] ^ (crc >>> 8);
    return (crc ^ 0xffffffff) >>> 0;
}
