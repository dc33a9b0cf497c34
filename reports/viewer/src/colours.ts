// Colours as a canvas' memory has them: 0xAABBGGRR.
import {background} from './numbers';

export function packed(r: number, g: number, b: number): number {
    return (0xff000000 | b << 16 | g << 8 | r) >>> 0;
}

export function fromHex(text: string): number {
    const n = parseInt(text.slice(1), 16);
    return packed(n >> 16, n >> 8 & 255, n & 255);
}

export function darkened(colour: number): number {
    return (0xff000000 | (colour >>> 2 & 0x3f3f3f)) >>> 0;
}

const srgb = Uint8Array.from({length: 4097}, (_, i) => {
    const light = i / 4096;
    return Math.round(255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055));
});

/// Linear light as an 8-bit sRGB code (IEC 61966-2-1).
export function encoded(light: number): number { return srgb[Math.round(4096 * Math.min(1, Math.max(0, light)))]; }

export const ground = packed(0x14, 0x16, 0x1a);
export const noNumber = packed(0xff, 0, 0xff);

function ramp(stops: number[][]): Uint32Array {
    return Uint32Array.from({length: 256}, (_, i) => {
        const t = i / 255 * (stops.length - 1), k = Math.min(stops.length - 2, Math.floor(t)), f = t - k;
        const mix = (c: number) => Math.round(stops[k][c] + f * (stops[k + 1][c] - stops[k][c]));
        return packed(mix(0), mix(1), mix(2));
    });
}

/// Viridis (van der Walt and Smith, 2015) in nine steps.
export const viridis = ramp([[68, 1, 84], [71, 45, 123], [59, 82, 139], [44, 114, 142], [33, 145, 140],
                             [40, 174, 128], [94, 201, 98], [173, 220, 48], [253, 231, 37]]);

/// Codes of error / bound (view_planes.h): blue to pale below the bound, orange and brighter from it up.
export const errorPalette = Uint32Array.from({length: 256}, (_, code) => {
    if (code === 0) return ground;
    if (code > 200) return packed(255, Math.min(230, 120 + 2 * (code - 201)), Math.min(120, 2 * (code - 201)));
    const t = Math.max(0, (code - 121) / 79);  // 20 octaves below the bound
    return packed(Math.round(24 + 150 * t * t), Math.round(34 + 170 * t), Math.round(52 + 150 * Math.sqrt(t)));
});

function channel(hue: number, saturation: number, value: number, shift: number): number {
    const k = (shift + 6 * hue) % 6;
    return Math.round(255 * value * (1 - saturation * Math.max(0, Math.min(1, k, 4 - k))));
}

/// The colour of an id, the same as in the report's pictures (reports/pictures.cpp).
export function idColour(id: number): number {
    if (id === background) return ground;
    let h = (id + 1) >>> 0;
    h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
    h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
    h = (h ^ (h >>> 16)) >>> 0;
    const hue = (h & 0xffff) / 65536, saturation = 0.35 + 0.3 * (h >>> 16 & 255) / 255;
    const value = 0.6 + 0.38 * (h >>> 24) / 255;
    return packed(channel(hue, saturation, value, 5), channel(hue, saturation, value, 3),
                  channel(hue, saturation, value, 1));
}

export function cssOf(colour: number): string {
    return `rgb(${colour & 255} ${colour >>> 8 & 255} ${colour >>> 16 & 255})`;
}
