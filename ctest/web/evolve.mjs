// node evolve.mjs PAGE: opens a page of `idiophone evolve` in Chromium without a window, waits until its sounds are loaded,
// marks the first and the third tree, and prints what happened as JSON.
import {createRequire} from "node:module";
import {pathToFileURL} from "node:url";

const {chromium} = createRequire(`${process.env.WEB_MODULES}/`)("playwright-core");

const browser = await chromium.launch({executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--mute-audio"]});
const page = await browser.newPage();
const complaints = [];
page.on("pageerror", error => complaints.push(error.message));
await page.goto(pathToFileURL(process.argv[2]).href);
const before = await page.locator("#command").textContent();
await page.waitForFunction(() => [...document.querySelectorAll("audio")].every(sound => sound.readyState > 0));
const durations = await page.evaluate(() => [...document.querySelectorAll("audio")].map(sound => sound.duration));
await page.locator("input").nth(0).check();
await page.locator("input").nth(2).check();
const command = await page.locator("#command").textContent();
await browser.close();
console.log(JSON.stringify({complaints, before, durations, command}));
