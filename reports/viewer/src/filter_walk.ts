// From one telling pixel of a filter study to the next.
import type {FilterChoice} from './filter_layers';
import type {FilterView} from './filter_view';
import {worstByRegion} from './filter_worst';
import {grouped} from './numbers';
import type {PixelWalk, Stage} from './subject';
import {stepIn} from './walk';

export class FilterWalk implements PixelWalk {
    private sorted: {of: Float32Array; order: number[]} | null = null;

    constructor(private readonly stage: Stage, private readonly choice: FilterChoice, private readonly view: () => FilterView | null) {}

    /// Over the worst pixels of the regions, the worst of all first.
    toNext(direction: 1 | -1): void {
        const view = this.view(), errors = view?.errors(this.choice.method);
        if (!view || !errors) return;
        const rows = worstByRegion(view, errors, this.stage.current.selection?.match ?? null).sort((a, b) => b.error - a.error);
        this.along([...new Set(rows.map((row) => row.pixel))], direction, 'of the regions\' worst pixels');
    }

    bySeverity(direction: 1 | -1): void {
        const errors = this.view()?.errors(this.choice.method), match = this.stage.current.selection?.match;
        if (!errors) return;
        if (this.sorted?.of !== errors)
            this.sorted = {of: errors, order: Array.from(errors.keys()).sort((a, b) => errors[b] - errors[a] || a - b)};
        const {order} = this.sorted;
        this.along(match ? order.filter((p) => match[p]) : order, direction, 'by error');
    }

    toStory(): void {
        const view = this.view(), {look} = this.stage.current;
        const told = view?.inspections.filter((one) => one.method === this.choice.method).map((one) => one.y * view.planes.width + one.x) ?? [];
        if (!told.length) return this.stage.notice.tell(`No inspections of ${this.choice.method} are stored for this view.`);
        this.stage.go(told.find((pixel) => pixel > (look.hasCross ? look.cross : -1)) ?? told[0]);
    }

    /// Over the pixels outside what the picture's claim permits, the farthest first.
    toOutside(): void {
        const distances = this.view()?.outside(this.choice.method);
        if (!distances) return;
        const outside = Array.from(distances.keys()).filter((p) => distances[p] > 0);
        this.along(outside.sort((a, b) => distances[b] - distances[a] || a - b), 1, 'outside what is permitted');
    }

    private along(order: number[], direction: 1 | -1, words: string): void {
        const {look} = this.stage.current;
        if (!order.length) return this.stage.notice.tell('No pixel is in the filter.');
        const next = stepIn(order, look.hasCross ? look.cross : -1, direction);
        this.stage.go(order[next]);
        this.stage.notice.tell(`Number ${grouped(next + 1)} of ${grouped(order.length)} ${words}.`);
    }
}
