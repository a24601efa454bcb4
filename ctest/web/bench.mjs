// node bench.mjs PAGE: opens a tuning bench in Chromium without a window, as large as that of a phone, and chooses the last
// partial. Prints what it shows as JSON.
import {open} from "./browser.mjs";

const {browser, page, complaints} = await open(process.argv[2], 390, 760);
await page.waitForFunction(() => window.idiophone?.bench.view.frames > 0);
const text = selector => page.locator(selector).textContent();
const first = await text("#legend");
const bands = await page.evaluate(() => window.idiophone.bench.view.bodies.map(({triangles}) => triangles.length));
await page.locator("#choice button").last().click();
const last = await text("#legend");
const advice = await text("#advice"), carried = await text("#carried");
const cuts = await page.locator("#cuts tr").count() - 1;
const narrow = await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);
await browser.close();
console.log(JSON.stringify({complaints, narrow, advice, carried, cuts, cut_triangles: bands[9],
                            coloured: bands.slice(0, 9).filter(count => count > 0).length, first_legend: first, last_legend: last}));
