// The viewer of report.html in a real browser, over runs of the real program.
import assert from 'node:assert/strict';
import {readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, describe, it} from 'node:test';
import {readExr, writeExr} from './exr.mjs';
import {choose, countColour, crc32, frames, isReady, makeFolder, openBrowser, openReport, paneDigest, pixelShown, press, removeFolder,
        says, shell, viewerShows, zproof} from './stage.mjs';

const small = ['--width', '480', '--height', '270'];
let folder, failing, admissible, browser;

before(async () => {
    folder = makeFolder();
    failing = join(folder, 'failing');
    admissible = join(folder, 'admissible');
    zproof(1, 'run', 'room', ...small, '--precision', 'raster,subpixel_bits=14', '--oracle', 'none', '--pictures', '--evidence', 'all', '-o', failing);
    zproof(0, 'run', 'room', 'coplanar', ...small, '--oracle', 'none', '--evidence', 'all', '-o', admissible);
    browser = await openBrowser();
});

after(async () => {
    await browser?.close();
    removeFolder(folder);
});

const results = (run) => JSON.parse(readFileSync(join(run, 'results.json'), 'utf8'));
const folderOf = (run, view) => results(run).views.find((v) => v.view === view).folder;

/// {"x,y" -> class} of every differing pixel.
function findings(run, view) {
    const lines = readFileSync(join(run, folderOf(run, view), 'findings.csv'), 'utf8').trim().split('\n').slice(1);
    return new Map(lines.map((line) => line.split(',')).map(([x, y, kind]) => [`${x},${y}`, kind]));
}

const failsGate = (kind) => ['wrong_depth', 'hole', 'outside', 'hidden', 'invalid'].includes(kind);

describe('a page from disk', () => {
    it('shows the summary at once, complains of nothing and asks for nothing', async () => {
        const page = await openReport(browser, failing);
        assert.equal(await page.isVisible('#cards'), true);
        assert.equal(await page.isVisible('#viewer'), false);
        await press(page, 'v');
        await viewerShows(page);
        await press(page, 'n', 'w', 'd', 'd', ']', 'n', 'q', '?');
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('is a usable table without scripts', async () => {
        const page = await openReport(browser, failing, '', {javaScriptEnabled: false});
        assert.match(await page.textContent('table.summary.sortable'), /room/);
        assert.equal(await page.locator('table.worst').count() > 0, true);
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('forbids itself the network', async () => {
        const page = await openReport(browser, failing);
        const refused = await page.evaluate(() => fetch('https:' + '//example.org/').then(() => 'answered', () => 'refused'));
        assert.equal(refused, 'refused');
        assert.match(page.trouble.join('\n'), /Content Security Policy/);
        await page.close();
    });

    it('sorts its tables by a click on a heading and back by another', async () => {
        const page = await openReport(browser, admissible);
        await page.selectOption('nav.pages select[aria-label=show]', 'table');
        const column = () => page.$$eval('table.summary.sortable tbody tr', (rows) => rows.map((row) => Number(row.cells[4].textContent.replace(/,/g, ''))));
        await page.click('table.summary.sortable thead th:nth-child(5)');
        assert.deepEqual(await column(), (await column()).sort((a, b) => b - a));
        await page.click('table.summary.sortable thead th:nth-child(5)');
        assert.deepEqual(await column(), (await column()).sort((a, b) => a - b));
        await page.close();
    });
});

describe('planes', () => {
    it('are decoded to the very bits of the frames', async () => {
        const page = await openReport(browser, failing, '#view=room-door');
        await press(page, 'q');
        await page.waitForFunction(() => document.getElementById('viewer').dataset.digests);
        const digests = JSON.parse(await page.evaluate(() => document.getElementById('viewer').dataset.digests));
        for (const who of ['candidate', 'reference']) {
            const {planes} = readExr(readFileSync(join(failing, folderOf(failing, 'door'), who + '.exr')));
            assert.equal(digests[who + '.id'], crc32(new Uint8Array(planes.id.buffer)), who + ' ids');
            assert.equal(digests[who + '.depth'], crc32(new Uint8Array(planes.Z.buffer)), who + ' depths');
        }
        assert.equal('candidate.colour' in digests, true);
        await page.close();
    });

    it('that the page does not hold come from planes.zvp', async () => {
        const page = await openReport(browser, failing);
        await page.evaluate(() => document.querySelectorAll('script[id^=planes-]').forEach((element) => element.remove()));
        await press(page, 'v');
        await says(page, 'holds no planes');
        await choose(page, join(failing, folderOf(failing, 'floor'), 'planes.zvp'));
        await viewerShows(page, 'room-floor');
        await press(page, 'n');
        assert.equal(failsGate(findings(failing, 'floor').get((await pixelShown(page)).join())), true);
        await page.close();
    });

    it('of another format are refused in words', async () => {
        const page = await openReport(browser, failing, '#view=room-door');
        await choose(page, join(failing, folderOf(failing, 'door'), 'candidate.exr'));
        await says(page, 'does not begin with ZVP1');
        await page.close();
    });
});

describe('a deep link', () => {
    it('opens the pixel, and the page tells what explain prints', async () => {
        const {x, y, command} = results(failing).views[0].worst[0], view = results(failing).views[0].view;
        const page = await openReport(browser, failing, `#view=room-${view}&x=${x}&y=${y}`);
        assert.deepEqual(await pixelShown(page), [x, y]);
        assert.equal(await page.textContent('#viewer .inspector h2'), `Pixel ${x}, ${y}`);
        assert.equal(await page.textContent('#viewer pre.story'), shell(command));
        assert.equal(await page.textContent('#viewer .command code'), command);
        await page.close();
    });

    it('is kept in the address while one walks', async () => {
        const page = await openReport(browser, failing, '#view=room-door&x=100&y=50');
        await press(page, 'ArrowRight', 'Shift+ArrowDown');
        await page.waitForURL(/#view=room-door&x=101&y=66$/);
        await page.close();
    });

    it('forgets the pixel where another view is opened, also one that the page holds no planes of', async () => {
        const page = await openReport(browser, failing, '#view=room-door&x=100&y=50');
        await page.evaluate(() => document.querySelectorAll('script[id^=planes-]').forEach((element) => element.remove()));
        await press(page, ']');
        await says(page, 'holds no planes');
        await page.waitForURL(/#view=room-floor$/);
        await page.close();
    });

    it('to what is not there is answered in words', async () => {
        const page = await browser.newPage();
        await page.goto(`file://${failing}/report.html#view=nowhere&x=1&y=1`);
        await says(page, 'no view "nowhere"');
        await page.close();
    });

    it('from a row of the written report leads into the viewer', async () => {
        const page = await openReport(browser, failing);
        const row = page.locator('table.worst tbody tr').first(), x = await row.getAttribute('data-x'), y = await row.getAttribute('data-y');
        await row.locator('a').click();
        await viewerShows(page);
        assert.deepEqual(await pixelShown(page), [Number(x), Number(y)]);
        await page.close();
    });
});

describe('keys', () => {
    it('go first to the worst defect that has a story, then over every defect in order, and back', async () => {
        const page = await openReport(browser, failing, '#view=room-door');
        const wrong = [...findings(failing, 'door')].filter(([, kind]) => failsGate(kind)).map(([place]) => place);
        assert.equal(wrong.length > 2, true, 'a view with several defects');
        await press(page, 'n');
        const first = wrong.indexOf((await pixelShown(page)).join()), order = [...wrong.slice(first), ...wrong.slice(0, first)];
        assert.ok(first >= 0, 'a defect');
        assert.equal(await page.locator('#viewer .inspector pre.story').count(), 1, 'its story is stored');
        for (const place of order.slice(1, 5)) {
            await press(page, 'n');
            assert.equal((await pixelShown(page)).join(), place);
        }
        await press(page, ...Array(Math.min(5, order.length)).fill('p'));
        assert.equal((await pixelShown(page)).join(), order.at(-1), 'before the first');
        await page.close();
    });

    it('go by severity, worst first', async () => {
        const page = await openReport(browser, failing, '#view=room-door');
        const severity = await page.evaluate(
            () => JSON.parse(document.getElementById('run').textContent).classes.map((c) => c.name));
        const kinds = findings(failing, 'door'), seen = [];
        for (let i = 0; i < 6; ++i) {
            await press(page, 'u');
            seen.push(severity.indexOf(kinds.get((await pixelShown(page)).join())));
        }
        assert.deepEqual(seen, [...seen].sort((a, b) => b - a));
        assert.equal(seen[0], Math.max(...[...kinds.values()].map((kind) => severity.indexOf(kind))));
        await page.close();
    });

    it('change views, panes, layers and theme', async () => {
        const page = await openReport(browser, failing, '#view=room-door');
        await press(page, ']');
        await viewerShows(page, 'room-floor');
        for (const count of ['6', '9', '2']) {
            await press(page, 'm');
            assert.equal(await page.getAttribute('#viewer .panes', 'data-count'), count);
        }
        await press(page, '4');
        assert.equal(await page.inputValue('#viewer .pane select >> nth=0'), 'reference.id');
        const before = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
        await press(page, 't');
        assert.notEqual(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), before);
        await press(page, '?');
        assert.equal(await page.isVisible('dialog.help'), true);
        await press(page, 'Escape', '/');
        await page.keyboard.type('floor');
        assert.equal(await page.locator('#viewer .view-entry').count(), 1);
        await page.close();
    });

    it('held, flip two panes, and let go, show them as before', async () => {
        const page = await openReport(browser, failing, '#view=room-door&x=200&y=100');
        const [first, second] = [await paneDigest(page, 0), await paneDigest(page, 1)];
        assert.notEqual(first, second);
        await page.keyboard.down(' ');
        await frames(page);
        assert.deepEqual([await paneDigest(page, 0), await paneDigest(page, 1)], [second, first]);
        await page.keyboard.up(' ');
        await frames(page);
        assert.deepEqual([await paneDigest(page, 0), await paneDigest(page, 1)], [first, second]);
        await page.close();
    });
});

describe('filters', () => {
    it('a bin of the histogram leaves only its pixels', async () => {
        const page = await openReport(browser, failing, '#view=room-door'), before = await paneDigest(page, 0);
        await page.focus('#viewer canvas.histogram >> nth=0');
        await page.keyboard.press('ArrowRight');
        await page.keyboard.press('Enter');
        await frames(page);
        assert.match(await page.textContent('#viewer .filter-note'), /error \/ bound/);
        assert.notEqual(await paneDigest(page, 0), before);
        await page.evaluate(() => document.activeElement.blur());
        await press(page, 'x');
        assert.equal(await paneDigest(page, 0), before);
        await page.close();
    });

    it('and their highlight outlive a change of the theme', async () => {
        const page = await openReport(browser, failing, '#view=room-door');
        await page.focus('#viewer canvas.histogram >> nth=0');
        await page.keyboard.press('ArrowRight');
        await page.keyboard.press('Enter');
        const caption = () => page.textContent('#viewer .histogram-box p >> nth=0');
        assert.match(await caption(), /shown alone/);
        const shown = () => page.evaluate(() => document.querySelector('#viewer canvas.histogram').toDataURL());
        const before = await shown();
        await press(page, 't');
        assert.match(await caption(), /shown alone/);
        assert.notEqual(await shown(), before, 'drawn in the colours of the theme');
        await page.close();
    });

    it('a class leaves only its pixels to the keys', async () => {
        const page = await openReport(browser, failing, '#view=room-door'), kinds = findings(failing, 'door');
        await page.click('#viewer .classes button:has-text("edge")');
        await press(page, 'n');
        assert.equal(kinds.get((await pixelShown(page)).join()), 'edge');
        await page.close();
    });
});

describe('a single wrong pixel of two million', () => {
    it('is seen in the fitted view, and found with one key', async () => {
        const run = join(folder, 'whole'), bad = join(folder, 'bad.exr'), judged = join(folder, 'judged');
        zproof(0, 'run', 'coplanar', '--oracle', 'none', '--evidence', 'all', '-o', run);
        const view = results(run).views[0], frame = readExr(readFileSync(join(run, view.folder, 'candidate.exr')));
        const wrong = 700 * frame.width + 1234;
        frame.planes.id[wrong] = 0xfffffffe;
        writeFileSync(bad, writeExr(frame));
        zproof(1, 'compare', bad, 'coplanar', '--view', view.view, '-o', judged);
        const page = await openReport(browser, judged);
        await press(page, 'v');
        await viewerShows(page);
        assert.equal(await countColour(page, 0, [255, 255, 255]) >= 9, true, 'a dot of 3 x 3');
        await page.reload();
        await isReady(page);
        await press(page, 'n');
        await viewerShows(page);
        assert.deepEqual(await pixelShown(page), [1234, 700]);
        assert.match(await page.textContent('#viewer .inspector'), /invalid/);
        assert.match(await page.textContent('#viewer .answers'), /4294967294/);
        await page.close();
    });
});

describe('a hostile name', () => {
    it('does nothing but stand there', async () => {
        const evil = '</script><img src=x onerror="window.pwned=1">', file = join(folder, '<img src=x onerror="window.pwned=1">.gltf');
        const corners = Buffer.from(Float32Array.from([-1, -1, -3, 1, -1, -3, 0, 1, -3]).buffer);
        writeFileSync(file, JSON.stringify({
            asset: {version: '2.0'}, scene: 0, scenes: [{nodes: [0], name: evil}], nodes: [{mesh: 0, name: evil}],
            meshes: [{name: evil, primitives: [{attributes: {POSITION: 0}}]}],
            accessors: [{bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [-1, -1, -3], max: [1, 1, -3]}],
            bufferViews: [{buffer: 0, byteLength: 36}],
            buffers: [{byteLength: 36, uri: 'data:application/octet-stream;base64,' + corners.toString('base64')}],
        }));
        const run = join(folder, 'hostile');
        zproof(0, 'run', file, ...small, '--oracle', 'none', '--evidence', 'all', '-o', run);
        const page = await openReport(browser, run);
        await press(page, 'v');
        await viewerShows(page);
        await press(page, 'ArrowDown', 'n', 's');
        assert.equal(await page.evaluate(() => window.pwned), undefined);
        assert.equal(await page.locator('#viewer img').count(), 0);
        assert.match(await page.textContent('#viewer .answers'), /onerror/);
        assert.deepEqual(page.trouble, []);
        await page.close();
    });
});

describe('pages of crops', () => {
    it('move together', async () => {
        const script = readFileSync(new URL('../../reports/viewer/dist/page.js', import.meta.url), 'utf8');
        const page = await browser.newPage(), dot = 'data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=';
        const figure = (group) => `<figure data-linked="${group}"><img src="${dot}" style="width:200px;height:200px"></figure>`;
        await page.setContent(`${figure('a')}${figure('a')}${figure('b')}<script>${script}</script>`);
        await page.focus('figure div >> nth=0');
        await page.keyboard.press('+');
        const moved = await page.$$eval('figure img', (images) => images.map((image) => image.style.transform));
        assert.match(moved[0], /scale\(1\.5\)/);
        assert.deepEqual([moved[1], moved[2]], [moved[0], '']);
        await page.close();
    });
});

it('folders of views hold what the page embeds', () => {
    for (const view of results(failing).views)
        assert.equal(readdirSync(join(failing, view.folder)).includes('planes.zvp'), true);
});
