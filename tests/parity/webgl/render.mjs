// node render.mjs SCENE RESULT [--driver llvmpipe|swiftshader] [--times N] [--break NAME] [--three FOLDER]
// Draws the output of claque parity export in Chromium and writes the result. --times: N times as large in each
// direction, of which the middle pixels are kept. --break: with a mistake (breaks.mjs). --three: where it is installed.
// Exit codes: 0 done; 1 failed, with one sentence; 2 wrong usage.
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { breaks, broken } from './breaks.mjs';
import { Browser, drivers } from './browser.mjs';
import { serve } from './server.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const seconds = 540;
// Beside a copy of this folder, or where make test-webgl puts it.
const places = ['node_modules/three', '../../../build/webgl/node_modules/three'].map((name) => join(here, name));

function usage(why) {
    const driver = Object.keys(drivers).join('|'), mistake = Object.keys(breaks).join('|');
    console.error(`render.mjs: ${why}`);
    console.error(`render.mjs SCENE RESULT [--driver ${driver}] [--times N] [--break ${mistake}] [--three FOLDER]`);
    process.exit(2);
}

function given() {
    try {
        const { values, positionals } = parseArgs({
            allowPositionals: true,
            options: {
                driver: { type: 'string', default: 'llvmpipe' }, times: { type: 'string', default: '1' },
                break: { type: 'string' }, three: { type: 'string', default: places.find(existsSync) },
            },
        });
        if (!values.three) usage('three.js is not installed: npm install --ignore-scripts, or --three FOLDER');
        if (positionals.length !== 2) usage('it needs the folder of a scene and a folder for the result');
        if (!drivers[values.driver]) usage(`no driver ${values.driver}`);
        if (values.break && !breaks[values.break]) usage(`no mistake ${values.break}`);
        if (!(Number.isInteger(+values.times) && values.times >= 1 && values.times <= 64)) usage('--times is 1 to 64');
        return { scene: positionals[0], result: positionals[1], ...values };
    } catch (error) {
        return usage(error.message);
    }
}

const { scene, result, driver, times, break: mistake, three } = given();
const folders = { '': join(here, 'page'), three: join(three, 'build'), scene };
let server, browser;
try {
    server = await serve(folders, result, broken(mistake, folders['']));
    browser = await Browser.open(driver);
    await browser.send('Page.navigate', { url: `${server.address}?times=${times}` });
    await browser.until(server.complete, seconds);
} catch (error) {
    console.error(`render.mjs: ${error.message}`);
    process.exitCode = 1;
} finally {
    await browser?.close();
    server?.close();
}
