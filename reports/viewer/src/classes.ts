// Classes or regions of a view with their counts; one of them may be looked at alone.
import {element, replaceChildren} from './element';
import {badge} from './inspector';
import {grouped} from './numbers';
import type {ClassStyle} from './run';

export type ListedStyle = Pick<ClassStyle, 'name' | 'glyph' | 'colour' | 'meaning'>;

export class ClassList {
    readonly root = element('div', {class: 'classes'});

    constructor(private readonly title: string, private readonly styles: ListedStyle[],
                private readonly onChoice: (kind: number) => void) {}

    show(counts: number[], remark: string): void {
        replaceChildren(this.root, element('h3', {}, this.title), ...counts.map((count, kind) => count > 0 && this.row(kind, count)),
            element('p', {class: 'fine'}, remark));
    }

    clear(): void {
        this.root.querySelectorAll('button').forEach((button) => button.setAttribute('aria-pressed', 'false'));
    }

    private row(kind: number, count: number): HTMLElement {
        const style = this.styles[kind];
        const button = element('button', {type: 'button', title: style.meaning, 'aria-pressed': 'false'},
            badge(style), element('span', {class: 'n'}, grouped(count)));
        button.addEventListener('click', () => {
            const on = button.getAttribute('aria-pressed') !== 'true';
            this.clear();
            button.setAttribute('aria-pressed', String(on));
            this.onChoice(on ? kind : -1);
        });
        return button;
    }
}
