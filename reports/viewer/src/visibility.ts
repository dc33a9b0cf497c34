// The viewer's subject in report.html: what renderers say of ids and depths, and what the judge says of that.
import {Drawer} from './drawer';
import {element} from './element';
import {errorBins, ulpBins} from './filters';
import {Inspector} from './inspector';
import {layersOf} from './layers';
import {counted, grouped, rounded} from './numbers';
import type {Planes} from './planes';
import {defects, differing, outcomeInWords, outcomeMarks, wordsOf} from './run';
import type {JudgedView, Run, ViewEntry} from './run';
import type {EntryStyle, Stage, Subject} from './subject';
import {Walk} from './walk';
import {WorstTable} from './worst';

export const firstLayers = ['class', 'candidate.id', 'candidate.error', 'reference.id'];

/// Every view of a run is judged.
function judged(view: ViewEntry): JudgedView { return view as JudgedView; }

function entryStyle(run: Run): EntryStyle {
    return {
        words: (view) => wordsOf(judged(view), run.classes),
        mark: (view) => ({text: outcomeMarks[judged(view).outcome], kind: judged(view).outcome, title: outcomeInWords(judged(view))}),
        line(view) {
            const wrong = defects(judged(view), run.classes);
            return {kind: wrong ? 'defective' : 'quiet', text: wrong ? counted(wrong, 'defect')
                : view.planes ? grouped(differing(judged(view))) + ' admissible differences' : view.message || 'not judged'};
        },
        bar: (view) => shares(judged(view), run),
        chips: run.classes.flatMap((style, i) => i > 0 && run.views.some((view) => view.counts[i] > 0) ? [{
            label: element('span', {}, element('i', {style: `background:${style.colour}`}), ` ${style.glyph} ${style.name}`),
            title: style.meaning, holds: (view: ViewEntry) => judged(view).counts[i] > 0,
        }] : []),
    };
}

/// The shares of the classes but `agree`, each at least a sliver.
function shares(view: JudgedView, run: Run): HTMLElement | null {
    const all = differing(view);
    if (!all) return null;
    return element('span', {class: 'shares', 'aria-hidden': 'true'}, ...view.counts.map((count, i) =>
        i > 0 && count > 0 && element('i', {style: `flex:${Math.max(count, all / 25)};background:${run.classes[i].colour}`})));
}

function drawerOf(run: Run, stage: Stage): Drawer {
    return new Drawer(stage, {
        table: new WorstTable(run.classes, stage.go),
        title: 'Classes', styles: run.classes,
        counts: (_, view) => judged(view).counts,
        remark: (counts) => `${rounded(100 * (1 - counts[0] / counts.reduce((a, b) => a + b, 0)))} % differ`,
        holds: (planes, kind) => (p) => planes.classes[p] === kind,
        bins: [
            async (planes) => planes.has('candidate.error') ? errorBins(await planes.bytes('candidate.error'))
                : 'Depth error / bound: not in this page',
            async (planes) => planes.has('candidate.depth') && planes.has('reference.depth')
                ? ulpBins(...await Promise.all([planes.words('candidate.depth'), planes.words('reference.depth')]))
                : 'Depths apart: not in this page',
        ],
    });
}

/// The cause of its defects, and what the candidate promises.
function aboutView(run: Run, view: JudgedView | undefined): HTMLElement | null {
    if (!view) return null;
    const promise = run.promises[view.candidate];
    return element('dl', {class: 'bound'},
        ...view.cause ? [element('dt', {}, 'likely cause'), element('dd', {}, view.cause)] : [],
        ...promise ? [element('dt', {}, 'promised'), element('dd', {}, promise)] : []);
}

export function visibilityOf(run: Run, stage: Stage): Subject {
    const walk = new Walk(stage.current, run.classes, stage.go, stage.notice);
    return {
        inspector: new Inspector(run.classes, () => aboutView(run, stage.current.entry as JudgedView | undefined), (text, what) => void stage.notice.copy(text, what), stage.link, () => walk.toStory()),
        walk, drawer: drawerOf(run, stage), tools: null, entries: entryStyle(run),
        facts: (view) => `${judged(view).candidate} against ${judged(view).reference}, ${view.width} × ${view.height}, ` +
            counted(judged(view).triangles, 'triangle'),
        open: async () => {},
        layers: (planes) => layersOf(run.classes, new Set([...planes.names(), ...planes.leftOut]), planes.judged.oracles),
        atOnce: () => ['candidate.id', 'reference.id', 'candidate.error'],
        later: (planes: Planes) => planes.names().filter((name) => /^oracle\..*\.(id|depth)$|^reference\.error$/.test(name)),
        place: () => ({}),
        follow: () => {},
        keys: [],
    };
}
