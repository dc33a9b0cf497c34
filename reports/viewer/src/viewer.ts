// Entry of report.html: the written report stays as it is, and the viewer opens over it.
import {App} from './app';
import {linkCrops} from './crops';
import {readRun} from './run';
import {makeTablesSortable} from './sortable';
import {linkSummary} from './summary';

makeTablesSortable(document);
linkCrops(document);
const run = readRun();
if (run?.views.some((view) => view.planes)) {
    linkSummary(run);
    void new App(run).follow();
}
