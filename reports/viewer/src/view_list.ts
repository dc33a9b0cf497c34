// The views of a run, as pictures or as a table, and their sections below: filtered, searched and sorted as a whole, a page
// of them at a time. The first page stands in the file as markup, for readers without scripts.
import {Cards} from './cards';
import {element, replaceChildren} from './element';
import {counted, grouped} from './numbers';
import {outcomeInWords, outcomeMarks, wordsOf} from './run';
import type {JudgedView, Run} from './run';
import {Search} from './search';
import {unfold} from './sections';
import type {Sections} from './sections';
import {sortedPlaces} from './sortable';
import type {SortOrder} from './sortable';
import {ViewFilter, readChoice} from './view_filter';

export class ViewList {
    private readonly position = element('input', {type: 'number', min: 1, 'aria-label': 'page of the list'});
    private readonly last = element('span');
    private readonly extent = element('span', {class: 'fine', role: 'status'});
    private readonly turning = element('span', {class: 'turning'},
        element('button', {type: 'button', title: 'previous page', onclick: () => this.turnTo(this.page - 1)}, '←'), ' page ',
        this.position, this.last, ' ',
        element('button', {type: 'button', title: 'next page', onclick: () => this.turnTo(this.page + 1)}, '→'));
    private readonly filter: ViewFilter;
    private readonly names: Search;
    private readonly cards: Cards;
    private readonly details = document.querySelector<HTMLDetailsElement>('details#table')!;
    private columnOrder: number[] | null = null;  // all views, as a heading of the table sorts them
    private found: number[];                      // those that search and lists leave
    private page = 0;

    constructor(private readonly table: HTMLTableElement, private readonly run: Run, private readonly sections: Sections) {
        this.cards = new Cards(run);
        this.names = new Search(run.views.length, (i) => wordsOf(run.views[i], run.classes));
        this.found = run.views.map((_, i) => i);
        this.filter = new ViewFilter(run, (key) => {
            if (key === 'sort') this.columnOrder = null;
            this.find();
        });
        this.position.addEventListener('change', () => this.turnTo(Number(this.position.value) - 1));
        table.addEventListener('sort', (event) => {
            event.preventDefault();
            this.sort((event as CustomEvent<SortOrder>).detail);
        });
        window.addEventListener('hashchange', () => void this.follow());
        document.querySelector('p.rings')!.before(
            element('nav', {class: 'pages', 'aria-label': 'the views'}, ...this.filter.controls, this.extent, this.turning));
        if (readChoice(location.hash)) this.find();
        else this.tell();
        if (location.hash) void this.follow();
    }

    private get pages(): number { return Math.max(1, Math.ceil(this.found.length / this.run.inMarkup)); }

    private find(): void {
        const {views} = this.run, matching = new Set(this.names.matching(this.filter.choice.search));
        const order = this.columnOrder ?? this.filter.sorted(views.map((_, i) => i));
        this.found = order.filter((i) => matching.has(i) && this.filter.matches(views[i]));
        this.turnTo(0);
    }

    private sort({column, direction}: SortOrder): void {
        this.columnOrder = sortedPlaces(this.run.views.map((view) => textsOf(view)[column] ?? ''), direction);
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
        await Promise.all([this.cards.show(shown), this.sections.show(shown)]);
    }

    private tell(): void {
        const {views} = this.run, {found, page, pages} = this, isTable = this.filter.choice.show === 'table';
        this.extent.textContent = found.length === views.length ? counted(views.length, 'view')
            : `${grouped(found.length)} of ${counted(views.length, 'view')}`;
        this.position.value = String(page + 1);
        this.position.max = String(pages);
        this.last.textContent = ` of ${grouped(pages)}`;
        this.turning.hidden = pages === 1;
        this.table.dataset.page = String(page + 1);
        document.getElementById('cards')!.hidden = isTable;
        this.details.open = isTable;
    }

    /// Goes to the section, or else the row, that the address names: "#view-137"; or shows what it asks for.
    private async follow(): Promise<void> {
        const choice = readChoice(location.hash), index = Number(/^#view-(\d+)$/.exec(location.hash)?.[1]) - 1;
        if (choice) {
            this.filter.take(choice);
            this.find();
        }
        if (!this.run.views[index]) return;
        if (!this.found.includes(index)) {
            this.filter.take({...this.filter.choice, search: '', verdict: '', cause: '', scene: '', class: ''});
            this.find();
        }
        const page = Math.floor(this.found.indexOf(index) / this.run.inMarkup);
        if (page !== this.page) {
            this.page = page;
            await this.show();
        }
        const section = document.getElementById(location.hash.slice(1));
        unfold(section);
        await bringIntoView(section ?? this.table.tBodies[0].rows[this.found.indexOf(index) % this.run.inMarkup]);
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
