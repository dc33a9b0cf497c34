// Histograms over a logarithmic count. A bin that is chosen filters the picture.
import {element, fittedCanvas, styleColour} from './element';
import {counted, grouped} from './numbers';

export type Bins = {
    title: string;
    counts: number[];
    label(bin: number): string;  // what it holds: "0.25 to 0.3 of the bound"
    tick(bin: number): string;   // at its left side; empty for none
    bound?: number;              // the bin that begins at the bound
};

export class Histogram {
    private readonly canvas = element('canvas', {class: 'histogram', tabindex: 0, role: 'application'});
    private readonly caption = element('p', {class: 'fine'});
    private readonly heading = element('h3');
    readonly root = element('div', {class: 'histogram-box'}, this.heading, this.canvas, this.caption);
    private bins: Bins | null = null;
    private chosen = -1;
    private pointed = -1;

    constructor(private readonly onChoice: (bin: number) => void) {
        this.canvas.addEventListener('pointermove', (event) => this.point(this.binAt(event.offsetX)));
        this.canvas.addEventListener('pointerleave', () => this.point(-1));
        this.canvas.addEventListener('click', (event) => this.choose(this.binAt(event.offsetX)));
        this.canvas.addEventListener('keydown', (event) => this.key(event));
        new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    show(bins: Bins): void {
        this.bins = bins;
        this.chosen = this.pointed = -1;
        this.heading.textContent = bins.title;
        this.canvas.setAttribute('aria-label', bins.title + '; arrows point at a bin, Enter filters the picture by it');
        this.draw();
    }

    clear(): void {
        this.chosen = -1;
        this.draw();
    }

    private key(event: KeyboardEvent): void {
        if (!this.bins || !['ArrowLeft', 'ArrowRight', 'Enter', 'Escape'].includes(event.key)) return;
        event.preventDefault();
        event.stopPropagation();
        if (event.key === 'Enter') return this.choose(this.pointed);
        if (event.key === 'Escape') return this.choose(this.chosen);
        const step = event.key === 'ArrowRight' ? 1 : -1;
        for (let bin = this.pointed + step; bin >= 0 && bin < this.bins.counts.length; bin += step)
            if (this.bins.counts[bin]) return this.point(bin);
    }

    private binAt(x: number): number {
        const count = this.bins?.counts.length ?? 0, left = 34, width = this.canvas.clientWidth - left - 6;
        const bin = Math.floor((x - left) / width * count);
        return bin >= 0 && bin < count ? bin : -1;
    }

    private point(bin: number): void {
        if (bin === this.pointed) return;
        this.pointed = bin;
        this.draw();
    }

    /// A bin that is chosen again takes the filter away.
    private choose(bin: number): void {
        if (!this.bins || bin < 0 || (!this.bins.counts[bin] && bin !== this.chosen)) return;
        this.chosen = bin === this.chosen ? -1 : bin;
        this.draw();
        this.onChoice(this.chosen);
    }

    private describe(): string {
        const bins = this.bins!, bin = this.pointed >= 0 ? this.pointed : this.chosen;
        if (bin >= 0) return `${bins.label(bin)}: ${counted(bins.counts[bin], 'pixel')}${bin === this.chosen ? ', shown alone' : ''}`;
        const all = bins.counts.reduce((a, b) => a + b, 0);
        if (!all) return 'nothing to count';
        const quantile = (q: number) => {
            let seen = 0;
            return bins.label(bins.counts.findIndex((count) => (seen += count) >= q * all && count > 0));
        };
        return `${grouped(all)} pixels; median ${quantile(0.5)}; 99 % up to ${quantile(0.99)}; largest ${quantile(1)}`;
    }

    draw(): void {
        if (!this.bins || !this.canvas.clientWidth) return;
        const {context, scale} = fittedCanvas(this.canvas), {counts, bound} = this.bins;
        const width = this.canvas.width, height = this.canvas.height;
        const left = 34 * scale, right = width - 6 * scale, bottom = height - 16 * scale, top = 6 * scale;
        const most = Math.max(1, ...counts), decades = Math.max(1, Math.ceil(Math.log10(most + 1)));
        const y = (count: number) => bottom - (bottom - top) * Math.log10(count + 1) / decades;
        const x = (bin: number) => left + (right - left) * bin / counts.length;
        context.clearRect(0, 0, width, height);
        context.font = `${10 * scale}px system-ui, sans-serif`;
        context.fillStyle = styleColour('--quiet');
        context.textAlign = 'right';
        for (let d = 0; d <= decades; d += decades > 4 ? 2 : 1) {
            const count = 10 ** d, text = d < 3 ? String(count) : d < 6 ? `${10 ** (d - 3)}k` : `${10 ** (d - 6)}M`;
            context.globalAlpha = 0.25;
            context.fillRect(left, y(count), right - left, scale);
            context.globalAlpha = 1;
            context.fillText(text, left - 5 * scale, y(count) + 3 * scale);
        }
        counts.forEach((count, bin) => {
            if (!count) return;
            const over = bound !== undefined && bin >= bound;
            context.globalAlpha = this.chosen >= 0 && bin !== this.chosen ? 0.3 : 1;
            context.fillStyle = styleColour(bin === this.pointed ? '--ink' : over ? '--defect' : '--blue');
            context.fillRect(x(bin) + 0.5, y(count), Math.max(1, x(bin + 1) - x(bin) - scale), bottom - y(count));
        });
        context.globalAlpha = 1;
        context.textAlign = 'center';
        context.fillStyle = styleColour('--quiet');
        let free = 0;  // from here on, no label stands yet
        counts.forEach((_, bin) => {
            const tick = this.bins!.tick(bin), half = context.measureText(tick).width / 2;
            if (!tick || x(bin) - half < free || x(bin) + half > width) return;
            context.fillText(tick, x(bin), height - 4 * scale);
            free = x(bin) + half + 4 * scale;
        });
        if (bound !== undefined) {
            context.fillStyle = styleColour('--defect');
            context.fillRect(x(bound), top, 1.5 * scale, bottom - top);
        }
        this.caption.textContent = this.describe();
    }
}
