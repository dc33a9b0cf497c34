// One view of a filter study: its planes as numbers, and what is stored of single pixels.
import type {Header} from './container';
import type {Planes} from './planes';

/// Of a studied view (reports/filters/evidence_planes.cpp).
export type StudyHeader = Header & {
    truth: string; regions: {name: string; pixels: number}[]; methods: string[]; explain: string;
};

type Triple = [number, number, number];
type Pair = [number, number];
export type Shape = {sum: number | null; centroid: (number | null)[]; covariance: (number | null)[]};  // uu, uv, vv
export type ReadImage = {image: number; width: number; height: number; taps: number; weight: number; level: Pair | null};
export type TextureWindow = {
    column: number; row: number; width: number; height: number; block: number;  // cells of block x block texels
    colour: number[]; read: number[]; exact: number[];
};

/// As reports/filters/inspection_json.cpp writes it; lengths in texels.
export type Inspection = {
    x: number; y: number; method: string; why: string; text: string; texture: Pair; factor: Triple; result: Triple;
    centre: Pair; corners: Pair[]; major: number; minor: number; direction: Pair; window?: TextureWindow; exact?: Shape;
    reading?: {taps: number[][]; taps_in_all: number; images: ReadImage[]; shape: Shape};
};

export type Channels = [Float32Array, Float32Array, Float32Array];

export const channelNames = ['r', 'g', 'b'] as const;

export function planesOf(method: string): string[] { return channelNames.map((c) => `method.${method}.${c}`); }

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
    private readonly channels = new Map<string, Channels>();
    private readonly magnitudes = new Map<string, Float32Array>();

    constructor(readonly planes: Planes) {}

    get header(): StudyHeader { return this.planes.header as StudyHeader; }

    async open(): Promise<void> {
        this.regions = await this.planes.words('region');
        this.truth = await this.read(channelNames.map((c) => 'truth.' + c));
        this.inspections = await this.planes.json<Inspection[]>('inspections') ?? [];
    }

    /// Decodes a method's picture, where the page holds it.
    async need(method: string): Promise<void> {
        const names = planesOf(method);
        if (!this.channels.has(method) && names.every((name) => this.planes.has(name)))
            this.channels.set(method, await this.read(names));
    }

    private async read(names: string[]): Promise<Channels> {
        return await Promise.all(names.map(async (name) => asFloats(await this.planes.words(name)))) as Channels;
    }

    /// What need() has decoded.
    picture(method: string): Channels | null { return this.channels.get(method) ?? null; }

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
        return this.inspections.find((one) => one.x === x && one.y === y && one.method === method);
    }

    regionsAt(pixel: number): string[] {
        return this.header.regions.filter((_, i) => this.regions[pixel] >>> i & 1).map((region) => region.name);
    }
}
