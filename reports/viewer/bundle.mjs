// Bundles src/ into the files that the C++ build embeds. `bundle.mjs FOLDER` writes them; `bundle.mjs --check
// FOLDER` compares, and ends with 1 where the committed files are not what the sources give.
import {createHash} from 'node:crypto';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {build} from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry) {
    const result = await build({
        entryPoints: [join(here, 'src', entry)],
        bundle: true, minify: true, write: false, format: 'iife', target: 'es2022', charset: 'utf8',
        legalComments: 'none', logLevel: 'warning', absWorkingDir: here,
    });
    return result.outputFiles[0].text.trimEnd();
}

// A page's content security policy admits a script by the digest of its text, which must therefore be embedded
// to the byte.
function withDigest(name, text) {
    if (/<\/script|<!--/i.test(text)) throw new Error(`${name}: would end its own element`);
    if (/:\/\//.test(text)) throw new Error(`${name}: holds an address`);
    return {[name]: text, [name + '.sha256']: createHash('sha256').update(text, 'utf8').digest('base64')};
}

export async function bundles() {
    return {
        ...withDigest('viewer.js', await bundle('viewer.ts')),
        ...withDigest('page.js', await bundle('page.ts')),
        'viewer.css': await bundle('viewer.css'),
    };
}

function differing(files, folder) {
    const committed = (name) => {
        try { return readFileSync(join(folder, name), 'utf8'); } catch { return null; }
    };
    return Object.keys(files).filter((name) => committed(name) !== files[name]);
}

const words = process.argv.slice(2);
const check = words[0] === '--check';
const folder = join(here, words[check ? 1 : 0] ?? 'dist');
const files = await bundles();
if (check) {
    const stale = differing(files, folder);
    for (const name of stale) console.error(`${join(folder, name)}: not what src/ gives; run: npm run build`);
    process.exitCode = stale.length ? 1 : 0;
} else {
    mkdirSync(folder, {recursive: true});
    for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
}
