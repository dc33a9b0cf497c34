// What the page says of its views; of a run, by reports/html_planes.cpp and html_packs.cpp.
import {unpackAll} from './packed';

/// What every page says of a view.
export type ViewEntry = {
    anchor: string; link: string; folder: string; scene: string; view: string; message: string;
    width: number; height: number;
    planes: boolean;  // is there a planes.zvp at all?
};

export type JudgedView = ViewEntry & {
    outcome: string; source: string; candidate: string; reference: string; triangles: number; counts: number[]; cause: string;
    row: string;      // its texts in the summary's columns, a tab between two; empty where it was not judged
    seconds: string;
};

/// A column of the summary behind verdict and name.
export type Column = {kind: string; quietZeros: boolean};

export type ClassStyle = {name: string; glyph: string; colour: string; meaning: string; passes: boolean};

export type Run = {
    views: JudgedView[]; classes: ClassStyle[]; columns: Column[];
    promises: Record<string, string>;  // what each renderer declares, in words
    facts: string[];   // names of what is known of a view, in the order of its array
    inMarkup: number;  // views that stand in the page as markup; so many are shown at once
    inPack: number;    // sections
};

/// The page's JSON of that id, or null.
export function readFacts<T>(id: string): T | null {
    const text = document.getElementById(id)?.textContent;
    return text ? JSON.parse(text) as T : null;
}

/// The run with its views, failed ones first; null where the page has none.
export async function readRun(): Promise<Run | null> {
    const run = readFacts<Run>('run');
    if (!run) return null;
    run.views = (await unpackAll('facts')).flatMap((text) => JSON.parse(text) as unknown[][]).map((values, i) => {
        const view: Record<string, unknown> = {anchor: `view-${i + 1}`};
        for (let k = 0; k < run.facts.length; ++k) view[run.facts[k]] = values[k];
        return view as JudgedView;
    });
    return run;
}

/// All that a search looks at.
export function wordsOf(view: JudgedView, classes: ClassStyle[]): string {
    const found = classes.filter((_, i) => i > 0 && view.counts[i] > 0).map((style) => style.name);
    return [view.scene, view.view, view.source, view.outcome, outcomeInWords(view), view.cause, ...found].join(' ');
}

export function outcomeInWords(view: JudgedView): string { return view.outcome.replace('_', ' '); }

export const outcomeMarks: Record<string, string> = {
    proven: '✓', defective: '✗', undecided: '?', unreadable: '!', not_judged: '?', internal_error: '!'};

export function defects(view: JudgedView, classes: ClassStyle[]): number {
    return view.counts.reduce((sum, count, i) => sum + (classes[i].passes ? 0 : count), 0);
}

/// Pixels that are not `agree`.
export function differing(view: JudgedView): number {
    return view.counts.slice(1).reduce((sum, count) => sum + count, 0);
}
