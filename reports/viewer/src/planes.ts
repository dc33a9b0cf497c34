// The planes of one view: decoded when first asked for, and kept.
import {beside, doublesFrom, fromChannels, fromLeft, fromPlanar, fromRuns, inflated, sparse} from './coding';
import type {Container, Header, JudgedHeader} from './container';
import {containerIn} from './scripts_beside';
import type {Story, TriangleRange} from './story';

export type Findings = {
    count: number; all: number;  // listed, and in the view
    pixel: Uint32Array; candidate: Uint32Array; reference: Uint32Array;
    candidateDepth: Uint32Array; referenceDepth: Uint32Array;
    eps: Float64Array; low: Float64Array; truth: Float64Array; high: Float64Array; error: Float64Array;
};

type Made = Uint8Array | Uint32Array;

export class Planes {
    private readonly made = new Map<string, Promise<Made>>();
    private readonly ready = new Map<string, Made>();
    private readonly known = new Map<number, number>();  // pixel -> row of findings
    private readonly told = new Map<number, Story>();
    private readonly loading = new Map<string, Promise<void>>();  // by the script's file
    classes: Uint8Array = new Uint8Array(0);
    findings: Findings | null = null;
    stories: Story[] = [];
    ranges: TriangleRange[] = [];

    constructor(private readonly container: Container) {}

    get header(): Header { return this.container.header; }
    /// The header of a judged view; another has none.
    get judged(): JudgedHeader { return this.container.header as JudgedHeader; }
    get width(): number { return this.header.width; }
    get height(): number { return this.header.height; }
    get pixelCount(): number { return this.width * this.height; }
    /// Names of what the page does not hold of it.
    get leftOut(): string[] { return this.header.leftOut ?? []; }
    names(): string[] { return [...this.container.blocks.keys()].filter((name) => this.has(name)); }
    /// Loads what lies beside the page of these. What is not found there is left out.
    async load(names: string[]): Promise<void> {
        const beside = Object.entries(this.header.scripts ?? {}).filter(([, blocks]) => blocks.some((name) => names.includes(name)));
        await Promise.all(beside.map(([file]) => {
            if (!this.loading.has(file)) this.loading.set(file, this.take(file));
            return this.loading.get(file);
        }));
    }

    private async take(file: string): Promise<void> {
        const container = await containerIn(file);
        for (const [name, block] of container?.blocks ?? []) this.container.blocks.set(name, block);
    }

    /// Can it be decoded?
    has(name: string): boolean {
        const block = this.container.blocks.get(name);
        return block !== undefined && (!block.facts.beside || this.has(block.facts.beside));
    }

    /// What every judged view has: classes, findings, stories and names.
    async open(): Promise<void> {
        const [classes, findings, stories, ranges] = await Promise.all([
            this.has('class') ? this.bytes('class') : new Uint8Array(0), this.readFindings(), this.json<Story[]>('stories'),
            this.json<TriangleRange[]>('ranges'),
        ]);
        this.classes = classes;
        this.findings = findings;
        this.stories = stories ?? [];
        this.ranges = ranges ?? [];
        for (const story of this.stories) this.told.set(story.y * this.width + story.x, story);
        for (let i = 0; findings && i < findings.count; ++i) this.known.set(findings.pixel[i], i);
    }

    story(pixel: number): Story | undefined { return this.told.get(pixel); }
    finding(pixel: number): number | undefined { return this.known.get(pixel); }

    /// A plane that is decoded already, else null.
    now(name: string): Made | null { return this.ready.get(name) ?? null; }

    words(name: string): Promise<Uint32Array> { return this.plane(name) as Promise<Uint32Array>; }
    bytes(name: string): Promise<Uint8Array> { return this.plane(name) as Promise<Uint8Array>; }

    plane(name: string): Promise<Made> {
        let made = this.made.get(name);
        if (!made) {
            made = this.decode(name).then((plane) => {
                this.ready.set(name, plane);
                return plane;
            });
            this.made.set(name, made);
        }
        return made;
    }

    /// The digest that was taken of a plane before it was coded.
    digest(name: string): number | undefined { return this.container.blocks.get(name)?.facts.crc32; }

    private async decode(name: string): Promise<Made> {
        const block = this.container.blocks.get(name);
        if (!block) throw new Error(`the page does not hold ${name}`);
        const content = await inflated(block.content), size = this.width * this.height;
        switch (block.facts.coding) {
            case 'left': return fromLeft(content, size, this.width);
            case 'planar': return fromPlanar(content, size, this.width);
            case 'beside': return beside(content, await this.words(block.facts.beside!));
            case 'sparse': return sparse(content, block.facts.count!, await this.words(block.facts.beside!));
            case 'runs': return fromRuns(content, size);
            case 'channels': return fromChannels(content);
            default: return content;
        }
    }

    /// A block of JSON, or null where the page does not hold it.
    async json<T>(name: string): Promise<T | null> {
        const block = this.container.blocks.get(name);
        return block ? JSON.parse(new TextDecoder().decode(await inflated(block.content))) as T : null;
    }

    private async readFindings(): Promise<Findings | null> {
        const block = this.container.blocks.get('findings');
        if (!block) return null;
        const count = block.facts.count!, split = block.facts.words!;
        const [wordBytes, doubleBytes] = await Promise.all(
            [inflated(block.content.slice(0, split)), inflated(block.content.slice(split))]);
        const words = fromLeft(wordBytes, 5 * count, Math.max(count, 1)), doubles = doublesFrom(doubleBytes, 5 * count);
        const w = (k: number) => words.subarray(k * count, (k + 1) * count);
        const d = (k: number) => doubles.subarray(k * count, (k + 1) * count);
        return {
            count, all: block.facts.all!, pixel: w(0), candidate: w(1), reference: w(2), candidateDepth: w(3),
            referenceDepth: w(4), eps: d(0), low: d(1), truth: d(2), high: d(3), error: d(4),
        };
    }
}
