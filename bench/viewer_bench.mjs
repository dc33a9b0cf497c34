// How long report.html takes in a browser: viewer_bench.mjs FOLDER of a run. Prints; judges nothing.
import {statSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {openBrowser, viewerShows} from '../tests/viewer/stage.mjs';

const folder = resolve(process.argv[2] ?? 'zproof-out'), file = join(folder, 'report.html'), loads = 5;
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const ms = (values) => `${Math.round(median(values))} ms (${Math.round(Math.min(...values))} to ${Math.round(Math.max(...values))}, ${values.length} times)`;

const browser = await openBrowser(), paints = [], loaded = [];
let page;
for (let i = 0; i < loads; ++i) {
    await page?.close();
    page = await browser.newPage({viewport: {width: 1920, height: 1080}});
    page.setDefaultTimeout(120_000);
    await page.goto('file://' + file);
    paints.push(await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime));
    loaded.push(await page.evaluate(() => performance.getEntriesByType('navigation')[0].loadEventEnd));
}
await page.keyboard.press('v');
await viewerShows(page);
const views = await page.locator('#viewer .view-entry').count(), entries = page.locator('#viewer .view-entry');
for (let i = 1; i < Math.min(views, 40); ++i) {
    await entries.nth(i).click();
    await page.waitForFunction((n) => performance.getEntriesByName('open view').length > n, i);
    await page.waitForTimeout(400);  // what comes after the switch is not part of it
}
const opened = await page.evaluate(() => performance.getEntriesByName('open view').map((entry) => entry.duration));
const session = await page.context().newCDPSession(page);
await session.send('HeapProfiler.collectGarbage');
const {usedSize, backingStorageSize = 0} = await session.send('Runtime.getHeapUsage');
console.log(`page           ${(statSync(file).size / 1e6).toFixed(1)} MB, ${views} views`);
console.log(`first paint    ${ms(paints)}`);
console.log(`loaded         ${ms(loaded)}`);
console.log(`first view     ${Math.round(opened[0])} ms`);
if (opened.length > 1) console.log(`view switch    ${ms(opened.slice(1))}`);
console.log(`memory         ${((usedSize + backingStorageSize) / 1e6).toFixed(0)} MB of scripts and planes, after all that`);
await browser.close();
