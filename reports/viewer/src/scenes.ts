// The list of views: failed ones first, searched by name, filtered by outcome and class.
import {element, replaceChildren} from './element';
import {counted, grouped} from './numbers';
import {defects, differing} from './run';
import type {ClassStyle, Run, ViewEntry} from './run';

const marks: Record<string, string> = {proven: '✓', defective: '✗', undecided: '?', unreadable: '!', not_judged: '?',
    internal_error: '!'};

export class SceneList {
    readonly search = element('input', {type: 'search', placeholder: 'Search  /', 'aria-label': 'search views'});
    private readonly chips = element('div', {class: 'chips'});
    private readonly list = element('ul', {class: 'views'});
    readonly root = element('nav', {class: 'scenes', 'aria-label': 'views'}, this.search, this.chips, this.list);
    private readonly wanted = new Set<number>();
    private current = -1;

    constructor(private readonly run: Run, private readonly open: (index: number) => void) {
        this.search.addEventListener('input', () => this.fill());
        this.search.addEventListener('keydown', (event) => {
            if (event.key === 'Enter' && this.visible().length) this.open(this.visible()[0]);
            if (event.key === 'Escape') { this.search.value = ''; this.fill(); this.search.blur(); }
        });
        this.run.classes.forEach((style, i) => {
            if (i > 0 && this.run.views.some((view) => view.counts[i] > 0)) this.chips.append(this.chip(style, i));
        });
        this.fill();
    }

    private chip(style: ClassStyle, i: number): HTMLElement {
        const button = element('button', {type: 'button', class: 'chip', 'aria-pressed': 'false', title: style.meaning},
            element('i', {style: `background:${style.colour}`}), `${style.glyph} ${style.name}`);
        button.addEventListener('click', () => {
            if (!this.wanted.delete(i)) this.wanted.add(i);
            button.setAttribute('aria-pressed', String(this.wanted.has(i)));
            this.fill();
        });
        return button;
    }

    setCurrent(index: number): void {
        this.current = index;
        this.fill();
        this.list.querySelector('[aria-current]')?.scrollIntoView({block: 'nearest'});
    }

    visible(): number[] {
        const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
        const all = this.run.views.map((_, i) => i);
        return all.filter((i) => {
            const view = this.run.views[i], text = `${view.scene} ${view.view} ${view.outcome} ${view.cause ?? ''}`.toLowerCase();
            return words.every((word) => text.includes(word)) &&
                (!this.wanted.size || [...this.wanted].some((kind) => view.counts[kind] > 0));
        });
    }

    private fill(): void {
        const shown = this.visible();
        replaceChildren(this.list, ...shown.map((i) => this.entry(this.run.views[i], i)),
            shown.length === 0 && element('li', {class: 'quiet'}, 'No view matches.'));
    }

    private entry(view: ViewEntry, i: number): HTMLElement {
        const wrong = defects(view, this.run.classes);
        const line = wrong ? counted(wrong, 'defect') : view.planes ? grouped(differing(view)) + ' admissible differences'
            : view.message || 'not judged';
        return element('li', {}, element('button', {
            type: 'button', class: 'view-entry', 'aria-current': i === this.current && 'true', onclick: () => this.open(i),
        }, element('span', {class: 'mark ' + view.outcome, title: view.outcome.replace('_', ' ')}, marks[view.outcome] ?? '?'),
            element('span', {class: 'name'}, view.scene, ' ', element('span', {class: 'quiet'}, view.view)),
            element('span', {class: wrong ? 'line defective' : 'line quiet'}, line), this.bar(view)));
    }

    /// The shares of the classes but `agree`, each at least a sliver.
    private bar(view: ViewEntry): HTMLElement | null {
        const all = differing(view);
        if (!all) return null;
        return element('span', {class: 'shares', 'aria-hidden': 'true'}, ...view.counts.map((count, i) =>
            i > 0 && count > 0 && element('i', {style: `flex:${Math.max(count, all / 25)};background:${this.run.classes[i].colour}`})));
    }
}
