// node evolve.mjs PAGE: opens a page of `idiophone evolve` in Chromium without a window, waits until its sounds are loaded,
// marks the first and the third tree, and prints what happened as JSON.
import {open} from "./browser.mjs";

const {browser, page, complaints} = await open(process.argv[2], 1280, 720);
const before = await page.locator("#command").textContent();
await page.waitForFunction(() => [...document.querySelectorAll("audio")].every(sound => sound.readyState > 0));
const durations = await page.evaluate(() => [...document.querySelectorAll("audio")].map(sound => sound.duration));
await page.locator("input").nth(0).check();
await page.locator("input").nth(2).check();
const command = await page.locator("#command").textContent();
const title = await page.title();
await browser.close();
console.log(JSON.stringify({complaints, before, durations, command, title}));
