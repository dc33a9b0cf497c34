// The drawer below the panes: worst pixels, classes and histograms. A class or a bin that is chosen filters the view.
import {ClassList} from './classes';
import {element} from './element';
import {errorBins, selectionOf, ulpBins} from './filters';
import type {CodedBins} from './filters';
import {Histogram} from './histogram';
import type {OpenView} from './open_view';
import type {Planes} from './planes';
import type {Selection} from './raster';
import type {ClassStyle} from './run';
import {WorstTable} from './worst';

type Counted = 'errors' | 'ulps';

export class Drawer {
    readonly note = element('span', {class: 'filter-note'});  // what is filtered, for the bar
    readonly root: HTMLElement;
    private readonly worst: WorstTable;
    private readonly classes: ClassList;
    private readonly errors = new Histogram((bin) => this.chooseBin('errors', bin));
    private readonly ulps = new Histogram((bin) => this.chooseBin('ulps', bin));
    private readonly coded: {[which in Counted]?: CodedBins} = {};

    constructor(private readonly current: OpenView, private readonly styles: ClassStyle[], go: (pixel: number) => void,
                private readonly onFilter: (selection: Selection | null) => void) {
        this.worst = new WorstTable(styles, go);
        this.classes = new ClassList(styles, (kind) => this.chooseClass(kind));
        this.root = element('div', {class: 'drawer'}, this.worst.root, this.classes.root, this.errors.root, this.ulps.root);
    }

    /// All but the histograms, of a view without a filter.
    show(): void {
        const {planes, entry} = this.current;
        this.note.textContent = '';
        if (!planes || !entry) return;
        this.worst.show(planes, null);
        this.classes.show(entry.counts);
    }

    /// Stops as soon as other planes are open.
    async showHistograms(planes: Planes): Promise<void> {
        const stale = () => this.current.planes !== planes;
        const empty = (title: string) => ({title, counts: [], label: () => '', tick: () => ''});
        const codes = planes.has('candidate.error') ? await planes.bytes('candidate.error') : null;
        if (stale()) return;
        this.coded.errors = codes ? errorBins(codes) : undefined;
        this.errors.show(this.coded.errors?.bins ?? empty('Depth error / bound: not in this page'));
        const depths = planes.has('candidate.depth') && planes.has('reference.depth')
            ? await Promise.all([planes.words('candidate.depth'), planes.words('reference.depth')]) : null;
        if (stale()) return;
        this.coded.ulps = depths ? ulpBins(...depths) : undefined;
        this.ulps.show(this.coded.ulps?.bins ?? empty('Depths apart: not in this page'));
    }

    clearFilter(): void { this.filter(null, ''); }

    /// In the colours of the theme.
    redraw(): void {
        this.errors.draw();
        this.ulps.draw();
    }

    private chooseBin(which: Counted, bin: number): void {
        const coded = this.coded[which], {planes} = this.current;
        if (!coded || !planes) return;
        if (bin < 0) return this.clearFilter();
        const {codes, binOf, bins} = coded;
        this.filter(selectionOf(planes, (p) => binOf[codes[p]] === bin), `${bins.title}: ${bins.label(bin)}`, which);
    }

    private chooseClass(kind: number): void {
        const {planes} = this.current;
        if (!planes) return;
        if (kind < 0) return this.clearFilter();
        this.filter(selectionOf(planes, (p) => planes.classes[p] === kind), this.styles[kind].name, 'classes');
    }

    /// Of classes and histograms, only `keep` goes on to show its choice.
    private filter(selection: Selection | null, words: string, keep: Counted | 'classes' | null = null): void {
        if (keep !== 'errors') this.errors.clear();
        if (keep !== 'ulps') this.ulps.clear();
        if (keep !== 'classes') this.classes.clear();
        this.note.textContent = words && 'Only ' + words + '   (X: all)';
        this.onFilter(selection);
        const {planes} = this.current;
        if (planes) this.worst.show(planes, selection?.match ?? null);
    }
}
