// The viewer as a whole: its parts, and which view they show.
import {Address} from './address';
import {checkPlanes} from './check';
import type {Container} from './container';
import {Crosshair} from './crosshair';
import {Drawer} from './drawer';
import {element, replaceChildren} from './element';
import {FileIntake} from './files';
import {Help} from './help';
import {Inspector} from './inspector';
import {layersOf} from './layers';
import {Library} from './library';
import {readLinkTarget} from './link';
import type {LinkTarget} from './link';
import {Look} from './look';
import {Notice} from './notice';
import {counted} from './numbers';
import {OpenView} from './open_view';
import {Panes} from './panes';
import type {Planes} from './planes';
import type {Run, ViewEntry} from './run';
import {SceneList} from './scenes';
import {toggleTheme} from './theme';
import {Walk} from './walk';

const shownAtOnce = ['candidate.id', 'reference.id', 'candidate.error'];

export class App {
    readonly root = element('div', {id: 'viewer', hidden: true});
    readonly title = element('h1');
    readonly help = new Help();
    readonly notice = new Notice();
    readonly panes = new Panes(() => this.crosshair.moved());
    readonly inspector: Inspector;
    readonly list: SceneList;
    readonly drawer: Drawer;
    readonly crosshair: Crosshair;
    readonly walk: Walk;
    readonly files: FileIntake;
    private readonly current: OpenView;
    private readonly address: Address;
    private readonly library = new Library();
    private opening = 0;

    constructor(private readonly run: Run) {
        const current = this.current = new OpenView(run);
        this.address = new Address(current, this.panes, () => this.isOpen);
        this.inspector = new Inspector(run.classes, (text, what) => void this.notice.copy(text, what),
            () => this.address.link(), () => this.walk.toStory());
        this.crosshair = new Crosshair(current, this.panes, this.inspector, (x, y) => {
            this.root.dataset.pixel = `${x},${y}`;
            this.address.remember();
        });
        this.walk = new Walk(current, run.classes, this.crosshair, this.notice);
        this.drawer = new Drawer(current, run.classes, (pixel) => this.crosshair.go(pixel), (selection) => {
            current.selection = selection;
            this.panes.select(selection);
        });
        this.list = new SceneList(run, (index) => void this.open(index));
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
        const index = this.run.views.findIndex((view) => view.link === place.view);
        if (index < 0) return this.notice.tell(`This report has no view "${place.view}".`);
        await this.open(index, place);
    }

    /// Shows the viewer, and in it a view; of several calls the last one wins.
    private async open(index: number, place: LinkTarget | null = null): Promise<void> {
        const view = this.run.views[index];
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
            element('span', {class: 'fine'}, `${view.candidate} against ${view.reference}, ${view.width} × ${view.height}, ${counted(view.triangles, 'triangle')}`));
        this.root.classList.toggle('empty', !planes);
        this.inspector.show(null, -1, -1);
        this.drawer.show();
        if (!planes) return this.notice.tell(view.message || 'This page holds no planes of this view.');
        current.look.fit(this.panes.size);
        const offered = new Set([...planes.names(), ...view.leftOut]);
        await Promise.all([
            this.panes.open(planes, layersOf(this.run.classes, offered, planes.header.oracles), current.look),
            ...shownAtOnce.filter((name) => planes.has(name)).map((name) => planes.plane(name)),
        ]);
        setTimeout(() => void this.showRest(planes, view), 30);
    }

    /// What takes longer: histograms, and the depths that the inspector shows.
    private async showRest(planes: Planes, view: ViewEntry): Promise<void> {
        const stale = () => this.current.planes !== planes;
        await this.drawer.showHistograms(planes);
        if (stale()) return;
        for (const name of planes.names().filter((name) => /^oracle\..*\.(id|depth)$|^reference\.error$/.test(name))) await planes.plane(name);
        if (stale()) return;
        if (this.current.look.hasCross) this.crosshair.inspect();
        this.root.dataset.complete = view.link;
    }

    close(): void {
        const anchor = this.current.entry?.anchor;
        this.root.hidden = true;
        document.body.classList.remove('viewing');
        history.replaceState(null, '', '#' + (anchor ?? ''));
        if (anchor) document.getElementById(anchor)?.scrollIntoView();
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
    async nextDefect(direction: 1 | -1): Promise<void> {
        if (!this.isOpen || !this.current.planes) await this.openAgain();
        this.walk.toDefect(direction);
    }

    private take(container: Container, name: string): void {
        const {scene, view, width, height} = container.header;
        const index = this.run.views.findIndex((v) => v.scene === scene && v.view === view && v.width === width && v.height === height);
        if (index < 0) return this.notice.tell(`${name} is of ${scene}/${view}, ${width} × ${height}, which this report does not have.`);
        this.library.put(this.run.views[index], container);
        this.current.planes = null;
        void this.open(index);
        this.notice.tell(`${name}: all planes of ${scene}/${view}.`);
    }

    private goTo(place: LinkTarget): void {
        const {planes, look} = this.current;
        if (!planes) return;
        if (place.layers) place.layers.slice(0, 4).forEach((id, i) => void this.panes.setLayer(i, id));
        if (place.x === undefined || place.y === undefined) return;
        if (place.x >= planes.width || place.y >= planes.height)
            return this.notice.tell(`Pixel ${place.x}, ${place.y} lies outside this view.`);
        if (place.zoom) look.zoomBy(place.zoom / look.zoom);
        this.crosshair.go(place.y * planes.width + place.x);
    }

    switchTheme(): void {
        toggleTheme();
        this.panes.redraw();
        this.drawer.redraw();
    }

    async check(): Promise<void> {
        const {planes} = this.current;
        if (planes) this.root.dataset.digests = JSON.stringify(await checkPlanes(planes, this.notice));
    }
}
