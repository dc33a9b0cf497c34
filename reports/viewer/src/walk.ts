// From one telling pixel to the next.
import type {Notice} from './notice';
import {grouped} from './numbers';
import type {OpenView} from './open_view';
import type {Planes} from './planes';
import type {ClassStyle, JudgedView} from './run';
import type {PixelWalk} from './subject';

const nothing = 'Both renderers agree at every pixel.';

export class Walk implements PixelWalk {
    private readonly sorted = new WeakMap<Planes, number[]>();  // pixels by severity

    constructor(private readonly current: OpenView, private readonly classes: ClassStyle[],
                private readonly go: (pixel: number) => void, private readonly notice: Notice) {}

    /// To a defect; where a view has none, to a differing pixel.
    toNext(direction: 1 | -1): void {
        const {planes, look, selection} = this.current, entry = this.current.entry as JudgedView | undefined;
        if (!planes || !entry) return;
        const fails = this.classes.findIndex((style) => !style.passes);
        const worst = look.hasCross || selection || direction < 0 ? undefined : worstTold(planes);
        if (worst !== undefined) return this.go(worst);
        const from = selection ? 0 : entry.counts.slice(fails).some((count) => count > 0) ? fails : 1;
        const step = nextPixel(planes, from, look.hasCross ? look.cross : -1, direction, selection?.match ?? null);
        if (!step) return this.notice.tell(nothing);
        if (step.wrapped) this.notice.tell('From the other end again.');
        this.go(step.pixel);
    }

    bySeverity(direction: 1 | -1): void {
        const {planes, look, selection} = this.current, match = selection?.match;
        if (!planes) return;
        const all = this.sorted.get(planes) ?? severestFirst(planes);
        this.sorted.set(planes, all);
        const order = match ? all.filter((p) => match[p]) : all;
        if (!order.length) return this.notice.tell(nothing);
        const next = stepIn(order, look.hasCross ? look.cross : -1, direction);
        this.go(order[next]);
        this.notice.tell(`Number ${grouped(next + 1)} of ${grouped(order.length)} by severity.`);
    }

    toStory(): void {
        const {planes, look} = this.current;
        if (!planes?.stories.length) return this.notice.tell('No stories are stored for this view.');
        const pixels = planes.stories.map((story) => story.y * planes.width + story.x);
        this.go(pixels.find((pixel) => pixel > (look.hasCross ? look.cross : -1)) ?? pixels[0]);
    }
}

/// The place in the order behind (direction 1) or before (-1) a pixel; an end of it where it does not have the pixel.
export function stepIn(order: number[], pixel: number, direction: 1 | -1): number {
    const at = order.indexOf(pixel);
    return at < 0 ? (direction > 0 ? 0 : order.length - 1) : (at + direction + order.length) % order.length;
}

/// In raster order, the next pixel (direction 1) or the one before (-1) whose class is at least `from`.
function nextPixel(planes: Planes, from: number, start: number, direction: 1 | -1,
                   match: Uint8Array | null): {pixel: number; wrapped: boolean} | null {
    const classes = planes.classes, count = classes.length;
    let at = start < 0 ? (direction > 0 ? -1 : count) : start;
    for (let i = 0; i < count; ++i) {
        at += direction;
        if (at < 0) at = count - 1;
        if (at >= count) at = 0;
        if (classes[at] >= from && (!match || match[at]))
            return {pixel: at, wrapped: start >= 0 && (direction > 0 ? at <= start : at >= start)};
    }
    return null;
}

/// The severest pixel whose story is stored.
function worstTold(planes: Planes): number | undefined {
    return severestFirst(planes).find((pixel) => planes.story(pixel));
}

/// The findings' pixels by class, then error / bound, then in raster order.
function severestFirst(planes: Planes): number[] {
    const f = planes.findings;
    if (!f) return [];
    const error = (row: number) => Number.isNaN(f.error[row]) ? -1 : f.error[row];
    return Array.from({length: f.count}, (_, row) => row)
        .sort((a, b) => planes.classes[f.pixel[b]] - planes.classes[f.pixel[a]] || error(b) - error(a) || f.pixel[a] - f.pixel[b])
        .map((row) => f.pixel[row]);
}
