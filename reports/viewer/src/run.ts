// What the page says of its views; of a run, by reports/html_planes.cpp.

/// What every page says of a view.
export type ViewEntry = {
    anchor: string; link: string; folder: string; scene: string; view: string; message: string;
    width: number; height: number;
    leftOut: string[];  // names of blocks that the page does not hold
    planes: boolean;    // is there a planes.zvp at all?
};

export type JudgedView = ViewEntry & {
    outcome: string; candidate: string; reference: string; triangles: number; counts: number[]; cause?: string;
};

export type ClassStyle = {name: string; glyph: string; colour: string; meaning: string; passes: boolean};

export type Run = {views: JudgedView[]; classes: ClassStyle[]};

/// The page's JSON of that id, or null.
export function readFacts<T>(id: string): T | null {
    const text = document.getElementById(id)?.textContent;
    return text ? JSON.parse(text) as T : null;
}

export function defects(view: JudgedView, classes: ClassStyle[]): number {
    return view.counts.reduce((sum, count, i) => sum + (classes[i].passes ? 0 : count), 0);
}

/// Pixels that are not `agree`.
export function differing(view: JudgedView): number {
    return view.counts.slice(1).reduce((sum, count) => sum + count, 0);
}
