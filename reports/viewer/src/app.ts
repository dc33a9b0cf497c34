// The viewer as a whole: what is open, and who is told when that changes.
import {bindKeys} from './bindings';
import {ClassList} from './classes';
import {checksum} from './coding';
import type {Container} from './container';
import {append, element, replaceChildren} from './element';
import {FileIntake} from './files';
import {errorBins, selectionOf, ulpBins} from './filters';
import type {CodedBins} from './filters';
import {makeHelp} from './help';
import {Histogram} from './histogram';
import {Inspector} from './inspector';
import {layersOf} from './layers';
import {Library} from './library';
import {hashOf, readPlace} from './link';
import type {Place} from './link';
import {Look} from './look';
import {counted, grouped} from './numbers';
import {Panes} from './panes';
import type {Planes} from './planes';
import type {Selection} from './raster';
import type {Run, ViewEntry} from './run';
import {SceneList} from './scenes';
import {toggleTheme} from './theme';
import {bySeverity, nextPixel} from './walk';
import {WorstTable} from './worst';

const pixelZoom = 36, shownAtOnce = ['candidate.id', 'reference.id', 'candidate.error'];

export class App {
    private readonly library = new Library();
    private readonly panes = new Panes(() => this.crossMoved());
    private readonly inspector: Inspector;
    private readonly list: SceneList;
    private readonly worst: WorstTable;
    private readonly errors = new Histogram((bin) => this.filterBy('errors', bin));
    private readonly ulps = new Histogram((bin) => this.filterBy('ulps', bin));
    private readonly classes: ClassList;
    private readonly title = element('h1');
    private readonly notice = element('p', {class: 'notice', role: 'status', hidden: true});
    private readonly filterNote = element('span', {class: 'filter-note'});
    private readonly help = makeHelp();
    private readonly files: FileIntake;
    private readonly root: HTMLElement;
    private readonly coded: {errors?: CodedBins; ulps?: CodedBins} = {};
    private index = -1;
    private planes: Planes | null = null;
    private look = new Look({width: 1, height: 1});
    private selection: Selection | null = null;
    private severity: number[] | null = null;
    private noticeTimer = 0;
    private addressTimer = 0;
    private opening = 0;

    constructor(private readonly run: Run) {
        this.inspector = new Inspector(run.classes, (text, what) => void this.copy(text, what),
            () => this.address(), () => this.nextStory());
        this.list = new SceneList(run, (index) => void this.open(index));
        this.classes = new ClassList(run.classes, (kind) => this.filterByClass(kind));
        this.worst = new WorstTable(run.classes, (pixel) => this.go(pixel));
        this.files = new FileIntake((container, name) => this.take(container, name), (text) => this.tell(text));
        this.root = this.build();
        append(document.body, [this.root, this.help]);
        window.addEventListener('hashchange', () => void this.follow());
        bindKeys(this);
    }

    private build(): HTMLElement {
        const button = (text: string, title: string, act: () => void) =>
            element('button', {type: 'button', title, onclick: act}, text);
        return element('div', {id: 'viewer', hidden: true},
            element('header', {class: 'bar'},
                button('← Summary', 'back to the written report (V)', () => this.close()), this.title, this.filterNote,
                element('span', {class: 'spring'}),
                button('Panes', '2, 3 or 4 panes (M)', () => this.cyclePanes()),
                button('Fit', 'the whole view (0)', () => this.fit()),
                button('Open…', 'planes.zvp from disk (O)', () => this.askForFile()),
                button('◐', 'light or dark (T)', () => this.switchTheme()),
                button('?', 'keys (?)', () => this.toggleHelp())),
            this.list.root,
            element('main', {class: 'stage'}, this.panes.root,
                element('div', {class: 'drawer'}, this.worst.root, this.classes.root, this.errors.root, this.ulps.root)),
            this.inspector.root, this.notice);
    }

    get isOpen(): boolean { return !this.root.hidden; }

    // --- what is open ---------------------------------------------------------------------------------------

    /// Goes where the address says; without a place in it, nowhere.
    async follow(): Promise<void> {
        const place = readPlace(location.hash);
        if (!place) {
            if (!this.root.hidden && location.hash) this.close();
            return;
        }
        const index = this.run.views.findIndex((view) => view.link === place.view);
        if (index < 0) return this.tell(`This report has no view "${place.view}".`);
        await this.open(index, place);
    }

    async open(index: number, place: Place | null = null): Promise<void> {
        const view = this.run.views[index];
        if (!view) return;
        this.reveal();
        try {
            await this.reach(view, index, place);
        } catch (error) {
            this.tell(`${view.scene}/${view.view} cannot be shown: ${error instanceof Error ? error.message : error}`);
        }
    }

    private async reach(view: ViewEntry, index: number, place: Place | null): Promise<void> {
        const ticket = ++this.opening;
        performance.mark('open');
        if (index !== this.index || !this.planes) {
            const planes = await this.library.get(view);
            if (ticket !== this.opening) return;
            await this.show(index, planes);
            if (ticket !== this.opening) return;
        }
        if (place) this.goTo(place);
        this.remember();
        requestAnimationFrame(() => setTimeout(() => {
            performance.measure('open view', 'open');
            this.root.dataset.view = view.link;
        }));
    }

    private async show(index: number, planes: Planes | null): Promise<void> {
        const view = this.run.views[index];
        this.index = index;
        this.planes = planes;
        this.selection = this.severity = null;
        delete this.root.dataset.view;
        this.list.setCurrent(index);
        replaceChildren(this.title, view.scene + ' ', element('span', {class: 'quiet'}, view.view), ' ',
            element('span', {class: 'fine'}, `${view.candidate} against ${view.reference}, ${view.width} × ${view.height}, ${counted(view.triangles, 'triangle')}`));
        this.filterNote.textContent = '';
        this.root.classList.toggle('empty', !planes);
        this.inspector.show(null, -1, -1);
        if (!planes) return this.tell(view.message || 'This page holds no planes of this view.');
        this.look = new Look(planes);
        this.look.fit(this.panes.size);
        const offered = new Set([...planes.names(), ...view.leftOut]);
        this.worst.show(planes, null);
        this.classes.show(view.counts);
        await Promise.all([
            this.panes.open(planes, layersOf(this.run.classes, offered, planes.header.witnesses), this.look),
            ...shownAtOnce.filter((name) => planes.has(name)).map((name) => planes.plane(name)),
        ]);
        setTimeout(() => void this.showRest(planes), 30);
    }

    /// What takes longer: histograms, and the depths that the inspector shows.
    private async showRest(planes: Planes): Promise<void> {
        const fresh = () => this.planes === planes;
        const empty = (title: string) => ({title, counts: [], label: () => '', tick: () => ''});
        const codes = planes.has('candidate.error') ? await planes.bytes('candidate.error') : null;
        if (!fresh()) return;
        this.coded.errors = codes ? errorBins(codes) : undefined;
        this.errors.show(this.coded.errors?.bins ?? empty('Depth error / bound: not in this page'));
        const depths = planes.has('candidate.depth') && planes.has('reference.depth')
            ? await Promise.all([planes.words('candidate.depth'), planes.words('reference.depth')]) : null;
        if (!fresh()) return;
        this.coded.ulps = depths ? ulpBins(...depths) : undefined;
        this.ulps.show(this.coded.ulps?.bins ?? empty('Depths apart: not in this page'));
        for (const name of planes.names().filter((name) => /^witness\..*\.(id|depth)$|^reference\.error$/.test(name))) await planes.plane(name);
        if (!fresh()) return;
        if (this.look.hasCross) this.inspect();
        this.root.dataset.complete = this.run.views[this.index].link;
    }

    private reveal(): void {
        this.root.hidden = false;
        document.body.classList.add('viewing');
    }

    close(): void {
        const anchor = this.run.views[this.index]?.anchor;
        this.root.hidden = true;
        document.body.classList.remove('viewing');
        history.replaceState(null, '', '#' + (anchor ?? ''));
        if (anchor) document.getElementById(anchor)?.scrollIntoView();
    }

    async openBeside(step: number): Promise<void> {
        const shown = this.list.visible(), at = shown.indexOf(this.index);
        const next = shown[(at + step + shown.length) % shown.length];
        if (next !== undefined) await this.open(next);
    }

    private take(container: Container, name: string): void {
        const {scene, view, width, height} = container.header;
        const entry = this.run.views.find((v: ViewEntry) =>
            v.scene === scene && v.view === view && v.width === width && v.height === height);
        if (!entry) return this.tell(`${name} is of ${scene}/${view}, ${width} × ${height}, which this report does not have.`);
        this.library.put(entry, container);
        this.planes = null;
        void this.open(this.run.views.indexOf(entry));
        this.tell(`${name}: all planes of ${scene}/${view}.`);
    }

    // --- where the crosshair is -----------------------------------------------------------------------------

    private goTo(place: Place): void {
        if (!this.planes) return;
        if (place.layers) place.layers.slice(0, 4).forEach((id, i) => void this.panes.setLayer(i, id));
        if (place.x === undefined || place.y === undefined) return;
        if (place.x >= this.planes.width || place.y >= this.planes.height)
            return this.tell(`Pixel ${place.x}, ${place.y} lies outside this view.`);
        if (place.zoom) this.look.zoomBy(place.zoom / this.look.zoom);
        this.go(place.y * this.planes.width + place.x);
    }

    private go(pixel: number): void {
        if (!this.planes) return;
        const x = pixel % this.planes.width, y = (pixel - x) / this.planes.width;
        this.look.setCross(x, y);
        if (this.look.isFitted || this.look.zoom < 3) this.look.zoomBy(pixelZoom / this.look.zoom);
        this.look.follow(this.panes.size);
        this.crossMoved();
    }

    step(dx: number, dy: number): void {
        if (!this.planes) return;
        const {look} = this;
        if (look.hasCross) look.setCross(look.crossX + dx, look.crossY + dy);
        else look.setCross(Math.floor(look.x), Math.floor(look.y));
        look.follow(this.panes.size);
        this.crossMoved();
    }

    private crossMoved(): void {
        this.panes.redraw();
        this.inspect();
        const {look} = this;
        this.root.dataset.pixel = `${look.crossX},${look.crossY}`;
        this.remember();
    }

    /// Keeps the address; browsers refuse too many changes of it.
    private remember(): void {
        clearTimeout(this.addressTimer);
        this.addressTimer = window.setTimeout(() => {
            if (this.isOpen) history.replaceState(null, '', hashOf(this.place(false)));
        }, 200);
    }

    private inspect(): void { this.inspector.show(this.planes, this.look.crossX, this.look.crossY); }

    private place(whole: boolean): Place {
        const {look} = this, place: Place = {view: this.run.views[this.index]?.link ?? ''};
        if (look.hasCross) Object.assign(place, {x: look.crossX, y: look.crossY});
        if (whole) Object.assign(place, {zoom: look.zoom, layers: this.panes.layerIds()});
        return place;
    }

    private address(): string { return location.href.replace(/#.*$/s, '') + hashOf(this.place(true)); }

    async nextDefect(direction: 1 | -1): Promise<void> {
        if (this.root.hidden || !this.planes) await this.open(Math.max(0, this.index));
        if (!this.planes) return;
        const fails = this.run.classes.findIndex((style) => !style.passes);
        const counts = this.run.views[this.index].counts;
        const from = this.selection ? 0 : counts.slice(fails).some((count) => count > 0) ? fails : 1;
        const step = nextPixel(this.planes, from, this.look.hasCross ? this.look.cross : -1, direction, this.selection?.match ?? null);
        if (!step) return this.tell('Both renderers agree at every pixel.');
        if (step.wrapped) this.tell('From the other end again.');
        this.go(step.pixel);
    }

    bySeverity(direction: 1 | -1): void {
        if (!this.planes) return;
        this.severity ??= bySeverity(this.planes);
        const match = this.selection?.match, order = match ? this.severity.filter((p) => match[p]) : this.severity;
        if (!order.length) return this.tell('Both renderers agree at every pixel.');
        const at = this.look.hasCross ? order.indexOf(this.look.cross) : -1;
        const next = at < 0 ? (direction > 0 ? 0 : order.length - 1) : (at + direction + order.length) % order.length;
        this.go(order[next]);
        this.tell(`Number ${grouped(next + 1)} of ${grouped(order.length)} by severity.`);
    }

    nextStory(): void {
        const planes = this.planes;
        if (!planes?.stories.length) return this.tell('No stories are stored for this view.');
        const pixels = planes.stories.map((story) => story.y * planes.width + story.x);
        this.go(pixels.find((pixel) => pixel > (this.look.hasCross ? this.look.cross : -1)) ?? pixels[0]);
    }

    // --- how it is looked at --------------------------------------------------------------------------------

    zoom(factor: number): void {
        const {look} = this;
        if (look.hasCross) look.zoomBy(factor, look.crossX + 0.5, look.crossY + 0.5);
        else look.zoomBy(factor);
        this.panes.redraw();
    }

    fit(): void {
        this.look.fit(this.panes.size);
        this.panes.redraw();
    }

    zoomToCross(): void {
        if (!this.look.hasCross || this.look.zoom >= pixelZoom) return this.fit();
        this.look.zoomBy(pixelZoom / this.look.zoom);
        this.look.follow({width: 0, height: 0});
        this.panes.redraw();
    }

    cyclePanes(): void {
        const next = this.panes.count === 4 ? 2 : this.panes.count + 1;
        void this.panes.setCount(next).then(() => { if (this.look.isFitted) this.fit(); });
    }

    activateNext(): void {
        this.panes.active = (this.panes.active + 1) % this.panes.count;
        this.panes.focusActive();
    }

    compare(way: 'wipe' | 'difference'): void {
        this.panes.comparison = this.panes.comparison === way ? 'none' : way;
        this.panes.redraw();
        this.tell(this.panes.comparison === 'none' ? 'Panes as they are.' : way === 'wipe'
            ? 'Wipe: right of the line, the neighbouring pane.' : 'Difference of neighbouring panes, in the second of each pair.');
    }

    switchTheme(): void {
        toggleTheme();
        this.panes.redraw();
        this.errors.clear();
        this.ulps.clear();
    }

    // --- what is filtered -----------------------------------------------------------------------------------

    private filterBy(which: 'errors' | 'ulps', bin: number): void {
        const coded = this.coded[which];
        if (!coded || !this.planes) return;
        if (bin < 0) return this.select(null, '');
        (which === 'errors' ? this.ulps : this.errors).clear();
        const {codes, binOf, bins} = coded;
        this.select(selectionOf(this.planes, (p) => binOf[codes[p]] === bin), `${bins.title}: ${bins.label(bin)}`, which);
    }

    private select(selection: Selection | null, words: string, keep = ''): void {
        this.selection = selection;
        if (keep !== 'errors') this.errors.clear();
        if (keep !== 'ulps') this.ulps.clear();
        this.filterNote.textContent = words && 'Only ' + words + '   (X: all)';
        if (keep !== 'classes') this.classes.clear();
        this.panes.select(selection);
        if (this.planes) this.worst.show(this.planes, selection?.match ?? null);
    }

    private filterByClass(kind: number): void {
        if (!this.planes) return;
        if (kind < 0) return this.select(null, '');
        const {classes} = this.planes;
        this.select(selectionOf(this.planes, (p) => classes[p] === kind), this.run.classes[kind].name, 'classes');
    }

    clearFilter(): void { this.select(null, ''); }

    // --- small talk -----------------------------------------------------------------------------------------

    copyLink(): void { void this.copy(this.address(), 'link'); }

    copyCommand(): void {
        const text = this.inspector.root.querySelector('.command code')?.textContent;
        if (text) void this.copy(text, 'command');
    }

    askForFile(): void { this.files.ask(); }

    toggleHelp(): void { if (this.help.open) this.help.close(); else this.help.showModal(); }

    search(): void { this.list.search.focus(); }

    showLayer(n: number): void { this.panes.choose(n); }

    flip(held: boolean): void { this.panes.force(held ? 'flip' : null); }

    moveWipe(by: number): void { this.panes.moveWipe(by); }

    /// The viewer where the summary is, and the other way round.
    toggle(): void {
        if (this.isOpen) this.close();
        else void this.open(Math.max(0, this.index));
    }

    /// Decodes all planes and holds them against the digests of what was written.
    async check(): Promise<void> {
        const planes = this.planes, digests: Record<string, number> = {}, bad: string[] = [];
        if (!planes) return;
        for (const name of planes.names().filter((name) => planes.digest(name) !== undefined)) {
            digests[name] = checksum(await planes.plane(name));
            if (digests[name] !== planes.digest(name)) bad.push(name);
        }
        this.root.dataset.digests = JSON.stringify(digests);
        this.tell(bad.length ? 'Not what was written: ' + bad.join(', ') + '!'
                             : `${counted(Object.keys(digests).length, 'plane')}: every bit is what was written.`);
    }

    private async copy(text: string, what: string): Promise<void> {
        try {
            await navigator.clipboard.writeText(text);
            this.tell(`The ${what} is in the clipboard.`);
        } catch {
            this.tell(text);
        }
    }

    private tell(text: string): void {
        this.notice.textContent = text;
        this.notice.hidden = false;
        clearTimeout(this.noticeTimer);
        this.noticeTimer = window.setTimeout(() => { this.notice.hidden = true; }, 6000);
    }
}
