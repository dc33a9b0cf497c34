// Entry of report.html: the written report stays as it is, and the viewer opens over it.
import {App} from './app';
import {bindKeys} from './bindings';
import {linkCrops} from './crops';
import {buildFrame} from './frame';
import {readRun} from './run';
import {makeTablesSortable} from './sortable';
import {linkSummary} from './summary';

makeTablesSortable(document);
linkCrops(document);
const run = readRun();
if (run?.views.some((view) => view.planes)) {
    linkSummary(run);
    const app = new App(run);
    buildFrame(app);
    bindKeys(app);
    window.addEventListener('hashchange', () => void app.follow());
    void app.follow();
}
