// The list of views in the page's order, searched by name, filtered by what its subject offers.
import {element, replaceChildren} from './element';
import {grouped} from './numbers';
import type {ViewEntry} from './run';
import {Search} from './search';
import type {EntryStyle} from './subject';

const mostShown = 200;  // a browser takes long over a list of thousands

export class SceneList {
    readonly search = element('input', {type: 'search', placeholder: 'Search  /', 'aria-label': 'search views'});
    private readonly chips = element('div', {class: 'chips'});
    private readonly list = element('ul', {class: 'views'});
    readonly root = element('nav', {class: 'scenes', 'aria-label': 'views'}, this.search, this.chips, this.list);
    private readonly wanted = new Set<number>();
    private readonly names: Search;
    private current = -1;

    constructor(private readonly views: ViewEntry[], private readonly style: EntryStyle,
                private readonly open: (index: number) => void) {
        this.names = new Search(views.length, (i) => style.words(views[i]));
        this.search.addEventListener('input', () => this.fill());
        this.search.addEventListener('keydown', (event) => {
            if (event.key === 'Enter' && this.visible().length) this.open(this.visible()[0]);
            if (event.key === 'Escape') { this.search.value = ''; this.fill(); this.search.blur(); }
        });
        style.chips.forEach((_, i) => this.chips.append(this.chip(i)));
        this.root.hidden = views.length === 1;
        this.fill();
    }

    private chip(i: number): HTMLElement {
        const {label, title} = this.style.chips[i];
        const button = element('button', {type: 'button', class: 'chip', 'aria-pressed': 'false', title}, label);
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
        return this.names.matching(this.search.value).filter((i) =>
            !this.wanted.size || [...this.wanted].some((chip) => this.style.chips[chip].holds(this.views[i])));
    }

    /// Lists the scenes; where they are many, those around the current one.
    private fill(): void {
        const all = this.visible(), at = Math.max(0, all.indexOf(this.current) - mostShown / 2);
        const shown = all.slice(Math.min(at, Math.max(0, all.length - mostShown))).slice(0, mostShown);
        const others = all.length - shown.length;
        replaceChildren(this.list, ...shown.map((i) => this.entry(this.views[i], i)),
            all.length === 0 && element('li', {class: 'quiet'}, 'No view matches.'),
            others > 0 && element('li', {class: 'quiet'}, `${grouped(others)} more: search for them.`));
    }

    private entry(view: ViewEntry, i: number): HTMLElement {
        const mark = this.style.mark(view), line = this.style.line(view);
        return element('li', {}, element('button', {
            type: 'button', class: 'view-entry', 'aria-current': i === this.current && 'true', onclick: () => this.open(i),
        }, element('span', {class: 'mark ' + mark.kind, title: mark.title}, mark.text),
            element('span', {class: 'name'}, view.scene, ' ', element('span', {class: 'quiet'}, view.view)),
            element('span', {class: 'line ' + line.kind}, line.text), this.style.bar(view)));
    }
}
