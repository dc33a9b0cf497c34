// Two to nine panes with one look: pointer and wheel move all of them together.
import {element, replaceChildren} from './element';
import type {Layer} from './layers';
import type {Look, Size} from './look';
import {Pane} from './pane';
import type {Wipe} from './pane';
import type {Planes} from './planes';
import type {Selection} from './raster';

type Comparison = 'none' | 'flip' | 'wipe' | 'difference';

export const paneCounts = [2, 3, 4, 6, 9];

export class Panes {
    readonly root = element('div', {class: 'panes', 'data-count': 4});
    private readonly panes = Array.from({length: Math.max(...paneCounts)}, () => new Pane());
    private readonly chosen: string[];
    private layers: Layer[] = [];
    private planes: Planes | null = null;
    private look: Look | null = null;
    private selection: Selection | null = null;
    private frameAsked = false;
    private wipeAt = 0.5;
    private forced: Comparison | null = null;  // while a key is held
    private comparison: Comparison = 'none';
    private wanted = 4;
    private active = 0;

    /// `first`: the layers that they show before somebody chooses.
    constructor(first: string[], private readonly onCross: () => void) {
        this.chosen = [...first];
        this.panes.forEach((pane, i) => this.listen(pane, i));
        replaceChildren(this.root, ...this.panes.map((pane) => pane.root));
        new ResizeObserver(() => {
            if (this.look?.isFitted) this.look.fit(this.size);
            this.redraw();
        }).observe(this.root);
    }

    /// No more than there are layers.
    private get count(): number { return Math.max(1, ...paneCounts.filter((count) => count <= Math.min(this.wanted, this.layers.length))); }

    get size(): Size { return this.panes[0].size; }

    /// Resolves when every visible pane is ready to show its layer; until then they show what they did before.
    async open(planes: Planes, layers: Layer[], look: Look): Promise<void> {
        this.planes = planes;
        this.look = look;
        this.selection = null;
        await this.setLayers(layers);
    }

    /// Other layers of the same view; every pane keeps the id of its own.
    async setLayers(layers: Layer[]): Promise<void> {
        this.layers = layers;
        this.arrange();
        const options = (group: string | undefined) => layers.filter((layer) => layer.group === group)
            .map((layer) => element('option', {value: layer.id}, layer.title));
        const groups = [...new Set(layers.map((layer) => layer.group))].filter((group) => group !== undefined);
        for (const pane of this.panes)
            replaceChildren(pane.choice, ...options(undefined), ...groups.map((label) => element('optgroup', {label}, ...options(label))));
        await this.showAll();
    }

    private arrange(): void {
        this.active = Math.min(this.active, this.count - 1);
        this.root.dataset.count = String(this.count);
        this.panes.forEach((pane, i) => { pane.root.hidden = i >= this.count; });
    }

    private async showAll(): Promise<void> {
        await Promise.all(this.panes.slice(0, this.count).map((pane, i) => pane.show(this.layerFor(i), this.planes!)));
        this.redraw();
    }

    private layerFor(i: number): Layer {
        return this.layers.find((layer) => layer.id === this.chosen[i]) ?? this.layers[Math.min(i, this.layers.length - 1)];
    }

    async setLayer(i: number, id: string): Promise<void> {
        this.chosen[i] = id;
        if (!this.planes || i >= this.count) return;
        await this.panes[i].show(this.layerFor(i), this.planes);
        this.redraw();
    }

    /// The n-th layer, from 0, into the active pane.
    choose(n: number): void {
        if (this.layers[n]) void this.setLayer(this.active, this.layers[n].id);
    }

    /// 2, 3, 4, 6 or 9 panes in turn.
    async cycle(): Promise<void> { await this.resize(paneCounts[(paneCounts.indexOf(this.wanted) + 1) % paneCounts.length]); }

    /// These layers side by side, in as many panes as they need; of too many the first.
    async tile(ids: string[]): Promise<void> {
        this.chosen.splice(0, ids.length, ...ids.slice(0, Math.max(...paneCounts)));
        await this.resize(paneCounts.find((count) => count >= ids.length) ?? Math.max(...paneCounts));
    }

    private async resize(count: number): Promise<void> {
        this.wanted = count;
        this.arrange();
        if (this.planes) await this.showAll();
        if (this.look?.isFitted) this.fit();
    }

    layerIds(): string[] { return this.panes.slice(0, this.count).map((_, i) => this.layerFor(i)?.id ?? ''); }

    select(selection: Selection | null): void {
        this.selection = selection;
        this.redraw();
    }

    force(comparison: Comparison | null): void {
        if (this.forced === comparison) return;
        this.forced = comparison;
        this.redraw();
    }

    /// Goes over to this comparison, or back from it. Returns in words what the panes show then.
    compare(way: 'wipe' | 'difference'): string {
        this.comparison = this.comparison === way ? 'none' : way;
        this.redraw();
        return this.comparison === 'none' ? 'Panes as they are.' : way === 'wipe'
            ? 'Wipe: right of the line, the neighbouring pane.' : 'Difference of neighbouring panes, in the second of each pair.';
    }

    activateNext(): void {
        this.active = (this.active + 1) % this.count;
        this.panes[this.active].canvas.focus();
    }

    fit(): void {
        this.look?.fit(this.size);
        this.redraw();
    }

    moveWipe(by: number): void {
        this.wipeAt = Math.min(1, Math.max(0, this.wipeAt + by));
        this.redraw();
    }

    redraw(): void {
        if (this.frameAsked) return;
        this.frameAsked = true;
        requestAnimationFrame(() => {
            this.frameAsked = false;
            this.draw();
        });
    }

    private draw(): void {
        if (!this.look) return;
        const comparison = this.forced ?? this.comparison;
        this.panes.slice(0, this.count).forEach((pane, i) => {
            const other = this.panes[i ^ 1], pair = other?.current && (i ^ 1) < this.count ? other : null;
            const wipe: Wipe | null = comparison === 'wipe' && pair ? {layer: pair.current!, at: this.wipeAt} : null;
            const instead = !pair ? null : comparison === 'flip' ? pair.current :
                comparison === 'difference' && i % 2 === 1 ? pane.differenceFrom(pair) : null;
            pane.draw(this.look!, this.selection, instead, wipe);
        });
    }

    private listen(pane: Pane, i: number): void {
        pane.root.addEventListener('pointerdown', () => { this.active = i; });
        pane.root.addEventListener('focusin', () => { this.active = i; });
        pane.choice.addEventListener('change', () => void this.setLayer(i, pane.choice.value));
        pane.canvas.addEventListener('wheel', (event) => this.wheel(pane, event), {passive: false});
        pane.canvas.addEventListener('pointerdown', (event) => this.press(pane, event));
        pane.canvas.addEventListener('pointermove', (event) => {
            if ((this.forced ?? this.comparison) !== 'wipe' || event.buttons) return;
            this.wipeAt = event.offsetX / pane.size.width;
            this.redraw();
        });
        pane.canvas.addEventListener('dblclick', (event) => {
            const at = this.rasterAt(pane, event);
            this.look?.zoomBy(this.look.zoom < 24 ? 32 / this.look.zoom : 1, at.x, at.y);
            this.redraw();
        });
    }

    private rasterAt(pane: Pane, event: MouseEvent): {x: number; y: number} {
        const look = this.look!, {width, height} = pane.size;
        return {x: look.x + (event.offsetX - width / 2) / look.zoom, y: look.y + (event.offsetY - height / 2) / look.zoom};
    }

    private wheel(pane: Pane, event: WheelEvent): void {
        if (!this.look) return;
        event.preventDefault();
        const at = this.rasterAt(pane, event);
        this.look.zoomBy(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0022)), at.x, at.y);
        this.redraw();
    }

    /// A click sets the crosshair, a drag pans.
    private press(pane: Pane, start: PointerEvent): void {
        if (!this.look || start.button !== 0) return;
        const look = this.look, canvas = pane.canvas;
        let lastX = start.clientX, lastY = start.clientY, moved = false;
        const move = (event: PointerEvent) => {
            const dx = event.clientX - lastX, dy = event.clientY - lastY;
            if (!moved && Math.abs(dx) + Math.abs(dy) < 4) return;
            moved = true;
            look.pan(-dx / look.zoom, -dy / look.zoom);
            [lastX, lastY] = [event.clientX, event.clientY];
            this.redraw();
        };
        const up = (event: PointerEvent) => {
            canvas.removeEventListener('pointermove', move);
            if (moved) return;
            const at = this.rasterAt(pane, event);
            look.setCross(Math.floor(at.x), Math.floor(at.y));
            this.onCross();
        };
        canvas.setPointerCapture(start.pointerId);
        canvas.addEventListener('pointermove', move);
        canvas.addEventListener('pointerup', up, {once: true});
    }
}
