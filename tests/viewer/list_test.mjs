// What report.html shows before the viewer is opened: the answer, cards, lists to choose from, folded sections.
import assert from 'node:assert/strict';
import {readFileSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, describe, it} from 'node:test';
import {makeFolder, openBrowser, openReport, removeFolder, viewerShows, zproof} from './stage.mjs';

let folder, run, browser;

before(async () => {
    folder = makeFolder();
    run = join(folder, 'run');
    zproof(1, 'run', 'room', 'shared_edges', 'near_plane', '--width', '320', '--height', '180', '--oracle', 'none',
        '--precision', 'raster,subpixel_bits=11', '-o', run);
    browser = await openBrowser();
});

after(async () => {
    await browser?.close();
    removeFolder(folder);
});

const results = () => JSON.parse(readFileSync(join(run, 'results.json'), 'utf8'));
const count = (outcome) => results().views.filter((view) => view.outcome === outcome).length;
const shown = (page) => page.$$eval('#cards > a', (all) => all.map((card) => card.querySelector('.outcome').textContent));
const choose = (page, list, value) => page.selectOption(`nav.pages select[aria-label=${list}]`, value);
const untilShown = (page, n) => page.waitForFunction((wanted) => document.querySelectorAll('#cards > a').length === wanted, n);

describe('the page', () => {
    it('has a picture of every view, failed ones first, and two verdicts to tell apart', async () => {
        assert.ok(count('defective') > 0 && count('proven') > 0, 'the run is worth a test');
        const page = await openReport(browser, run), outcomes = await shown(page);
        assert.equal(await page.locator('#cards > a img').count(), results().views.length);
        assert.deepEqual(outcomes, [...outcomes].sort((a, b) => b.localeCompare(a)));
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('has no empty boxes of views that left no frames, and says why', async () => {
        const random = join(folder, 'random');
        zproof(0, 'run', '--random', '2', '--oracle', 'none', '-o', random);
        const page = await openReport(browser, random);
        assert.deepEqual(await page.$$eval('#cards > a > :first-child', (all) => all.map((one) => one.className)), ['name', 'name']);
        assert.equal(await page.textContent('p.rings'), ' Views without a picture left no frames; --evidence all keeps them.');
        await page.close();
    });

    it('shows the cards and the table without scripts', async () => {
        const page = await openReport(browser, run, '', {javaScriptEnabled: false});
        assert.equal(await page.locator('#cards > a img').count(), results().views.length);
        await page.click('details#table > summary');
        assert.equal(await page.locator('details#table tbody tr:visible').count(), results().views.length);
        await page.close();
    });

    it('folds a proven view until its card is clicked; then it has the picture of the card', async () => {
        const page = await openReport(browser, run), last = `#view-${results().views.length}`;
        assert.equal(await page.$eval(`${last} details`, (details) => details.open), false);
        await page.click(`#cards > a[href="${last}"]`);
        await page.waitForFunction((id) => document.querySelector(`${id} details`).open, last);
        assert.ok(await page.isVisible(`${last} figure.of-card img`));
        await page.close();
    });

    for (const width of [1400, 1000, 390])
        it(`is not wider than a window of ${width} pixels`, async () => {
            const page = await openReport(browser, run, '', {viewport: {width, height: 900}});
            assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
            await page.close();
        });
});

describe('the lists', () => {
    it('leave the views that have what is chosen, and the address keeps the choice', async () => {
        const page = await openReport(browser, run);
        await choose(page, 'verdict', 'proven');
        await untilShown(page, count('proven'));
        assert.match(page.url(), /#verdict=proven$/);
        await choose(page, 'scene', 'room');
        const rooms = results().views.filter((view) => view.outcome === 'proven' && view.scene === 'room').length;
        await untilShown(page, rooms);
        await page.reload();
        await untilShown(page, rooms);
        assert.equal(await page.inputValue('nav.pages select[aria-label=verdict]'), 'proven');
        await choose(page, 'verdict', '');
        await choose(page, 'scene', '');
        await untilShown(page, results().views.length);
        await page.close();
    });

    it('turn pictures into the table and back', async () => {
        const page = await openReport(browser, run);
        await choose(page, 'show', 'table');
        await page.waitForFunction(() => document.getElementById('table').open);
        assert.equal(await page.isVisible('#cards'), false);
        await page.reload();
        assert.equal(await page.isVisible('#cards'), false);
        await choose(page, 'show', 'pictures');
        await page.waitForFunction(() => !document.getElementById('table').open);
        assert.ok(await page.isVisible('#cards'));
        await page.close();
    });

    it('sort by name and by defects', async () => {
        const page = await openReport(browser, run);
        const names = () => page.$$eval('#cards .name', (all) => all.map((name) => name.textContent));
        await choose(page, 'sort', 'name');
        await page.waitForFunction(() => document.querySelector('#cards .name').textContent.startsWith('near_plane'));
        assert.deepEqual(await names(), (await names()).sort((a, b) => a.localeCompare(b)));
        await choose(page, 'sort', 'most defects');
        const most = Math.max(...results().views.map((view) => view.defects ?? 0)), first = await page.textContent('#cards > a .fine');
        assert.ok(most === 0 || first.length > 0);
        await page.close();
    });
});

describe('a proven view', () => {
    it('opens in the viewer with its classes', async () => {
        const {views} = results(), view = views.find((one) => one.outcome === 'proven');
        const page = await openReport(browser, run, `#view=${view.folder.replace('scenes/', '')}`);
        await viewerShows(page);
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('leaves few bytes', () => {
        for (const view of results().views.filter((one) => one.outcome === 'proven'))
            assert.ok(statSync(join(run, view.folder, 'view.webp')).size < 40_000);
    });
});
