// Selections of pixels: what a histogram's bin or a class stands for.
import type {Bins} from './histogram';
import {ratioOf, ulpCodes} from './layers';
import {MaxChain} from './mips';
import {rounded} from './numbers';
import type {Planes} from './planes';
import type {Selection} from './raster';

/// A histogram of one byte per pixel with the way back from a bin to its pixels.
export type CodedBins = {bins: Bins; codes: Uint8Array; binOf: Int16Array};  // binOf[code], -1: not counted

export function selectionOf(planes: Planes, holds: (pixel: number) => boolean): Selection {
    const match = new Uint8Array(planes.pixelCount);
    for (let i = 0; i < match.length; ++i) if (holds(i)) match[i] = 1;
    return {match, chain: new MaxChain(match, planes.width, planes.height)};
}

function counted(codes: Uint8Array, binOf: Int16Array, count: number): number[] {
    const perCode = new Float64Array(256), counts = new Array<number>(count).fill(0);
    for (let i = 0; i < codes.length; ++i) ++perCode[codes[i]];
    perCode.forEach((n, code) => { if (binOf[code] >= 0) counts[binOf[code]] += n; });
    return counts;
}

function power(exponent: number): string {
    return exponent >= 0 && exponent < 10 ? String(2 ** exponent) : '2' + [...String(exponent)].map((c) =>
        c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]).join('');
}

/// Half octaves of numbers from 2^-20 to 1, by the codes of error / bound.
export function magnitudeBins(codes: Uint8Array, title: string): CodedBins {
    const first = 121, one = 201, count = (one - first) / 2 + 2;
    const binOf = Int16Array.from({length: 256}, (_, code) => code === 0 ? 0 : Math.min(count - 1, Math.max(1, 1 + ((code - first) >> 1))));
    const low = (bin: number) => ratioOf(first + 2 * (bin - 1));
    return {codes, binOf, bins: {
        title, counts: counted(codes, binOf, count),
        label: (bin) => bin === 0 ? 'no error' : bin === 1 ? 'below ' + rounded(low(2)) : bin === count - 1 ? '1 and more'
            : `${rounded(low(bin))} to ${rounded(low(bin + 1))}`,
        tick: (bin) => bin > 0 && (bin - 1) % 8 === 0 ? power((first + 2 * (bin - 1) - one) / 4) : '',
    }};
}

/// Numbers from 0 to 1 in steps of 1/255, 32 bins.
export function byteBins(codes: Uint8Array, title: string): CodedBins {
    const count = 32, binOf = Int16Array.from({length: 256}, (_, code) => code >> 3);
    const low = (bin: number) => rounded(8 * bin / 255);
    return {codes, binOf, bins: {
        title, counts: counted(codes, binOf, count), label: (bin) => `${low(bin)} to ${bin === count - 1 ? '1' : low(bin + 1)}`,
        tick: (bin) => bin % 8 === 0 ? rounded(bin / 32) : '',
    }};
}

/// Half octaves of error / bound from 2^-20 to 2^6; the bound lies between two bins.
export function errorBins(codes: Uint8Array): CodedBins {
    const first = 121, bound = (201 - first) / 2, count = bound + 12;
    const binOf = Int16Array.from({length: 256}, (_, code) =>
        code === 0 ? -1 : Math.min(count - 1, Math.max(0, (code - first) >> 1)));
    const low = (bin: number) => rounded(ratioOf(first + 2 * bin));
    return {codes, binOf, bins: {
        title: 'Depth error / bound, candidate', counts: counted(codes, binOf, count), bound,
        label: (bin) => bin === 0 ? 'below ' + low(1) : bin === count - 1 ? 'from ' + low(bin) + ' up' : `${low(bin)} to ${low(bin + 1)}`,
        tick: (bin) => bin % 8 === 0 ? power((first + 2 * bin - 201) / 4) : '',
    }};
}

/// Half octaves of the depths' difference in ULPs.
export function ulpBins(ours: Uint32Array, theirs: Uint32Array): CodedBins {
    const codes = ulpCodes(ours, theirs), count = 66;
    const binOf = Int16Array.from({length: 256}, (_, code) => code === 255 ? count - 1 : Math.min(count - 2, code));
    const from = (bin: number) => Math.ceil(2 ** ((bin - 1) / 2));
    return {codes, binOf, bins: {
        title: 'Depths apart, ULPs', counts: counted(codes, binOf, count),
        label: (bin) => bin === 0 ? 'equal' : bin === count - 1 ? 'no number' : `${from(bin)} ULPs and more`,
        tick: (bin) => bin === 0 ? '0' : (bin - 1) % 16 === 0 ? power((bin - 1) / 2) : '',
    }};
}
