// Tables that are sorted by a click, or Enter, on a column's heading.
//
//   <table class="sortable">: the last row of its thead holds the headings. A cell's key is its data-key or data-value, else its
//   text; keys that are numbers ("1,234", "0.93", "41 %", "1.2e+07") sort as numbers. Rows without a key stay last.
//   <th class="unsortable">: not this column. <th data-first="ascending">: the first click sorts so; else it is descending.
//   A table of which the page shows a part only listens to `sort` events, and prevents what they do by default.

type Key = {number: number; text: string};

/// The number that a text begins with, or NaN.
export function leadingNumber(text: string): number {
    const match = /^[-+−]?(?:\d[\d,\u202f]*)?\.?\d+(?:e[-+]?\d+)?|^[-+]?inf/i.exec(text.trim());
    if (!match) return NaN;
    const plain = match[0].replace(/[,\u202f]/g, '').replace('−', '-');
    return /inf/i.test(plain) ? (plain.startsWith('-') ? -Infinity : Infinity) : Number(plain);
}

function keyTextOf(row: HTMLTableRowElement, column: number): string {
    const cell = row.cells[column];
    return (cell?.dataset.key ?? cell?.dataset.value ?? cell?.textContent ?? '').trim();
}

function compare(a: Key, b: Key): number {
    const aIs = !Number.isNaN(a.number), bIs = !Number.isNaN(b.number);
    if (aIs && bIs) return a.number - b.number;
    if (aIs !== bIs) return aIs ? -1 : 1;
    return a.text.localeCompare(b.text);
}

export type SortOrder = {column: number; direction: 1 | -1};

/// The places of cells, by their texts; those without one come last.
export function sortedPlaces(texts: string[], direction: 1 | -1): number[] {
    const keys = texts.map((text) => ({number: leadingNumber(text), text}));
    return keys.map((_, place) => place).sort((a, b) => {
        if (!keys[a].text || !keys[b].text) return keys[a].text ? -1 : keys[b].text ? 1 : a - b;
        return direction * compare(keys[a], keys[b]) || a - b;
    });
}

function sortRows(table: HTMLTableElement, {column, direction}: SortOrder): void {
    for (const body of table.tBodies) {
        const rows = [...body.rows], texts = rows.map((row) => keyTextOf(row, column));
        body.append(...sortedPlaces(texts, direction).map((place) => rows[place]));
    }
}

function activate(table: HTMLTableElement, headings: HTMLTableCellElement[], heading: HTMLTableCellElement): void {
    const first = heading.dataset.first ?? 'descending', now = heading.getAttribute('aria-sort');
    const direction = (now ? now === 'descending' : first === 'ascending') ? 1 : -1;
    for (const other of headings) other.removeAttribute('aria-sort');
    heading.setAttribute('aria-sort', direction === 1 ? 'ascending' : 'descending');
    const detail: SortOrder = {column: heading.cellIndex, direction};
    if (table.dispatchEvent(new CustomEvent('sort', {detail, cancelable: true}))) sortRows(table, detail);
}

function prepare(table: HTMLTableElement): void {
    const rows = table.tHead?.rows;
    if (!rows?.length) return;
    const headings = [...rows[rows.length - 1].cells].filter((th) => !th.classList.contains('unsortable'));
    for (const heading of headings) {
        heading.tabIndex = 0;
        heading.style.cursor = 'pointer';
        heading.addEventListener('click', () => activate(table, headings, heading));
        heading.addEventListener('keydown', (event) => {
            if (event.key !== 'Enter' && event.key !== ' ') return;
            event.preventDefault();
            activate(table, headings, heading);
        });
    }
}

export function makeTablesSortable(root: ParentNode): void {
    root.querySelectorAll<HTMLTableElement>('table.sortable').forEach(prepare);
}
