// The table of worst pixels, a row per pair of triangles.
import {clustersOf} from './clusters';
import type {Cluster} from './clusters';
import {element, replaceChildren} from './element';
import {badge} from './inspector';
import {counted, grouped, idText, rounded} from './numbers';
import type {Planes} from './planes';
import type {ClassStyle} from './run';
import {makeTablesSortable} from './sortable';
import {nameOf} from './story';

const mostRows = 200;

export class WorstTable {
    readonly root = element('div', {class: 'worst-box'});

    constructor(private readonly classes: ClassStyle[], private readonly go: (pixel: number) => void) {}

    show(planes: Planes, match: Uint8Array | null): void {
        const clusters = clustersOf(planes, match), f = planes.findings;
        if (!clusters.length)
            return replaceChildren(this.root, element('p', {class: 'quiet'}, match
                ? 'None of the differing pixels is in the filter.' : 'Both renderers agree at every pixel.'));
        const head = ['class', 'pixels', 'triangles', 'error / bound', 'where'];
        const table = element('table', {class: 'clusters sortable'},
            element('thead', {}, element('tr', {}, ...head.map((title) => element('th', {}, title)))),
            element('tbody', {}, ...clusters.slice(0, mostRows).map((cluster) => this.row(planes, cluster))));
        const rest = clusters.length - mostRows, listed = f && f.all > f.count
            ? ` The first ${grouped(f.count)} of ${grouped(f.all)} differing pixels are listed, defects first.` : '';
        replaceChildren(this.root, table, element('p', {class: 'fine'},
            counted(clusters.length, 'pair') + ' of triangles.' + (rest > 0 ? ` ${grouped(rest)} more are not shown.` : '') + listed));
        makeTablesSortable(this.root);
    }

    private row(planes: Planes, c: Cluster): HTMLElement {
        const x = c.pixel % planes.width, y = (c.pixel - x) / planes.width;
        const pair = c.candidate === c.reference ? idText(c.candidate) : `${idText(c.candidate)}, ${idText(c.reference)}`;
        const names = `candidate: ${nameOf(planes.ranges, c.candidate) || idText(c.candidate)}; ` +
            `reference: ${nameOf(planes.ranges, c.reference) || idText(c.reference)}`;
        const where = c.count === 1 ? `${x}, ${y}` : `${x}, ${y} in ${c.right - c.left + 1} × ${c.bottom - c.top + 1}`;
        return element('tr', {tabindex: 0, onclick: () => this.go(c.pixel),
                              onkeydown: (event: KeyboardEvent) => { if (event.key === 'Enter') this.go(c.pixel); }},
            element('td', {'data-key': c.class}, badge(this.classes[c.class])), element('td', {class: 'n'}, grouped(c.count)),
            element('td', {'data-key': c.candidate, title: names}, pair),
            element('td', {class: 'n', 'data-key': Number.isNaN(c.worst) ? '' : c.worst}, rounded(c.worst)), element('td', {}, where));
    }
}
