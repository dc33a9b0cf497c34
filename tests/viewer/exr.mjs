// Frames as OpenEXR, read and written from the format's description alone: nothing of zproof's is used.
import {inflateSync} from 'node:zlib';

const sizes = {0: 4, 1: 2, 2: 4};  // uint, half, float
const rowsPerBlock = {0: 1, 2: 1, 3: 16};

function readHeader(file) {
    let at = 8;
    const text = () => {
        const end = file.indexOf(0, at), found = file.toString('latin1', at, end);
        at = end + 1;
        return found;
    };
    const attributes = {};
    for (let name = text(); name; name = text()) {
        text();  // the type
        const size = file.readUInt32LE(at);
        attributes[name] = file.subarray(at + 4, at + 4 + size);
        at += 4 + size;
    }
    return {attributes, at};
}

function channelsOf(bytes) {
    const channels = [];
    for (let at = 0; bytes[at];) {
        const end = bytes.indexOf(0, at);
        channels.push({name: bytes.toString('latin1', at, end), type: bytes.readUInt32LE(end + 1)});
        at = end + 17;
    }
    return channels;
}

/// zip's predictor and interleaving undone.
function unzipped(data, size) {
    if (data.length === size) return data;
    const bytes = inflateSync(data), out = Buffer.alloc(size), half = (size + 1) >> 1;
    for (let i = 1; i < size; ++i) bytes[i] = (bytes[i] + bytes[i - 1] - 128) & 255;
    for (let i = 0; i < size; ++i) out[i] = bytes[i & 1 ? half + (i >> 1) : i >> 1];
    return out;
}

/// {width, height, planes: {id: Uint32Array, Z: Uint32Array}}: the bits of every channel.
export function readExr(file) {
    const {attributes, at} = readHeader(file);
    const box = attributes.dataWindow, compression = attributes.compression[0];
    const width = box.readInt32LE(8) - box.readInt32LE(0) + 1, height = box.readInt32LE(12) - box.readInt32LE(4) + 1;
    const channels = channelsOf(attributes.channels), planes = {};
    for (const channel of channels) planes[channel.name] = new Uint32Array(width * height);
    const perRow = channels.reduce((sum, channel) => sum + sizes[channel.type] * width, 0);
    const blockRows = rowsPerBlock[compression], blocks = Math.ceil(height / blockRows);
    for (let b = 0; b < blocks; ++b) {
        const offset = Number(file.readBigUInt64LE(at + 8 * b)), top = file.readInt32LE(offset) - box.readInt32LE(4);
        const rows = Math.min(blockRows, height - top), length = file.readUInt32LE(offset + 4);
        const data = unzipped(file.subarray(offset + 8, offset + 8 + length), perRow * rows);
        for (let row = 0, from = 0; row < rows; ++row)
            for (const channel of channels)
                for (let x = 0; x < width; ++x, from += 4)
                    planes[channel.name][(top + row) * width + x] = data.readUInt32LE(from);
    }
    return {width, height, planes};
}

function attribute(name, type, content) {
    const size = Buffer.alloc(4);
    size.writeUInt32LE(content.length);
    return Buffer.concat([Buffer.from(`${name}\0${type}\0`, 'latin1'), size, content]);
}

const ints = (...values) => Buffer.from(Int32Array.from(values).buffer);
const floats = (...values) => Buffer.from(Float32Array.from(values).buffer);

/// The same, uncompressed.
export function writeExr({width, height, planes}) {
    const channel = (name, type) => Buffer.concat([Buffer.from(name + '\0'), ints(type, 0, 1, 1)]);
    const box = ints(0, 0, width - 1, height - 1);
    const header = Buffer.concat([
        ints(20000630, 2),
        attribute('channels', 'chlist', Buffer.concat([channel('Z', 2), channel('id', 0), Buffer.from([0])])),
        attribute('compression', 'compression', Buffer.from([0])), attribute('dataWindow', 'box2i', box),
        attribute('displayWindow', 'box2i', box), attribute('lineOrder', 'lineOrder', Buffer.from([0])),
        attribute('pixelAspectRatio', 'float', floats(1)), attribute('screenWindowCenter', 'v2f', floats(0, 0)),
        attribute('screenWindowWidth', 'float', floats(1)), Buffer.from([0])]);
    const block = 8 + 8 * width, offsets = Buffer.alloc(8 * height), rows = [];
    for (let y = 0; y < height; ++y) {
        offsets.writeBigUInt64LE(BigInt(header.length + 8 * height + y * block), 8 * y);
        const row = (plane) => Buffer.from(planes[plane].buffer, planes[plane].byteOffset + 4 * y * width, 4 * width);
        rows.push(ints(y, 8 * width), row('Z'), row('id'));
    }
    return Buffer.concat([header, offsets, ...rows]);
}
