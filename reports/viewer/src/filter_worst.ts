// The table of worst pixels of a method, a row per region.
import {element, replaceChildren} from './element';
import type {FilterView} from './filter_view';
import {grouped, rounded} from './numbers';
import {makeTablesSortable} from './sortable';

export type RegionWorst = {region: number; pixels: number; pixel: number; error: number};

/// By region the pixel with the greatest error, of those in the filter; regions without one are left out.
export function worstByRegion(view: FilterView, errors: Float32Array, match: Uint8Array | null): RegionWorst[] {
    const worst = view.header.regions.map((_, region): RegionWorst => ({region, pixels: 0, pixel: -1, error: -1}));
    for (let p = 0; p < errors.length; ++p) {
        if (match && !match[p]) continue;
        for (let bits = view.regions[p]; bits; bits &= bits - 1) {
            const row = worst[31 - Math.clz32(bits & -bits)];
            ++row.pixels;
            if (errors[p] > row.error) { row.error = errors[p]; row.pixel = p; }
        }
    }
    return worst.filter((row) => row.pixel >= 0);
}

export class RegionTable {
    readonly root = element('div', {class: 'worst-box'});

    constructor(private readonly go: (pixel: number) => void) {}

    show(view: FilterView, method: string, match: Uint8Array | null): void {
        const errors = view.errors(method);
        if (!errors) return replaceChildren(this.root, element('p', {class: 'quiet'}, `The picture of ${method} is not in this page.`));
        const rows = worstByRegion(view, errors, match);
        if (!rows.length) return replaceChildren(this.root, element('p', {class: 'quiet'}, 'No pixel is in the filter.'));
        replaceChildren(this.root, element('table', {class: 'clusters sortable'},
            element('thead', {}, element('tr', {}, ...['region', 'pixels', 'worst error', 'at'].map((title, i) =>
                element('th', {class: ['', 'n pixels', 'n', ''][i]}, title)))),
            element('tbody', {}, ...rows.map((row) => this.row(view, method, row)))),
            element('p', {class: 'fine'}, `The worst pixels of ${method}, region by region; ● has a stored inspection.`));
        makeTablesSortable(this.root);
    }

    private row(view: FilterView, method: string, row: RegionWorst): HTMLElement {
        const x = row.pixel % view.planes.width, y = (row.pixel - x) / view.planes.width;
        return element('tr', {tabindex: 0, onclick: () => this.go(row.pixel),
                              onkeydown: (event: KeyboardEvent) => { if (event.key === 'Enter') this.go(row.pixel); }},
            element('td', {'data-key': row.region}, view.header.regions[row.region].name),
            element('td', {class: 'n pixels'}, grouped(row.pixels)),
            element('td', {class: 'n', 'data-key': row.error}, rounded(row.error)),
            element('td', {}, `${x}, ${y}`, view.inspection(row.pixel, method) ? ' ●' : ''));
    }
}
