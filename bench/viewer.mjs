// How long report.html takes in a browser: viewer.mjs FOLDER of a run. Prints; judges nothing.
import {readFileSync, readdirSync, statSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {isReady, openBrowser, viewerShows} from '../tests/viewer/stage.mjs';

const folder = resolve(process.argv[2] ?? 'zproof-out'), file = join(folder, 'report.html'), loads = 5;
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const ms = (values) => `${Math.round(median(values))} ms (${Math.round(Math.min(...values))} to ${Math.round(Math.max(...values))}, ${values.length} times)`;

/// Of all below this process, the largest that shows a page: bytes that lie in memory.
function renderersMemory() {
    const processes = readdirSync('/proc').filter((name) => /^\d+$/.test(name)).flatMap((pid) => {
        try {
            const status = readFileSync(`/proc/${pid}/status`, 'utf8'), field = (name) => Number(new RegExp(`^${name}:\\s+(\\d+)`, 'm').exec(status)?.[1] ?? 0);
            return [{pid: Number(pid), parent: field('PPid'), memory: 1024 * field('VmRSS'), words: readFileSync(`/proc/${pid}/cmdline`, 'utf8')}];
        } catch {
            return [];  // it has ended meanwhile
        }
    });
    const isOurs = ({parent}) => parent === process.pid || processes.some((other) => other.pid === parent && isOurs(other));
    return Math.max(...processes.filter((one) => one.words.includes('--type=renderer') && isOurs(one)).map((one) => one.memory));
}

const browser = await openBrowser(), paints = [], loaded = [], ready = [];
let page;
for (let i = 0; i < loads; ++i) {
    await page?.close();
    page = await browser.newPage({viewport: {width: 1920, height: 1080}});
    page.setDefaultTimeout(120_000);
    await page.goto('file://' + file);
    paints.push(await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime));
    await isReady(page);
    ready.push(await page.evaluate(() => performance.now()));
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
const memory = renderersMemory();
console.log(`page           ${(statSync(file).size / 1e6).toFixed(1)} MB, ${views} views`);
console.log(`first paint    ${ms(paints)}`);
console.log(`loaded         ${ms(loaded)}`);
console.log(`ready          ${ms(ready)}`);
console.log(`first view     ${Math.round(opened[0])} ms`);
if (opened.length > 1) console.log(`view switch    ${ms(opened.slice(1))}`);
console.log(`memory         ${(memory / 1e6).toFixed(0)} MB of the largest page process, after all that`);
await browser.close();
