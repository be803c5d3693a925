// node report.mjs REPORT.html PICTURES: opens a report of claque parity compare in Chromium, as a wide and as a narrow
// window. Fails with a sentence a fault: a picture that does not load, things that overlap, what is reached only by
// moving the page sideways, small letters. PICTURES gets a picture of each window.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Browser } from './browser.mjs';

// Runs in the page.
function faults() {
    const found = [], smallest = 12, text = (e) => e.textContent.trim().slice(0, 40);
    for (const img of document.images)
        if (!img.complete || img.naturalWidth === 0) found.push(`the picture '${img.alt}' does not load`);
    const across = document.documentElement.scrollWidth;
    if (across > innerWidth) found.push(`the page is ${across} pixels wide`);
    const parts = [...document.querySelectorAll('h1, h2, p, th, td, img, figcaption')].filter((e) => e.offsetHeight);
    const boxes = parts.map((e) => e.getBoundingClientRect());
    parts.forEach((e, i) => {
        const a = boxes[i];
        if (a.right > innerWidth + 1 || a.left < -1)
            found.push(`${e.tagName} '${text(e)}' reaches from ${a.left} to ${a.right}`);
        if (e.scrollWidth > e.clientWidth + 1) found.push(`${e.tagName} '${text(e)}' is wider than its place`);
        if (parseFloat(getComputedStyle(e).fontSize) < smallest) found.push(`${e.tagName} '${text(e)}' is small`);
        for (let k = i + 1; k < parts.length; ++k) {
            const b = boxes[k], width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
            const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
            if (width > 1 && height > 1 && !e.contains(parts[k]))
                found.push(`${e.tagName} '${text(e)}' and ${parts[k].tagName} '${text(parts[k])}' overlap`);
        }
    });
    return { found, pictures: document.images.length };
}

async function look(browser, page, width, folder) {
    const screen = { width, height: 900, deviceScaleFactor: 1, mobile: width < 600 };
    await browser.send('Emulation.setDeviceMetricsOverride', screen);
    await browser.send('Page.navigate', { url: pathToFileURL(resolve(page)).href });
    const ready = "new Promise((keep) => document.readyState === 'complete' ? keep() : addEventListener('load', keep))";
    const expression = `${ready}.then(${faults})`;
    const { result, exceptionDetails } =
        await browser.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
    const { data } = await browser.send('Page.captureScreenshot', { captureBeyondViewport: true });
    mkdirSync(folder, { recursive: true });
    writeFileSync(join(folder, `report-${width}.png`), data, 'base64');
    const { found, pictures } = result.value;
    if (pictures === 0) found.push('the page has no pictures');
    return found.map((fault) => `at ${width} pixels, ${fault}`);
}

const [page, folder] = process.argv.slice(2);
if (!folder) {
    console.error('report.mjs REPORT.html PICTURES');
    process.exit(2);
}
const browser = await Browser.open('swiftshader');
try {
    for (const width of [1024, 390])
        for (const fault of await browser.until(look(browser, page, width, folder), 60)) {
            console.error(`report.mjs: ${fault}`);
            process.exitCode = 1;
        }
} catch (error) {
    console.error(`report.mjs: ${error.message}`);
    process.exitCode = 1;
} finally {
    await browser.close();
}
