// What a pane can show of a filter study.
import type {Channels} from './channels';
import {encoded, errorPalette, fromHex, ground, noNumber, packed, viridis} from './colours';
import {claimPlanesOf} from './filter_claim';
import {asFloats, codeOf, planesOf} from './filter_view';
import type {FilterView} from './filter_view';
import type {ColourKey, Layer, Painted} from './layers';
import {rounded} from './numbers';
import type {Planes} from './planes';

/// A grey is one number.
function triple(numbers: string[]): string { return new Set(numbers).size === 1 ? numbers[0] : numbers.join(' '); }

/// How bright pictures are shown, and which errors.
export type Tone = {
    stops: number;    // of exposure, pictures are 2^stops times as bright
    octaves: number;  // the loudest error is 2^-octaves
    grey: boolean;    // errors
};

/// What is looked at, beside what, and how it is shown.
export type FilterChoice = {method: string; other: string; tone: Tone};

function pictureLayer(id: string, title: string, needs: string[], tone: Tone, channels: () => Promise<Channels | null>): Layer {
    const gain = 2 ** tone.stops;
    return {
        id, title: tone.stops ? `${title}, ${signed(tone.stops)} EV` : title, needs,
        async paint() {
            const [r, g, b] = (await channels())!;
            const at = (p: number) => Number.isFinite(r[p] + g[p] + b[p])
                ? packed(encoded(gain * r[p]), encoded(gain * g[p]), encoded(gain * b[p])) : noNumber;
            return {colour: at, text: (p) => triple([r, g, b].map((c) => rounded(c[p]))), label: (p) => rounded((r[p] + g[p] + b[p]) / 3), bits: at};
        },
    };
}

const codeOfOne = 201, shownCodes = 40;  // errors are shown over ten octaves

/// 0 to 1: how loud an error of this code is.
function loudness(code: number, tone: Tone): number {
    return Math.min(1, Math.max(0, (code - codeOfOne + shownCodes + 4 * tone.octaves) / shownCodes));
}

const greys = Uint32Array.from({length: 256}, (_, i) => packed(i, i, i));

function magnitudePalette(tone: Tone): Uint32Array {
    const colours = tone.grey ? greys : viridis;
    return Uint32Array.from({length: 256}, (_, code) => code <= 1 ? ground : colours[Math.round(255 * (0.08 + 0.92 * loudness(code, tone)))]);
}

/// From the faintest error that is told apart to the loudest.
function magnitudeKey(tone: Tone): ColourKey {
    const one = codeOfOne - 4 * tone.octaves, palette = magnitudePalette(tone);
    return {from: rounded(2 ** (-10 - tone.octaves)), colours: [40, 30, 20, 10, 0].map((below) => palette[one - below]), to: rounded(2 ** -tone.octaves)};
}

export function magnitudeCodes(errors: Float32Array): Uint8Array { return Uint8Array.from(errors, (e) => e === 0 ? 0 : codeOf(e)); }

function magnitudeLayer(view: FilterView, id: string, method: string, tone: Tone): Layer {
    const palette = magnitudePalette(tone);
    return {
        id, title: `|${method} − truth|`, needs: planesOf(method), key: magnitudeKey(tone),
        async paint() {
            await view.need(method);
            const errors = view.errors(method)!, values = magnitudeCodes(errors);
            return {colour: (p) => palette[values[p]], text: (p) => rounded(errors[p]), label: (p) => rounded(errors[p]),
                    bits: (p) => values[p], severity: {values, palette, dotted: 256}};
        },
    };
}

/// Twice how loud, and odd where the picture is too dark: so that of two errors the larger wins, of either sign.
const signedPalette = Uint32Array.from({length: 256}, (_, code) => {
    const t = Math.min(1, (code >> 1) / 81), dark = Math.round(20 + 40 * t);
    if (code < 2) return ground;
    return code & 1 ? packed(dark, Math.round(40 + 140 * t), Math.round(70 + 185 * t))
        : packed(Math.round(70 + 185 * t), Math.round(40 + 110 * t), dark);
});

function signedKey({octaves}: Tone): ColourKey {
    const by = octaves ? ` by ${rounded(2 ** -octaves)}` : '';
    return {from: 'darker' + by, colours: [163, 83, 0, 82, 162].map((code) => signedPalette[code]), to: 'brighter' + by};
}

/// The difference of the channel that is farthest off.
function worstDifference(picture: Channels, truth: Channels, p: number): number {
    let worst = 0;
    for (let c = 0; c < 3; ++c) {
        const difference = picture[c][p] - truth[c][p];
        if (!(Math.abs(difference) <= Math.abs(worst))) worst = difference;
    }
    return worst;
}

function signedLayer(view: FilterView, id: string, method: string, tone: Tone): Layer {
    return {
        id, title: `${method} − truth`, needs: planesOf(method), key: signedKey(tone),
        async paint() {
            await view.need(method);
            const picture = view.picture(method)!, truth = view.truth!;
            const at = (p: number) => worstDifference(picture, truth, p);
            const values = Uint8Array.from({length: truth[0].length}, (_, p) => {
                const difference = at(p);
                return difference === 0 ? 0 : 2 * Math.round(1 + 80 * loudness(codeOf(Math.abs(difference)), tone)) + (difference < 0 ? 1 : 0);
            });
            const signs = (p: number) => triple(picture.map((c, i) => signed(c[p] - truth[i][p])));
            return {colour: (p) => signedPalette[values[p]], text: signs, label: (p) => signed(at(p)), bits: (p) => values[p],
                    severity: {values, palette: signedPalette, dotted: 256}};
        },
    };
}

export function signed(value: number): string { return (value > 0 ? '+' : '') + rounded(value).replace('-', '−'); }

const exactTruth = packed(0x2a, 0x30, 0x38), exactCode = 1;

const ratioPalette = Uint32Array.from({length: 256}, (_, code) => code === exactCode ? exactTruth : errorPalette[code]);

/// |error| over the truth's half width. Where the truth is exact there is nothing to ask.
function ratioLayer(view: FilterView, id: string, method: string): Layer {
    return {
        id, title: `|${method} − truth| / certainty`, needs: [...planesOf(method), 'half_width'],
        async paint(planes) {
            await view.need(method);
            const errors = view.errors(method)!, half = asFloats(await planes.words('half_width'));
            const values = Uint8Array.from(errors, (e, p) => half[p] === 0 ? exactCode : Math.max(exactCode + 1, codeOf(e / half[p])));
            const words = (p: number) => half[p] === 0 ? 'exact' : rounded(errors[p] / half[p]);
            return {colour: (p) => ratioPalette[values[p]], label: words, bits: (p) => values[p],
                    text: (p) => half[p] === 0 ? 'the truth is exact' : `${words(p)}${errors[p] < 5 * half[p] ? ', not resolved' : ''}`,
                    severity: {values, palette: ratioPalette, dotted: 256}};
        },
    };
}

const leastOutside = codeOf(2 ** -26);  // of values near 1, the half of an ulp

const outsidePalette = Uint32Array.from({length: 256}, (_, code) => code === 0 ? ground
    : viridis[Math.round(255 * (0.15 + 0.85 * Math.min(1, Math.max(0, (code - leastOutside) / (codeOfOne - leastOutside)))))]);

/// How far the picture lies outside what the method that it claims to be of permits.
function outsideLayer(view: FilterView, id: string, method: string): Layer {
    return {
        id, title: `${method}: outside what ${view.header.claims?.[method]?.method} permits`, needs: claimPlanesOf(method),
        async paint() {
            await view.need(method);
            const distances = view.outside(method)!, values = magnitudeCodes(distances);
            return {colour: (p) => outsidePalette[values[p]], text: (p) => distances[p] ? `${rounded(distances[p])} outside` : 'permitted',
                    label: (p) => distances[p] ? rounded(distances[p]) : '', bits: (p) => values[p],
                    severity: {values, palette: outsidePalette, dotted: 256}};
        },
    };
}

function flipLayer(id: string, method: string): Layer {
    const plane = `method.${method}.flip`;
    return {
        id, title: `FLIP of ${method}`, needs: [plane], key: {from: '0', colours: [0, 64, 128, 192, 255].map((code) => viridis[code]), to: '1'},
        async paint(planes) {
            const values = await planes.bytes(plane), words = (p: number) => rounded(values[p] / 255);
            return {colour: (p) => viridis[values[p]], text: words, label: words, bits: (p) => values[p],
                    severity: {values, palette: viridis, dotted: 256}};
        },
    };
}

/// Numbers over their range; 0 where there is no texture.
function scaled(values: Float32Array, has: (p: number) => boolean): Painted {
    let low = Infinity, high = -Infinity;
    values.forEach((v, p) => { if (has(p) && Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); } });
    const per = 255 / (high - low || 1);
    return {
        colour: (p) => !has(p) ? ground : Number.isFinite(values[p]) ? viridis[Math.round(per * (values[p] - low))] : noNumber,
        text: (p) => has(p) ? rounded(values[p]) : 'no texture', label: (p) => has(p) ? rounded(values[p]) : '', bits: (p) => values[p],
    };
}

async function textured(planes: Planes): Promise<(p: number) => boolean> {
    const major = await planes.words('major');
    return (p) => major[p] !== 0;
}

function lodLayer(): Layer {
    return {
        id: 'lod', title: 'LOD of the footprint', needs: ['lod', 'major'],
        async paint(planes) { return scaled(asFloats(await planes.words('lod')), await textured(planes)); },
    };
}

function anisotropyLayer(): Layer {
    return {
        id: 'anisotropy', title: 'anisotropy', needs: ['major', 'minor'],
        async paint(planes) {
            const [major, minor] = await Promise.all(['major', 'minor'].map(async (name) => asFloats(await planes.words(name))));
            const has = await textured(planes), ratio = (p: number) => rounded(major[p] / minor[p]);
            const shown = scaled(Float32Array.from(major, (m, p) => Math.log2(m / minor[p])), has);
            return {...shown, text: (p) => has(p) ? `${ratio(p)}: ${rounded(major[p])} by ${rounded(minor[p])} texels` : 'no texture',
                    label: (p) => has(p) ? ratio(p) : ''};
        },
    };
}

const hues = ['#5d6670', '#98a1ab', '#e69f00', '#cc79a7', '#56b4e9', '#f0e442', '#1d4d6e', '#2673a3', '#2f9e8f', '#67b33e',
              '#c2b92d', '#e07b39', '#c8443c'];

/// The colour of the region of this place in the list.
export function regionColour(index: number): string { return hues[Math.min(index, hues.length - 1)]; }

/// A pixel has the colour of the last of its regions that is no class of angles.
function regionLayer(view: FilterView): Layer {
    return {
        id: 'region', title: 'region', needs: ['region'],
        async paint() {
            const classes = view.header.regions.filter((region) => !region.name.startsWith('angle ')).length;
            const shown = 2 ** classes - 1, palette = hues.map(fromHex);
            const last = (p: number) => 31 - Math.clz32(view.regions[p] & shown);
            return {colour: (p) => palette[Math.min(last(p), palette.length - 1)], label: (p) => view.header.regions[last(p)].name,
                    text: (p) => view.regionsAt(p).slice(1).join(', ') || 'all', bits: (p) => view.regions[p]};
        },
    };
}

/// The id of a layer that every method has.
export function tiledId(kind: 'picture' | 'error', method: string): string { return `${kind}:${method}`; }

/// Every layer of a view, the most asked for first; `offered` are the names of planes that exist, in the page or not.
export function filterLayers(view: FilterView, {method, other, tone}: FilterChoice, offered: Set<string>): Layer[] {
    const picture = (id: string, label: string) => pictureLayer(id, label, planesOf(label), tone, async () => {
        await view.need(label);
        return view.picture(label);
    });
    const layers = [
        picture('method', method), pictureLayer('truth', 'truth', ['truth.r', 'truth.g', 'truth.b'], tone, async () => view.truth),
        signedLayer(view, 'signed', method, tone), magnitudeLayer(view, 'error', method, tone), picture('other', other),
        signedLayer(view, 'other-signed', other, tone), flipLayer('flip', method), lodLayer(), anisotropyLayer(), regionLayer(view),
        outsideLayer(view, 'outside', method), ratioLayer(view, 'ratio', method), magnitudeLayer(view, 'other-error', other, tone),
        flipLayer('other-flip', other),
    ];
    const tiled = view.header.methods.flatMap((label) => [
        {...picture(tiledId('picture', label), label), group: 'pictures of all methods'},
        {...magnitudeLayer(view, tiledId('error', label), label, tone), group: 'errors of all methods'}]);
    return [...layers, ...tiled].filter((layer) => layer.needs.every((name) => offered.has(name)));
}
