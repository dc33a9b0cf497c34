// The drawer below the panes: worst pixels, a list of classes or regions, and histograms. What is chosen of a list or
// a histogram filters the view.
import {ClassList} from './classes';
import type {ListedStyle} from './classes';
import {element} from './element';
import {selectionOf} from './filters';
import type {CodedBins} from './filters';
import {Histogram} from './histogram';
import type {Planes} from './planes';
import type {Selection} from './raster';
import type {ViewEntry} from './run';
import type {PixelDrawer, Stage} from './subject';

export type DrawerParts = {
    table: {root: HTMLElement; show(planes: Planes, match: Uint8Array | null): void};
    title: string;          // of the list
    styles: ListedStyle[];  // its rows
    counts(planes: Planes, view: ViewEntry): number[];
    remark(counts: number[]): string;
    holds(planes: Planes, kind: number): (pixel: number) => boolean;
    bins: ((planes: Planes) => Promise<CodedBins | string>)[];  // of each histogram; or why it is empty
};

const nothing = (title: string) => ({title, counts: [], label: () => '', tick: () => ''});

export class Drawer implements PixelDrawer {
    readonly note = element('span', {class: 'filter-note'});
    readonly root: HTMLElement;
    private readonly list: ClassList;
    private readonly histograms: Histogram[];
    private coded: (CodedBins | null)[] = [];

    constructor(private readonly stage: Stage, private readonly parts: DrawerParts) {
        this.list = new ClassList(parts.title, parts.styles, (kind) => this.chooseKind(kind));
        this.histograms = parts.bins.map((_, i) => new Histogram((bin) => this.chooseBin(i, bin)));
        this.root = element('div', {class: 'drawer'}, parts.table.root, this.list.root, ...this.histograms.map((h) => h.root));
    }

    /// All but the histograms, of a view without a filter.
    show(): void {
        const {planes, entry} = this.stage.current;
        this.note.textContent = '';
        if (!planes || !entry) return;
        this.parts.table.show(planes, null);
        const counts = this.parts.counts(planes, entry);
        this.list.show(counts, this.parts.remark(counts));
    }

    /// Stops as soon as other planes are open.
    async showHistograms(planes: Planes): Promise<void> {
        for (const [i, bins] of this.parts.bins.entries()) {
            const made = await bins(planes);
            if (this.stage.current.planes !== planes) return;
            this.coded[i] = typeof made === 'string' ? null : made;
            this.histograms[i].show(typeof made === 'string' ? nothing(made) : made.bins);
        }
    }

    clearFilter(): void { this.filter(null, ''); }

    /// In the colours of the theme.
    redraw(): void { for (const histogram of this.histograms) histogram.draw(); }

    private chooseBin(which: number, bin: number): void {
        const coded = this.coded[which], {planes} = this.stage.current;
        if (!coded || !planes) return;
        if (bin < 0) return this.clearFilter();
        const {codes, binOf, bins} = coded;
        this.filter(selectionOf(planes, (p) => binOf[codes[p]] === bin), `${bins.title}: ${bins.label(bin)}`, this.histograms[which]);
    }

    private chooseKind(kind: number): void {
        const {planes} = this.stage.current;
        if (!planes) return;
        if (kind < 0) return this.clearFilter();
        this.filter(selectionOf(planes, this.parts.holds(planes, kind)), this.parts.styles[kind].name, this.list);
    }

    /// Only `keep`, of the list and the histograms, goes on to show its choice.
    private filter(selection: Selection | null, words: string, keep: {clear(): void} | null = null): void {
        for (const chooser of [this.list, ...this.histograms]) if (chooser !== keep) chooser.clear();
        this.note.textContent = words && 'Only ' + words + '   (X: all)';
        this.stage.select(selection);
        const {planes} = this.stage.current;
        if (planes) this.parts.table.show(planes, selection?.match ?? null);
    }
}
