// What a pane can show: each layer turns planes of a view into colours, and one pixel into words.
import {errorPalette, fromHex, ground, idColour, noNumber, packed, viridis} from './colours';
import {MaxChain} from './mips';
import {floatOf, idText, rounded, shortestFloat, ulpsBetween} from './numbers';
import type {Planes} from './planes';
import type {ClassStyle} from './run';

/// Byte per pixel; minified by its maximum, since greater is worse.
export type Severity = {values: Uint8Array; palette: Uint32Array; dotted: number};  // dotted: from this value up

export type Painted = {
    colour(pixel: number): number;
    text(pixel: number): string;   // for the pane's head
    label(pixel: number): string;  // as short as fits into an enlarged pixel
    bits(pixel: number): number;   // equal for two layers where they show the same
    severity?: Severity;
    outlines?: Uint32Array;        // ids whose borders are drawn as lines
};

/// What the colours of a layer mean, from one end to the other.
export type ColourKey = {from: string; colours: number[]; to: string};

export type Layer = {
    id: string; title: string; key?: ColourKey;
    group?: string;  // in the list of layers
    needs: string[];  // names of planes
    paint(planes: Planes): Promise<Painted>;
};

/// Ratio at the lower end of an error code.
export function ratioOf(code: number): number {
    return code <= 1 ? 0 : 2 ** ((code - 201) / 4);
}

function classLayer(classes: ClassStyle[]): Layer {
    const palette = Uint32Array.from(classes, (c) => fromHex(c.colour));
    return {
        id: 'class', title: 'class', needs: ['class'],
        async paint(planes) {
            const values = planes.classes;
            return {
                colour: (p) => palette[values[p]],
                text: (p) => `${classes[values[p]].glyph} ${classes[values[p]].name}`,
                label: (p) => values[p] ? classes[values[p]].glyph : '',
                bits: (p) => values[p],
                severity: {values, palette, dotted: classes.findIndex((c) => !c.passes)},
            };
        },
    };
}

function idLayer(plane: string, title: string): Layer {
    return {
        id: plane, title, needs: [plane],
        async paint(planes) {
            const ids = await planes.words(plane);
            let last = ids[0], colour = idColour(last);
            const colourOf = (id: number) => id === last ? colour : (last = id, colour = idColour(id));
            return {colour: (p) => colourOf(ids[p]), text: (p) => idText(ids[p]),
                    label: (p) => ids[p] === 0xffffffff ? '–' : String(ids[p]), bits: (p) => ids[p]};
        },
    };
}

function wireframeLayer(): Layer {
    const plain = packed(0x1d, 0x21, 0x28), line = packed(0xb8, 0xc4, 0xd0);
    return {
        id: 'wireframe', title: 'wireframe: borders of ids', needs: ['candidate.id'],
        async paint(planes) {
            const ids = await planes.words('candidate.id'), width = planes.width;
            const isBorder = (p: number) =>
                ids[p] !== ids[p + 1] && (p + 1) % width !== 0 || p + width < ids.length && ids[p] !== ids[p + width];
            return {colour: (p) => isBorder(p) ? line : plain, text: (p) => idText(ids[p]),
                    label: () => '', bits: (p) => ids[p], outlines: ids};
        },
    };
}

/// Logarithm over the range of finite positive depths, near bright.
function tones(depths: Uint32Array): Uint8Array {
    let low = Infinity, high = 0;
    const floats = new Float32Array(depths.buffer, depths.byteOffset, depths.length);
    for (const z of floats) if (z > 0 && z < Infinity) { if (z < low) low = z; if (z > high) high = z; }
    const from = Math.log(high), per = 254 / (Math.log(high) - Math.log(low) || 1);
    const out = new Uint8Array(depths.length);
    for (let i = 0; i < out.length; ++i) {
        const z = floats[i];
        out[i] = z > 0 && z < Infinity ? 1 + per * (from - Math.log(z)) : 0;
    }
    return out;
}

function depthLayer(plane: string, title: string): Layer {
    return {
        id: plane, title, needs: [plane], key: {from: 'far', colours: [...viridis.filter((_, i) => i % 32 === 1)], to: 'near'},
        async paint(planes) {
            const bits = await planes.words(plane), tone = tones(bits);
            return {
                colour: (p) => tone[p] ? viridis[tone[p]] : bits[p] === 0x7f800000 ? ground : noNumber,
                text: (p) => shortestFloat(floatOf(bits[p])),
                label: (p) => rounded(floatOf(bits[p])),
                bits: (p) => bits[p],
            };
        },
    };
}

/// From a thousandth of the bound over the bound itself, where the hue changes, to a thousand times it.
const errorKey: ColourKey = {
    from: '1/1000', colours: [161, 180, 200, 201, 221, 241].map((code) => errorPalette[code]), to: '1000 × the bound'};

function errorLayer(plane: string, title: string): Layer {
    return {
        id: plane, title, needs: [plane], key: errorKey,
        async paint(planes) {
            const values = await planes.bytes(plane);
            const words = (code: number) => code === 0 ? '–' : code === 1 ? '0' : '≥ ' + rounded(ratioOf(code));
            return {colour: (p) => errorPalette[values[p]], text: (p) => words(values[p]),
                    label: (p) => values[p] > 1 ? rounded(ratioOf(values[p])) : words(values[p]),
                    bits: (p) => values[p], severity: {values, palette: errorPalette, dotted: 256}};
        },
    };
}

/// 0 where equal, else 1 + twice the logarithm, so that 1 ULP is 1; 255 where one of them is NaN.
export function ulpCodes(a: Uint32Array, b: Uint32Array): Uint8Array {
    const codes = new Uint8Array(a.length);
    for (let i = 0; i < codes.length; ++i) {
        if (a[i] === b[i]) continue;
        const ulps = Math.abs(ulpsBetween(a[i], b[i]));
        codes[i] = Number.isNaN(ulps) ? 255 : Math.min(254, 1 + Math.floor(2 * Math.log2(ulps)));
    }
    return codes;
}

const ulpPalette = Uint32Array.from({length: 256}, (_, code) =>
    code === 0 ? ground : code === 255 ? noNumber : viridis[Math.min(255, 60 + 4 * code)]);

function ulpLayer(): Layer {
    return {
        id: 'ulps', title: 'depth: reference less candidate, ULPs', needs: ['candidate.depth', 'reference.depth'],
        key: {from: '1', colours: [1, 13, 25, 37, 49].map((code) => ulpPalette[code]), to: '2²⁴ ULPs'},
        async paint(planes) {
            const [ours, theirs] =
                await Promise.all([planes.words('candidate.depth'), planes.words('reference.depth')]);
            const values = ulpCodes(ours, theirs);
            const ulps = (p: number) => String(ulpsBetween(ours[p], theirs[p]));
            return {colour: (p) => ulpPalette[values[p]], text: (p) => ulps(p) + ' ULPs', label: ulps,
                    bits: (p) => ulpsBetween(ours[p], theirs[p]),
                    severity: {values, palette: ulpPalette, dotted: 256}};
        },
    };
}

function colourLayer(plane: string, title: string): Layer {
    return {
        id: plane, title, needs: [plane],
        async paint(planes) {
            const values = await planes.bytes(plane), count = values.length / 3;
            const at = (p: number) => packed(values[p], values[count + p], values[2 * count + p]);
            const words = (p: number) => `${values[p]} ${values[count + p]} ${values[2 * count + p]}`;
            return {colour: at, text: (p) => words(p) + ' (sRGB)', label: () => '', bits: at};
        },
    };
}

/// Every layer of a view, the most asked for first. `offered` are the names of planes that exist, in the page or not.
export function layersOf(classes: ClassStyle[], offered: Set<string>, oracles: string[]): Layer[] {
    const layers = [
        classLayer(classes), errorLayer('candidate.error', 'depth error / bound, candidate'),
        idLayer('candidate.id', 'candidate id'), idLayer('reference.id', 'reference id'),
        depthLayer('candidate.depth', 'candidate depth'), depthLayer('reference.depth', 'reference depth'),
        ulpLayer(), wireframeLayer(), colourLayer('candidate.colour', 'colour'),
        errorLayer('reference.error', 'depth error / bound, reference'),
    ];
    for (const name of oracles)
        layers.push(idLayer(`oracle.${name}.id`, `${name} id`), depthLayer(`oracle.${name}.depth`, `${name} depth`),
                    colourLayer(`oracle.${name}.colour`, `${name} colour`));
    return layers.filter((layer) => layer.needs.every((name) => offered.has(name)));
}

/// Where two layers differ: black where they do not.
export function difference(a: Painted, b: Painted): Painted {
    const differ = (p: number) => a.bits(p) !== b.bits(p);
    const bright = packed(0xf0, 0xe4, 0x42);
    return {colour: (p) => differ(p) ? bright : ground, text: (p) => differ(p) ? 'differ' : 'same',
            label: (p) => differ(p) ? '≠' : '', bits: (p) => Number(differ(p))};
}

/// Only the pixels of a selection: what is not selected is 0, everything else one more than before.
export function selected(severity: Severity, match: Uint8Array): Severity {
    const values = new Uint8Array(match.length), palette = new Uint32Array(257);
    for (let i = 0; i < values.length; ++i) values[i] = match[i] ? Math.min(255, severity.values[i] + 1) : 0;
    palette[0] = packed(0x0c, 0x0d, 0x10);
    palette.set(severity.palette, 1);
    palette[1] = packed(0x8f, 0x9b, 0xa8);
    return {values, palette, dotted: severity.dotted + 1};
}

export function chainOf(severity: Severity, planes: Planes): MaxChain {
    return new MaxChain(severity.values, planes.width, planes.height);
}
