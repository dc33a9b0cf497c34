// One view of a filter study: its planes as numbers, and what is stored of single pixels.
import {channelNames} from './channels';
import type {Channels} from './channels';
import type {Header} from './container';
import {claimPlanesOf, distanceOutside} from './filter_claim';
import type {Claim, Permitted} from './filter_claim';
import type {Planes} from './planes';

/// The header of a studied view (filters/report/evidence_planes.cpp).
export type StudyHeader = Header & {
    truth: string; regions: {name: string; pixels: number}[]; methods: string[]; explain: string;
    claims?: Record<string, Claim>;  // by the picture's label
};

type Triple = [number, number, number];
type Pair = [number, number];
export type Shape = {sum: number | null; centroid: (number | null)[]; covariance: (number | null)[]};  // uu, uv, vv
export type ReadImage = {image: number; width: number; height: number; taps: number; weight: number; level: Pair | null};
export type TextureWindow = {
    column: number; row: number; width: number; height: number; block: number;  // cells of block x block texels
    colour: number[]; read: number[]; exact: number[];
};

/// As filters/report/inspection_json.cpp writes it; lengths in texels.
export type Inspection = {
    x: number; y: number; method: string; why: string; text: string; texture: Pair; factor: Triple; result: Triple;
    centre: Pair; corners: Pair[]; major: number; minor: number; direction: Pair; window?: TextureWindow; exact?: Shape;
    reading?: {taps: number[][]; taps_in_all: number; images: ReadImage[]; shape: Shape};
};

export function planesOf(method: string): string[] { return channelNames.map((c) => `method.${method}.${c}`); }

function rowOf(method: string, y: number): string { return `inspected.${method}.${y}`; }

/// Words as the floats whose bits they are.
export function asFloats(words: Uint32Array): Float32Array {
    return new Float32Array(words.buffer, words.byteOffset, words.length);
}

/// Quarter octaves from 2^-50, as in error_code.h: 0 for no number, 201 begins at 1.
export function codeOf(value: number): number {
    if (Number.isNaN(value)) return 0;
    return 1 + Math.min(254, Math.max(0, Math.floor(4 * (Math.log2(value) + 50))));
}

export class FilterView {
    regions: Uint32Array = new Uint32Array(0);
    truth: Channels | null = null;
    inspections: Inspection[] = [];
    private readonly rows = new Map<string, Inspection[]>();  // of every pixel, by the block's name
    private readonly channels = new Map<string, Channels>();
    private readonly magnitudes = new Map<string, Float32Array>();
    private readonly intervals = new Map<string, Permitted>();
    private readonly distances = new Map<string, Float32Array>();

    constructor(readonly planes: Planes) {}

    get header(): StudyHeader { return this.planes.header as StudyHeader; }

    /// Throws Error with a sentence for people where what every view has is not to be found.
    async open(): Promise<void> {
        const always = ['region', 'inspections', ...channelNames.map((c) => 'truth.' + c)];
        await this.planes.load([...always, 'half_width', 'major', 'minor', 'lod']);
        if (!always.every((name) => this.planes.has(name)))
            throw new Error('planes of it lie beside the page, in planes/, and are not found there; O opens its planes.zvp');
        this.regions = await this.planes.words('region');
        this.truth = await this.read(channelNames.map((c) => 'truth.' + c));
        this.inspections = await this.planes.json<Inspection[]>('inspections') ?? [];
    }

    /// Decodes a method's picture and what its claim permits, where they are to be found.
    async need(method: string): Promise<void> {
        const names = planesOf(method), ends = claimPlanesOf(method), hasAll = (all: string[]) => all.every((name) => this.planes.has(name));
        await this.planes.load([...names, ...ends]);
        if (!this.channels.has(method) && hasAll(names)) this.channels.set(method, await this.read(names));
        if (!this.intervals.has(method) && hasAll(ends))
            this.intervals.set(method, {least: await this.read(ends.slice(0, 3)), greatest: await this.read(ends.slice(3))});
    }

    private async read(names: string[]): Promise<Channels> {
        return await Promise.all(names.map(async (name) => asFloats(await this.planes.words(name)))) as Channels;
    }

    /// Decodes what is told of every pixel of this row, where it is to be found.
    async needRow(method: string, y: number): Promise<void> {
        const name = rowOf(method, y);
        await this.planes.load([name]);
        const told = await this.planes.json<Inspection[]>(name);
        if (told && !this.rows.has(name)) this.rows.set(name, told);
    }

    /// Is the pixel's row told, in the page or beside it?
    hasRow(method: string, y: number): boolean {
        return this.planes.has(rowOf(method, y)) || this.planes.leftOut.includes(rowOf(method, y));
    }

    /// What need() has decoded.
    picture(method: string): Channels | null { return this.channels.get(method) ?? null; }

    /// Likewise; null without a claim.
    permitted(method: string): Permitted | null { return this.intervals.get(method) ?? null; }

    /// How far every pixel lies outside what its claim permits, 0 inside; null without the picture or a claim.
    outside(method: string): Float32Array | null {
        const known = this.distances.get(method), picture = this.picture(method), permitted = this.permitted(method);
        if (known || !picture || !permitted) return known ?? null;
        const made = Float32Array.from({length: picture[0].length}, (_, p) => distanceOutside(picture, permitted, p));
        this.distances.set(method, made);
        return made;
    }

    /// |method - truth| of the worst channel at every pixel, infinite where one is no number; null without the picture.
    errors(method: string): Float32Array | null {
        const known = this.magnitudes.get(method);
        const picture = this.picture(method), truth = this.truth;
        if (known || !picture || !truth) return known ?? null;
        const made = Float32Array.from({length: truth[0].length}, (_, p) => {
            let most = 0;
            for (let c = 0; c < 3; ++c) {
                const error = Math.abs(picture[c][p] - truth[c][p]);
                most = Number.isFinite(error) ? Math.max(most, error) : Infinity;
            }
            return most;
        });
        this.magnitudes.set(method, made);
        return made;
    }

    inspection(pixel: number, method: string): Inspection | undefined {
        const x = pixel % this.planes.width, y = (pixel - x) / this.planes.width;
        const told = this.rows.get(rowOf(method, y)) ?? this.inspections;
        return told.find((one) => one.x === x && one.y === y && one.method === method);
    }

    regionsAt(pixel: number): string[] {
        return this.header.regions.filter((_, i) => this.regions[pixel] >>> i & 1).map((region) => region.name);
    }
}
