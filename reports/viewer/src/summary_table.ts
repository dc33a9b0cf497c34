// The summary of a run of many views: a page of its table, and of the sections below, at a time; searched and sorted
// as a whole. The first page stands in the file as markup, for readers without scripts.
import {element, replaceChildren} from './element';
import {counted, grouped} from './numbers';
import {outcomeInWords, outcomeMarks, wordsOf} from './run';
import type {JudgedView, Run} from './run';
import {Search} from './search';
import {Sections} from './sections';
import {sortedPlaces} from './sortable';
import type {SortOrder} from './sortable';

export class SummaryTable {
    private readonly search = element('input', {
        type: 'search', placeholder: 'Search scene, view, verdict, class, file', 'aria-label': 'search the table'});
    private readonly position = element('input', {type: 'number', min: 1, 'aria-label': 'page of the table'});
    private readonly last = element('span');
    private readonly extent = element('span', {class: 'fine', role: 'status'});
    private readonly root = element('nav', {class: 'pages', 'aria-label': 'pages of the table'}, this.search, this.extent,
        element('button', {type: 'button', title: 'previous page', onclick: () => this.turnTo(this.page - 1)}, '←'), 'page ',
        this.position, this.last,
        element('button', {type: 'button', title: 'next page', onclick: () => this.turnTo(this.page + 1)}, '→'));
    private readonly names: Search;
    private order: number[];  // all views, as sorted
    private found: number[];  // those of them that the search leaves
    private page = 0;

    constructor(private readonly table: HTMLTableElement, private readonly run: Run, private readonly sections: Sections) {
        this.names = new Search(run.views.length, (i) => wordsOf(run.views[i], run.classes));
        this.order = this.found = run.views.map((_, i) => i);
        this.search.addEventListener('input', () => this.find());
        this.position.addEventListener('change', () => this.turnTo(Number(this.position.value) - 1));
        table.addEventListener('sort', (event) => {
            event.preventDefault();
            this.sort((event as CustomEvent<SortOrder>).detail);
        });
        window.addEventListener('hashchange', () => void this.follow());
        table.closest('.wide')!.before(this.root);
        this.tell();
        if (location.hash) void this.follow();
    }

    private get pages(): number { return Math.max(1, Math.ceil(this.found.length / this.run.inMarkup)); }

    private find(): void {
        const matching = new Set(this.names.matching(this.search.value));
        this.found = this.order.filter((i) => matching.has(i));
        this.turnTo(0);
    }

    private sort({column, direction}: SortOrder): void {
        const {views} = this.run, order = views.map((_, i) => i);
        this.order = sortedPlaces(order.map((i) => textsOf(views[i])[column] ?? ''), direction);
        this.find();
    }

    private turnTo(page: number): void {
        this.page = Math.min(Math.max(0, Math.trunc(page) || 0), this.pages - 1);
        void this.show();
    }

    private async show(): Promise<void> {
        const {inMarkup} = this.run, shown = this.found.slice(this.page * inMarkup, (this.page + 1) * inMarkup);
        replaceChildren(this.table.tBodies[0], ...shown.map((i) => this.row(i)));
        this.tell();
        await this.sections.show(shown);
    }

    private tell(): void {
        const {views} = this.run, {found, page, pages} = this;
        this.extent.textContent = found.length === views.length ? counted(views.length, 'view')
            : `${grouped(found.length)} of ${counted(views.length, 'view')}`;
        this.position.value = String(page + 1);
        this.position.max = String(pages);
        this.last.textContent = ` of ${grouped(pages)}`;
        this.table.dataset.page = String(page + 1);
    }

    /// Goes to the section, or else the row, that the address names: "#view-137".
    private async follow(): Promise<void> {
        const index = Number(/^#view-(\d+)$/.exec(location.hash)?.[1]) - 1;
        if (!this.run.views[index]) return;
        if (!this.found.includes(index)) {
            this.search.value = '';
            this.found = this.order;
        }
        const page = Math.floor(this.found.indexOf(index) / this.run.inMarkup);
        if (page !== this.page) {
            this.page = page;
            await this.show();
        }
        const row = this.table.tBodies[0].rows[this.found.indexOf(index) % this.run.inMarkup];
        await bringIntoView(document.getElementById(location.hash.slice(1)) ?? row);
    }

    private row(index: number): HTMLTableRowElement {
        const view = this.run.views[index], {columns} = this.run;
        const name = [view.scene + ' ', element('span', {class: 'view'}, view.view)];
        const cells = view.row ? view.row.split('\t').map((text, i) => {
            const lines = text.split('\n'), {kind, quietZeros} = columns[i];
            return element('td', {class: kind + (quietZeros && lines[0] === '0' ? ' zero' : '')},
                lines[0], ...lines.slice(1).flatMap((line) => [element('br'), line]));
        }) : [element('td', {class: 'message', colspan: columns.length}, view.message)];
        return element('tr', {},
            element('td', {}, element('span', {class: 'outcome ' + view.outcome}, textsOf(view)[0])),
            element('td', {}, ...this.sections.has(index) ? [element('a', {href: '#' + view.anchor}, ...name)] : name),
            ...cells, element('td', {class: 'n'}, view.seconds));
    }
}

/// What comes into view is laid out only then, and may push away what was scrolled to.
async function bringIntoView(target: HTMLElement): Promise<void> {
    for (let frame = 0; frame < 3; ++frame) {
        target.scrollIntoView();
        await new Promise(requestAnimationFrame);
    }
}

/// By the columns of the table.
function textsOf(view: JudgedView): string[] {
    const texts = [`${outcomeMarks[view.outcome]} ${outcomeInWords(view)}`, `${view.scene} ${view.view}`];
    return view.row ? [...texts, ...view.row.split('\t'), view.seconds] : texts;
}
