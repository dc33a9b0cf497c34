// What the viewer stands over: the ids and depths of a run, or the pictures of a filter study. All that depends on
// which of them it is, is asked for here.
import type {Layer} from './layers';
import type {LinkTarget} from './link';
import type {Notice} from './notice';
import type {OpenView} from './open_view';
import type {Planes} from './planes';
import type {Selection} from './raster';
import type {ViewEntry} from './run';

/// All that is known of the pixel under the crosshair.
export type PixelInspector = {
    readonly root: HTMLElement;
    show(planes: Planes | null, x: number, y: number): void;
    copyLink(): void;
    copyCommand(): void;
};

/// From one telling pixel to the next.
export type PixelWalk = {
    toNext(direction: 1 | -1): void;      // N and P
    bySeverity(direction: 1 | -1): void;  // U and Y
    toStory(): void;                      // S
};

/// What stands below the panes.
export type PixelDrawer = {
    readonly root: HTMLElement;
    readonly note: HTMLElement;  // what is filtered, for the bar
    show(): void;
    showHistograms(planes: Planes): Promise<void>;
    clearFilter(): void;
    redraw(): void;
};

/// How the list of views shows one.
export type EntryStyle = {
    words(view: ViewEntry): string;  // that a search looks at
    mark(view: ViewEntry): {text: string; kind: string; title: string};
    line(view: ViewEntry): {text: string; kind: string};
    bar(view: ViewEntry): HTMLElement | null;
    chips: {label: HTMLElement; title: string; holds(view: ViewEntry): boolean}[];
};

/// What the viewer lends to its subject.
export type Stage = {
    current: OpenView;
    notice: Notice;
    go(pixel: number): void;
    select(selection: Selection | null): void;
    link(): string;          // to the pixel under the crosshair
    relayer(): void;         // layers() gives others now
    tile(layers: string[]): void;  // these ids side by side
};

export type Subject = {
    inspector: PixelInspector;
    walk: PixelWalk;
    drawer: PixelDrawer;
    tools: HTMLElement | null;  // for the bar
    entries: EntryStyle;
    facts(view: ViewEntry): string;                     // for the title
    open(planes: Planes): Promise<void>;                // what the parts ask of every view
    layers(planes: Planes): Layer[];
    atOnce(planes: Planes): string[];                   // planes to decode before the view is shown
    later(planes: Planes): string[];                    // and soon after
    place(): Partial<LinkTarget>;                       // its own part of a link
    follow(place: LinkTarget): void;
    keys: [name: string, meaning: string, acts: Record<string, () => void>][];  // beside those of every page
};
