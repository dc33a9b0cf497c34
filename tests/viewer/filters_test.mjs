// The viewer of filters.html in a real browser, over a study of the real program.
import assert from 'node:assert/strict';
import {copyFileSync, mkdirSync, readFileSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, describe, it} from 'node:test';
import {readExr} from './exr.mjs';
import {choose, crc32, frames, makeFolder, openBrowser, openReport, paneDigest, pixelShown, press, removeFolder, says, shell,
        viewerShows, zproof} from './stage.mjs';

const methods = ['nearest', 'trilinear-gl', 'ewa-true'], width = 96, height = 72, size = ['--width', width, '--height', height];
let folder, study, claims, browser;

before(async () => {
    folder = makeFolder();
    study = join(folder, 'study');
    zproof(0, 'filters', 'run', 'worked', 'tunnel', '--view', 'phi-45,aside', '--methods', methods.join(), ...size,
           '--flicker', '0', '-o', study);
    claims = join(folder, 'claims');
    const picture = (name) => join(study, 'pictures/worked-phi-45', name + '.exr');
    zproof(0, 'filters', 'run', 'worked', '--view', 'phi-45', '--methods', 'nearest', ...size, '--flicker', '0', '--evidence', '-o', claims,
           '--picture', 'right=' + picture('trilinear-gl'), '--picture', 'wrong=' + picture('nearest'),
           '--claim', 'right=trilinear-gl', '--claim', 'wrong=trilinear-gl', '--precision', 'gpu');
    browser = await openBrowser();
});

after(async () => {
    await browser?.close();
    removeFolder(folder);
});

const open = (hash = '', options = {}) => openReport(browser, study, hash, options, 'filters.html');
const results = () => JSON.parse(readFileSync(join(study, 'filters.json'), 'utf8'));
const exr = (name, view = 'worked-phi-45') => readExr(readFileSync(join(study, 'pictures', view, name + '.exr')));

/// |method - truth| of the worst channel at every pixel.
function errorsOf(method) {
    const floats = (picture, channel) => new Float32Array(picture.planes[channel].buffer);
    const picture = exr(method), truth = exr('truth');
    return Array.from({length: width * height}, (_, p) => Math.max(...['R', 'G', 'B'].map((c) =>
        Math.fround(Math.abs(floats(picture, c)[p] - floats(truth, c)[p])))));
}

describe('a filter study', () => {
    it('shows the written page at once, complains of nothing and asks for nothing', async () => {
        const page = await open();
        assert.equal(await page.isVisible('section[id] details[open] table.scores'), true);
        assert.equal(await page.isVisible('#viewer'), false);
        await press(page, 'v');
        await viewerShows(page);
        await press(page, 'n', 'u', 's', 'w', 'd', 'd', 'g', 'b', 'i', ']', 'n', 'q', '?');
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('holds the very bits of the pictures', async () => {
        const page = await open('#view=worked-phi-45');
        await press(page, 'q');
        await page.waitForFunction(() => document.getElementById('viewer').dataset.digests);
        const digests = JSON.parse(await page.evaluate(() => document.getElementById('viewer').dataset.digests));
        for (const [name, plane] of [['truth', 'truth'], ...methods.map((m) => [m, 'method.' + m])]) {
            const {planes} = exr(name);
            for (const [channel, letter] of [['R', 'r'], ['G', 'g'], ['B', 'b']])
                assert.equal(digests[`${plane}.${letter}`], crc32(new Uint8Array(planes[channel].buffer)), `${name} ${channel}`);
        }
        await says(page, 'every bit is what was written');
        await page.close();
    });

    it('opens its planes from a file where the page holds none', async () => {
        const page = await open();
        await page.evaluate(() => document.querySelectorAll('script[id^=planes-]').forEach((element) => element.remove()));
        await press(page, 'v');
        await says(page, 'holds no planes');
        await choose(page, join(study, 'pictures/tunnel-aside/planes.zvp'));
        await viewerShows(page, 'tunnel-aside');
        assert.match(await page.textContent('#viewer .bar h1'), /tunnel aside/);
        await page.close();
    });
});

/// The page has no room for its planes: they lie in scripts beside it.
describe('a large study', () => {
    let large;
    before(() => {
        large = join(folder, 'large');
        zproof(0, 'filters', 'run', 'tunnel', '--view', 'aside', '--methods', methods.join(), '--width', 640, '--height', 480,
               '--flicker', '0', '-o', large);
    });

    it('shows every method with the bits of its picture, from a page of 3 MB', async () => {
        assert.equal(statSync(join(large, 'filters.html')).size < 3e6, true);
        const page = await openReport(browser, large, '#view=tunnel-aside', {}, 'filters.html');
        for (const method of methods) {
            await page.selectOption('#viewer select.method', method);
            await viewerShows(page);
            assert.equal(await page.isVisible('#viewer .pane-note'), false, method);
        }
        await press(page, 'q');
        await page.waitForFunction(() => document.getElementById('viewer').dataset.digests);
        const digests = JSON.parse(await page.evaluate(() => document.getElementById('viewer').dataset.digests));
        for (const method of methods) {
            const {planes} = readExr(readFileSync(join(large, 'pictures/tunnel-aside', method + '.exr')));
            for (const channel of ['R', 'G', 'B'])
                assert.equal(digests[`method.${method}.${channel.toLowerCase()}`], crc32(new Uint8Array(planes[channel].buffer)), `${method} ${channel}`);
        }
        await says(page, 'every bit is what was written');
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('says what is missing where its page stands alone, and opens it', async () => {
        const alone = join(folder, 'alone');
        mkdirSync(alone);
        copyFileSync(join(large, 'filters.html'), join(alone, 'filters.html'));
        const page = await openReport(browser, alone, '', {}, 'filters.html');
        await press(page, 'v');
        await says(page, 'tunnel/aside cannot be shown: planes of it lie beside the page');
        await choose(page, join(large, 'pictures/tunnel-aside/planes.zvp'));
        await viewerShows(page, 'tunnel-aside');
        assert.equal(await page.isVisible('#viewer .pane-note'), false);
        await page.close();
    });
});

describe('a pixel of a study', () => {
    it('is opened by a link, with its method, and says what the command prints', async () => {
        const page = await open('#view=worked-phi-45&method=ewa-true&other=nearest');
        await press(page, 's');
        const [x, y] = await pixelShown(page);
        const printed = zproof(0, 'filters', 'explain', 'worked', '--view', 'phi-45', '--width', width, '--height', height,
                               '--pixel', `${x},${y}`, '--method', 'ewa-true');
        assert.equal(await page.textContent('#viewer pre.story'), printed);
        assert.equal(printed.startsWith(`pixel ${x},${y}, ewa-true: `), true);
        assert.equal(printed.split('\n')[0], `pixel ${x},${y}, ` + (await page.textContent('#viewer .why')).replace('ewa-true ', 'ewa-true: ').slice(0, -1));
        await page.waitForFunction((place) => location.hash.includes(place) && location.hash.includes('method=ewa-true&other=nearest'),
                                   `x=${x}&y=${y}`);
        const again = await open(await page.evaluate(() => location.hash));
        await viewerShows(again, 'worked-phi-45');
        assert.deepEqual(await pixelShown(again), [x, y]);
        assert.equal(await again.inputValue('#viewer select.method'), 'ewa-true');
        assert.equal(await again.inputValue('#viewer select.other'), 'nearest');
        await page.close();
        await again.close();
    });

    it('of the box that was inspected says what the command prints, from a script beside the page', async () => {
        const boxed = join(folder, 'boxed');
        zproof(0, 'filters', 'run', 'worked', '--view', 'phi-45', '--methods', 'nearest,trilinear-gl', ...size, '--flicker', '0',
               '--inspect', '88,64,8,8', '-o', boxed);
        const page = await openReport(browser, boxed, '#view=worked-phi-45&x=95&y=71&method=trilinear-gl', {}, 'filters.html');
        const shows = async (x, y, method) => {
            await page.waitForSelector('#viewer pre.story', {state: 'attached'});
            assert.equal(await page.textContent('#viewer pre.story'), zproof(0, 'filters', 'explain', 'worked', '--view', 'phi-45',
                '--width', width, '--height', height, '--pixel', `${x},${y}`, '--method', method));
            assert.equal(await page.locator('#viewer canvas[data-shown=read]').count(), 1);
        };
        await shows(95, 71, 'trilinear-gl');
        await press(page, 'ArrowLeft', 'ArrowUp', 'g');
        await shows(94, 70, 'nearest');
        const outside = await openReport(browser, boxed, '#view=worked-phi-45&x=87&y=71&method=trilinear-gl', {}, 'filters.html');
        assert.equal(await outside.locator('#viewer pre.story').count(), 0);
        assert.match(await outside.textContent('#viewer .inspector'), /A study with --inspect 64,40,32,32 tells every pixel/);
        assert.deepEqual([...page.trouble, ...outside.trouble], []);
        await page.close();
        await outside.close();
    });

    it('that has no inspection names the command that makes one', async () => {
        const page = await open('#view=worked-phi-45&x=3&y=71&method=trilinear-gl');
        const command = await page.textContent('#viewer .command code');
        assert.match(shell(command), /^pixel 3,71, trilinear-gl: reads level/);
        await page.close();
    });

    it('shows the values that the pictures have', async () => {
        const page = await open('#view=worked-phi-45&x=48&y=50&method=nearest&other=trilinear-gl');
        const cells = await page.$$eval('#viewer .values tbody tr', (rows) => rows.map((row) => row.cells[1].firstChild.textContent));
        const at = (name) => new Float32Array(exr(name).planes.R.buffer)[50 * width + 48];
        for (const [i, name] of ['truth', 'nearest', 'trilinear-gl'].entries()) assert.equal(Math.abs(Number(cells[i]) - at(name)) < 0.005, true, name);
        await page.close();
    });

    it('is drawn on its texture with both weights', async () => {
        const page = await open('#view=worked-phi-45&method=trilinear-gl');
        for (let i = 0; i < 20 && await page.locator('canvas[data-shown=exact]').count() === 0; ++i) await press(page, 's');  // past sampled ones
        const drawn = await page.$$eval('#viewer canvas.footprint', (all) => all.map((canvas) => {
            const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            let cyan = 0, orange = 0;
            for (let k = 0; k < data.length; k += 4) {
                cyan += data[k] < 90 && data[k + 1] > 200 && data[k + 2] > 200;
                orange += data[k] > 100 && data[k + 2] < data[k] / 2;
            }
            return {shown: canvas.dataset.shown, cyan: cyan > 0, orange: orange > 20};
        }));
        assert.deepEqual(drawn, [{shown: 'texture', cyan: true, orange: false}, {shown: 'read', cyan: true, orange: true},
                                 {shown: 'exact', cyan: true, orange: true}]);
        await page.close();
    });
});

/// Pictures of strangers: `right` is trilinear-gl as it claims, `wrong` is nearest and claims to be trilinear-gl.
describe('a picture with a claim', () => {
    const permitted = (name) => readExr(readFileSync(join(claims, 'pictures/worked-phi-45', name + '-permitted.exr'))).planes;
    const floats = (plane) => new Float32Array(plane.buffer);
    const openClaims = (place) => openReport(browser, claims, '#view=worked-phi-45&' + place, {}, 'filters.html');
    const rows = (page) => page.$$eval('#viewer .permitted tbody tr', (all) => all.map((row) => [...row.cells].slice(1).map((cell) => cell.textContent)));
    const outside = () => floats(permitted('wrong').outside);
    const farthest = () => outside().indexOf(Math.max(...outside()));

    it('counts the pixels outside as the check does', async () => {
        const page = await openClaims('x=48&y=50&method=wrong');
        const count = outside().filter((distance) => distance > 0).length;
        const checked = zproof(1, 'filters', 'check', 'trilinear-gl', 'worked', '--view', 'phi-45', ...size, '--precision', 'gpu',
                               '--picture', join(claims, 'pictures/worked-phi-45/wrong.exr'));
        assert.equal(checked.includes(`${count} of ${width * height} pixels outside`), true, checked);
        const shown = await page.textContent('#viewer .inspector');
        assert.equal(shown.includes(`${count.toLocaleString('en')} pixels of ${(width * height).toLocaleString('en')} outside`), true, shown);
        await page.close();
    });

    it('shows for each channel what was found, what is permitted, and how far it is outside', async () => {
        const page = await openClaims('x=0&y=0&method=wrong');
        await page.click('#viewer button:has-text("Next pixel outside")');
        const [x, y] = await pixelShown(page), pixel = y * width + x;
        assert.equal(pixel, farthest());
        const planes = permitted('wrong'), found = exr('nearest').planes;
        for (const [i, channel] of ['R', 'G', 'B'].entries()) {
            const [value, least, greatest] = [found[channel], planes['least.' + channel], planes['greatest.' + channel]].map((plane) => floats(plane)[pixel]);
            const [shown, low, high, side] = (await rows(page))[i];
            assert.deepEqual([shown, low, high].map((text) => Math.fround(Number(text))), [value, least, greatest], channel);
            const rank = (number) => new Int32Array(Float32Array.of(number).buffer)[0];
            const ulps = value < least ? rank(least) - rank(value) : value > greatest ? rank(value) - rank(greatest) : 0;
            const words = ulps === 0 ? /^inside$/ : new RegExp(`^${ulps.toLocaleString('en')} ulp \\([0-9.e-]+/255\\) ${value < least ? 'below' : 'above'}$`);
            assert.match(side, words, channel);
        }
        assert.match(await page.textContent('#viewer .why'), /^wrong claims to be trilinear-gl, which reads level/);
        assert.equal(await page.locator('#viewer canvas[data-shown=read]').count(), 1);
        assert.match(shell(await page.textContent('#viewer .command code')), new RegExp(`^pixel ${x},${y}, trilinear-gl: `));
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('that keeps it is inside everywhere', async () => {
        const page = await openClaims('x=48&y=50&method=right');
        assert.deepEqual((await rows(page)).map((row) => row[3]), ['inside', 'inside', 'inside']);
        assert.match(await page.textContent('#viewer .claim'), /Permitted by trilinear-gl, promising gpu/);
        assert.match(await page.textContent('#viewer .inspector'), /0 pixels of 6,912 outside/);
        assert.equal(await page.locator('#viewer button:has-text("Next pixel outside")').count(), 0);
        await page.close();
    });

    it('has a pane of the pixels outside, dark where it keeps it', async () => {
        const layers = 'layers=outside,truth,outside,truth';
        const wrong = await openClaims('method=wrong&' + layers), right = await openClaims('method=right&' + layers);
        const lit = (page) => page.evaluate(() => {
            const canvas = document.querySelector('#viewer .pane canvas'), {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const colours = new Set();
            for (let k = 0; k < data.length; k += 4) colours.add(data[k] << 16 | data[k + 1] << 8 | data[k + 2]);
            return colours.size;
        });
        assert.equal(await lit(wrong) > 10, true);
        assert.equal(await lit(right) <= 3, true);
        await wrong.close();
        await right.close();
    });

    it('is none without --claim', async () => {
        const page = await openClaims('x=48&y=50&method=nearest');
        assert.equal(await page.locator('#viewer .claim').count(), 0);
        await page.close();
    });
});

describe('the look of a study', () => {
    const sized = (width, hash = '') => open('#view=worked-phi-45&method=trilinear-gl' + hash, {viewport: {width, height: 900}});
    const texts = (page, selector) => page.$$eval(selector, (all) => all.map((one) => [one.textContent, one.scrollWidth > one.clientWidth]));

    it('cuts no column of the worst pixels and no value of a pane', async () => {
        for (const width of [1600, 1400, 1280, 1000]) {
            const page = await sized(width, '&x=48&y=50');
            assert.deepEqual((await texts(page, '#viewer .worst-box')).map(([, isCut]) => isCut), [false], `${width} px`);
            assert.deepEqual((await texts(page, '#viewer .pane:not([hidden]) .pane-value')).filter(([, isCut]) => isCut), [], `${width} px`);
            await page.close();
        }
        const coloured = await open('#view=tunnel-aside&method=nearest&x=48&y=50', {viewport: {width: 1400, height: 900}});
        assert.deepEqual((await texts(coloured, '#viewer .pane:not([hidden]) .pane-value')).filter(([text, isCut]) => isCut || text.split(' ').length !== 3), []);
        await coloured.close();
    });

    it('fits a narrow window, bar and panes', async () => {
        const page = await sized(390);
        const right = await page.$$eval('#viewer .bar > *, #viewer .pane:not([hidden])', (all) => Math.max(...all.map((one) => one.getBoundingClientRect().right)));
        assert.equal(right <= 390, true, `${right} px`);
        await page.close();
    });

    /// What is drawn since a canvas was last cleared: labels of ticks as [which canvas, x, half of the width], and lines.
    const watched = async (hash) => {
        const page = await browser.newPage({viewport: {width: 1400, height: 900}});
        await page.addInitScript(() => {
            window.labels = [];
            window.lines = new Map();
            const {fillText, clearRect, lineTo, putImageData} = CanvasRenderingContext2D.prototype;
            Object.assign(CanvasRenderingContext2D.prototype, {
                fillText(text, x, y) {
                    if (this.canvas.className === 'histogram' && this.textAlign === 'center')
                        window.labels.push([this.canvas, x, this.measureText(text).width / 2]);
                    fillText.call(this, text, x, y);
                },
                clearRect(...where) {
                    window.labels = window.labels.filter(([canvas]) => canvas !== this.canvas);
                    clearRect.apply(this, where);
                },
                lineTo(...to) {
                    if (this.canvas.closest('.pane')) window.lines.set(this.canvas, window.lines.get(this.canvas) + 1);
                    lineTo.apply(this, to);
                },
                putImageData(...what) {
                    window.lines.set(this.canvas, 0);
                    putImageData.apply(this, what);
                },
            });
        });
        await page.goto(`file://${study}/filters.html#view=worked-phi-45&method=trilinear-gl${hash}`);
        await viewerShows(page);
        return page;
    };

    it('has a key of colours for errors, and labels of ticks apart', async () => {
        const page = await watched('');
        const gaps = await page.evaluate(() => window.labels.flatMap(([canvas, x, half], i) => {
            const [before, left, width] = window.labels[i - 1] ?? [];
            return before === canvas ? [x - half - left - width] : [];
        }));
        assert.equal(gaps.length >= 3 && Math.min(...gaps) >= 2, true, `${gaps}`);
        const heads = await page.$$eval('#viewer .pane:not([hidden])', (panes) => panes.map((pane) => [
            pane.querySelector('select').selectedOptions[0].textContent, pane.querySelector('.colour-key').textContent]));
        assert.deepEqual(heads, [['trilinear-gl', ''], ['truth', ''], ['trilinear-gl − truth', 'darkerbrighter'], ['nearest', '']]);
        await page.close();
    });

    it('draws no line through the numbers of pixels', async () => {
        const linesAt = async (zoom) => {
            const page = await watched(`&x=48&y=50&zoom=${zoom}`);
            const lines = await page.evaluate(() => [...window.lines].filter(([canvas]) => canvas.closest('.pane')).map(([, count]) => count));
            await page.close();
            return lines;
        };
        assert.deepEqual(await linesAt(12), [8, 8, 8, 8]);
        assert.deepEqual(await linesAt(40), [0, 0, 0, 0]);
    });

    it('leaves out the list where there is one view', async () => {
        const page = await openReport(browser, claims, '#view=worked-phi-45', {}, 'filters.html');
        assert.equal(await page.isVisible('#viewer .scenes'), false);
        assert.equal((await page.locator('#viewer .stage').boundingBox()).x, 0);
        await page.close();
    });
});

describe('the keys of a study', () => {
    it('N goes to the worst pixel of all, U after U by falling error', async () => {
        const errors = errorsOf('trilinear-gl'), page = await open('#view=worked-phi-45&method=trilinear-gl');
        const shown = async () => { const [x, y] = await pixelShown(page); return errors[y * width + x]; };
        await press(page, 'n');
        assert.equal(await shown(), Math.max(...errors));
        await press(page, 'u', 'u', 'u');
        const after = await shown(), higher = errors.filter((e) => e > after).length;
        assert.equal(higher <= 3, true, `${higher} pixels are worse`);
        await page.close();
    });

    it('flip, wipe and another method change what a pane shows', async () => {
        const page = await open('#view=worked-phi-45&method=nearest&other=ewa-true');
        const before = await paneDigest(page, 0);
        await page.keyboard.down(' ');
        await frames(page);
        assert.equal(await paneDigest(page, 0), await paneDigest(page, 0));
        assert.notEqual(await paneDigest(page, 0), before);
        await page.keyboard.up(' ');
        await press(page, 'w');
        assert.notEqual(await paneDigest(page, 0), before);
        await press(page, 'w');
        assert.equal(await paneDigest(page, 0), before);
        await press(page, 'g');
        await viewerShows(page);
        assert.equal(await page.inputValue('#viewer select.method'), 'trilinear-gl');
        assert.notEqual(await paneDigest(page, 0), before);
        await page.close();
    });

    it('all methods stand side by side, and errors after pictures', async () => {
        const page = await open('#view=worked-phi-45&method=trilinear-gl');
        const shown = () => page.$$eval('#viewer .pane:not([hidden]) > .pane-head select', (all) => all.map((one) => one.value));
        for (const kind of ['picture', 'error']) {
            await press(page, 'f');
            assert.deepEqual(await shown(), ['trilinear-gl', 'ewa-true', 'nearest'].map((method) => `${kind}:${method}`));
        }
        await press(page, 'f');
        assert.deepEqual(await shown(), ['method', 'truth', 'signed', 'other']);
        for (const count of [6, 9, 2]) {
            await press(page, 'm');
            assert.equal((await shown()).length, count);
        }
        assert.deepEqual(page.trouble, []);
        await page.close();
    });

    it('a link opens as many panes as it names', async () => {
        const page = await open('#view=worked-phi-45&layers=truth,picture%3Anearest,error%3Anearest');
        assert.equal(await page.getAttribute('#viewer .panes', 'data-count'), '3');
        await page.close();
    });

    it('exposure, range and colours of errors change panes and their keys, and come back', async () => {
        const page = await open('#view=worked-phi-45&method=trilinear-gl&layers=method,error,signed,other');
        const heads = () => page.$$eval('#viewer .pane:not([hidden])', (panes) => panes.map((pane) =>
            pane.querySelector('select').selectedOptions[0].textContent + ' ' + pane.querySelector('.colour-key').textContent));
        const digests = async () => [await paneDigest(page, 0), await paneDigest(page, 1), await paneDigest(page, 2)];
        const before = await digests(), first = await heads();
        const after = async (...keys) => {
            await press(page, ...keys);
            await viewerShows(page);
            return (await digests()).map((digest, i) => digest !== before[i]);
        };
        assert.deepEqual(await after(')'), [true, false, false]);
        assert.match((await heads())[0], /^trilinear-gl, \+1 EV/);
        assert.deepEqual(await after('('), [false, false, false]);
        assert.deepEqual(await after('r'), [false, true, true]);
        assert.match((await heads())[1], /0\.000244.*0\.25$/);
        assert.deepEqual(await after('r', 'r', 'r'), [false, false, false]);
        assert.deepEqual(await after(';'), [false, true, false]);
        assert.deepEqual(await after(';'), [false, false, false]);
        assert.deepEqual(await heads(), first);
        await page.close();
    });

    it('a region and a bin leave only their pixels', async () => {
        const page = await open('#view=worked-phi-45&method=nearest');
        const {pixels} = results().views[0].methods[0].regions.find((r) => r.region === 'anisotropy 2-4');
        await page.click('#viewer .classes button:has-text("anisotropy 2-4")');
        const rows = await page.$$eval('#viewer .clusters tbody tr', (all) => all.map((row) => [row.cells[0].textContent, row.cells[1].textContent]));
        assert.deepEqual(rows.find(([name]) => name === 'all'), ['all', pixels.toLocaleString('en')]);
        await press(page, 'x');
        const before = await paneDigest(page, 2);
        await page.focus('#viewer canvas.histogram >> nth=0');
        await page.keyboard.press('ArrowRight');
        await page.keyboard.press('Enter');
        await frames(page);
        assert.notEqual(await paneDigest(page, 2), before);
        assert.match(await page.textContent('#viewer .filter-note'), /nearest − truth/);
        await page.close();
    });
});

/// Most pixels of this view have no error: sampled, or averaged, the view would be dark where checks are large.
it('the worst error is seen when the view is much smaller than its pixels', async () => {
    const page = await open('#view=worked-phi-45&method=nearest&layers=error,truth,error,error');
    await press(page, '0');
    for (let i = 0; i < 8; ++i) await press(page, '-');
    const [shown, dark] = await page.evaluate(() => {
        const canvas = document.querySelector('#viewer .pane canvas');
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let all = 0, without = 0;
        for (let k = 0; k < data.length; k += 4) {
            all += data[k] !== 0x0a;        // within the view
            without += data[k] === 0x14;    // no error
        }
        return [all, without];
    });
    const errors = errorsOf('nearest'), free = errors.filter((e) => e === 0).length / errors.length;
    assert.equal(shown > 50, true);
    assert.equal(free > 0.4, true);
    assert.equal(dark / shown < 0.6 * free, true, `${dark} of ${shown} show no error, of the pixels ${free}`);
    await page.close();
});

describe('the written page', () => {
    it('has room for every column at 1400 pixels, also with many methods', async () => {
        const page = await open('', {viewport: {width: 1400, height: 1000}});
        await page.evaluate(() => document.querySelectorAll('table.scores tbody tr:first-child').forEach((row) => {
            row.cells[1].textContent = 'supersample-nearest:n=8:wrap=mirrored';
            [...row.cells].slice(2, 4).forEach((cell) => { cell.className = 'n open'; cell.textContent = 'not resolved'; });
        }));
        const cut = await page.$$eval('.wide', (all) => all.filter((box) => box.scrollWidth > box.clientWidth).length);
        assert.equal(cut, 0);
        await page.close();
    });

    it('puts the best first at the first click on a metric', async () => {
        const page = await open();
        const column = async (name) => {
            const heads = await page.$$eval('section[id] details[open] table.scores >> nth=0 >> th', (all) => all.map((th) => th.textContent));
            const at = heads.indexOf(name);
            await page.click(`section[id] details[open] table.scores >> nth=0 >> th >> nth=${at}`);
            return page.$$eval('section[id] details[open] table.scores >> nth=0 >> tbody tr', (rows, i) => rows.map((row) => Number(row.cells[i].textContent)), at);
        };
        const rmse = await column('rmse');
        assert.deepEqual(rmse, [...rmse].sort((a, b) => a - b));
        const psnr = await column('psnr');
        assert.deepEqual(psnr, [...psnr].sort((a, b) => b - a));
        await page.close();
    });

    it('lets a reader choose among the series of its charts', async () => {
        const page = await open();
        const drawn = () => page.$$eval('.plots >> nth=0 >> g.series', (all) =>
            [...new Set(all.filter((g) => getComputedStyle(g).display !== 'none').map((g) => g.dataset.series))].sort());
        assert.deepEqual(await drawn(), [...methods].sort());
        const chip = '.chart-legend >> nth=0 >> button[data-series="ewa-true"]';
        await page.hover(chip);
        assert.equal(await page.$eval('.plots', (plots) => plots.classList.contains('pointing')), true);
        assert.deepEqual(await page.$$eval('.plots >> nth=0 >> g.series.lit', (all) => [...new Set(all.map((g) => g.dataset.series))]), ['ewa-true']);
        await page.click(chip);
        assert.deepEqual(await drawn(), ['ewa-true']);
        await page.click('.chart-legend >> nth=0 >> button:text-is("all")');
        assert.deepEqual(await drawn(), [...methods].sort());
        await page.close();
    });

    it('shows the error below every crop of a method', async () => {
        const page = await open();
        assert.deepEqual(await page.$$eval('.crops >> nth=0 >> > div', (all) => all.map((one) => one.querySelectorAll('figure').length)), [1, 2, 2, 2]);
        await page.close();
    });
});
