// Entry of report.html and filters.html: the written report stays as it is, and the viewer opens over it.
import {App} from './app';
import {bindKeys} from './bindings';
import {linkCharts} from './charts';
import {linkCrops} from './crops';
import {buildFrame} from './frame';
import {filterStudyOf, studyLayers} from './filter_study';
import type {Study} from './filter_study';
import {readFacts, readRun} from './run';
import type {Run} from './run';
import {Sections} from './sections';
import {makeTablesSortable} from './sortable';
import {linkSection, linkSummary} from './summary';
import {ViewList} from './view_list';
import {firstLayers as visibilityLayers, visibilityOf} from './visibility';

void main();

async function main(): Promise<void> {
    makeTablesSortable(document);
    linkCrops(document);
    linkCharts(document);
    const run = await readRun(), study = readFacts<Study>('study');
    if (run?.views.some((view) => view.planes)) {
        linkSummary(run.views, 'N', 'the first defect');
        start(new App(run.views, visibilityLayers, (stage) => visibilityOf(run, stage)));
    } else if (study?.views.some((view) => view.planes)) {
        linkSummary(study.views, 'N', 'the worst pixel');
        start(new App(study.views, studyLayers, (stage) => filterStudyOf(study, stage)));
    }
    if (run) listViews(run);
    document.documentElement.dataset.ready = '';  // for whoever drives the page
}

function listViews(run: Run): void {
    const table = document.querySelector<HTMLTableElement>('table.summary.sortable');
    if (table) new ViewList(table, run, new Sections(run, (section, view) => {
        makeTablesSortable(section);
        linkSection(section, view);
    }));
}

function start(app: App): void {
    buildFrame(app);
    bindKeys(app);
    window.addEventListener('hashchange', () => void app.follow());
    void app.follow();
}
