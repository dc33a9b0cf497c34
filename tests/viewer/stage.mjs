// A browser, a folder for runs, and the program: what every test here stands on.
import {execFileSync, spawnSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const {chromium} = createRequire(join(root, 'reports/viewer/package.json'))('playwright-core');

export const program = process.env.ZPROOF ?? join(root, 'build/release/zproof');

export function makeFolder() { return mkdtempSync(join(tmpdir(), 'zproof-viewer-')); }
export function removeFolder(folder) { rmSync(folder, {recursive: true, force: true}); }

/// Runs zproof; the exit status must be the expected one.
export function zproof(expected, ...words) {
    const ran = spawnSync(program, words, {encoding: 'utf8', maxBuffer: 1 << 28});
    if (ran.status !== expected) throw new Error(`zproof ${words.join(' ')}: status ${ran.status}\n${ran.stdout}${ran.stderr}`);
    return ran.stdout;
}

/// What a shell makes of "zproof explain ...", as reports spell it.
export function shell(command) {
    return execFileSync('/bin/sh', ['-c', command.replace(/^zproof /, '"$ZPROOF_PROGRAM" ') + ' || true'],
                        {encoding: 'utf8', env: {...process.env, ZPROOF_PROGRAM: program}});
}

export async function openBrowser() {
    return chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox']});
}

/// A page of a report from disk. Whatever the page complains of or asks the network for is in `page.trouble`.
export async function openReport(browser, folder, hash = '', options = {}, name = 'report.html') {
    const page = await browser.newPage({viewport: {width: 1600, height: 1000}, ...options});
    page.setDefaultTimeout(120_000);
    page.trouble = [];
    page.on('console', (message) => page.trouble.push(`console ${message.type()}: ${message.text()}`));
    page.on('pageerror', (error) => page.trouble.push('error: ' + error.message));
    page.on('request', (request) => {
        const url = request.url();
        const known = [name, 'planes/'].some((place) => url.startsWith(`file://${folder}/${place}`));
        if (!known && !/^(data|blob):/.test(url)) page.trouble.push('request: ' + url);
    });
    await page.goto(`file://${folder}/${name}${hash}`);
    if (options.javaScriptEnabled !== false) await isReady(page);
    if (hash) await viewerShows(page);
    return page;
}

/// Waits until a page with a viewer has read what it says of its views.
export async function isReady(page) {
    await page.waitForFunction(() => 'ready' in document.documentElement.dataset || !document.querySelector('#run, #study'));
}

/// Waits until the viewer shows a view (any, or the named one) with all that it decodes.
export async function viewerShows(page, view = null) {
    await page.waitForFunction((wanted) => {
        const shown = document.getElementById('viewer')?.dataset;
        return shown?.view && shown.complete === shown.view && (!wanted || shown.view === wanted);
    }, view, {timeout: 120_000});
    await frames(page);
}

/// Waits until the viewer's notice says so.
export async function says(page, words) {
    await page.waitForFunction((wanted) => document.querySelector('#viewer .notice').textContent.includes(wanted), words);
}

/// Presses O, which must ask for a file, and chooses one. The browser's own dialog stays closed: whether it is caught in
/// time would depend on the machine.
export async function choose(page, file) {
    await page.evaluate(() => { HTMLInputElement.prototype.click = function () { this.dataset.asked = 'yes'; }; });
    await press(page, 'o');
    await page.setInputFiles('input[type=file][data-asked]', file);
}

/// Lets the page draw what it has been asked to draw.
export async function frames(page) {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))));
}

export async function press(page, ...keys) {
    for (const key of keys) {
        await page.keyboard.press(key);
        await frames(page);
    }
}

export function pixelShown(page) {
    return page.evaluate(() => document.getElementById('viewer').dataset.pixel?.split(',').map(Number));
}

/// A digest of what a pane shows.
export function paneDigest(page, index = 0) {
    return page.evaluate((i) => {
        const canvas = document.querySelectorAll('#viewer .pane canvas')[i];
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let hash = 2166136261;
        for (let k = 0; k < data.length; ++k) hash = Math.imul(hash ^ data[k], 16777619);
        return hash >>> 0;
    }, index);
}

/// How many device pixels of a pane have a colour, [r, g, b].
export function countColour(page, index, colour) {
    return page.evaluate(([i, [r, g, b]]) => {
        const canvas = document.querySelectorAll('#viewer .pane canvas')[i];
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let k = 0; k < data.length; k += 4) count += data[k] === r && data[k + 1] === g && data[k + 2] === b;
        return count;
    }, [index, colour]);
}

export function crc32(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte;
        for (let k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
    }
    return (crc ^ 0xffffffff) >>> 0;
}
