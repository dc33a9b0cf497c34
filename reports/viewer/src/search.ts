// Which views a reader's words mean.

export class Search {
    private texts: string[] | null = null;

    /// `words`: all that is looked at, of each of `count` views.
    constructor(private readonly count: number, private readonly words: (index: number) => string) {}

    /// The views, in order, that have every one of the query's words; all where it has none.
    matching(query: string): number[] {
        const wanted = query.toLowerCase().split(/\s+/).filter(Boolean), found: number[] = [];
        this.texts ??= Array.from({length: this.count}, (_, i) => this.words(i).toLowerCase());
        for (let i = 0; i < this.count; ++i)
            if (wanted.every((word) => this.texts![i].includes(word))) found.push(i);
        return found;
    }
}
