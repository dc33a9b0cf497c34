// The viewer's subject in filters.html: methods' pictures against the truth.
import {Drawer} from './drawer';
import {element, replaceChildren} from './element';
import {FilterInspector} from './filter_inspector';
import {filterLayers, magnitudeCodes, regionColour, tiledId} from './filter_layers';
import type {FilterChoice} from './filter_layers';
import {FilterView} from './filter_view';
import {FilterWalk} from './filter_walk';
import {RegionTable} from './filter_worst';
import {byteBins, magnitudeBins} from './filters';
import {grouped} from './numbers';
import type {Planes} from './planes';
import type {ViewEntry} from './run';
import type {EntryStyle, Stage, Subject} from './subject';

export type StudiedView = ViewEntry & {methods: string[]};

/// As filters/report/page.cpp writes it.
export type Study = {truth: string; regions: {name: string; definition: string}[]; views: StudiedView[]};

export const studyLayers = ['method', 'truth', 'signed', 'other'];

const entryStyle: EntryStyle = {
    words: (view) => `${view.scene} ${view.view}`,
    mark: () => ({text: '·', kind: 'quiet', title: 'studied'}),
    line: (view) => ({kind: 'quiet', text: `${view.width} × ${view.height}`}),
    bar: () => null,
    chips: [],
};

/// Which method is looked at, and which beside it.
class MethodChoice {
    readonly method = element('select', {class: 'method', 'aria-label': 'method'});
    readonly other = element('select', {class: 'other', 'aria-label': 'another method'});
    readonly root = element('span', {class: 'methods'}, this.method, ' beside ', this.other);
    private labels: string[] = [];

    constructor(private readonly choice: FilterChoice, private readonly onChange: () => void) {
        this.method.addEventListener('change', () => this.set(this.method.value, choice.other));
        this.other.addEventListener('change', () => this.set(choice.method, this.other.value));
    }

    /// Those of a view; what was chosen stays where the view has it.
    offer(labels: string[]): void {
        this.labels = labels;
        const kept = (label: string, instead: number) => labels.includes(label) ? label : labels[Math.min(instead, labels.length - 1)] ?? '';
        this.choice.method = kept(this.choice.method, 0);
        this.choice.other = kept(this.choice.other, 1);
        for (const select of [this.method, this.other])
            replaceChildren(select, ...labels.map((label) => element('option', {value: label}, label)));
        this.show();
    }

    /// Labels that the view does not have change nothing.
    set(method: string, other: string): void {
        const {choice, labels} = this, before = `${choice.method} ${choice.other}`;
        if (labels.includes(method)) choice.method = method;
        if (labels.includes(other)) choice.other = other;
        this.show();
        if (`${choice.method} ${choice.other}` !== before) this.onChange();
    }

    step(by: 1 | -1): void {
        const {labels, choice} = this, at = labels.indexOf(choice.method);
        if (labels.length) this.set(labels[(at + by + labels.length) % labels.length], choice.other);
    }

    swap(): void { this.set(this.choice.other, this.choice.method); }

    private show(): void {
        this.method.value = this.choice.method;
        this.other.value = this.choice.other;
    }
}

/// Keys of how pictures and errors are shown.
class ToneKeys {
    constructor(private readonly choice: FilterChoice, private readonly stage: Stage) {}

    expose(stops: number): void { this.set({stops: this.choice.tone.stops + stops}); }
    nextRange(): void { this.set({octaves: (this.choice.tone.octaves + 2) % 8}); }
    recolour(): void { this.set({grey: !this.choice.tone.grey}); }

    private set(change: Partial<FilterChoice['tone']>): void {
        this.choice.tone = {...this.choice.tone, ...change};
        this.stage.relayer();
    }
}

/// Small multiples: first the methods' pictures, then their errors, then the four panes again.
class Tiles {
    private turn = 0;

    constructor(private readonly choice: FilterChoice, private readonly stage: Stage, private readonly methods: () => string[]) {}

    next(): void {
        this.turn = (this.turn + 1) % 3;
        const labels = this.methods(), first = Math.max(0, labels.indexOf(this.choice.method));
        const turned = [...labels.slice(first), ...labels.slice(0, first)];
        this.stage.tile(this.turn === 0 ? studyLayers : turned.map((label) => tiledId(this.turn === 1 ? 'picture' : 'error', label)));
    }
}

export function filterStudyOf(study: Study, stage: Stage): Subject {
    const choice: FilterChoice = {method: '', other: '', tone: {stops: 0, octaves: 0, grey: false}};
    let open: FilterView | null = null;
    const methods = new MethodChoice(choice, () => stage.relayer());
    const tones = new ToneKeys(choice, stage), tiles = new Tiles(choice, stage, () => open?.header.methods ?? []);
    const walk = new FilterWalk(stage, choice, () => open);
    const table = new RegionTable(stage.go);
    const drawer = new Drawer(stage, {
        table: {root: table.root, show: (_, match) => { if (open) table.show(open, choice.method, match); }},
        title: 'Regions',
        styles: study.regions.map((region, i) => ({name: region.name, glyph: '', colour: regionColour(i), meaning: region.definition})),
        counts: () => open?.header.regions.map((region) => region.pixels) ?? [],
        remark: (counts) => `${grouped(counts[1] ?? 0)} pixels are interior`,
        holds: (_, kind) => (p) => (open!.regions[p] >>> kind & 1) === 1,
        bins: [
            async () => {
                const errors = open?.errors(choice.method);
                return errors ? magnitudeBins(magnitudeCodes(errors), `|${choice.method} − truth|`) : 'Error: not in this page';
            },
            async (planes) => planes.has(`method.${choice.method}.flip`)
                ? byteBins(await planes.bytes(`method.${choice.method}.flip`), `FLIP of ${choice.method}`) : 'FLIP: not in this page',
        ],
    });
    return {
        inspector: new FilterInspector(choice, (planes) => open?.planes === planes ? open : null,
            (text, what) => void stage.notice.copy(text, what), stage.link, walk),
        walk, drawer, tools: methods.root, entries: entryStyle,
        facts: (view) => `truth GT-${study.truth}, ${view.width} × ${view.height}`,
        async open(planes: Planes) {
            if (open?.planes !== planes) {
                const view = new FilterView(planes);
                await view.open();
                open = view;
                methods.offer(view.header.methods);
            }
            await Promise.all([choice.method, choice.other].map((label) => open!.need(label)));
        },
        layers: (planes) => open ? filterLayers(open, choice, new Set([...planes.names(), ...planes.leftOut])) : [],
        atOnce: () => ['half_width', 'major', 'minor', 'lod'],
        later: (planes) => [`method.${choice.method}.flip`].filter((name) => planes.has(name)),
        place: () => ({method: choice.method, other: choice.other}),
        follow: ({method = choice.method, other}) =>
            methods.set(method, other ?? (method === choice.other ? choice.method : choice.other)),
        keys: [['G / B', 'next / previous method', {g: () => methods.step(1), b: () => methods.step(-1)}],
               ['I', 'swap both methods', {i: () => methods.swap()}],
               ['F', 'all methods side by side, from this one on: pictures, errors, four panes', {f: () => tiles.next()}],
               ['( / )', 'exposure of pictures by a stop', {'(': () => tones.expose(-1), ')': () => tones.expose(1)}],
               ['R', 'range of errors: up to 1, 1/4, 1/16, 1/64', {r: () => tones.nextRange()}],
               [';', 'errors in colours or greys', {';': () => tones.recolour()}]],
    };
}
