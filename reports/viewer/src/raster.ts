// Fills a canvas' memory with a layer as a look shows it.
import {darkened, packed} from './colours';
import type {Painted, Severity} from './layers';
import type {MaxChain} from './mips';
import type {Planes} from './planes';

/// Device pixels of a pane, and the raster position of its upper left corner.
export type Frame = {width: number; height: number; left: number; top: number; perPixel: number};  // device px

export type Selection = {match: Uint8Array; chain: MaxChain};

const outside = packed(0x0a, 0x0b, 0x0d);

/// For each column (or row), the pixel of the view that its middle shows, or -1.
function indices(count: number, from: number, perPixel: number, size: number): Int32Array {
    return Int32Array.from({length: count}, (_, i) => {
        const at = Math.floor(from + (i + 0.5) / perPixel);
        return at < 0 || at >= size ? -1 : at;
    });
}

/// For each column (or row), the range [begin, end) of all pixels that it touches; empty outside.
function spans(count: number, from: number, perPixel: number, size: number): {begin: Int32Array; end: Int32Array} {
    const begin = new Int32Array(count), end = new Int32Array(count);
    for (let i = 0; i < count; ++i) {
        begin[i] = Math.max(0, Math.floor(from + i / perPixel));
        end[i] = Math.min(size, Math.ceil(from + (i + 1) / perPixel));
    }
    return {begin, end};
}

/// Nearest neighbour: a row that shows the same pixels as the one above is copied.
export function fillNearest(out: Uint32Array, frame: Frame, planes: Planes, painted: Painted,
                            selection: Selection | null): void {
    const xs = indices(frame.width, frame.left, frame.perPixel, planes.width);
    const ys = indices(frame.height, frame.top, frame.perPixel, planes.height);
    for (let j = 0, last = -2; j < frame.height; last = ys[j++]) {
        const row = j * frame.width;
        if (ys[j] === last) { out.copyWithin(row, row - frame.width, row); continue; }
        if (ys[j] < 0) { out.fill(outside, row, row + frame.width); continue; }
        const base = ys[j] * planes.width;
        for (let i = 0, x = -2, colour = outside; i < frame.width; ++i) {
            if (xs[i] !== x) {
                x = xs[i];
                colour = x < 0 ? outside : painted.colour(base + x);
                if (selection && x >= 0 && !selection.match[base + x]) colour = darkened(colour);
            }
            out[row + i] = colour;
        }
    }
}

/// The worst of all that a device pixel touches. What is severe enough to be dotted grows to 3 x 3 CSS pixels.
export function fillWorst(out: Uint32Array, frame: Frame, planes: Planes, severity: Severity, chain: MaxChain,
                          scale: number): void {
    const xs = spans(frame.width, frame.left, frame.perPixel, planes.width);
    const ys = spans(frame.height, frame.top, frame.perPixel, planes.height);
    const block = 1 / frame.perPixel, dots: number[] = [];
    for (let j = 0; j < frame.height; ++j)
        for (let i = 0, at = j * frame.width; i < frame.width; ++i, ++at) {
            if (xs.begin[i] >= xs.end[i] || ys.begin[j] >= ys.end[j]) { out[at] = outside; continue; }
            const worst = chain.most(xs.begin[i], ys.begin[j], xs.end[i], ys.end[j], block);
            out[at] = severity.palette[worst];
            if (worst >= severity.dotted) dots.push(at, worst);
        }
    drawDots(out, frame, severity, dots, Math.max(1, Math.round(scale)));
}

function drawDots(out: Uint32Array, frame: Frame, severity: Severity, dots: number[], reach: number): void {
    const order = Array.from({length: dots.length / 2}, (_, k) => k);
    if (order.length < 100_000) order.sort((a, b) => dots[2 * a + 1] - dots[2 * b + 1]);
    for (const k of order) {
        const x = dots[2 * k] % frame.width, y = Math.floor(dots[2 * k] / frame.width);
        for (let j = Math.max(0, y - reach); j <= Math.min(frame.height - 1, y + reach); ++j)
            out.fill(severity.palette[dots[2 * k + 1]], j * frame.width + Math.max(0, x - reach),
                     j * frame.width + Math.min(frame.width - 1, x + reach) + 1);
    }
}
