// What the page packs of the views behind the first ones, so many in a pack (reports/html_packs.cpp).
import {unpack} from './packed';
import type {Run} from './run';

export class Packs<T> {
    private readonly opened = new Map<string, Promise<T[]>>();

    /// `parse`: what a pack's text holds, one after another.
    constructor(private readonly kind: string, private readonly run: Run, private readonly parse: (text: string) => T[]) {}

    /// Does the page hold that of this view? Those of the first views are not packed.
    has(index: number): boolean { return document.getElementById(this.nameOf(index)) !== null; }

    /// That of the view; undefined where the page lacks it.
    async at(index: number): Promise<T | undefined> {
        const name = this.nameOf(index);
        if (!this.opened.has(name)) this.opened.set(name, unpack(name).then((text) => text === null ? [] : this.parse(text)));
        return (await this.opened.get(name)!)[(index - this.run.inMarkup) % this.run.inPack];
    }

    private nameOf(index: number): string { return `${this.kind}-${Math.floor((index - this.run.inMarkup) / this.run.inPack)}`; }
}
