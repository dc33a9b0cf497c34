// report.html of a run of many views: its table turns pages, is searched and sorted as a whole. The views are those of
// a real run, many times over.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, describe, it} from 'node:test';
import {frames, makeFolder, openBrowser, openReport, removeFolder, viewerShows, zproof} from './stage.mjs';

const views = 1050, pages = 6;
let folder, run, failing, browser;

before(async () => {
    folder = makeFolder();
    run = join(folder, 'run');
    const small = ['--width', '160', '--height', '90', '--oracle', 'none'], proven = join(folder, 'proven');
    zproof(1, 'run', 'room', ...small, '--precision', 'raster,subpixel_bits=14', '-o', run);
    zproof(0, 'run', 'room', ...small, '-o', proven);
    const [ours, others] = [run, proven].map((one) => JSON.parse(readFileSync(join(one, 'results.json'), 'utf8')));
    failing = ours.views.length;
    while (ours.views.length < views) {
        const i = ours.views.length;
        ours.views.push({...others.views[0], scene: `model-${i}`, view: `cam${i % 7}`, source: `models/area-${i % 10}.glb`, triangles: i});
    }
    writeFileSync(join(run, 'results.json'), JSON.stringify(ours));
    zproof(0, 'report', run, '-o', join(run, 'report.html'));
    browser = await openBrowser();
});

after(async () => {
    await browser?.close();
    removeFolder(folder);
});

const table = 'table.summary.sortable', search = 'nav.pages input[type=search]';
const names = (page) => page.$$eval(`${table} tbody tr`, (rows) => rows.map((row) => row.cells[1].textContent));
const sections = (page) => page.$$eval('#sections > section', (all) => all.map((section) => section.id));

/// Waits until the sections are those of the page's table.
async function turned(page, first) {
    await page.waitForFunction((id) => document.querySelector('#sections > section')?.id === id, first);
    await frames(page);
}

async function find(page, words, count) {
    await page.fill(search, words);
    await page.waitForFunction((n) => document.querySelectorAll('#sections > section').length === n, Math.min(count, 200));
    assert.equal(await page.textContent('nav.pages .fine'), (count === views ? '' : count.toLocaleString('en') + ' of ') + '1,050 views');
}

/// The report with its table shown.
async function openTable() {
    const page = await openReport(browser, run);
    await page.selectOption('nav.pages select[aria-label=show]', 'table');
    return page;
}

describe('the cards of a long run', () => {
    const cards = (page) => page.$$eval('#cards > a', (all) => all.map((card) => card.getAttribute('href')));

    it('turn with its pages; those behind the first are made of what is packed', async () => {
        const page = await openReport(browser, run);
        assert.equal((await cards(page)).length, 200);
        await page.click('nav.pages button[title="next page"]');
        await turned(page, 'view-201');
        assert.equal((await cards(page))[0], '#view-201');
        assert.match(await page.textContent('#cards > a'), /^model-200 cam4✓ proven/);
        assert.match(await page.getAttribute('#cards > a img', 'src'), /^data:image\/webp/);
        await page.click('#cards > a');
        await page.waitForFunction(() => document.querySelector('#view-201 details').open);
        assert.ok(await page.isVisible('#view-201 figure'));
        assert.deepEqual(page.trouble, []);
        await page.close();
    });
});

describe('the table of a long run', () => {
    it('turns its pages, and the sections with them', async () => {
        const page = await openTable();
        assert.equal((await names(page)).length, 200);
        assert.match((await names(page))[0], /^room /);
        await page.click('nav.pages button[title="next page"]');
        await turned(page, 'view-201');
        assert.equal((await names(page))[0], 'model-200 cam4');
        assert.deepEqual(await sections(page), Array.from({length: 200}, (_, i) => `view-${201 + i}`));
        assert.equal(await page.textContent('#view-201 h2 >> nth=0'), 'model-200 cam4 ✓ proven Open in the viewer');
        await page.fill('nav.pages input[type=number]', String(pages));
        await page.keyboard.press('Enter');
        await turned(page, 'view-1001');
        assert.equal((await names(page)).length, 50);
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('is searched by scene, view, verdict, class and file', async () => {
        const page = await openTable();
        await find(page, 'model-777', 1);
        assert.deepEqual(await names(page), ['model-777 cam0']);
        assert.deepEqual(await sections(page), ['view-778']);
        await find(page, 'cam3 area-7', [...Array(views).keys()].filter((i) => i >= failing && i % 7 === 3 && i % 10 === 7).length);
        await find(page, 'defective', failing);
        await find(page, 'proven AREA-2', [...Array(views).keys()].filter((i) => i >= failing && i % 10 === 2).length);
        await find(page, 'hidden proven', 0);
        await find(page, '', views);
        await page.close();
    });

    it('is sorted as a whole', async () => {
        const page = await openTable();
        await find(page, 'model', views - failing);
        await page.click(`${table} thead th:nth-child(3)`);
        await turned(page, `view-${views}`);
        assert.equal((await names(page))[0], `model-${views - 1} cam6`);
        await page.click(`${table} thead th:nth-child(3)`);
        await turned(page, `view-${failing + 1}`);
        assert.equal((await names(page))[0], `model-${failing} cam2`);
        await page.close();
    });

    it('is its first page without scripts', async () => {
        const page = await openReport(browser, run, '', {javaScriptEnabled: false});
        assert.equal((await names(page)).length, 200);
        assert.equal((await sections(page)).length, 200);
        assert.match(await page.textContent('#length'), /first 200 of 1,050 views/);
        await page.close();
    });
});

describe('a link into a long run', () => {
    it('to a section opens its page of the table', async () => {
        const page = await openReport(browser, run);
        await page.evaluate(() => { location.hash = '#view-950'; });
        await turned(page, 'view-801');
        await page.waitForFunction(() => {
            const {top} = document.querySelector('#view-950 h2').getBoundingClientRect();
            return top > document.querySelector('nav.pages').getBoundingClientRect().bottom - 1 && top < 200;
        });
        await page.close();
    });

    it('to a pixel opens the viewer, which leads back to the section', async () => {
        const {views: judged} = JSON.parse(readFileSync(join(run, 'results.json'), 'utf8')), {x, y} = judged[0].worst[0];
        const page = await openReport(browser, run, `#view=${judged[0].folder.replace('scenes/', '')}&x=${x}&y=${y}`);
        await viewerShows(page);
        assert.equal(await page.textContent('#viewer .inspector h2'), `Pixel ${x}, ${y}`);
        assert.equal(await page.locator('#viewer .view-entry').count(), 200, 'of the list, those around this view');
        assert.equal(await page.isVisible('#cards'), false);
        await page.keyboard.press('v');
        await page.waitForURL(/#view-1$/);
        assert.equal(await page.isVisible('#cards'), true);
        await page.close();
    });
});
