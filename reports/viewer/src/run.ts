// What the page says of the run, written by reports/html_planes.cpp.

export type ViewEntry = {
    anchor: string; link: string; folder: string; scene: string; view: string; outcome: string; message: string;
    candidate: string; reference: string; width: number; height: number; triangles: number; counts: number[];
    leftOut: string[];  // names of blocks that the page does not hold
    planes: boolean;    // is there a planes.zvp at all?
    cause?: string;
};

export type ClassStyle = {name: string; glyph: string; colour: string; meaning: string; passes: boolean};

export type Run = {views: ViewEntry[]; classes: ClassStyle[]};

export function readRun(): Run | null {
    const text = document.getElementById('run')?.textContent;
    return text ? JSON.parse(text) as Run : null;
}

export function defects(view: ViewEntry, classes: ClassStyle[]): number {
    return view.counts.reduce((sum, count, i) => sum + (classes[i].passes ? 0 : count), 0);
}

/// Pixels that are not `agree`.
export function differing(view: ViewEntry): number {
    return view.counts.slice(1).reduce((sum, count) => sum + count, 0);
}
