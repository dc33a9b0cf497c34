// Pictures of one place that are looked at together: one zoom and pan over several images.
//
//   <figure data-linked="GROUP"><img ...></figure>, any number of them per group, all images of one aspect.
//   Drag pans, double click and Home reset; + and - zoom, arrows pan. The wheel zooms only in a figure that has
//   the focus, so that it never traps somebody who scrolls the page.

type Look = {zoom: number; x: number; y: number};  // x, y: place of the picture in the frame's middle, 0 to 1

const whole: Look = {zoom: 1, x: 0.5, y: 0.5};
const mostZoom = 64;

function clamped(look: Look): Look {
    const zoom = Math.min(mostZoom, Math.max(1, look.zoom)), half = 0.5 / zoom;
    const within = (v: number) => Math.min(1 - half, Math.max(half, v));
    return {zoom, x: within(look.x), y: within(look.y)};
}

function show(image: HTMLImageElement, look: Look): void {
    const x = 50 - 100 * look.zoom * look.x, y = 50 - 100 * look.zoom * look.y;
    image.style.transform = look.zoom === 1 ? '' : `translate(${x}%, ${y}%) scale(${look.zoom})`;
}

function framed(image: HTMLImageElement): HTMLElement {
    const frame = document.createElement('div');
    frame.style.overflow = 'hidden';
    frame.style.touchAction = 'pan-y';
    frame.tabIndex = 0;
    frame.setAttribute('role', 'group');
    frame.setAttribute('aria-label', (image.alt || 'picture') + '; + and - zoom, arrows pan, Home shows all');
    image.replaceWith(frame);
    frame.append(image);
    image.draggable = false;
    image.style.transformOrigin = '0 0';
    image.style.imageRendering = 'pixelated';
    image.style.maxWidth = '100%';
    return frame;
}

class Group {
    private look = whole;
    private readonly images: HTMLImageElement[] = [];

    add(image: HTMLImageElement): void {
        const frame = framed(image);
        this.images.push(image);
        frame.addEventListener('dblclick', () => this.set(whole));
        frame.addEventListener('wheel', (event) => {
            if (document.activeElement !== frame) return;
            event.preventDefault();
            this.zoomAt(frame, event, Math.exp(-event.deltaY / 300));
        }, {passive: false});
        frame.addEventListener('keydown', (event) => this.key(event));
        frame.addEventListener('pointerdown', (event) => this.drag(frame, event));
    }

    private set(look: Look): void {
        this.look = clamped(look);
        for (const image of this.images) show(image, this.look);
    }

    private zoomAt(frame: HTMLElement, at: {clientX: number; clientY: number}, factor: number): void {
        const box = frame.getBoundingClientRect(), {zoom, x, y} = this.look;
        const next = Math.min(mostZoom, Math.max(1, zoom * factor));
        const u = (at.clientX - box.left) / box.width - 0.5, v = (at.clientY - box.top) / box.height - 0.5;
        this.set({zoom: next, x: x + u / zoom - u / next, y: y + v / zoom - v / next});
    }

    private key(event: KeyboardEvent): void {
        const {zoom, x, y} = this.look, step = 0.1 / zoom;
        const looks: Record<string, Look> = {
            '+': {zoom: zoom * 1.5, x, y}, '=': {zoom: zoom * 1.5, x, y}, '-': {zoom: zoom / 1.5, x, y}, Home: whole,
            ArrowLeft: {zoom, x: x - step, y}, ArrowRight: {zoom, x: x + step, y},
            ArrowUp: {zoom, x, y: y - step}, ArrowDown: {zoom, x, y: y + step},
        };
        const look = looks[event.key];
        if (!look || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        this.set(look);
    }

    private drag(frame: HTMLElement, start: PointerEvent): void {
        if (start.button !== 0 || this.look.zoom === 1) return;
        const from = this.look, box = frame.getBoundingClientRect();
        const move = (event: PointerEvent) => this.set({
            zoom: from.zoom,
            x: from.x - (event.clientX - start.clientX) / box.width / from.zoom,
            y: from.y - (event.clientY - start.clientY) / box.height / from.zoom,
        });
        frame.setPointerCapture(start.pointerId);
        frame.addEventListener('pointermove', move);
        frame.addEventListener('pointerup', () => frame.removeEventListener('pointermove', move), {once: true});
    }
}

export function linkCrops(root: ParentNode): void {
    const groups = new Map<string, Group>();
    root.querySelectorAll<HTMLElement>('figure[data-linked]').forEach((figure) => {
        const name = figure.dataset.linked ?? '';
        const image = figure.querySelector('img');
        if (!image) return;
        if (!groups.has(name)) groups.set(name, new Group());
        groups.get(name)!.add(image);
    });
}
