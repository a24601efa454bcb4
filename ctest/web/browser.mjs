// Chromium without a window, for the tests of web pages.
import {createRequire} from "node:module";
import {pathToFileURL} from "node:url";

const {chromium} = createRequire(`${process.env.WEB_MODULES}/`)("playwright-core");

/// Opens a page. `complaints` are its errors and warnings, also those that are still to come.
/// @param place      path of the page, or its address
/// @param width, height  of the view, pixels
/// @param more       arguments of Chromium
export async function open(place, width, height, more = []) {
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--mute-audio", ...more],
  });
  const page = await browser.newPage({viewport: {width, height}});
  const complaints = [];
  page.on("console", message => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", error => complaints.push(error.message));
  await page.goto(place.startsWith("http:") ? place : pathToFileURL(place).href);
  return {browser, page, complaints};
}

/// Opens a Sonic Explorer, and waits for its first picture.
export async function openExplorer(file, width, height) {
  const opened = await open(file, width, height);
  await opened.page.waitForFunction(() => window.idiophone?.explorer.view.frames > 0);
  return opened;
}
