// Charts whose series a reader chooses: a legend above them filters, and pointing at a name shows where it is.
//
//   <div class="plots">: figures with charts of reports/pages/chart.h inside, <g class="series" data-series="NAME">. A chosen
//   series has a colour of its own, the same in every chart; nothing chosen shows all, as they were drawn.
import {element} from './element';

/// Okabe and Ito 2008, without yellow.
const colours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00', '#000000'];

class Legend {
    readonly root = element('div', {class: 'chart-legend', role: 'group', 'aria-label': 'series of the charts'});
    private readonly chosen: string[] = [];
    private readonly series: SVGGElement[];

    constructor(private readonly plots: HTMLElement) {
        this.series = [...plots.querySelectorAll<SVGGElement>('g.series')];
        const names = [...new Set(this.series.map(nameOf))];
        this.root.append(...names.map((name) => this.chip(name)), element('button', {type: 'button', onclick: () => this.clear()}, 'all'));
        for (const one of this.series) {
            one.addEventListener('pointerenter', () => this.point(nameOf(one)));
            one.addEventListener('pointerleave', () => this.point(null));
        }
    }

    private chip(name: string): HTMLElement {
        const button = element('button', {type: 'button', 'aria-pressed': 'false', 'data-series': name}, name);
        button.addEventListener('click', () => this.toggle(name));
        for (const event of ['pointerenter', 'focus']) button.addEventListener(event, () => this.point(name));
        for (const event of ['pointerleave', 'blur']) button.addEventListener(event, () => this.point(null));
        return button;
    }

    private toggle(name: string): void {
        const at = this.chosen.indexOf(name);
        if (at < 0) this.chosen.push(name);
        else this.chosen.splice(at, 1);
        this.show();
    }

    private clear(): void {
        this.chosen.length = 0;
        this.show();
    }

    private show(): void {
        for (const one of [...this.series, ...this.root.querySelectorAll<HTMLElement>('[data-series]')]) {
            const at = this.chosen.indexOf(nameOf(one));
            one.style.setProperty('--series', colours[Math.max(0, at) % colours.length]);
            if (one instanceof HTMLElement) one.setAttribute('aria-pressed', String(at >= 0));
            one.classList.toggle('chosen', at >= 0);
            one.classList.toggle('away', one instanceof SVGGElement && this.chosen.length > 0 && at < 0);
        }
    }

    private point(name: string | null): void {
        this.plots.classList.toggle('pointing', name !== null);
        for (const one of this.series) one.classList.toggle('lit', nameOf(one) === name);
    }
}

function nameOf(one: SVGElement | HTMLElement): string { return one.dataset.series ?? ''; }

export function linkCharts(root: ParentNode): void {
    root.querySelectorAll<HTMLElement>('.plots').forEach((plots) => {
        if (plots.querySelector('g.series')) plots.prepend(new Legend(plots).root);
    });
}
