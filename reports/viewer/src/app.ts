// The viewer as a whole: its parts, and which view they show.
import {Address} from './address';
import {checkPlanes} from './check';
import type {Container} from './container';
import {Crosshair} from './crosshair';
import {element, replaceChildren} from './element';
import {FileIntake} from './files';
import {Help} from './help';
import {Library} from './library';
import {readLinkTarget} from './link';
import type {LinkTarget} from './link';
import {Look} from './look';
import {Notice} from './notice';
import {OpenView} from './open_view';
import {Panes} from './panes';
import type {Planes} from './planes';
import type {ViewEntry} from './run';
import {SceneList} from './scenes';
import type {Stage, Subject} from './subject';
import {toggleTheme} from './theme';

export class App {
    readonly root = element('div', {id: 'viewer', hidden: true});
    readonly title = element('h1');
    readonly help: Help;
    readonly notice = new Notice();
    readonly panes: Panes;
    readonly subject: Subject;
    readonly list: SceneList;
    readonly crosshair: Crosshair;
    readonly files: FileIntake;
    private readonly current: OpenView;
    private readonly address: Address;
    private readonly library = new Library();
    private opening = 0;
    private completing = 0;

    /// `firstLayers`: what the panes show before somebody chooses.
    constructor(private readonly views: ViewEntry[], firstLayers: string[], subjectOf: (stage: Stage) => Subject) {
        const current = this.current = new OpenView(views);
        this.panes = new Panes(firstLayers, () => this.crosshair.moved());
        this.subject = subjectOf({
            current, notice: this.notice, go: (pixel) => this.crosshair.go(pixel), link: () => this.address.link(),
            select: (selection) => {
                current.selection = selection;
                this.panes.select(selection);
            },
            relayer: () => void this.relayer(), tile: (layers) => void this.panes.tile(layers),
        });
        this.help = new Help(this.subject.keys.map(([name, meaning]) => [name, meaning]));
        this.address = new Address(current, this.panes, () => this.isOpen, () => this.subject.place());
        this.crosshair = new Crosshair(current, this.panes, this.subject.inspector, (x, y) => {
            this.root.dataset.pixel = `${x},${y}`;
            this.address.remember();
        });
        this.list = new SceneList(views, this.subject.entries, (index) => void this.open(index));
        this.files = new FileIntake((container, name) => this.take(container, name), (text) => this.notice.tell(text));
    }

    get isOpen(): boolean { return !this.root.hidden; }

    /// Goes where the address says; without a place in it, nowhere.
    async follow(): Promise<void> {
        const place = readLinkTarget(location.hash);
        if (!place) {
            if (this.isOpen && location.hash) this.close();
            return;
        }
        const index = this.views.findIndex((view) => view.link === place.view);
        if (index < 0) return this.notice.tell(`This page has no view "${place.view}".`);
        await this.open(index, place);
    }

    /// Shows the viewer, and in it a view; of several calls the last one wins.
    private async open(index: number, place: LinkTarget | null = null): Promise<void> {
        const view = this.views[index];
        if (!view) return;
        this.root.hidden = false;
        document.body.classList.add('viewing');
        try {
            await this.reach(view, index, place);
        } catch (error) {
            this.notice.tell(`${view.scene}/${view.view} cannot be shown: ${error instanceof Error ? error.message : error}`);
        }
    }

    private async reach(view: ViewEntry, index: number, place: LinkTarget | null): Promise<void> {
        const ticket = ++this.opening;
        performance.mark('open');
        if (index !== this.current.index || !this.current.planes) {
            const planes = await this.library.get(view);
            if (ticket !== this.opening) return;
            await this.show(view, index, planes);
            if (ticket !== this.opening) return;
        }
        if (place) this.goTo(place);
        this.address.remember();
        requestAnimationFrame(() => setTimeout(() => {
            performance.measure('open view', 'open');
            this.root.dataset.view = view.link;
        }));
    }

    private async show(view: ViewEntry, index: number, planes: Planes | null): Promise<void> {
        const {current} = this;
        current.index = index;
        current.planes = planes;
        current.look = new Look(planes ?? view);  // without the pixel of the view before
        current.selection = null;
        delete this.root.dataset.view;
        this.list.setCurrent(index);
        replaceChildren(this.title, view.scene + ' ', element('span', {class: 'quiet'}, view.view), ' ',
            element('span', {class: 'fine'}, this.subject.facts(view)));
        this.root.classList.toggle('empty', !planes);
        this.subject.inspector.show(null, -1, -1);
        if (planes) await this.subject.open(planes);
        this.subject.drawer.show();
        if (!planes) return this.notice.tell(view.message || 'This page holds no planes of this view' +
            (view.planes ? `: they are in ${view.folder}/planes.zvp, which O opens.` : '.'));
        current.look.fit(this.panes.size);
        await Promise.all([
            this.panes.open(planes, this.subject.layers(planes), current.look),
            ...this.subject.atOnce(planes).filter((name) => planes.has(name)).map((name) => planes.plane(name)),
        ]);
        const ticket = ++this.completing;
        setTimeout(() => { if (ticket === this.completing) void this.showRest(planes, view); }, 30);
    }

    /// What takes longer: histograms, and what else the inspector shows.
    private async showRest(planes: Planes, view: ViewEntry): Promise<void> {
        const ticket = ++this.completing, stale = () => ticket !== this.completing || this.current.planes !== planes;
        await this.subject.drawer.showHistograms(planes);
        if (stale()) return;
        for (const name of this.subject.later(planes)) await planes.plane(name);
        if (stale()) return;
        if (this.current.look.hasCross) this.crosshair.inspect();
        this.root.dataset.complete = view.link;
    }

    /// The subject's choice has changed.
    private async relayer(): Promise<void> {
        const {planes, entry, look} = this.current;
        if (!planes || !entry) return;
        const ticket = ++this.completing;
        delete this.root.dataset.complete;
        await this.subject.open(planes);
        await this.panes.setLayers(this.subject.layers(planes));
        if (ticket !== this.completing) return;
        this.subject.drawer.show();
        this.subject.drawer.clearFilter();
        if (look.hasCross) this.crosshair.moved();
        this.address.remember();
        await this.showRest(planes, entry);
    }

    close(): void {
        const anchor = this.current.entry?.anchor;
        this.root.hidden = true;
        document.body.classList.remove('viewing');
        location.replace('#' + (anchor ?? ''));  // whoever shows sections listens to the address
    }

    /// The viewer where the summary is, and the other way round.
    toggle(): void {
        if (this.isOpen) this.close();
        else void this.openAgain();
    }

    private openAgain(): Promise<void> { return this.open(Math.max(0, this.current.index)); }

    async openBeside(step: number): Promise<void> {
        const shown = this.list.visible(), at = shown.indexOf(this.current.index);
        const next = shown[(at + step + shown.length) % shown.length];
        if (next !== undefined) await this.open(next);
    }

    /// Opens the viewer first where it is not open.
    async next(direction: 1 | -1): Promise<void> {
        if (!this.isOpen || !this.current.planes) await this.openAgain();
        this.subject.walk.toNext(direction);
    }

    private take(container: Container, name: string): void {
        const {scene, view, width, height} = container.header;
        const index = this.views.findIndex((v) => v.scene === scene && v.view === view && v.width === width && v.height === height);
        if (index < 0) return this.notice.tell(`${name} is of ${scene}/${view}, ${width} × ${height}, which this page does not have.`);
        this.library.put(this.views[index], container);
        this.current.planes = null;
        void this.open(index);
        this.notice.tell(`${name}: all planes of ${scene}/${view}.`);
    }

    private goTo(place: LinkTarget): void {
        const {planes, look} = this.current;
        if (!planes) return;
        this.subject.follow(place);
        if (place.layers) void this.panes.tile(place.layers);
        if (place.x === undefined || place.y === undefined) return;
        if (place.x >= planes.width || place.y >= planes.height)
            return this.notice.tell(`Pixel ${place.x}, ${place.y} lies outside this view.`);
        if (place.zoom) look.zoomBy(place.zoom / look.zoom);
        this.crosshair.go(place.y * planes.width + place.x);
    }

    switchTheme(): void {
        toggleTheme();
        this.panes.redraw();
        this.subject.drawer.redraw();
    }

    async check(): Promise<void> {
        const {planes} = this.current;
        if (planes) this.root.dataset.digests = JSON.stringify(await checkPlanes(planes, this.notice));
    }
}
